// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_MATRIX_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_MATRIX_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A sparse matrix of doubles that is assembled entry by entry, a model of `SparseLinearAlgebraTraits_d::Matrix`. Entries are collected and, whenever as many
// wait as there are, merged into the rows: so a sum over the faces takes little more memory than its result.
class Sparse_matrix
{
public:
  typedef double              NT;
  typedef Sparse_rows<double> Rows;

  explicit Sparse_matrix(std::size_t dimension) : Sparse_matrix(dimension, dimension) { }

  Sparse_matrix(std::size_t rows, std::size_t columns) : m_columns(columns), m_rows(std::make_shared<Rows>())
  {
    m_rows->first.assign(rows + 1, 0);
  }

  int row_dimension() const { return int(m_rows->number_of_rows()); }
  int column_dimension() const { return int(m_columns); }

  // a_ij
  double get_coef(std::size_t i, std::size_t j) const
  {
    merge();
    const std::size_t k = position(i, j);
    return k == not_found ? 0 : m_rows->values[k];
  }

  // a_ij := value; `is_new`: the caller knows that a_ij has not been set before, which saves time while the matrix is filled
  void set_coef(std::size_t i, std::size_t j, double value, bool is_new = false)
  {
    const bool was_merged = !m_rows->values.empty();
    if (!was_merged || !m_waiting.empty() || !change_existing(i, j, [value](double& a) { a = value; }))
      append(i, j, value, was_merged || !is_new);
  }

  // a_ij := a_ij + value
  void add_coef(std::size_t i, std::size_t j, double value)
  {
    if (m_replacements_wait || !change_existing(i, j, [value](double& a) { a += value; }))
      append(i, j, value, false);
  }

  // The rows, their columns ascending. They stay as they are while somebody holds them, whatever becomes of the matrix; so one pointer means equal values.
  std::shared_ptr<const Rows> rows() const
  {
    merge();
    return m_rows;
  }

private:
  static constexpr std::size_t not_found = std::size_t(-1);
  static constexpr std::size_t fewest_waiting = 1024;

  struct Entry
  {
    Index row;
    Index column : 31;
    Index replaces : 1;       // what the entry held before, rather than being added to it
    double value;
  };

  void append(std::size_t i, std::size_t j, double value, bool replaces)
  {
    CGAL_precondition(i < m_rows->number_of_rows() && j < m_columns);
    const std::size_t most_waiting = (std::max)({ fewest_waiting, m_rows->values.size(), m_rows->first.size() * expected_row_size });
    if (m_waiting.size() >= most_waiting)
      merge();
    if (m_waiting.empty())
      m_waiting.reserve(most_waiting);
    m_waiting.push_back({ Index(i), Index(j), replaces, value });
    m_replacements_wait = m_replacements_wait || replaces;
  }

  static constexpr std::size_t expected_row_size = 8;

  std::size_t position(std::size_t i, std::size_t j) const
  {
    const auto begin = m_rows->columns.begin() + m_rows->first[i], end = m_rows->columns.begin() + m_rows->first[i + 1];
    const auto found = std::lower_bound(begin, end, Index(j));
    return found != end && *found == Index(j) ? found - m_rows->columns.begin() : not_found;
  }

  // Returns whether there is such an entry among the rows.
  template <class Change>
  bool change_existing(std::size_t i, std::size_t j, const Change& change)
  {
    const std::size_t k = position(i, j);
    if (k == not_found)
      return false;
    if (m_rows.use_count() > 1)
      m_rows = std::make_shared<Rows>(*m_rows);
    change(m_rows->values[k]);
    return true;
  }

  // Counting sort of what waits by rows; then each row is merged with what it had.
  void merge() const
  {
    if (m_waiting.empty())
      return;
    const Rows& old = *m_rows;
    const Index n = old.number_of_rows();
    std::vector<Index> order(m_waiting.size()), next(n + 1, 0);
    for (const Entry& e : m_waiting)
      ++next[e.row + 1];
    for (Index i = 0; i < n; ++i)
      next[i + 1] += next[i];
    for (std::size_t k = 0; k < m_waiting.size(); ++k)
      order[next[m_waiting[k].row]++] = Index(k);       // from here on next[i] ends row i

    const auto merged = std::make_shared<Rows>();
    merged->first.reserve(n + 1);
    merged->first.push_back(0);
    merged->columns.reserve(old.columns.size() + m_waiting.size());
    merged->values.reserve(old.columns.size() + m_waiting.size());
    std::vector<Index> place(m_columns, 0);
    std::vector<std::pair<Index, double>> row;
    for (Index i = 0; i < n; ++i)
      merge_row(i, order.data() + (i == 0 ? 0 : next[i - 1]), order.data() + next[i], place, row, *merged);
    merged->columns.shrink_to_fit();
    merged->values.shrink_to_fit();
    m_rows = merged;
    std::vector<Entry>().swap(m_waiting);
    m_replacements_wait = false;
  }

  // Of the columns that the row has met, `place` tells where in `row` they are; of others, anything.
  void merge_row(Index i, const Index* begin, const Index* end, std::vector<Index>& place, std::vector<std::pair<Index, double>>& row, Rows& merged) const
  {
    row.clear();
    const auto at = [&](Index column) -> double& {
      if (!(place[column] < row.size() && row[place[column]].first == column)) {
        place[column] = Index(row.size());
        row.emplace_back(column, 0.);
      }
      return row[place[column]].second;
    };
    for (Index k = m_rows->first[i]; k < m_rows->first[i + 1]; ++k)
      at(m_rows->columns[k]) = m_rows->values[k];
    for (; begin != end; ++begin) {
      const Entry& e = m_waiting[*begin];
      double& value = at(e.column);
      value = e.replaces ? e.value : value + e.value;
    }
    std::sort(row.begin(), row.end());
    for (const auto& [column, value] : row) {
      merged.columns.push_back(column);
      merged.values.push_back(value);
    }
    merged.first.push_back(Index(merged.columns.size()));
  }

  std::size_t m_columns;
  mutable std::shared_ptr<Rows> m_rows;
  mutable std::vector<Entry> m_waiting;
  mutable bool m_replacements_wait = false;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_MATRIX_H
