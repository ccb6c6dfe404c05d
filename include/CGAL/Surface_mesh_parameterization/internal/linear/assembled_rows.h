// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_ASSEMBLED_ROWS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_ASSEMBLED_ROWS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The matrix of a system that has `components` unknowns for each of n vertices, made in place. Each row of vertex v has
// `size_of(v)` entries, its columns all different; `fill(v, rows)` adds them to the empty rows, in any order.
template <std::size_t components, class Size, class Fill>
Sparse_rows<double> assembled_rows(Index n, const Size& size_of, const Fill& fill, const Loops& loops)
{
  Sparse_rows<double> result;
  std::vector<Index>& first = result.first;
  first.resize(components * std::size_t(n) + 1);
  loops.for_each(0, n, [&](Index v) { std::fill_n(first.begin() + 1 + components * v, components, size_of(v)); });
  std::size_t entries = 0;
  for (Index& size_or_end : first)
    size_or_end = Sparse_rows<double>::checked_end(entries += size_or_end);
  result.columns.resize(entries);
  result.values.resize(entries);

  typedef std::array<Sparse_row, components>   Rows;
  loops.for_each_block_with_scratch(0, n, [] { return Rows(); }, [&](Index begin, Index end, Rows& rows) {
    for (Index v = begin; v < end; ++v) {
      for (Sparse_row& row : rows)
        row.clear();
      fill(v, rows);
      for (std::size_t c = 0; c < components; ++c) {
        Index k = first[components * v + c];
        CGAL_assertion(first[components * v + c + 1] - k == rows[c].size());
        std::sort(rows[c].begin(), rows[c].end());
        for (const auto& [column, value] : rows[c]) {
          result.columns[k] = column;
          result.values[k++] = value;
        }
      }
    }
  });
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_ASSEMBLED_ROWS_H
