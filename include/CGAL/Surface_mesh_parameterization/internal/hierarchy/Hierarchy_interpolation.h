// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHY_INTERPOLATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHY_INTERPOLATION_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Vertex_hierarchy.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// What a linear solver needs of a hierarchy: how its vertices are interpolated, and how many each level has. It takes a
// fifth of the memory, so that a hierarchy that nobody else needs can go before the matrix comes.
class Hierarchy_interpolation
{
public:
  // From the coarsest level to the given one; without points.
  Hierarchy_interpolation(const Vertex_hierarchy& vertices, std::size_t finest_level);

  // With points, unless the hierarchy has another metric than that of space.
  Hierarchy_interpolation(const Collapse_hierarchy_3& hierarchy, bool has_unit_edges = false);

  // Builds the hierarchy of a surface.
  Hierarchy_interpolation(Triangulated_surface_3 surface, const Hierarchy_options& options,
                          const Loops& loops = Loops());

  // As of Collapse_hierarchy_3, the coordinates rounded to single precision.
  std::size_t number_of_levels() const { return m_level_vertices.size(); }
  std::size_t number_of_vertices(std::size_t level) const { return m_level_vertices[level]; }
  std::size_t number_of_vertices() const { return m_level_vertices.back(); }
  Index input_vertex(Index v) const { return m_input_vertex[v]; }
  std::vector<Index> ranks() const { return positions_in(m_input_vertex, number_of_vertices()); }      // of the input
  const Index_triangle& parent_triangle(Index v) const { return parent(v).triangle; }

  std::array<double, 3> barycentric_coordinates(Index v) const
  {
    const std::array<float, 2>& c = parent(v).coordinates;
    return { (std::max)(0., 1. - c[0] - c[1]), c[0], c[1] };
  }

  // Whether it knows where the vertices are in space.
  bool has_points() const { return !m_points.empty(); }

  // The point of a vertex, seen from that of the input's first one, in single precision.
  Point_3 point(Index v) const { return Point_3(m_points[v][0], m_points[v][1], m_points[v][2]); }

private:
  typedef std::array<float, 3>   Rounded_point;

  struct Parent
  {
    Index_triangle triangle;
    std::array<float, 2> coordinates;
  };

  const Parent& parent(Index v) const { return m_parents[v - m_level_vertices.front()]; }

  static std::vector<Rounded_point> rounded(const std::vector<Point_3>& points, const Point_3& origin);

  std::vector<std::size_t> m_level_vertices;
  std::vector<Index> m_input_vertex;
  std::vector<Parent> m_parents;            // of the vertices that are not on level 0
  std::vector<Rounded_point> m_points;      // empty if the hierarchy has another metric than that of space
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHY_INTERPOLATION_H
