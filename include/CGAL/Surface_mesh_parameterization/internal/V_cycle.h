// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_V_CYCLE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_V_CYCLE_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/Galerkin_product.h>
#include <CGAL/Surface_mesh_parameterization/internal/Pruned_prolongation.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A symmetric multigrid V-cycle for a block matrix on a level: Galerkin operators over every fifth collapse group, two block Gauss-Seidel
// sweeps each way, a direct solution at the bottom. On a hierarchy of one level there is only that one.
class V_cycle
{
public:
  static constexpr std::size_t groups_per_grid = 5;
  static constexpr std::size_t coarsest_size = 1000;      // is solved directly

  explicit V_cycle(const Level& level)
  {
    m_grids.emplace_back();
    for (std::size_t fine = level.index(); fine > 0 && level.hierarchy().number_of_vertices(fine) > coarsest_size;) {
      const std::size_t coarse = fine > groups_per_grid ? fine - groups_per_grid : 0;
      m_grids.back().prolongation = std::make_unique<Pruned_prolongation>(level.hierarchy(), coarse, fine);
      m_grids.emplace_back();
      fine = coarse;
    }
  }

  // The matrix of the finest grid, to be filled in. The coarse grids are made from it by setup(); while it changes little they may stay as they are.
  Block_matrix& matrix() { return m_grids.front().matrix; }
  const Block_matrix& matrix() const { return m_grids.front().matrix; }

  void setup()
  {
    for (std::size_t g = 0; g + 1 < m_grids.size(); ++g) {
      Grid& grid = m_grids[g];
      if (!grid.galerkin_product)
        grid.galerkin_product = std::make_unique<Galerkin_product>(grid.matrix, *grid.prolongation);
      grid.galerkin_product->compute(grid.matrix, m_grids[g + 1].matrix);
    }
    for (Grid& grid : m_grids) {
      grid.solution.resize(grid.matrix.number_of_rows());
      if (&grid != &m_grids.front())
        grid.right_side.resize(grid.matrix.number_of_rows());
    }
    factorize();
  }

  // Whether the direct solver at the bottom could factorize its matrix.
  bool is_ready() const { return m_solver.info() == Eigen::Success; }

  // One cycle from 0 for A x = b, in scaled variables.
  const Pair_vector& operator()(const Pair_vector& b)
  {
    cycle(0, b);
    return m_grids.front().solution;
  }

private:
  struct Grid
  {
    Block_matrix matrix;
    std::unique_ptr<Pruned_prolongation> prolongation;      // from the next coarser grid
    std::unique_ptr<Galerkin_product> galerkin_product;
    Pair_vector right_side, solution, residual;
  };

  void cycle(std::size_t g, const Pair_vector& right_side)
  {
    constexpr int sweeps = 2;
    Grid& grid = m_grids[g];
    if (g + 1 == m_grids.size()) {
      solve(right_side, grid.solution);
      return;
    }
    std::fill(grid.solution.begin(), grid.solution.end(), Pair{ 0, 0 });
    for (int i = 0; i < sweeps; ++i)
      grid.matrix.relax_forward(right_side, grid.solution);
    restrict_residual(right_side, grid, m_grids[g + 1]);
    cycle(g + 1, m_grids[g + 1].right_side);
    add_correction(m_grids[g + 1], grid);
    for (int i = 0; i < sweeps; ++i)
      grid.matrix.relax_backward(right_side, grid.solution);
  }

  // The right side of the coarse grid: S_c P^T S^-1 (b - A x).
  static void restrict_residual(const Pair_vector& right_side, Grid& fine, Grid& coarse)
  {
    const Pruned_prolongation& p = *fine.prolongation;
    fine.residual.resize(fine.matrix.number_of_rows());
    for (Index i = 0; i < fine.matrix.number_of_rows(); ++i) {
      const Pair ax = fine.matrix.row_times(i, fine.solution);
      const double inverse_scale = 1 / fine.matrix.scale[i];
      fine.residual[i] = { inverse_scale * (right_side[i][0] - ax[0]), inverse_scale * (right_side[i][1] - ax[1]) };
    }
    for (Index i = 0; i < coarse.matrix.number_of_rows(); ++i) {
      Pair sum = fine.residual[i];
      for (const auto* e = p.column_begin(i); e != p.column_end(i); ++e) {
        sum[0] += e->weight * fine.residual[e->row][0];
        sum[1] += e->weight * fine.residual[e->row][1];
      }
      coarse.right_side[i] = { coarse.matrix.scale[i] * sum[0], coarse.matrix.scale[i] * sum[1] };
    }
  }

  // x += S^-1 P S_c x_c
  static void add_correction(Grid& coarse, Grid& fine)
  {
    const Pruned_prolongation& p = *fine.prolongation;
    for (Index i = 0; i < coarse.matrix.number_of_rows(); ++i) {
      coarse.solution[i] = { coarse.matrix.scale[i] * coarse.solution[i][0], coarse.matrix.scale[i] * coarse.solution[i][1] };
      fine.solution[i][0] += coarse.solution[i][0] / fine.matrix.scale[i];
      fine.solution[i][1] += coarse.solution[i][1] / fine.matrix.scale[i];
    }
    for (Index i = Index(p.coarse_size()); i < p.fine_size(); ++i) {
      const Pruned_prolongation::Row& row = p.row(i);
      const double inverse_scale = 1 / fine.matrix.scale[i];
      for (int k = 0; k < Pruned_prolongation::row_size; ++k) {
        const double w = inverse_scale * row.weights[k];
        fine.solution[i][0] += w * coarse.solution[row.columns[k]][0];
        fine.solution[i][1] += w * coarse.solution[row.columns[k]][1];
      }
    }
  }

  // The energies do not change when the plane is moved, so the matrix is singular: a small shift makes it definite.
  void factorize()
  {
    constexpr double shift = 1e-10;
    const Block_matrix& a = m_grids.back().matrix;
    std::vector<Eigen::Triplet<double>> entries;
    for (Index i = 0; i < a.number_of_rows(); ++i) {
      entries.emplace_back(2 * i, 2 * i, a.diagonal[i][0] + shift);
      entries.emplace_back(2 * i + 1, 2 * i, a.diagonal[i][1]);
      entries.emplace_back(2 * i + 1, 2 * i + 1, a.diagonal[i][2] + shift);
      for (Index k = a.first[i]; k < a.first[i + 1]; ++k)
        if (a.columns[k] < i)
          for (int e = 0; e < 4; ++e)
            entries.emplace_back(2 * i + e / 2, 2 * a.columns[k] + e % 2, a.blocks[k][e]);
    }
    Eigen::SparseMatrix<double> matrix(2 * a.number_of_rows(), 2 * a.number_of_rows());
    matrix.setFromTriplets(entries.begin(), entries.end());
    m_solver.compute(matrix);
  }

  void solve(const Pair_vector& right_side, Pair_vector& solution) const
  {
    const Eigen::Map<const Eigen::VectorXd> b(right_side.data()->data(), 2 * right_side.size());
    Eigen::Map<Eigen::VectorXd>(solution.data()->data(), 2 * solution.size()) = m_solver.solve(b);
  }

  std::vector<Grid> m_grids;      // finest first
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_solver;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_V_CYCLE_H
