// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_BLOCK_MATRIX_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_BLOCK_MATRIX_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/prefetch.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A symmetric sparse matrix of 2x2 blocks, by rows, scaled so that every diagonal block has the trace 2. In double
// precision: an almost conformal map can be changed into another one at a cost of 1e-9 of the diagonal, which single
// precision does not see, and Newton's method stalls.
//
// The unscaled matrix is S^-1 A S^-1, with one factor `scale[i]` for each block row in S.
struct Block_matrix
{
  // The pattern: the columns of row i, but for the diagonal, are columns[first[i]] .. columns[first[i+1] - 1]. Kept by
  // whoever made it.
  const Index* first = nullptr;
  const Index* columns = nullptr;

  std::vector<Block> blocks;                 // in the order of the columns
  Block_vectors diagonal;                    // (a, b) for the block (1 + a, b; b, 1 - a)
  std::vector<double> scale;

  Index number_of_rows() const { return Index(diagonal.size()); }

  void set_pattern(std::size_t number_of_rows, const Index* first_, const Index* columns_)
  {
    first = first_;
    columns = columns_;
    diagonal.resize(number_of_rows);
    scale.resize(number_of_rows);
    blocks.resize(first[number_of_rows]);
  }

  // Takes the diagonal block of row i, unscaled, and fixes the row's scale.
  void set_diagonal(Index i, const Block& block)
  {
    const double half_trace = 0.5 * (block.xx() + block.yy());
    const double factor = half_trace > 0 ? 1 / half_trace : 1;
    scale[i] = std::sqrt(factor);
    diagonal[i] = 0.5 * factor * Block_vector(block.xx() - block.yy(), block.xy() + block.yx());
  }

  Block diagonal_block(Index i) const
  {
    return Block(1 + diagonal[i].x, diagonal[i].y, diagonal[i].y, 1 - diagonal[i].x);
  }
  Block unscaled_diagonal_block(Index i) const { return diagonal_block(i) / (scale[i] * scale[i]); }

  // The block of row i and column j, which have to be joined.
  Block& block(Index i, Index j)
  {
    return blocks[std::find(columns + first[i], columns + first[i + 1], j) - columns];
  }

  // Scales the blocks beside the diagonal, when all scales are fixed.
  void scale_blocks(const Loops& loops)
  {
    loops.for_each(0, number_of_rows(), [&](Index i) {
      for (Index k = first[i]; k < first[i + 1]; ++k)
        blocks[k] *= scale[i] * scale[columns[k]];
    });
  }

  // A x, row i
  Block_vector row_times(Index i, const Block_vectors& x) const
  {
    const Block_vector &d = diagonal[i], &y = x[i];
    return Block_vector(y.x + d.x * y.x + d.y * y.y, y.y + d.y * y.x - d.x * y.y) + off_diagonal_times(i, x);
  }

  // One Gauss-Seidel step for A x = b on each row of a range, one after the other or the other way around.
  void relax_forward(Index begin, Index end, const Block_vectors& b, Block_vectors& x) const
  {
    for (Index i = begin; i < end; ++i)
      x[i] = relaxed_row(i, b, x);
  }

  void relax_backward(Index begin, Index end, const Block_vectors& b, Block_vectors& x) const
  {
    for (Index i = end; i-- > begin;)
      x[i] = relaxed_row(i, b, x);
  }

  // The same on all rows of a range at once: a Jacobi step where they are joined.
  void relax_at_once(const Loops& loops, Index begin, Index end, const Block_vectors& b, Block_vectors& x,
                     Block_vectors& scratch) const
  {
    scratch.resize(number_of_rows());
    loops.for_each(begin, end, [&](Index i) { scratch[i] = relaxed_row(i, b, x); });
    loops.for_each(begin, end, [&](Index i) { x[i] = scratch[i]; });
  }

private:
  // What x[i] has to be to satisfy row i. A diagonal block that is hardly definite is shifted by a small multiple of
  // its trace.
  Block_vector relaxed_row(Index i, const Block_vectors& b, const Block_vectors& x) const
  {
    constexpr double least_determinant = 1e-4, shift = 1e-2;
    const Block_vector &d = diagonal[i], r = b[i] - off_diagonal_times(i, x);
    const double radius2 = inner_product(d, d), one = 1 - radius2 > least_determinant ? 1 : 1 + shift;
    return Block_vector((one - d.x) * r.x - d.y * r.y, (one + d.x) * r.y - d.y * r.x) / (one * one - radius2);
  }

  Block_vector off_diagonal_times(Index i, const Block_vectors& x) const
  {
    Block_vector sum0(0, 0), sum1(0, 0);      // two chains of additions, which the processor interleaves
    for (Index k = first[i]; k < first[i + 1]; ++k) {
      prefetch_element_after(k, columns, blocks.size(), x);
      const Block_vector& y = x[columns[k]];
      sum0 += y.x * blocks[k].columns[0];
      sum1 += y.y * blocks[k].columns[1];
    }
    return sum0 + sum1;
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_BLOCK_MATRIX_H
