// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_BLOCK_MULTIGRID_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_BLOCK_MULTIGRID_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Pruned_prolongation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Galerkin_product.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/k_cycle.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/v_cycle.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

struct Block_multigrid_options
{
  std::size_t groups_per_grid = 5;        // collapse groups from one grid to the next
  std::size_t coarsest_size = 1000;       // a grid of so many vertices is solved directly
  int sweeps = 2;                         // of the smoother, before and after the coarse grids
  double shift =
      1e-10;      // of the coarsest matrix, that is singular: the energies do not change when the plane is moved
};

// Cycles for a block matrix on a level, as preconditioner of conjugate gradients: Galerkin operators over every fifth
// collapse group, block Gauss-Seidel sweeps as smoother, a direct solution at the bottom. On a hierarchy of one level
// there is only that one.
class Block_multigrid
{
public:
  explicit Block_multigrid(const Level& level, const Block_multigrid_options& options = Block_multigrid_options())
    : m_options(options), m_loops(level.loops()), m_hierarchy(level.hierarchy())
  {
    m_grids.emplace_back();
    for (std::size_t l = 0; l <= level.index(); ++l)
      m_group_ends.push_back(Index(m_hierarchy.number_of_vertices(l)));
    for (std::size_t fine = level.index(); fine > 0 && m_hierarchy.number_of_vertices(fine) > options.coarsest_size;) {
      const std::size_t coarse = fine > options.groups_per_grid ? fine - options.groups_per_grid : 0;
      m_grids.back().prolongation =
          std::make_unique<Pruned_prolongation>(m_hierarchy, coarse, fine, m_loops, Pruning::TRIANGLE);
      m_grids.emplace_back();
      fine = coarse;
    }
  }

  // Whether a level has one of the grids of the finest one.
  static bool has_grid_of_finest_level(const Level& level,
                                       const Block_multigrid_options& options = Block_multigrid_options())
  {
    const std::size_t groups_above = level.hierarchy().number_of_levels() - 1 - level.index();
    return groups_above % options.groups_per_grid == 0 || level.index() == 0;
  }

  // The matrix of the finest grid, to be filled in but for the scaling of its blocks. Then it is made ready by setup(),
  // or, while it has changed so little that the coarse grids may stay as they are, by scale().
  Block_matrix& matrix() { return m_grids.front().matrix; }
  const Block_matrix& matrix() const { return m_grids.front().matrix; }

  // To be called when the matrix has got another pattern.
  void forget_pattern()
  {
    for (Grid& grid : m_grids)
      grid.galerkin_product.reset();
  }

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
    factorize_coarsest();
  }

  void scale() { matrix().scale_blocks(m_loops); }

  // Whether the direct solver at the bottom could factorize its matrix.
  bool is_ready() const { return m_direct_solver != nullptr; }

  // Whether there are no coarse grids, so that a cycle is a direct solution.
  bool is_direct() const { return m_grids.size() == 1; }

  // From now on, cycles take two steps of conjugate gradients on each coarse grid, see take_second_step().
  void use_k_cycles() { m_has_k_cycles = true; }

  // One cycle from 0 for A x = b, in scaled variables; the result is valid until the next one, and may be overwritten.
  Block_vectors& cycle(const Block_vectors& b)
  {
    v_cycle(*this, 0, b, m_grids.front().solution);
    return m_grids.front().solution;
  }

  // The parts of a cycle, see v_cycle().

  bool is_coarsest(std::size_t g) const { return g + 1 == m_grids.size(); }
  Block_vectors& right_side(std::size_t g) { return m_grids[g].right_side; }
  Block_vectors& solution(std::size_t g) { return m_grids[g].solution; }
  void solve(const Block_vectors& b, Block_vectors& x) const { m_direct_solver->solve(&b.data()->x, &x.data()->x, 1); }

  void smooth_from_zero(std::size_t g, const Block_vectors& b, Block_vectors& x)
  {
    m_loops.for_each(0, Index(x.size()), [&](Index i) { x[i] = Block_vector(0, 0); });
    for (int i = 0; i < m_options.sweeps; ++i)
      relax_forward(m_grids[g], b, x);
  }

  void smooth(std::size_t g, const Block_vectors& b, Block_vectors& x)
  {
    for (int i = 0; i < m_options.sweeps; ++i)
      relax_backward(m_grids[g], b, x);
  }

  void solve_coarse(std::size_t g)
  {
    Grid& grid = m_grids[g];
    v_cycle(*this, g, grid.right_side, grid.solution);
    if (m_has_k_cycles && !is_coarsest(g))
      take_second_step<double>(
          m_loops, [&](Index i, const Block_vectors& x) { return grid.matrix.row_times(i, x); },
          [](const Block_vector& a, const Block_vector& b) { return inner_product(a, b); },
          [&](const Block_vectors& r, Block_vectors& z) { v_cycle(*this, g, r, z); }, grid.solution, grid.right_side,
          grid.second_solution, grid.product);
  }

  // The right side of the coarse grid: S_c P^T S^-1 (b - A x).
  void restrict_residual(std::size_t g, const Block_vectors& b, const Block_vectors& x)
  {
    Grid &fine = m_grids[g], &coarse = m_grids[g + 1];
    const Pruned_prolongation& p = *fine.prolongation;
    fine.residual.resize(x.size());
    m_loops.for_each(0, fine.matrix.number_of_rows(),
                     [&](Index i) { fine.residual[i] = (b[i] - fine.matrix.row_times(i, x)) / fine.matrix.scale[i]; });
    m_loops.for_each(0, coarse.matrix.number_of_rows(), [&](Index i) {
      Block_vector sum(0, 0);
      for (const auto* e = p.column_begin(i); e != p.column_end(i); ++e)
        sum += e->weight * fine.residual[e->row];
      coarse.right_side[i] = coarse.matrix.scale[i] * sum;
    });
  }

  // x += S^-1 P S_c x_c
  void add_correction(std::size_t g, Block_vectors& x)
  {
    Grid &fine = m_grids[g], &coarse = m_grids[g + 1];
    m_loops.for_each(0, coarse.matrix.number_of_rows(), [&](Index i) { coarse.solution[i] *= coarse.matrix.scale[i]; });
    m_loops.for_each(0, fine.matrix.number_of_rows(), [&](Index i) {
      const Pruned_prolongation::Row& row = fine.prolongation->row(i);
      Block_vector sum(0, 0);
      for (int k = 0; k < Pruned_prolongation::row_size; ++k)
        sum += row.weights[k] * coarse.solution[row.columns[k]];
      x[i] += sum / fine.matrix.scale[i];
    });
  }

private:
  struct Grid
  {
    Block_matrix matrix;
    std::unique_ptr<Pruned_prolongation> prolongation;      // from the next coarser grid
    std::unique_ptr<Galerkin_product> galerkin_product;
    Block_vectors right_side, solution, residual;
    Block_vectors second_solution, product;     // see take_second_step()
  };

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

  // A sweep goes from group to group, and over a group at once: its vertices share no edge. On coarse grids a few of
  // them are joined by the Galerkin operator; a step on these is one of Jacobi's. What is left of the mesh when all
  // groups are gone is densely joined and goes row by row.
  void relax_forward(Grid& grid, const Block_vectors& b, Block_vectors& x)
  {
    grid.matrix.relax_forward(0, m_group_ends[0], b, x);
    for (std::size_t l = 1; l < m_group_ends.size() && m_group_ends[l] <= grid.matrix.number_of_rows(); ++l)
      grid.matrix.relax_at_once(m_loops, m_group_ends[l - 1], m_group_ends[l], b, x, grid.residual);
  }

  void relax_backward(Grid& grid, const Block_vectors& b, Block_vectors& x)
  {
    for (std::size_t l = m_group_ends.size(); --l > 0;)
      if (m_group_ends[l] <= grid.matrix.number_of_rows())
        grid.matrix.relax_at_once(m_loops, m_group_ends[l - 1], m_group_ends[l], b, x, grid.residual);
    grid.matrix.relax_backward(0, m_group_ends[0], b, x);
  }

  void factorize_coarsest()
  {
    const Block_matrix& a = m_grids.back().matrix;
    std::vector<Matrix_entry> entries;
    for (Index i = 0; i < a.number_of_rows(); ++i) {
      const Block d = a.diagonal_block(i);
      entries.push_back({ 2 * i, 2 * i, d.xx() + m_options.shift });
      entries.push_back({ 2 * i + 1, 2 * i, d.yx() });
      entries.push_back({ 2 * i + 1, 2 * i + 1, d.yy() + m_options.shift });
      for (Index k = a.first[i]; k < a.first[i + 1]; ++k)
        if (const Index j = a.columns[k]; j < i) {
          const Block& block = a.blocks[k];
          entries.push_back({ 2 * i, 2 * j, block.xx() });
          entries.push_back({ 2 * i, 2 * j + 1, block.xy() });
          entries.push_back({ 2 * i + 1, 2 * j, block.yx() });
          entries.push_back({ 2 * i + 1, 2 * j + 1, block.yy() });
        }
    }
    m_direct_solver = factorize_symmetric(2 * a.number_of_rows(), entries);
  }

  Block_multigrid_options m_options;
  bool m_has_k_cycles = false;
  Loops m_loops;
  const Collapse_hierarchy_3& m_hierarchy;
  std::vector<Index> m_group_ends;      // the numbers of vertices of the levels
  std::vector<Grid> m_grids;            // finest first
  std::unique_ptr<Direct_solver> m_direct_solver;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_BLOCK_MULTIGRID_H
