// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_RIGHT_BLOCKS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_RIGHT_BLOCKS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>

namespace CGAL::Surface_mesh_parameterization::internal {

// A block right of the diagonal: the transpose of blocks[position].
struct Right_block { Index column, position; };

// Those of every row, their columns ascending: for what needs whole rows.
typedef Compressed_lists<Right_block>   Right_blocks;

inline Right_blocks right_blocks(const Block_matrix& matrix)
{
  return Right_blocks(matrix.number_of_rows(), [&](const auto& add) {
    for (Index i = 0; i < matrix.number_of_rows(); ++i)
      for (Index k = matrix.first[i]; k < matrix.first[i + 1]; ++k)
        add(matrix.columns[k], Right_block{ i, k });
  });
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_RIGHT_BLOCKS_H
