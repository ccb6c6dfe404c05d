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
  {
    const Index n = matrix.number_of_rows();
    for (Index number = internal::number_of_parts(n, options); number > 1; number /= 2) {
      const Row_parts parts(n, number);
      find_separators(matrix, parts);
      if (double(m_separators.size()) <= options.most_joints * double(n)) {
        collect_ranges(n, parts);
        return;
      }
    }
    m_is_separator.clear();
    m_separators.clear();
    m_ranges.assign(1, { { 0, n } });
  }

  Index number_of_parts() const { return Index(m_ranges.size()); }
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
    loops.for_each_block(0, number_of_parts(), [&](Index part, Index) { for_each_row_of_part(part, f); }, 1);
    for (const Index row : m_separators)
      f(row);
  }

  // The same with f(row, scratch); make_scratch() makes the scratch of a thread.
  template <class Make_scratch, class Function>
  void for_each_with_scratch(const Loops& loops, const Make_scratch& make_scratch, const Function& f) const
  {
    loops.for_each_block_with_scratch(0, number_of_parts(), make_scratch, [&](Index part, Index, auto& scratch) {
      for_each_row_of_part(part, [&](Index row) { f(row, scratch); });
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
    loops.for_each_block(0, number_of_parts(), [&](Index part, Index) {
      const Ranges& ranges = m_ranges[part];
      for (std::size_t k = ranges.size(); k-- > 0;)
        for (Index row = ranges[k].second; row-- > ranges[k].first;)
          f(row);
    }, 1);
  }

private:
  typedef std::vector<std::pair<Index, Index>>   Ranges;      // of rows, ascending: the first one, and the one after

  template <class Function>
  void for_each_row_of_part(Index part, const Function& f) const
  {
    for (const auto& [begin, end] : m_ranges[part])
      for (Index row = begin; row < end; ++row)
        f(row);
  }

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

  void collect_ranges(Index number_of_rows, const Row_parts& parts)
  {
    m_ranges.resize(parts.number_of_parts());
    Index begin = 0;
    const auto end_range = [&](Index end) {
      if (begin < end)
        m_ranges[parts.part_of(begin)].push_back({ begin, end });
    };
    for (Index row = 0; row < number_of_rows; ++row)
      if (m_is_separator[row]) {
        end_range(row);
        begin = row + 1;
      } else if (parts.part_of(row) != parts.part_of(begin)) {
        end_range(row);
        begin = row;
      }
    end_range(number_of_rows);
  }

  std::vector<Ranges> m_ranges;           // of each part, without separators
  std::vector<Index> m_separators;        // ascending
  std::vector<bool> m_is_separator;       // by row; empty: there is none
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_ELIMINATION_ORDER_H
