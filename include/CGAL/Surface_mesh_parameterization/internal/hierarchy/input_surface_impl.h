// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_INPUT_SURFACE_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_INPUT_SURFACE_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/input_surface.h>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Triangulated_surface_3 input_surface(const Collapse_hierarchy_3& hierarchy)
{
  Triangulated_surface_3 surface;
  surface.scale_exponent = hierarchy.scale_exponent();
  surface.points.resize(hierarchy.number_of_vertices());
  for (Index rank = 0; rank < surface.points.size(); ++rank) {
    const Index v = hierarchy.input_vertex(rank);
    surface.points[v] = hierarchy.point(rank);
    if (hierarchy.is_on_outer_border(rank))
      surface.outer_border.push_back(v);
    if (hierarchy.is_fixed(rank))
      surface.fixed_vertices.push_back({ v, hierarchy.fixed_place(rank) });
  }
  surface.springs = hierarchy.springs();
  for (Triangulated_surface_3::Spring& s : surface.springs)
    s.vertex = hierarchy.input_vertex(s.vertex);
  surface.triangles.resize(hierarchy.number_of_faces());
  for (Index rank = 0; rank < surface.triangles.size(); ++rank)
    for (int i = 0; i < 3; ++i)
      surface.triangles[hierarchy.input_face(rank)][i] = hierarchy.input_vertex(hierarchy.triangles()[rank][i]);
  return surface;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Triangulated_surface_3 surface_by_rank(const Level& level)
{
  Triangulated_surface_3 surface;
  surface.triangles = level.triangles();
  for (Index v = 0; v < level.number_of_vertices(); ++v) {
    surface.points.push_back(level.point(v));
    if (level.hierarchy().is_on_outer_border(v))
      surface.outer_border.push_back(v);
  }
  return surface;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_INPUT_SURFACE_IMPL_H
