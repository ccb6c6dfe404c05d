// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_GALERKIN_PRODUCT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_GALERKIN_PRODUCT_H

#include <CGAL/Surface_mesh_parameterization/internal/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/Pruned_prolongation.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The Galerkin operator P^T A P of a block matrix. Its pattern is found once; then it is computed for any values of A.
class Galerkin_product
{
public:
  Galerkin_product(const Block_matrix& fine, const Pruned_prolongation& prolongation)
    : m_prolongation(prolongation), m_position(prolongation.coarse_size(), no_index)
  {
    m_first.push_back(0);
    for (Index row = 0; row < prolongation.coarse_size(); ++row) {
      m_position[row] = 0;    // the diagonal is not stored
      for_each_fine_row(row, [&](Index i, double) {
        for_each_column(i, 1, [&](Index column, double) { add_column(column); });
        for (Index k = fine.first[i]; k < fine.first[i + 1]; ++k)
          for_each_column(fine.columns[k], 1, [&](Index column, double) { add_column(column); });
      });
      m_position[row] = no_index;
      for (Index k = m_first.back(); k < m_columns.size(); ++k)
        m_position[m_columns[k]] = no_index;
      m_first.push_back(Index(m_columns.size()));
    }
    m_columns.shrink_to_fit();
  }

  Galerkin_product(const Galerkin_product&) = delete;

  // Makes `coarse` the product, with this object's pattern, which must outlive it.
  void compute(const Block_matrix& fine, Block_matrix& coarse)
  {
    coarse.set_pattern(m_prolongation.coarse_size(), m_first.data(), m_columns.data());
    for (Index row = 0; row < m_prolongation.coarse_size(); ++row) {
      m_position[row] = 0;
      m_sums.assign(m_first[row + 1] - m_first[row] + 1, Block_matrix::Block{ 0, 0, 0, 0 });
      for (Index k = m_first[row]; k < m_first[row + 1]; ++k)
        m_position[m_columns[k]] = k - m_first[row] + 1;

      for_each_fine_row(row, [&](Index i, double weight) {
        const double row_weight = weight / fine.scale[i];
        const Block_matrix::Symmetric_block& d = fine.diagonal[i];
        for_each_column(i, row_weight / fine.scale[i], [&](Index column, double w) { add(m_sums[m_position[column]], w, d[0], d[1], d[1], d[2]); });
        for (Index k = fine.first[i]; k < fine.first[i + 1]; ++k) {
          const Block_matrix::Block& a = fine.blocks[k];
          for_each_column(fine.columns[k], row_weight / fine.scale[fine.columns[k]],
                          [&](Index column, double w) { add(m_sums[m_position[column]], w, a[0], a[1], a[2], a[3]); });
        }
      });
      coarse.set_diagonal(row, m_sums[0][0], 0.5 * (m_sums[0][1] + m_sums[0][2]), m_sums[0][3]);
      for (Index k = m_first[row]; k < m_first[row + 1]; ++k) {
        coarse.blocks[k] = m_sums[k - m_first[row] + 1];
        m_position[m_columns[k]] = no_index;
      }
      m_position[row] = no_index;
    }
    coarse.scale_blocks();
  }

private:
  static void add(Block_matrix::Block& sum, double w, double xx, double xy, double yx, double yy)
  {
    sum[0] += w * xx;
    sum[1] += w * xy;
    sum[2] += w * yx;
    sum[3] += w * yy;
  }

  void add_column(Index column)
  {
    if (m_position[column] == no_index) {
      m_position[column] = 0;
      m_columns.push_back(column);
    }
  }

  // The rows of P in which a coarse vertex has a weight, and that weight.
  template <class Function>
  void for_each_fine_row(Index coarse_vertex, const Function& f) const
  {
    f(coarse_vertex, 1.);
    for (const auto* e = m_prolongation.column_begin(coarse_vertex); e != m_prolongation.column_end(coarse_vertex); ++e)
      f(e->row, e->weight);
  }

  // The columns of P's row j, and their weights times a factor.
  template <class Function>
  void for_each_column(Index j, double factor, const Function& f) const
  {
    if (j < m_prolongation.coarse_size())
      f(j, factor);
    else {
      const Pruned_prolongation::Row& row = m_prolongation.row(j);
      for (int k = 0; k < Pruned_prolongation::row_size && row.weights[k] != 0; ++k)
        f(row.columns[k], factor * row.weights[k]);
    }
  }

  const Pruned_prolongation& m_prolongation;
  std::vector<Index> m_first, m_columns;
  std::vector<Index> m_position;      // scratch: of a column in the current row
  std::vector<Block_matrix::Block> m_sums;    // scratch: the current row, its diagonal first
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_GALERKIN_PRODUCT_H
