// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_MATRIX_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_MATRIX_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Sparse_matrix::make_room()
{
  constexpr std::size_t expected_row_size = 8, fewest = 1024, few = 1 << 16;
  const std::size_t expected =
      (std::max)({ fewest, m_rows->values.size(), m_rows->first.size() * expected_row_size });
  const std::size_t most = (std::max)(few, expected);      // a merge goes through all rows, so it waits for some
  if (m_waiting.size() >= most)
    merge();
  m_waiting.reserve((std::min)(most, (std::max)(expected, 2 * m_waiting.size())));
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Sparse_matrix::merge() const
{
  constexpr std::size_t greatest_expected_row_size = 16;
  if (m_waiting.empty())
    return;
  if (m_rows.use_count() > 1)
    m_rows = std::make_shared<Rows>(*m_rows);
  Rows& rows = *m_rows;
  const Index n = rows.number_of_rows();
  const Compressed_lists<Index> waiting_of_row(n, [this](const auto& add) {
    for (std::size_t k = 0; k < m_waiting.size(); ++k)
      add(m_waiting[k].row, Index(k));
  });
  std::vector<Index> place(m_columns, 0), first = { 0 };
  first.reserve(std::size_t(n) + 1);
  Sparse_row row;
  for (Index i = 0; i < n; ++i) {
    merge_row(i, waiting_of_row[i], place, row);
    first.push_back(Rows::checked_end(first.back() + row.size()));
  }
  rows.reserve(n, (std::max)(std::size_t(first.back()), n * greatest_expected_row_size));
  rows.columns.resize(first.back());
  rows.values.resize(first.back());
  for (Index i = n; i-- > 0;) {
    merge_row(i, waiting_of_row[i], place, row);
    std::sort(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < row.size(); ++k) {
      rows.columns[first[i] + k] = row[k].first;
      rows.values[first[i] + k] = row[k].second;
    }
  }
  rows.first.swap(first);
  std::vector<Entry>().swap(m_waiting);
  m_coef_of_waiting.clear();
  m_replacements_wait = false;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Sparse_matrix::merge_row(Index i, boost::iterator_range<const Index*> waiting, std::vector<Index>& place,
                              Sparse_row& row) const
{
  row.clear();
  const auto at = [&](Index column) -> double& {
    if (!(place[column] < row.size() && row[place[column]].first == column)) {
      place[column] = Index(row.size());
      row.emplace_back(column, 0.);
    }
    return row[place[column]].second;
  };
  m_rows->for_each_entry(i, [&](Index column, double value) { at(column) = value; });
  for (const Index k : waiting) {
    const Entry& e = m_waiting[k];
    double& value = at(e.column);
    value = e.replaces ? e.value : value + e.value;
  }
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_MATRIX_IMPL_H
