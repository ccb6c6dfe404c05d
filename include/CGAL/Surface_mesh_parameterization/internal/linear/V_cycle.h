// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_V_CYCLE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_V_CYCLE_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Pruned_prolongation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Galerkin_product.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
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

  explicit V_cycle(const Level& level) : m_hierarchy(level.hierarchy()), m_loops(level.loops())
  {
    m_grids.emplace_back();
    for (std::size_t l = 0; l <= level.index(); ++l)
      m_group_ends.push_back(Index(level.hierarchy().number_of_vertices(l)));
    for (std::size_t fine = level.index(); fine > 0 && level.hierarchy().number_of_vertices(fine) > coarsest_size;) {
      const std::size_t coarse = fine > groups_per_grid ? fine - groups_per_grid : 0;
      m_grids.back().prolongation = std::make_unique<Pruned_prolongation>(level.hierarchy(), coarse, fine, m_loops);
      m_grids.emplace_back();
      fine = coarse;
    }
  }

  // The matrix of the finest grid, to be filled in but for the scaling of its blocks. Then it is made ready by setup(), or, while it has changed so little that
  // the coarse grids may stay as they are, by scale().
  Block_matrix& matrix() { return m_grids.front().matrix; }
  const Block_matrix& matrix() const { return m_grids.front().matrix; }

  void setup()
  {
    std::vector<Index> order;
    if (m_grids.size() > 1 && !m_grids.front().galerkin_product)
      order = input_order();
    for (std::size_t g = 0; g + 1 < m_grids.size(); ++g) {
      Grid& grid = m_grids[g];
      if (!grid.galerkin_product) {
        keep_below(grid.prolongation->coarse_size(), order);
        grid.galerkin_product = std::make_unique<Galerkin_product>(grid.matrix, *grid.prolongation, order, m_loops);
      }
      grid.galerkin_product->compute(grid.matrix, m_grids[g + 1].matrix, m_loops);
      grid.matrix.scale_blocks(m_loops);
    }
    m_grids.back().matrix.scale_blocks(m_loops);
    for (Grid& grid : m_grids) {
      grid.solution.resize(grid.matrix.number_of_rows());
      if (&grid != &m_grids.front())
        grid.right_side.resize(grid.matrix.number_of_rows());
    }
    factorize();
  }

  void scale() { matrix().scale_blocks(m_loops); }

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
    m_loops.for_each(0, grid.matrix.number_of_rows(), [&](Index i) { grid.solution[i] = Pair(0, 0); });
    for (int i = 0; i < sweeps; ++i)
      relax_forward(grid, right_side);
    restrict_residual(right_side, grid, m_grids[g + 1]);
    cycle(g + 1, m_grids[g + 1].right_side);
    add_correction(m_grids[g + 1], grid);
    for (int i = 0; i < sweeps; ++i)
      relax_backward(grid, right_side);
  }

  // The ranks of the vertices in the order of the input.
  std::vector<Index> input_order() const
  {
    std::vector<Index> result(m_hierarchy.number_of_vertices(), no_index);
    for (Index v = 0; v < matrix().number_of_rows(); ++v)
      result[m_hierarchy.input_vertex(v)] = v;
    return result;
  }

  static void keep_below(std::size_t size, std::vector<Index>& order)
  {
    order.erase(std::remove_if(order.begin(), order.end(), [size](Index v) { return v >= size; }), order.end());
  }

  // A sweep goes from group to group, and over a group at once: its vertices share no edge. On coarse grids a few of them are joined by the Galerkin
  // operator; a step on these is one of Jacobi's. What is left of the mesh when all groups are gone is densely joined and goes row by row.
  void relax_forward(Grid& grid, const Pair_vector& right_side)
  {
    grid.matrix.relax_forward(0, m_group_ends[0], right_side, grid.solution);
    for (std::size_t l = 1; l < m_group_ends.size() && m_group_ends[l] <= grid.matrix.number_of_rows(); ++l)
      grid.matrix.relax_at_once(m_loops, m_group_ends[l - 1], m_group_ends[l], right_side, grid.solution, grid.residual);
  }

  void relax_backward(Grid& grid, const Pair_vector& right_side)
  {
    for (std::size_t l = m_group_ends.size(); --l > 0;)
      if (m_group_ends[l] <= grid.matrix.number_of_rows())
        grid.matrix.relax_at_once(m_loops, m_group_ends[l - 1], m_group_ends[l], right_side, grid.solution, grid.residual);
    grid.matrix.relax_backward(0, m_group_ends[0], right_side, grid.solution);
  }

  // The right side of the coarse grid: S_c P^T S^-1 (b - A x).
  void restrict_residual(const Pair_vector& right_side, Grid& fine, Grid& coarse) const
  {
    const Pruned_prolongation& p = *fine.prolongation;
    fine.residual.resize(fine.matrix.number_of_rows());
    m_loops.for_each(0, fine.matrix.number_of_rows(), [&](Index i) {
      fine.residual[i] = (right_side[i] - fine.matrix.row_times(i, fine.solution)) / fine.matrix.scale[i];
    });
    m_loops.for_each(0, coarse.matrix.number_of_rows(), [&](Index i) {
      Pair sum(0, 0);
      for (const auto* e = p.column_begin(i); e != p.column_end(i); ++e)
        sum += e->weight * fine.residual[e->row];
      coarse.right_side[i] = coarse.matrix.scale[i] * sum;
    });
  }

  // x += S^-1 P S_c x_c
  void add_correction(Grid& coarse, Grid& fine) const
  {
    m_loops.for_each(0, coarse.matrix.number_of_rows(), [&](Index i) { coarse.solution[i] *= coarse.matrix.scale[i]; });
    m_loops.for_each(0, fine.matrix.number_of_rows(), [&](Index i) {
      const Pruned_prolongation::Row& row = fine.prolongation->row(i);
      Pair sum(0, 0);
      for (int k = 0; k < Pruned_prolongation::row_size; ++k)
        sum += row.weights[k] * coarse.solution[row.columns[k]];
      fine.solution[i] += sum / fine.matrix.scale[i];
    });
  }

  // The energies do not change when the plane is moved, so the matrix is singular: a small shift makes it definite.
  void factorize()
  {
    constexpr double shift = 1e-10;
    const Block_matrix& a = m_grids.back().matrix;
    std::vector<Eigen::Triplet<double>> entries;
    for (Index i = 0; i < a.number_of_rows(); ++i) {
      const Block_matrix::Block d = a.diagonal_block(i);
      entries.emplace_back(2 * i, 2 * i, d(0, 0) + shift);
      entries.emplace_back(2 * i + 1, 2 * i, d(1, 0));
      entries.emplace_back(2 * i + 1, 2 * i + 1, d(1, 1) + shift);
      for (Index k = a.first[i]; k < a.first[i + 1]; ++k)
        if (a.columns[k] < i)
          for (int e = 0; e < 4; ++e)
            entries.emplace_back(2 * i + e / 2, 2 * a.columns[k] + e % 2, a.blocks[k](e / 2, e % 2));
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

  const Collapse_hierarchy_3& m_hierarchy;
  Loops m_loops;
  std::vector<Index> m_group_ends;  // the numbers of vertices of the levels
  std::vector<Grid> m_grids;      // finest first
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_solver;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_V_CYCLE_H
