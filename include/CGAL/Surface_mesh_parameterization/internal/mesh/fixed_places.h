// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_FIXED_PLACES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_FIXED_PLACES_H

#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// For each vertex of a surface, whether its place is given.
inline std::vector<bool> are_fixed(const Triangulated_surface_3& surface)
{
  std::vector<bool> result(surface.points.size(), false);
  for (const Triangulated_surface_3::Fixed_vertex& fixed : surface.fixed_vertices)
    result[fixed.vertex] = true;
  return result;
}

// For each vertex of a surface, its given place; null if there is none.
inline std::vector<const Point_2*> fixed_places(const Triangulated_surface_3& surface)
{
  std::vector<const Point_2*> result(surface.points.size(), nullptr);
  for (const Triangulated_surface_3::Fixed_vertex& fixed : surface.fixed_vertices)
    result[fixed.vertex] = &fixed.place;
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_FIXED_PLACES_H
