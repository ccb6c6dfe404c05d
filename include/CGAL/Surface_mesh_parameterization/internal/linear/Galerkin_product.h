// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GALERKIN_PRODUCT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GALERKIN_PRODUCT_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Pruned_prolongation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_pattern.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Right_blocks.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The Galerkin operator P^T A P of a block matrix, for any values of A with one pattern.
class Galerkin_product
{
public:
  // `order` holds the coarse rows in an order in which neighbors are close to each other: they share what is fetched
  // into the cache.
  Galerkin_product(const Pruned_prolongation& prolongation, Row_parts coarse_parts, std::vector<Index> order)
    : m_prolongation(prolongation), m_order(std::move(order)), m_pattern(std::move(coarse_parts))
  { }

  Galerkin_product(const Galerkin_product&) = delete;

  // Makes `coarse` the product, with this object's pattern, which must outlive it. Both matrices: the blocks beside the
  // diagonal not yet scaled.
  void compute(const Block_matrix& fine, Block_matrix& coarse, const Loops& loops)
  {
    const Factors factors{ m_prolongation, m_prolongation.transposed(), fine, right_blocks(fine) };
    const bool is_first_product = m_pattern.first.empty();
    if (is_first_product)
      count_blocks(factors, loops);
    coarse.set_pattern(m_pattern);
    for_each_row(loops, [&](Index row, Scratch& scratch) { compute_row(factors, row, coarse, scratch); });
    if (is_first_product)
      m_pattern.find_joints();
  }

private:
  // The current row: its columns in the order in which they were found, the diagonal first.
  struct Scratch
  {
    std::vector<Index> columns;
    std::vector<Block> sums;
    std::vector<Index> position;     // of a column among them, no_index if it was not found yet

    void begin(Index row)
    {
      columns.clear();
      sums.clear();
      position_of(row);
    }

    Index position_of(Index column)
    {
      Index& p = position[column];
      if (p == no_index) {
        p = Index(columns.size());
        columns.push_back(column);
        sums.push_back(Block::zero());
      }
      return p;
    }

    void end()
    {
      for (const Index column : columns)
        position[column] = no_index;
    }
  };

  template <class Function>
  void for_each_row(const Loops& loops, const Function& f) const
  {
    const Index n = Index(m_order.size());
    loops.for_each_block_with_scratch(
        0, n,
        [n] {
          return Scratch{ {}, {}, std::vector<Index>(n, no_index) };
        },
        [&](Index begin, Index end, Scratch& scratch) {
          for (Index k = begin; k < end; ++k) {
            scratch.begin(m_order[k]);
            f(m_order[k], scratch);
            scratch.end();
          }
        });
  }

  // P and A by whole columns and rows; that takes memory, and is made for each product.
  struct Factors
  {
    const Pruned_prolongation& prolongation;
    Pruned_prolongation::Transpose transpose;
    const Block_matrix& matrix;
    Right_blocks right;

    // Calls f(prolongation.row(k), w a_ik) for every weight w = p_ij and column k, for row j of P^T A P.
    template <class Function>
    void for_each_product(Index row, const Function& f) const
    {
      for (const auto& [i, weight] : transpose[row]) {
        f(prolongation.row(i), double(weight) * matrix.unscaled_diagonal_block(i));
        for (Index k = matrix.first[i]; k < matrix.first[i + 1]; ++k)
          f(prolongation.row(matrix.columns[k]), double(weight) * matrix.blocks[k]);
        for (const Right_block& b : right[i])
          f(prolongation.row(b.column), double(weight) * transposed(matrix.blocks[b.position]));
      }
    }
  };

  void count_blocks(const Factors& factors, const Loops& loops)
  {
    std::vector<Index>&first = m_pattern.first, &first_joint = m_pattern.first_joint;
    first.assign(m_order.size() + 1, 0);
    first_joint.assign(m_order.size(), 0);
    for_each_row(loops, [&](Index row, Scratch& scratch) {
      factors.for_each_product(row, [&](const Pruned_prolongation::Row& p, const Block&) {
        for (const Index column : p.columns)
          scratch.position_of(column);
      });
      for (const Index column : scratch.columns)
        if (column < row) {
          ++first[row + 1];
          first_joint[row] += joins_parts(row, column) ? 0 : 1;
        }
    });
    for (std::size_t row = 0; row < m_order.size(); ++row) {
      first[row + 1] += first[row];
      first_joint[row] += first[row];
    }
    m_pattern.columns.resize(first.back());
  }

  bool joins_parts(Index row, Index column) const
  {
    return m_pattern.parts.part_of(row) != m_pattern.parts.part_of(column);
  }

  void compute_row(const Factors& factors, Index row, Block_matrix& coarse, Scratch& scratch)
  {
    factors.for_each_product(
        row, [&](const Pruned_prolongation::Row& p, const Block& block) { add(p, block, scratch); });
    coarse.set_diagonal(row, scratch.sums[0]);
    const bool has_joint = m_pattern.has_joint(row);
    Index next = m_pattern.first[row], next_joint = m_pattern.first_joint[row];
    for (std::size_t i = 1; i < scratch.columns.size(); ++i)
      if (const Index column = scratch.columns[i]; column < row) {
        const Index k = has_joint && joins_parts(row, column) ? next_joint++ : next++;
        m_pattern.columns[k] = column;
        coarse.blocks[k] = scratch.sums[i];
      }
  }

  // No branch for weights that are 0: the processor would guess it wrong.
  static void add(const Pruned_prolongation::Row& row, const Block& block, Scratch& scratch)
  {
    for (int k = 0; k < Pruned_prolongation::row_size; ++k)
      scratch.sums[scratch.position_of(row.columns[k])] += double(row.weights[k]) * block;
  }

  const Pruned_prolongation& m_prolongation;
  std::vector<Index> m_order;
  Block_pattern m_pattern;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GALERKIN_PRODUCT_H
