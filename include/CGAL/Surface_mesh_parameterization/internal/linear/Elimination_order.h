// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_ELIMINATION_ORDER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_ELIMINATION_ORDER_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// An order in which the rows of a matrix are eliminated, such that threads can share the work, and none of the quality
// of incomplete factors is lost: the rows in parts, see Row_parts, but those that separate the parts come last. A row
// of a part meets no row of another one.
class Elimination_order
{
public:
  // Rows in the order of the hierarchy's input. They are one part if they are few, or if too many of them would
  // separate parts.
  template <class Number>
  explicit Elimination_order(const Sparse_rows<Number>& matrix, const Row_parts_options& options = Row_parts_options())
    : m_parts(matrix.number_of_rows())
  {
    const Index n = matrix.number_of_rows();
    for (Index number = internal::number_of_parts(n, options); number > 1; number /= 2) {
      find_separators(matrix, Row_parts(n, number));
      if (double(m_separators.size()) <= options.most_joints * double(n)) {
        m_parts = Row_parts(n, number, [this](Index row) { return !m_is_separator[row]; });
        return;
      }
    }
    m_is_separator.clear();
    m_separators.clear();
  }

  Index number_of_parts() const { return m_parts.number_of_parts(); }
  const std::vector<Index>& separators() const { return m_separators; }
  bool is_separator(Index row) const { return !m_is_separator.empty() && m_is_separator[row]; }

  bool is_before(Index a, Index b) const
  {
    return std::make_pair(is_separator(a), a) < std::make_pair(is_separator(b), b);
  }

  // Calls f(row) for every row after those before it that it meets.
  template <class Function>
  void for_each(const Loops& loops, const Function& f) const
  {
    m_parts.for_each(loops, [&](Index part) { m_parts.for_each_row(part, f); });
    for (const Index row : m_separators)
      f(row);
  }

  // The same with f(row, scratch); make_scratch() makes the scratch of a thread.
  template <class Make_scratch, class Function>
  void for_each_with_scratch(const Loops& loops, const Make_scratch& make_scratch, const Function& f) const
  {
    loops.for_each_block_with_scratch(0, number_of_parts(), make_scratch, [&](Index part, Index, auto& scratch) {
      m_parts.for_each_row(part, [&](Index row) { f(row, scratch); });
    }, 1);
    if (m_separators.empty())
      return;
    auto scratch = make_scratch();
    for (const Index row : m_separators)
      f(row, scratch);
  }

  // Calls f(row) for every row after those behind it that it meets.
  template <class Function>
  void for_each_backward(const Loops& loops, const Function& f) const
  {
    for (std::size_t k = m_separators.size(); k-- > 0;)
      f(m_separators[k]);
    m_parts.for_each(loops, [&](Index part) { m_parts.for_each_row_backward(part, f); });
  }

private:
  // Of two rows of different parts that meet, the one of the later part.
  template <class Number>
  void find_separators(const Sparse_rows<Number>& matrix, const Row_parts& parts)
  {
    const Index n = matrix.number_of_rows();
    m_is_separator.assign(n, false);
    for (Index row = 0; row < n; ++row) {
      const Index part = parts.part_of(row);
      matrix.for_each_entry(row, [&](Index column, const Number&) {
        if (parts.part_of(column) != part)
          m_is_separator[(std::max)(row, column)] = true;
      });
    }
    m_separators.clear();
    for (Index row = 0; row < n; ++row)
      if (m_is_separator[row])
        m_separators.push_back(row);
  }

  Row_parts m_parts;                      // without separators
  std::vector<Index> m_separators;        // ascending
  std::vector<bool> m_is_separator;       // by row; empty: there is none
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_ELIMINATION_ORDER_H
