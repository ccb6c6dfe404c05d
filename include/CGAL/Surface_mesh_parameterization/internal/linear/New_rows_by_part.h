// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_NEW_ROWS_BY_PART_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_NEW_ROWS_BY_PART_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Pruned_prolongation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>

#include <algorithm>

namespace CGAL::Surface_mesh_parameterization::internal {

// The rows of a prolongation that the coarse grid does not have, for loops that add to the coarse rows in their columns.
class New_rows_by_part
{
public:
  // `fine_rows`: in as many parts as the coarse grid has
  New_rows_by_part(const Pruned_prolongation& prolongation, Row_parts fine_rows)
    : m_first(Index(prolongation.coarse_size())), m_rows(std::move(fine_rows)),
      m_split_rows(m_rows.number_of_parts(), [&](const auto& add) {
        for (Index part = 0; part < m_rows.number_of_parts(); ++part)
          for_each_new_row(part, [&](Index row) {
            if (!is_inside(part, prolongation.new_row(row)))
              add(part, row);
          });
      })
  { }

  // Calls f(row) for all: by several threads for those whose columns are in one part, and then for the others.
  template <class Function>
  void for_each(const Loops& loops, const Function& f) const
  {
    m_rows.for_each(loops, [&](Index part) {
      auto next_split_row = m_split_rows[part].begin();
      for_each_new_row(part, [&](Index row) {
        if (next_split_row != m_split_rows[part].end() && row == *next_split_row)
          ++next_split_row;
        else
          f(row);
      });
    });
    for (const Index row : m_split_rows.items())
      f(row);
  }

private:
  template <class Function>
  void for_each_new_row(Index part, const Function& f) const
  {
    m_rows.for_each_row(part, [&](Index row) {
      if (row >= m_first)
        f(row);
    });
  }

  bool is_inside(Index part, const Pruned_prolongation::Row& row) const
  {
    return std::all_of(row.columns.begin(), row.columns.end(),
                       [&](Index column) { return m_rows.part_of(column) == part; });
  }

  Index m_first;
  Row_parts m_rows;
  Compressed_lists<Index> m_split_rows;      // of each part
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_NEW_ROWS_BY_PART_H
