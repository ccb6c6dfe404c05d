// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GALERKIN_PRODUCT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GALERKIN_PRODUCT_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Pruned_prolongation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The Galerkin operator P^T A P of a block matrix. What is fixed by its pattern is found once; then it is computed for
// any values of A.
class Galerkin_product
{
public:
  // `order` holds the coarse rows in an order in which neighbors are close to each other: they share what is fetched
  // into the cache.
  Galerkin_product(const Block_matrix& fine, const Pruned_prolongation& prolongation, std::vector<Index> order,
                   const Loops& loops)
    : m_prolongation(prolongation), m_order(std::move(order))
  {
    m_first.assign(m_order.size() + 1, 0);
    for_each_row(loops, [&](Index row, Scratch& scratch) { m_first[row + 1] = count_columns(fine, row, scratch); });
    for (std::size_t row = 0; row < m_order.size(); ++row)
      m_first[row + 1] += m_first[row];
    m_columns.resize(m_first.back());
  }

  Galerkin_product(const Galerkin_product&) = delete;

  // Makes `coarse` the product, with this object's pattern, which must outlive it. Both matrices: the blocks beside the
  // diagonal not yet scaled.
  void compute(const Block_matrix& fine, Block_matrix& coarse, const Loops& loops)
  {
    coarse.set_pattern(m_order.size(), m_first.data(), m_columns.data());
    for_each_row(loops, [&](Index row, Scratch& scratch) { compute_row(fine, row, coarse, scratch); });
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

  // But for the diagonal.
  Index count_columns(const Block_matrix& fine, Index row, Scratch& scratch) const
  {
    const auto find = [&](Index i) {
      for (const Index column : m_prolongation.row(i).columns)
        scratch.position_of(column);
    };
    for (const auto* e = m_prolongation.column_begin(row); e != m_prolongation.column_end(row); ++e) {
      find(e->row);
      for (Index k = fine.first[e->row]; k < fine.first[e->row + 1]; ++k)
        find(fine.columns[k]);
    }
    return Index(scratch.columns.size() - 1);
  }

  void compute_row(const Block_matrix& fine, Index row, Block_matrix& coarse, Scratch& scratch)
  {
    for (const auto* e = m_prolongation.column_begin(row); e != m_prolongation.column_end(row); ++e) {
      const Index i = e->row;
      add(m_prolongation.row(i), e->weight * fine.unscaled_diagonal_block(i), scratch);
      for (Index k = fine.first[i]; k < fine.first[i + 1]; ++k)
        add(m_prolongation.row(fine.columns[k]), e->weight * fine.blocks[k], scratch);
    }
    coarse.set_diagonal(row, scratch.sums[0]);
    std::copy(scratch.sums.begin() + 1, scratch.sums.end(), coarse.blocks.begin() + m_first[row]);
    std::copy(scratch.columns.begin() + 1, scratch.columns.end(), m_columns.begin() + m_first[row]);
  }

  // No branch for weights that are 0: the processor would guess it wrong.
  static void add(const Pruned_prolongation::Row& row, const Block& block, Scratch& scratch)
  {
    for (int k = 0; k < Pruned_prolongation::row_size; ++k)
      scratch.sums[scratch.position_of(row.columns[k])] += double(row.weights[k]) * block;
  }

  const Pruned_prolongation& m_prolongation;
  std::vector<Index> m_order, m_first, m_columns;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GALERKIN_PRODUCT_H
