// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHY_INTERPOLATION_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHY_INTERPOLATION_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_builder.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/pinned_vertices.h>

#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Hierarchy_interpolation::Hierarchy_interpolation(const Vertex_hierarchy& vertices, std::size_t finest_level)
  : m_level_vertices(vertices.level_vertices.begin(), vertices.level_vertices.begin() + finest_level + 1),
    m_input_vertex(vertices.input_vertex.begin(), vertices.input_vertex.begin() + m_level_vertices.back())
{
  m_parents.reserve(number_of_vertices() - m_level_vertices.front());
  for (Index v = Index(m_level_vertices.front()); v < number_of_vertices(); ++v) {
    const Vertex_split& split = vertices.split(v);
    m_parents.push_back({ split.parent, { float(split.coordinates[0]), float(split.coordinates[1]) } });
  }
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Hierarchy_interpolation::Hierarchy_interpolation(const Collapse_hierarchy_3& hierarchy, bool has_unit_edges)
  : Hierarchy_interpolation(hierarchy.vertices(), hierarchy.number_of_levels() - 1)
{
  if (has_unit_edges)
    return;
  const Index first_of_input = ranks()[0];
  m_points = rounded(hierarchy.points(), hierarchy.point(first_of_input));
}

inline Vertex_hierarchy build_vertex_hierarchy(Triangulated_surface_3 surface, const Hierarchy_options& options,
                                               const Loops& loops)
{
  std::vector<bool> is_pinned = pinned_vertices(surface, options.is_constrained);
  Hierarchy_builder builder(std::move(surface.points), std::move(is_pinned), surface.triangles, loops);
  std::vector<Index_triangle>().swap(surface.triangles);      // the builder has read them
  return builder.build(options);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Hierarchy_interpolation::Hierarchy_interpolation(Triangulated_surface_3 surface, const Hierarchy_options& options,
                                                 const Loops& loops)
{
  const std::vector<Rounded_point> points =
      options.has_unit_edges ? std::vector<Rounded_point>() : rounded(surface.points, surface.points.front());
  const Vertex_hierarchy vertices = build_vertex_hierarchy(std::move(surface), options, loops);
  *this = Hierarchy_interpolation(vertices, vertices.level_vertices.size() - 1);
  if (points.empty())
    return;
  m_points.reserve(points.size());
  for (const Index v : m_input_vertex)
    m_points.push_back(points[v]);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Hierarchy_interpolation::Rounded_point>
Hierarchy_interpolation::rounded(const std::vector<Point_3>& points, const Point_3& origin)
{
  std::vector<Rounded_point> result;
  result.reserve(points.size());
  for (const Point_3& p : points) {
    const Vector_3 from_origin = p - origin;
    result.push_back({ float(from_origin.x()), float(from_origin.y()), float(from_origin.z()) });
  }
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHY_INTERPOLATION_IMPL_H
