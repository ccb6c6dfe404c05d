// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_PRUNED_PROLONGATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_PRUNED_PROLONGATION_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The prolongation over several collapse groups, each row pruned to its three greatest weights, whose sum is made 1
// again: that keeps coarse operators sparse. The first rows, those of the coarse vertices, are the identity's.
class Pruned_prolongation
{
public:
  static constexpr int row_size = 3;

  struct Row
  {
    std::array<Index, row_size> columns;     // one with the weight 0 may come twice
    std::array<float, row_size>
        weights;      // single precision: they are transposed as they are, so the cycle stays symmetric
  };

  struct Entry { Index row; float weight; };  // of the transpose

  // `hierarchy`: a Collapse_hierarchy_3 or its Hierarchy_interpolation
  template <class Hierarchy>
  Pruned_prolongation(const Hierarchy& hierarchy, std::size_t coarse, std::size_t fine, const Loops& loops)
    : m_coarse_size(hierarchy.number_of_vertices(coarse))
  {
    typedef std::vector<std::pair<Index, double>> Entries;
    m_rows.resize(hierarchy.number_of_vertices(fine));
    loops.for_each(0, Index(m_coarse_size), [&](Index v) { m_rows[v] = { { v, v, v }, { 1, 0, 0 } }; });
    for (std::size_t l = coarse + 1; l <= fine; ++l)      // the rows of a group depend on those of earlier groups
      loops.for_each_block_with_scratch(
          Index(hierarchy.number_of_vertices(l - 1)), Index(hierarchy.number_of_vertices(l)), [] { return Entries(); },
          [&](Index begin, Index end, Entries& entries) {
            for (Index v = begin; v < end; ++v)
              m_rows[v] = composed_row(hierarchy, v, entries);
          });
    transpose();
  }

  std::size_t coarse_size() const { return m_coarse_size; }
  std::size_t fine_size() const { return m_rows.size(); }

  const Row& row(Index v) const { return m_rows[v]; }

  // The rows in which a coarse vertex occurs, its own first.
  const Entry* column_begin(Index v) const { return m_entries.data() + m_first[v]; }
  const Entry* column_end(Index v) const { return m_entries.data() + m_first[v + 1]; }

private:
  template <class Hierarchy>
  Row composed_row(const Hierarchy& hierarchy, Index v, std::vector<std::pair<Index, double>>& entries) const
  {
    entries.clear();
    const Index_triangle& parent = hierarchy.parent_triangle(v);
    const std::array<double, 3> coordinates = hierarchy.barycentric_coordinates(v);
    for (int i = 0; i < 3; ++i) {
      const Row& parent_row = row(parent[i]);
      for (int k = 0; k < row_size && coordinates[i] * parent_row.weights[k] != 0; ++k)
        entries.push_back({ parent_row.columns[k], coordinates[i] * parent_row.weights[k] });
    }
    return prune(entries);
  }

  static Row prune(std::vector<std::pair<Index, double>>& entries)
  {
    std::sort(entries.begin(), entries.end());
    std::size_t size = 0;
    for (const auto& e : entries)
      if (size > 0 && entries[size - 1].first == e.first)
        entries[size - 1].second += e.second;
      else
        entries[size++] = e;
    entries.resize(size);
    const auto end = entries.begin() + (std::min)(std::size_t(row_size), size);
    std::partial_sort(entries.begin(), end, entries.end(),
                      [](const auto& a, const auto& b) { return a.second > b.second; });
    double sum = 0;
    for (auto e = entries.begin(); e != end; ++e)
      sum += e->second;
    Row row;
    for (int k = 0; k < row_size; ++k) {
      const bool is_used = entries.begin() + k < end;
      row.columns[k] = entries[is_used ? k : 0].first;
      row.weights[k] = is_used ? float(entries[k].second / sum) : 0.f;
    }
    return row;
  }

  void transpose()
  {
    m_first.assign(m_coarse_size + 1, 0);
    for (const Row& row : m_rows)
      for (int k = 0; k < row_size; ++k)
        if (row.weights[k] != 0)
          ++m_first[row.columns[k] + 1];
    for (std::size_t v = 0; v < m_coarse_size; ++v)
      m_first[v + 1] += m_first[v];
    m_entries.resize(m_first.back());
    std::vector<Index> next(m_first.begin(), m_first.end() - 1);
    for (std::size_t i = 0; i < m_rows.size(); ++i)
      for (int k = 0; k < row_size; ++k)
        if (m_rows[i].weights[k] != 0)
          m_entries[next[m_rows[i].columns[k]]++] = { Index(i), m_rows[i].weights[k] };
  }

  std::size_t m_coarse_size;
  std::vector<Row> m_rows;
  std::vector<Index> m_first;
  std::vector<Entry> m_entries;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_PRUNED_PROLONGATION_H
