// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_ROWS_BY_PART_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_ROWS_BY_PART_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>

#include <algorithm>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// Rows of a prolongation, for loops that add to the coarse rows in their columns.
class Rows_by_part
{
public:
  // Those from `first` on. `is_inside(part, row)` tells whether all columns of a row belong to its part.
  template <class Is_inside>
  Rows_by_part(Row_parts rows, Index first, const Is_inside& is_inside)
    : m_rows(std::move(rows)), m_first(first), m_split_rows(m_rows.number_of_parts(), [&](const auto& add) {
        for (Index part = 0; part < m_rows.number_of_parts(); ++part)
          m_rows.for_each_row(part, [&](Index row) {
            if (row >= m_first && !is_inside(part, row))
              add(part, row);
          });
      })
  { }

  // Calls f(row) for all: by several threads for those whose columns are in one part, and then for the others.
  template <class Function>
  void for_each(const Loops& loops, const Function& f) const
  {
    m_rows.for_each(loops, [&](Index part) {
      auto split = m_split_rows[part].begin();
      const auto last_split = m_split_rows[part].end();
      m_rows.for_each_range(part, [&](Index begin, Index end) {
        for (Index row = (std::max)(begin, m_first); row < end; ++row) {
          const Index stop = split != last_split && *split < end ? *split++ : end;
          for (; row < stop; ++row)
            f(row);
        }
      });
    });
    for (const Index row : m_split_rows.items())
      f(row);
  }

private:
  Row_parts m_rows;
  Index m_first;
  Compressed_lists<Index> m_split_rows;      // of each part
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_ROWS_BY_PART_H
