// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GROUPED_ROWS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GROUPED_ROWS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Right_blocks.h>

#include <boost/range/adaptor/reversed.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The loops of a Block_matrix by several threads, where the rows of a group are not joined with each other. What the
// rows below add to a row, it gathers itself, in the same order: so the results are the same bytes. For that it has
// copies of the blocks right of the diagonal, in the order in which they are read: fetched one by one from the rows
// below, they would take twice as long.
class Grouped_rows
{
public:
  // The matrix is kept by reference, with its pattern. `group_ends`: see can_be_grouped().
  Grouped_rows(const Block_matrix& matrix, std::vector<Index> group_ends, const Loops& loops)
    : m_matrix(matrix), m_group_ends(std::move(group_ends)), m_loops(loops), m_right(right_blocks(matrix))
  {
    copy_blocks();
  }

  // To be called when the matrix has got other values.
  void copy_blocks()
  {
    m_blocks.resize(m_matrix.blocks.size());
    m_loops.for_each(0, Index(m_blocks.size()),
                     [&](Index k) { m_blocks[k] = m_matrix.blocks[m_right.items()[k].position]; });
  }

  // Whether no two rows of a group are joined; of the first group, they may be.
  static bool can_be_grouped(const Block_matrix& matrix, const std::vector<Index>& group_ends)
  {
    for (std::size_t g = 1; g < group_ends.size(); ++g)
      for (Index k = matrix.first[group_ends[g - 1]]; k < matrix.first[group_ends[g]]; ++k)
        if (matrix.columns[k] >= group_ends[g - 1])
          return false;
    return true;
  }

  void multiply(const Block_vectors& x, Block_vectors& y) const
  {
    m_loops.for_each(0, m_matrix.number_of_rows(), [&](Index i) {
      y[i] = m_matrix.diagonal_and_left_times(i, x);
      add_right_times(i, x, y[i]);
    });
  }

  void relax_forward(const Block_vectors& b, bool is_last, Block_vectors& x, Block_vectors& right) const
  {
    for (std::size_t g = 0; g < m_group_ends.size(); ++g)
      loops_of_group(g).for_each(group_begin(g), m_group_ends[g],
                                 [&](Index i) { m_matrix.relax_row_forward(i, b, is_last, x, right); });
    m_loops.for_each(0, m_matrix.number_of_rows(), [&](Index i) { add_right_times(i, x, right[i]); });
  }

  void relax_backward(const Block_vectors& b, Block_vectors& x, Block_vectors& right) const
  {
    const auto relax = [&](Index i) {
      for (const Right_block& b : boost::adaptors::reverse(m_right[i]))
        right[i] += transposed_times(copy_of(b), x[b.column]);
      m_matrix.relax_row_backward(i, b, x, right);
    };
    for (std::size_t g = m_group_ends.size(); g-- > 1;)
      m_loops.for_each(m_group_ends[g - 1], m_group_ends[g], relax);
    for (Index i = m_group_ends[0]; i-- > 0;)
      relax(i);
  }

private:
  const Block& copy_of(const Right_block& b) const { return m_blocks[&b - m_right.items().data()]; }

  Index group_begin(std::size_t g) const { return g == 0 ? 0 : m_group_ends[g - 1]; }
  Loops loops_of_group(std::size_t g) const { return g == 0 ? Loops() : m_loops; }

  // Adds to `y` what the rows below contribute to row i of A x, from the first one on.
  void add_right_times(Index i, const Block_vectors& x, Block_vector& y) const
  {
    for (const Right_block& b : m_right[i])
      y += transposed_times(copy_of(b), x[b.column]);
  }

  const Block_matrix& m_matrix;
  std::vector<Index> m_group_ends;
  Loops m_loops;
  Right_blocks m_right;
  std::vector<Block> m_blocks;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GROUPED_ROWS_H
