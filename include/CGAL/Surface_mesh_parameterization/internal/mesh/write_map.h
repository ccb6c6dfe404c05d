// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_WRITE_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_WRITE_MAP_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Writes a finished map, given by rank, into the user's property maps, in the user's units.
template <class TriangleMesh, class VertexUVMap, class VertexParameterizedMap>
void write_map(const Mesh_component<TriangleMesh>& component, const Collapse_hierarchy_3& hierarchy, const std::vector<Point_2>& uv,
               VertexUVMap uvmap, VertexParameterizedMap vpmap)
{
  typedef typename boost::property_traits<VertexUVMap>::value_type   User_point_2;
  for (Index rank = 0; rank < uv.size(); ++rank) {
    if (hierarchy.input_vertex(rank) >= component.vertices_of_component().size())   // virtual
      continue;
    const auto v = component.vertices_of_component()[hierarchy.input_vertex(rank)];
    put(uvmap, v, User_point_2(std::ldexp(uv[rank].x(), -hierarchy.scale_exponent()), std::ldexp(uv[rank].y(), -hierarchy.scale_exponent())));
    put(vpmap, v, true);
  }
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_WRITE_MAP_H
