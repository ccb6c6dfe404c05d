// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_RIGHT_BLOCKS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_RIGHT_BLOCKS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Where the blocks right of the diagonal of a Block_matrix stand, row by row: for what needs whole rows.
class Right_blocks
{
public:
  struct Entry { Index column, position; };       // the block is the transpose of blocks[position]

  explicit Right_blocks(const Block_matrix& matrix) : m_end(matrix.number_of_rows() + 1, 0)
  {
    const Index n = matrix.number_of_rows(), size = matrix.first[n];
    for (Index k = 0; k < size; ++k)
      ++m_end[matrix.columns[k] + 1];
    for (Index i = 0; i < n; ++i)
      m_end[i + 1] += m_end[i];
    m_entries.resize(size);
    for (Index i = 0; i < n; ++i)
      for (Index k = matrix.first[i]; k < matrix.first[i + 1]; ++k)
        m_entries[m_end[matrix.columns[k]]++] = { i, k };
  }

  // Those of row i, their columns ascending.
  const Entry* begin(Index i) const { return m_entries.data() + (i == 0 ? 0 : m_end[i - 1]); }
  const Entry* end(Index i) const { return m_entries.data() + m_end[i]; }

private:
  std::vector<Index> m_end;
  std::vector<Entry> m_entries;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_RIGHT_BLOCKS_H
