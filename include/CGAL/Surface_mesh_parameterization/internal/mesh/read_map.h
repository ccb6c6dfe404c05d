// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_READ_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_READ_MAP_H

#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The places of a component's vertices in the user's map, in units that are 2^-scale_exponent times the user's.
template <class TriangleMesh, class VertexUVMap>
std::vector<Point_2> read_map(const Mesh_component<TriangleMesh>& component, int scale_exponent, VertexUVMap uvmap)
{
  std::vector<Point_2> uv;
  uv.reserve(component.vertices_of_component().size());
  for (const auto v : component.vertices_of_component())
    uv.push_back(times_power_of_two(to_point_2(get(uvmap, v)), scale_exponent));
  return uv;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_READ_MAP_H
