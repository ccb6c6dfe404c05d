// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_GALERKIN_PRODUCT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_GALERKIN_PRODUCT_H

#include <CGAL/Surface_mesh_parameterization/internal/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/Pruned_prolongation.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The Galerkin operator P^T A P of a block matrix. Its pattern is found once; then it is computed for any values of A.
class Galerkin_product
{
public:
  // `order` holds the coarse rows in an order in which neighbors are close to each other: they share what is fetched into the cache.
  Galerkin_product(const Block_matrix& fine, const Pruned_prolongation& prolongation, std::vector<Index> order, const Loops& loops)
    : m_prolongation(prolongation), m_order(std::move(order))
  {
    // Twice: to count the columns, and to store them.
    m_first.assign(m_order.size() + 1, 0);
    find_columns(fine, loops, [&](Index row, const std::vector<Index>& columns) { m_first[row + 1] = Index(columns.size()); });
    for (std::size_t row = 0; row < m_order.size(); ++row)
      m_first[row + 1] += m_first[row];
    m_columns.resize(m_first.back());
    find_columns(fine, loops, [&](Index row, const std::vector<Index>& columns) { std::copy(columns.begin(), columns.end(), m_columns.begin() + m_first[row]); });
  }

  Galerkin_product(const Galerkin_product&) = delete;

  // Makes `coarse` the product, with this object's pattern, which must outlive it. Both matrices: the blocks beside the diagonal not yet scaled.
  void compute(const Block_matrix& fine, Block_matrix& coarse, const Loops& loops) const
  {
    const Index n = Index(m_order.size());
    coarse.set_pattern(n, m_first.data(), m_columns.data());
    loops.for_each_block(0, n, [n] { return Scratch{ std::vector<Index>(n), {} }; }, [&](Index begin, Index end, Scratch& scratch) {
      for (Index k = begin; k < end; ++k)
        compute_row(fine, m_order[k], coarse, scratch);
    });
  }

private:
  typedef Block_matrix::Block   Block;

  struct Scratch
  {
    std::vector<Index> position;     // of a column in the current row; the diagonal is at 0
    std::vector<Block> sums;         // the current row
  };

  // Calls f(row, columns) for every row; the diagonal is not among its columns.
  template <class Function>
  void find_columns(const Block_matrix& fine, const Loops& loops, const Function& f) const
  {
    struct Columns { std::vector<Index> columns; std::vector<unsigned char> is_found; };
    const Index n = Index(m_order.size());
    loops.for_each_block(0, n, [n] { return Columns{ {}, std::vector<unsigned char>(n, 0) }; }, [&](Index begin, Index end, Columns& scratch) {
      auto& [columns, is_found] = scratch;
      for (Index k = begin; k < end; ++k) {
        const Index row = m_order[k];
        columns.clear();
        is_found[row] = 1;
        for (const auto* e = m_prolongation.column_begin(row); e != m_prolongation.column_end(row); ++e) {
          add_columns(e->row, columns, is_found);
          for (Index l = fine.first[e->row]; l < fine.first[e->row + 1]; ++l)
            add_columns(fine.columns[l], columns, is_found);
        }
        is_found[row] = 0;
        for (const Index column : columns)
          is_found[column] = 0;
        f(row, columns);
      }
    });
  }

  void add_columns(Index j, std::vector<Index>& columns, std::vector<unsigned char>& is_found) const
  {
    for (const Index column : m_prolongation.row(j).columns)
      if (!is_found[column]) {
        is_found[column] = 1;
        columns.push_back(column);
      }
  }

  void compute_row(const Block_matrix& fine, Index row, Block_matrix& coarse, Scratch& scratch) const
  {
    auto& [position, sums] = scratch;
    position[row] = 0;
    for (Index k = m_first[row]; k < m_first[row + 1]; ++k)
      position[m_columns[k]] = k - m_first[row] + 1;
    sums.assign(m_first[row + 1] - m_first[row] + 1, Block::Zero());

    for (const auto* e = m_prolongation.column_begin(row); e != m_prolongation.column_end(row); ++e) {
      const Index i = e->row;
      add(m_prolongation.row(i), e->weight * fine.unscaled_diagonal_block(i), scratch);
      for (Index k = fine.first[i]; k < fine.first[i + 1]; ++k)
        add(m_prolongation.row(fine.columns[k]), e->weight * fine.blocks[k], scratch);
    }
    coarse.set_diagonal(row, sums[0]);
    std::copy(sums.begin() + 1, sums.end(), coarse.blocks.begin() + m_first[row]);
  }

  // No branch for weights that are 0: the processor would guess it wrong.
  static void add(const Pruned_prolongation::Row& row, const Block& block, Scratch& scratch)
  {
    for (int k = 0; k < Pruned_prolongation::row_size; ++k)
      scratch.sums[scratch.position[row.columns[k]]] += double(row.weights[k]) * block;
  }

  const Pruned_prolongation& m_prolongation;
  std::vector<Index> m_order, m_first, m_columns;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_GALERKIN_PRODUCT_H
