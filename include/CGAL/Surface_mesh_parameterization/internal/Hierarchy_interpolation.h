// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_INTERPOLATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_INTERPOLATION_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/flat_types.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// What a linear solver needs of a hierarchy: how its vertices are interpolated, and how many each level has. It takes a fifth of the memory, so that a
// hierarchy that nobody else needs can go before the matrix comes.
class Hierarchy_interpolation
{
public:
  Hierarchy_interpolation(const Collapse_hierarchy_3& hierarchy)
  {
    for (std::size_t level = 0; level < hierarchy.number_of_levels(); ++level)
      m_level_vertices.push_back(hierarchy.number_of_vertices(level));
    m_input_vertex.reserve(hierarchy.number_of_vertices());
    m_parents.reserve(hierarchy.number_of_vertices() - m_level_vertices.front());
    for (Index v = 0; v < hierarchy.number_of_vertices(); ++v) {
      m_input_vertex.push_back(hierarchy.input_vertex(v));
      if (v < m_level_vertices.front())
        continue;
      const std::array<double, 3> coordinates = hierarchy.barycentric_coordinates(v);
      m_parents.push_back({ hierarchy.parent_triangle(v), { float(coordinates[1]), float(coordinates[2]) } });
    }
  }

  // As of Collapse_hierarchy_3, the coordinates rounded to single precision.
  std::size_t number_of_levels() const { return m_level_vertices.size(); }
  std::size_t number_of_vertices(std::size_t level) const { return m_level_vertices[level]; }
  std::size_t number_of_vertices() const { return m_level_vertices.back(); }
  Index input_vertex(Index v) const { return m_input_vertex[v]; }
  const Index_triangle& parent_triangle(Index v) const { return parent(v).triangle; }

  std::array<double, 3> barycentric_coordinates(Index v) const
  {
    const std::array<float, 2>& c = parent(v).coordinates;
    return { (std::max)(0., 1. - c[0] - c[1]), c[0], c[1] };
  }

private:
  struct Parent
  {
    Index_triangle triangle;
    std::array<float, 2> coordinates;
  };

  const Parent& parent(Index v) const { return m_parents[v - m_level_vertices.front()]; }

  std::vector<std::size_t> m_level_vertices;
  std::vector<Index> m_input_vertex;
  std::vector<Parent> m_parents;      // of the vertices that are not on level 0
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_INTERPOLATION_H
