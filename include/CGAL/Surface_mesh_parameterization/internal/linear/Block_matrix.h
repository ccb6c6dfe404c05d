// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_BLOCK_MATRIX_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_BLOCK_MATRIX_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/prefetch.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_pattern.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A symmetric sparse matrix of 2x2 blocks, scaled so that every diagonal block has the trace 2. Each row is stored up
// to the diagonal only: what is right of it stands transposed in the rows below. So a loop over the rows reads every
// block once, takes it as the entry of its row, and adds what it contributes to the row above. That is inside a part of
// the pattern; blocks that join two parts come apart from the others, as each part sees them. So parts run side by
// side.
//
// In double precision: an almost conformal map can be changed into another one at a cost of 1e-9 of the diagonal, which
// single precision does not see. Newton's method stalls with such a matrix, and takes more cycles where only the coarse
// grids have one.
//
// The unscaled matrix is S^-1 A S^-1, with one factor `scale[i]` for each block row in S.
struct Block_matrix
{
  const Block_pattern* pattern = nullptr;    // kept by whoever made it
  const Index *first = nullptr, *first_joint = nullptr, *columns = nullptr;      // its arrays

  std::vector<Block> blocks;                 // in the order of the columns
  Block_vectors diagonal;                    // (a, b) for the block (1 + a, b; b, 1 - a)
  std::vector<double> scale;
  std::vector<float> damping;                // of the sweeps, see damp_joined_rows()

  Index number_of_rows() const { return Index(diagonal.size()); }
  const Row_parts& parts() const { return pattern->parts; }

  void set_pattern(const Block_pattern& pattern_)
  {
    pattern = &pattern_;
    first = pattern->first.data();
    first_joint = pattern->first_joint.data();
    columns = pattern->columns.data();
    diagonal.resize(pattern->number_of_rows());
    scale.resize(pattern->number_of_rows());
    blocks.resize(pattern->columns.size());
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

  // The block of row i and column j < i, which have to be joined.
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
    damp_joined_rows(loops);
  }

  // y := A x
  void multiply(const Block_vectors& x, Block_vectors& y, const Loops& loops) const
  {
    parts().for_each(loops, [&](Index part) {
      parts().for_each_row(part, [&](Index i) {
        y[i] = diagonal_times(i, x[i]) + left_times(i, x, first_joint[i]);
        add_right_times(i, x[i], y);
      });
      add_joints_times(part, x, y);
    });
  }

  // What row i contributes to x A x, where the rows above contribute nothing for it.
  double energy_of_row(Index i, const Block_vectors& x) const
  {
    return inner_product(x[i], diagonal_times(i, x[i]) + 2 * left_times(i, x, first[i + 1]));
  }

  // A sweep for A x = b: Gauss-Seidel over the rows of each part, one after the other, with what the other parts had
  // before it. The first one is from x = 0, whatever `x` holds. `right` holds what the blocks right of the diagonal
  // contribute to each row of A x, before the sweep and after it; that is inside a part. After the last one, it is
  // A x - b instead: a row knows the rest of it as soon as it is relaxed.
  void relax_forward(const Block_vectors& b, bool is_first, bool is_last, Block_vectors& x, Block_vectors& right,
                     const Loops& loops) const
  {
    if (!is_first)
      add_joints_times(x, right, loops);
    parts().for_each(loops, [&](Index part) {
      parts().for_each_row(part, [&](Index i) {
        const Block_vector r = b[i] - left_times(i, x, first_joint[i]);
        x[i] = relaxed(i, r - right[i], is_first ? Block_vector::zero() : x[i]);
        right[i] = is_last ? diagonal_times(i, x[i]) - r : Block_vector::zero();
        add_right_times(i, x[i], right);
      });
    });
    if (is_last)
      add_joints_times(x, right, loops);
  }

  // The same the other way around; `right` is 0 before and after.
  void relax_backward(const Block_vectors& b, Block_vectors& x, Block_vectors& right, const Loops& loops) const
  {
    add_joints_times(x, right, loops);
    parts().for_each(loops, [&](Index part) {
      parts().for_each_row_backward(part, [&](Index i) {
        prefetch_rows_before(i);
        x[i] = relaxed(i, b[i] - left_times(i, x, first_joint[i]) - right[i], x[i]);
        right[i] = Block_vector::zero();
        add_right_times(i, x[i], right);
      });
    });
  }

private:
  Block_vector diagonal_times(Index i, const Block_vector& y) const
  {
    const Block_vector& d = diagonal[i];
    return Block_vector(y.x + d.x * y.x + d.y * y.y, y.y + d.y * y.x - d.x * y.y);
  }

  // What x[i] has to be so that its diagonal block gives `r`; the damping holds it at its old place. A block that is
  // hardly definite is shifted by a small multiple of its trace.
  Block_vector relaxed(Index i, Block_vector r, const Block_vector& old) const
  {
    constexpr double least_determinant = 1e-4, shift = 1e-2;
    const Block_vector& d = diagonal[i];
    const double radius2 = inner_product(d, d), one = (1 - radius2 > least_determinant ? 1 : 1 + shift) + damping[i];
    r += double(damping[i]) * old;
    return Block_vector((one - d.x) * r.x - d.y * r.y, (one + d.x) * r.y - d.y * r.x) / (one * one - radius2);
  }

  // Adds a multiple of the identity to the diagonal blocks, for the sweeps only: half of the norms of what joins the
  // row to other parts. With D, L and J for the diagonal, what is left of it in the parts, and the joints, a cycle is
  // positive definite if the sum of D + L + damping and its transpose is greater than A, that is D + 2 damping > J.
  void damp_joined_rows(const Loops& loops)
  {
    damping.assign(number_of_rows(), 0);
    parts().for_each(loops, [&](Index part) {
      for (const Block_pattern::Joint& joint : pattern->joints[part])
        damping[joint.row] += float(0.5 * norm(blocks[joint.position]));
    });
  }

  // Adds to `y` what the blocks that join two parts contribute to A x.
  void add_joints_times(const Block_vectors& x, Block_vectors& y, const Loops& loops) const
  {
    parts().for_each(loops, [&](Index part) { add_joints_times(part, x, y); });
  }

  void add_joints_times(Index part, const Block_vectors& x, Block_vectors& y) const
  {
    for (const Block_pattern::Joint& joint : pattern->joints[part]) {
      const Block& block = blocks[joint.position];
      const Block_vector& other = x[joint.column];
      y[joint.row] += joint.row < joint.column ? transposed_times(block, other) : times(block, other);
    }
  }

  // What the blocks left of the diagonal, before the one at `end`, contribute to row i of A x.
  Block_vector left_times(Index i, const Block_vectors& x, Index end) const
  {
    Block_vector sum0(0, 0), sum1(0, 0);      // two chains of additions, which the processor interleaves
    for (Index k = first[i]; k < end; ++k) {
      const Block_vector& y = x[columns[k]];
      sum0 += y.x * blocks[k].columns[0];
      sum1 += y.y * blocks[k].columns[1];
    }
    return sum0 + sum1;
  }

  // Adds to `y` what the blocks of row i, transposed, contribute to the rows above in its part.
  void add_right_times(Index i, const Block_vector& x, Block_vectors& y) const
  {
    for (Index k = first[i]; k < first_joint[i]; ++k)
      y[columns[k]] += transposed_times(blocks[k], x);
  }

  // In a loop that goes down, at row i: asks for rows that are needed some rows later. A processor foresees what a loop
  // reads that goes up, less so rows that are read upward one below the other.
  BOOST_FORCEINLINE void prefetch_rows_before(Index i) const
  {
    constexpr std::size_t distance = 64;      // in blocks, two to each cache line
    if (first[i] < distance)
      return;
    prefetch(&blocks[first[i] - distance]);
    prefetch(&blocks[first[i] - distance + 2]);
    prefetch(&columns[first[i] - distance]);
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_BLOCK_MATRIX_H
