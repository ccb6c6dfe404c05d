// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_MATRIX_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_MATRIX_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Sparse_matrix::make_room()
{
  constexpr std::size_t expected_row_size = 8, fewest = 1024, few = 1 << 16;
  const std::size_t expected = (std::max)(fewest, m_rows->first.size() * expected_row_size);
  const std::size_t most = (std::max)(few, expected);      // a merge goes through all rows, so it waits for some
  if (m_waiting.size() >= most)
    merge();
  m_waiting.reserve((std::min)(most, (std::max)(expected, 2 * m_waiting.size())));
}

// Moves the entries of row i, so that they begin at `destination`, which is not before them.
inline void move_row(Sparse_rows<double>& rows, Index i, Index destination)
{
  const Index begin = rows.first[i], end = rows.first[i + 1];
  if (destination == begin)
    return;
  const auto move = [&](auto entries) {
    std::copy_backward(entries + begin, entries + end, entries + destination + (end - begin));
  };
  move(rows.columns.begin());
  move(rows.values.begin());
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Sparse_matrix::merge() const
{
  if (m_waiting.empty())
    return;
  if (m_rows.use_count() > 1)
    m_rows = std::make_shared<Rows>(*m_rows);
  if (m_rows->values.empty())
    make_rows();
  else
    insert_in_rows();
  std::vector<Entry>().swap(m_waiting);
  m_coef_of_waiting.clear();
  m_replacements_wait = false;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Sparse_matrix::make_rows() const
{
  constexpr std::size_t greatest_expected_row_size = 16;
  const Index n = m_rows->number_of_rows();
  Rows rows;
  rows.reserve(n, n * greatest_expected_row_size);
  for_each_merged_row([&](Index, const Sparse_row& row) { rows.append(row); });
  *m_rows = std::move(rows);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Sparse_matrix::insert_in_rows() const
{
  Rows& rows = *m_rows;
  const Index n = rows.number_of_rows();
  std::vector<Index> first = { 0 };
  first.reserve(std::size_t(n) + 1);
  std::vector<bool> is_merged(n, false);
  Sparse_row merged;      // the rows for which something waits, one after the other
  for_each_merged_row([&](Index i, const Sparse_row& row) {
    is_merged[i] = !row.empty();
    merged.insert(merged.end(), row.begin(), row.end());
    const std::size_t size = is_merged[i] ? row.size() : rows.first[i + 1] - rows.first[i];
    first.push_back(Rows::checked_end(first.back() + size));
  });
  rows.columns.resize(first.back());
  rows.values.resize(first.back());
  auto next = merged.rbegin();
  for (Index i = n; i-- > 0;)
    if (is_merged[i])
      for (Index k = first[i + 1]; k-- > first[i]; ++next) {
        rows.columns[k] = next->first;
        rows.values[k] = next->second;
      }
    else
      move_row(rows, i, first[i]);
  rows.first.swap(first);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Sparse_matrix::for_each_merged_row(Function_ref<void(Index, const Sparse_row&)> f) const
{
  const Index n = m_rows->number_of_rows();
  const Compressed_lists<Index> waiting_of_row(n, [this](const auto& add) {
    for (std::size_t k = 0; k < m_waiting.size(); ++k)
      add(m_waiting[k].row, Index(k));
  });
  std::vector<Index> place(m_columns, 0);
  Sparse_row row;
  for (Index i = 0; i < n; ++i) {
    row.clear();
    if (!waiting_of_row[i].empty())
      merge_row(i, waiting_of_row[i], place, row);
    f(i, row);
  }
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Sparse_matrix::merge_row(Index i, boost::iterator_range<const Index*> waiting, std::vector<Index>& place,
                              Sparse_row& row) const
{
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
  std::sort(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_MATRIX_IMPL_H
