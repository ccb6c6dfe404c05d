// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_MATRIX_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_MATRIX_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A sparse matrix of doubles that is assembled entry by entry, a model of `SparseLinearAlgebraTraits_d::Matrix`.
// Entries are collected and, whenever as many wait as there are, but at least some ten thousands, merged into the rows:
// so a sum over the faces takes little more memory than its result.
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
    if (m_waiting.empty())
      return merged_coef(i, j);
    if (m_coef_of_waiting.empty())
      for (const Entry& entry : m_waiting)
        count_in(entry);
    const auto found = m_coef_of_waiting.find(key(i, j));
    return found == m_coef_of_waiting.end() ? merged_coef(i, j) : found->second;
  }

  // a_ij := value; `is_new`: the caller knows that a_ij has not been set before, which saves time while the matrix is
  // filled
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

  // The rows, their columns ascending. They stay as they are while somebody holds them, whatever becomes of the matrix;
  // so one pointer means equal values.
  std::shared_ptr<const Rows> rows() const
  {
    merge();
    return m_rows;
  }

private:
  static constexpr std::size_t not_found = std::size_t(-1);

  struct Entry
  {
    Index row;
    Index column : 31;
    Index replaces : 1;       // what the entry held before, rather than being added to it
    double value;
  };

  void append(std::size_t i, std::size_t j, double value, bool replaces)
  {
    CGAL_precondition(has(i, j));
    if (m_waiting.size() == m_waiting.capacity())
      make_room();
    m_waiting.push_back({ Index(i), Index(j), replaces, value });
    if (!m_coef_of_waiting.empty())
      count_in(m_waiting.back());
    m_replacements_wait = m_replacements_wait || replaces;
  }

  double merged_coef(std::size_t i, std::size_t j) const
  {
    const std::size_t k = position(i, j);
    return k == not_found ? 0 : m_rows->values[k];
  }

  static std::uint64_t key(std::size_t i, std::size_t j) { return std::uint64_t(i) << 32 | j; }

  // Adds an entry that waits to what get_coef() knows of those.
  void count_in(const Entry& entry) const
  {
    double& coef = m_coef_of_waiting.try_emplace(key(entry.row, entry.column), merged_coef(entry.row, entry.column))
                       .first->second;
    coef = entry.replaces ? entry.value : coef + entry.value;
  }

  // For one more entry that waits. Merges those that wait if they are many.
  void make_room();

  bool has(std::size_t i, std::size_t j) const { return i < m_rows->number_of_rows() && j < m_columns; }

  std::size_t position(std::size_t i, std::size_t j) const
  {
    CGAL_precondition(has(i, j));
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

  // Merges each row with what waits for it.
  void merge() const;

  // The same, if there are no entries yet, and if there are: then in place, from the last row on, since no row becomes
  // shorter; a copy would double the memory.
  void make_rows() const;
  void insert_in_rows() const;

  // Calls f(i, row) for the rows from the first on: merged with what waits for it, or empty if nothing does.
  void for_each_merged_row(Function_ref<void(Index, const Sparse_row&)> f) const;

  // Adds the merged row to `row`, which is empty, its columns ascending. `place` is for the function's own use, a number
  // for each column.
  void merge_row(Index i, boost::iterator_range<const Index*> waiting, std::vector<Index>& place,
                 Sparse_row& row) const;

  std::size_t m_columns;
  mutable std::shared_ptr<Rows> m_rows;
  mutable std::vector<Entry> m_waiting;
  mutable bool m_replacements_wait = false;
  // a_ij where something waits for it, by key(i, j); empty until somebody asks for one
  mutable std::unordered_map<std::uint64_t, double> m_coef_of_waiting;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_MATRIX_H
