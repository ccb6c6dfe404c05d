// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_COLLAPSE_HIERARCHY_3_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_COLLAPSE_HIERARCHY_3_IMPL_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_builder.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/pinned_vertices.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

namespace internal {

// Adds the sum of the given entries, in the order of their columns, as row v.
template <class Matrix, class Entry>
void append_row(Matrix& matrix, Index v, std::vector<Entry>& row)
{
  std::sort(row.begin(), row.end(), [](const Entry& a, const Entry& b) { return a.first < b.first; });
  matrix.startVec(v);
  for (std::size_t i = 0; i < row.size();) {
    const Index column = row[i].first;
    double sum = 0;
    for (; i < row.size() && row[i].first == column; ++i)
      sum += row[i].second;
    matrix.insertBack(v, column) = sum;
  }
}

// Whether all indices are those of points.
inline bool are_indices_valid(const Triangulated_surface_3& surface)
{
  const auto is_valid = [&](Index v) { return v < surface.points.size(); };
  const auto is_vertex_valid = [&](const auto& x) { return is_valid(x.vertex); };
  return std::all_of(surface.triangles.begin(), surface.triangles.end(),
                     [&](const Index_triangle& t) { return std::all_of(t.begin(), t.end(), is_valid); }) &&
         std::all_of(surface.outer_border.begin(), surface.outer_border.end(), is_valid) &&
         std::all_of(surface.fixed_vertices.begin(), surface.fixed_vertices.end(), is_vertex_valid) &&
         std::all_of(surface.springs.begin(), surface.springs.end(), is_vertex_valid);
}

} // namespace internal

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Collapse_hierarchy_3::Collapse_hierarchy_3(Triangulated_surface_3 surface, const internal::Hierarchy_options& options,
                                           const internal::Loops& loops)
{
  build(std::move(surface), options, loops);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Collapse_hierarchy_3::build(Triangulated_surface_3 surface, const internal::Hierarchy_options& options,
                                 const internal::Loops& loops)
{
  CGAL_precondition_msg(internal::are_indices_valid(surface), "an index of the surface is none of a point");
  const std::vector<bool> is_pinned = internal::pinned_vertices(surface, options.is_constrained);
  m_vertices = internal::Hierarchy_builder(surface.points, is_pinned, surface.triangles, loops).build(options);
  m_faces = internal::Face_hierarchy(m_vertices, std::move(surface.triangles));
  number_by_rank(surface, is_pinned, loops);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
const Collapse_hierarchy_3::Point_2& Collapse_hierarchy_3::fixed_place(Index v) const
{
  CGAL_precondition(is_fixed(v));
  return std::lower_bound(m_fixed_places.begin(), m_fixed_places.end(), v,
                          [](const std::pair<Index, Point_2>& fixed, Index rank) { return fixed.first < rank; })
      ->second;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Collapse_hierarchy_3::Triangle Collapse_hierarchy_3::last_triangle(Index f) const
{
  const std::vector<Index>& first = m_faces.first_face;
  const std::size_t place = std::upper_bound(first.begin(), first.end(), f) - first.begin() - 1;
  return triangle(f, number_of_vertices(0) + place);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Collapse_hierarchy_3::Prolongation Collapse_hierarchy_3::prolongation(std::size_t coarse, std::size_t fine) const
{
  CGAL_precondition(coarse <= fine && fine < number_of_levels());
  typedef std::pair<Index, double> Entry;
  const Index rows = Index(number_of_vertices(fine)), columns = Index(number_of_vertices(coarse));
  Prolongation result(rows, columns);
  std::vector<Entry> row;
  for (Index v = 0; v < rows; ++v) {
    row.clear();
    if (v < columns)
      row.push_back({ v, 1. });
    else
      for (int i = 0; i < 3; ++i)
        for (Prolongation::InnerIterator it(result, parent_triangle(v)[i]); it; ++it)
          row.push_back({ Index(it.col()), barycentric_coordinates(v)[i] * it.value() });
    internal::append_row(result, v, row);
  }
  result.finalize();
  return result;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::size_t Collapse_hierarchy_3::memory() const
{
  const auto bytes = [](const auto& array) { return array.capacity() * sizeof(array[0]); };
  return bytes(m_vertices.level_vertices) + bytes(m_vertices.input_vertex) + bytes(m_vertices.splits) +
         bytes(m_faces.triangles) + bytes(m_faces.input_face) + bytes(m_faces.first_face) + bytes(m_points) +
         bytes(m_fixed_places) + bytes(m_springs) +
         (m_is_pinned.capacity() + m_is_fixed.capacity() + m_is_on_outer_border.capacity()) / 8;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Collapse_hierarchy_3::number_by_rank(const Triangulated_surface_3& surface, const std::vector<bool>& is_pinned,
                                          const internal::Loops& loops)
{
  const std::vector<Index> rank = m_vertices.ranks();
  m_scale_exponent = surface.scale_exponent;
  m_points.resize(rank.size());
  loops.for_each(0, Index(rank.size()), [&](Index v) { m_points[v] = surface.points[input_vertex(v)]; });
  m_is_pinned.reserve(rank.size());
  for (const Index v : m_vertices.input_vertex)
    m_is_pinned.push_back(is_pinned[v]);
  m_is_on_outer_border.assign(rank.size(), false);
  for (const Index v : surface.outer_border)
    m_is_on_outer_border[rank[v]] = true;

  m_is_fixed.assign(rank.size(), false);
  for (const Triangulated_surface_3::Fixed_vertex& fixed : surface.fixed_vertices) {
    m_is_fixed[rank[fixed.vertex]] = true;
    m_fixed_places.push_back({ rank[fixed.vertex], fixed.place });
  }
  std::sort(m_fixed_places.begin(), m_fixed_places.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  m_springs = surface.springs;
  for (Triangulated_surface_3::Spring& s : m_springs)
    s.vertex = rank[s.vertex];
  std::sort(m_springs.begin(), m_springs.end(), [](const auto& a, const auto& b) { return a.vertex < b.vertex; });
}

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_COLLAPSE_HIERARCHY_3_IMPL_H
