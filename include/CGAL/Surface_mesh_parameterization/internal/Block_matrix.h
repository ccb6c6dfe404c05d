// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BLOCK_MATRIX_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BLOCK_MATRIX_H

#include <CGAL/Surface_mesh_parameterization/internal/flat_types.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

typedef std::array<double, 2>   Pair;
typedef std::vector<Pair>       Pair_vector;

// A symmetric sparse matrix of 2x2 blocks, by rows, scaled so that every diagonal block has the trace 2. In double precision: an almost conformal map
// can be changed into another one at a cost of 1e-9 of the diagonal, which single precision does not see, and Newton's method stalls.
//
// The unscaled matrix is S^-1 A S^-1, with one factor `scale[i]` for each block row in S.
struct Block_matrix
{
  typedef std::array<double, 4>              Block;            // xx, xy, yx, yy
  typedef std::array<double, 3>              Symmetric_block;  // xx, xy, yy

  // The pattern: the columns of row i, but for the diagonal, are columns[first[i]] .. columns[first[i+1] - 1]. Kept by whoever made it.
  const Index* first = nullptr;
  const Index* columns = nullptr;

  std::vector<Block> blocks;                 // in the order of the columns
  std::vector<Symmetric_block> diagonal, inverse_diagonal;
  std::vector<double> scale;

  std::size_t number_of_rows() const { return diagonal.size(); }

  void set_pattern(std::size_t number_of_rows, const Index* first_, const Index* columns_)
  {
    first = first_;
    columns = columns_;
    diagonal.resize(number_of_rows);
    inverse_diagonal.resize(number_of_rows);
    scale.resize(number_of_rows);
    blocks.resize(first[number_of_rows]);
  }

  // Takes the diagonal block of row i, unscaled, and fixes the row's scale. A block that is hardly definite is shifted by a small multiple of
  // its own trace.
  void set_diagonal(Index i, double xx, double xy, double yy)
  {
    constexpr double least_relative_determinant = 1e-4, relative_shift = 1e-2;
    const double half_trace = 0.5 * (xx + yy);
    const double factor = half_trace > 0 ? 1 / half_trace : 1;
    xx *= factor;
    xy *= factor;
    yy *= factor;
    scale[i] = std::sqrt(factor);
    diagonal[i] = { xx, xy, yy };
    double determinant = xx * yy - xy * xy;
    if (!(determinant > least_relative_determinant)) {
      xx += relative_shift;
      yy += relative_shift;
      determinant = xx * yy - xy * xy;
    }
    inverse_diagonal[i] = { yy / determinant, -xy / determinant, xx / determinant };
  }

  // Scales the blocks beside the diagonal, when all scales are fixed.
  void scale_blocks()
  {
    for (Index i = 0; i < number_of_rows(); ++i)
      for (Index k = first[i]; k < first[i + 1]; ++k)
        for (double& entry : blocks[k])
          entry *= scale[i] * scale[columns[k]];
  }

  // A x, row i
  Pair row_times(Index i, const Pair_vector& x) const
  {
    const Symmetric_block& d = diagonal[i];
    Pair sum = { d[0] * x[i][0] + d[1] * x[i][1], d[1] * x[i][0] + d[2] * x[i][1] };
    add_off_diagonal(i, x, 1, sum);
    return sum;
  }

  // One block Gauss-Seidel step on row i of A x = b.
  void relax_row(Index i, const Pair_vector& b, Pair_vector& x) const
  {
    Pair r = b[i];
    add_off_diagonal(i, x, -1, r);
    const Symmetric_block& d = inverse_diagonal[i];
    x[i] = { d[0] * r[0] + d[1] * r[1], d[1] * r[0] + d[2] * r[1] };
  }

  void relax_forward(const Pair_vector& b, Pair_vector& x) const
  {
    for (Index i = 0; i < number_of_rows(); ++i)
      relax_row(i, b, x);
  }

  void relax_backward(const Pair_vector& b, Pair_vector& x) const
  {
    for (Index i = Index(number_of_rows()); i-- > 0;)
      relax_row(i, b, x);
  }

private:
  void add_off_diagonal(Index i, const Pair_vector& x, double sign, Pair& sum) const
  {
    double sx = 0, sy = 0;
    for (Index k = first[i]; k < first[i + 1]; ++k) {
      const Block& a = blocks[k];
      const Pair& y = x[columns[k]];
      sx += a[0] * y[0] + a[1] * y[1];
      sy += a[2] * y[0] + a[3] * y[1];
    }
    sum[0] += sign * sx;
    sum[1] += sign * sy;
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BLOCK_MATRIX_H
