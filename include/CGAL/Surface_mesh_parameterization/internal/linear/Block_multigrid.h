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
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Rows_by_part.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/k_cycle.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/level_parts.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/v_cycle.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

struct Block_multigrid_options
{
  std::size_t groups_per_grid = 5;        // collapse groups from one grid to the next
  std::size_t coarsest_size = 1000;       // a grid of so many vertices is solved directly
  int sweeps = 2;                         // of the smoother, before and after the coarse grids
  bool has_k_cycles = false;              // two steps of conjugate gradients on each coarse grid: take_second_step()
  double shift = 1e-10;                   // of the coarsest matrix, which is singular: energies do not change when the
                                          // plane is moved
};

// Cycles for a block matrix on a level, as preconditioner of conjugate gradients: Galerkin operators over every few
// collapse groups, block Gauss-Seidel sweeps as smoother, a direct solution at the bottom. On a hierarchy of one level
// there is only that one.
class Block_multigrid
{
public:
  explicit Block_multigrid(const Level& level, const Block_multigrid_options& options = Block_multigrid_options())
    : m_options(options), m_loops(level.loops()), m_hierarchy(level.hierarchy())
  {
    std::size_t fine = level.index();
    m_grids.emplace_back(level_parts(level));
    while (fine > 0 && m_hierarchy.number_of_vertices(fine) > options.coarsest_size) {
      const std::size_t coarse = fine > options.groups_per_grid ? fine - options.groups_per_grid : 0;
      const Index coarse_parts =
          (std::min)(m_grids.back().parts.number_of_parts(), number_of_parts(m_hierarchy.number_of_vertices(coarse)));
      m_grids.back().add_coarser_grid(m_hierarchy, coarse, fine, coarse_parts, m_loops);
      m_grids.emplace_back(Row_parts(m_hierarchy, coarse, coarse_parts));
      fine = coarse;
    }
  }

  Block_multigrid(const Block_multigrid&) = delete;

  // Whether a level has one of the grids of the finest one.
  static bool has_grid_of_finest_level(const Level& level, const Block_multigrid_options& options)
  {
    const std::size_t groups_above = level.hierarchy().number_of_levels() - 1 - level.index();
    return groups_above % options.groups_per_grid == 0 || level.index() == 0;
  }

  // For the pattern of the finest grid's matrix.
  const Row_parts& parts_of_finest() const { return m_grids.front().parts; }

  // The matrix of the finest grid, to be filled in but for the scaling of its blocks. Then it is made ready by setup(),
  // or, while it has changed so little that the coarse grids may stay as they are, by scale().
  Block_matrix& matrix() { return m_grids.front().matrix; }
  const Block_matrix& matrix() const { return m_grids.front().matrix; }

  // To be called when the matrix has got another pattern.
  void forget_pattern()
  {
    m_direct_solver.reset();
    for (Grid& grid : m_grids)
      grid.galerkin_product.reset();
  }

  // Gives up the coarse grids: from the next setup on a cycle is a direct solution.
  void drop_coarse_grids()
  {
    m_grids.erase(m_grids.begin() + 1, m_grids.end());
    m_grids.front().prolongation.reset();
    m_grids.front().new_rows.reset();
    forget_pattern();
  }

  void setup()
  {
    // A product of matrices takes memory for a time, about as much as these two vectors.
    m_grids.front().solution = Block_vectors();
    m_grids.front().right = Block_vectors();
    std::vector<Index> order;
    if (m_grids.size() > 1 && !m_grids.front().galerkin_product)
      order = input_order();
    for (std::size_t g = 0; g + 1 < m_grids.size(); ++g) {
      Grid& grid = m_grids[g];
      if (!grid.galerkin_product) {
        keep_below(grid.prolongation->coarse_size(), order);
        grid.galerkin_product = std::make_unique<Galerkin_product>(*grid.prolongation, m_grids[g + 1].parts, order);
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

  // The product with the matrix of the finest grid: y := A x
  void multiply(const Block_vectors& x, Block_vectors& y) const { matrix().multiply(x, y, m_loops); }

  void scale() { matrix().scale_blocks(m_loops); }

  // Whether the direct solver at the bottom could factorize its matrix.
  bool is_ready() const { return m_direct_solver != nullptr; }

  // Whether there are no coarse grids, so that a cycle is a direct solution.
  bool is_direct() const { return m_grids.size() == 1; }

  // One cycle from 0 for A x = b, in scaled variables; the result is valid until the next one, and may be overwritten.
  Block_vectors& cycle(const Block_vectors& b)
  {
    v_cycle(*this, 0, b, m_grids.front().solution);
    return m_grids.front().solution;
  }

  // A vector of the finest grid for other uses between two cycles.
  Block_vectors& scratch() { return m_grids.front().solution; }

  // The parts of a cycle, see v_cycle().

  bool is_coarsest(std::size_t g) const { return g + 1 == m_grids.size(); }
  Block_vectors& right_side(std::size_t g) { return m_grids[g].right_side; }
  Block_vectors& solution(std::size_t g) { return m_grids[g].solution; }
  void solve(const Block_vectors& b, Block_vectors& x) const { m_direct_solver->solve(&b.data()->x, &x.data()->x, 1); }

  void smooth_from_zero(std::size_t g, const Block_vectors& b, Block_vectors& x)
  {
    Grid& grid = m_grids[g];
    grid.right.assign(x.size(), Block_vector::zero());
    for (int i = 1; i <= m_options.sweeps; ++i)
      grid.matrix.relax_forward(b, i == 1, i == m_options.sweeps, x, grid.right, m_loops);
  }

  void smooth(std::size_t g, const Block_vectors& b, Block_vectors& x)
  {
    for (int i = 0; i < m_options.sweeps; ++i)
      m_grids[g].matrix.relax_backward(b, x, m_grids[g].right, m_loops);
  }

  void solve_coarse(std::size_t g)
  {
    Grid& grid = m_grids[g];
    v_cycle(*this, g, grid.right_side, grid.solution);
    if (m_options.has_k_cycles && !is_coarsest(g))
      take_second_step(*this, g);
  }

  // The right side of the coarse grid: S_c P^T S^-1 (b - A x). The sweeps have left A x - b, and want 0 back.
  void restrict_residual(std::size_t g, const Block_vectors&, const Block_vectors&)
  {
    Grid &fine = m_grids[g], &coarse = m_grids[g + 1];
    const Pruned_prolongation& p = *fine.prolongation;
    const Index coarse_size = coarse.matrix.number_of_rows();
    const auto take_residual = [&](Index i) {
      return -std::exchange(fine.right[i], Block_vector::zero()) / fine.matrix.scale[i];
    };
    m_loops.for_each(0, coarse_size, [&](Index i) { coarse.right_side[i] = take_residual(i); });
    fine.new_rows->for_each(m_loops, [&](Index i) {
      const Block_vector residual = take_residual(i);
      const Pruned_prolongation::Row& row = p.new_row(i);
      for (int k = 0; k < Pruned_prolongation::row_size; ++k)
        coarse.right_side[row.columns[k]] += double(row.weights[k]) * residual;
    });
    m_loops.for_each(0, coarse_size, [&](Index i) { coarse.right_side[i] *= coarse.matrix.scale[i]; });
  }

  // x += S^-1 P S_c x_c
  void add_correction(std::size_t g, Block_vectors& x)
  {
    Grid &fine = m_grids[g], &coarse = m_grids[g + 1];
    const Index coarse_size = coarse.matrix.number_of_rows();
    m_loops.for_each(0, coarse_size, [&](Index i) {
      coarse.solution[i] *= coarse.matrix.scale[i];
      x[i] += coarse.solution[i] / fine.matrix.scale[i];
    });
    m_loops.for_each(coarse_size, fine.matrix.number_of_rows(), [&](Index i) {
      const Pruned_prolongation::Row& row = fine.prolongation->new_row(i);
      Block_vector sum(0, 0);
      for (int k = 0; k < Pruned_prolongation::row_size; ++k)
        sum += row.weights[k] * coarse.solution[row.columns[k]];
      x[i] += sum / fine.matrix.scale[i];
    });
  }

  // What take_second_step() needs.
  typedef double   Scalar;
  const Loops& loops() const { return m_loops; }
  Block_vectors& second_solution(std::size_t g) { return m_grids[g].second_solution; }
  Block_vectors& image(std::size_t g) { return m_grids[g].image; }
  static double product(const Block_vector& a, const Block_vector& b) { return inner_product(a, b); }
  double energy_of_row(std::size_t g, Index i, const Block_vectors& x) const
  {
    return m_grids[g].matrix.energy_of_row(i, x);
  }
  void multiply(std::size_t g, const Block_vectors& x, Block_vectors& ax) const
  {
    m_grids[g].matrix.multiply(x, ax, m_loops);
  }

private:
  struct Grid
  {
    Row_parts parts;
    Block_matrix matrix;
    std::unique_ptr<Pruned_prolongation> prolongation;      // from the next coarser grid
    std::unique_ptr<Rows_by_part> new_rows;                 // of the prolongation
    std::unique_ptr<Galerkin_product> galerkin_product;
    Block_vectors right_side, solution;
    Block_vectors right;                        // see Block_matrix::relax_forward()
    Block_vectors second_solution, image;       // see take_second_step()

    explicit Grid(Row_parts parts_) : parts(std::move(parts_)) { }

    // `fine` is this grid's level.
    void add_coarser_grid(const Collapse_hierarchy_3& hierarchy, std::size_t coarse, std::size_t fine,
                          Index coarse_parts, const Loops& loops)
    {
      prolongation = std::make_unique<Pruned_prolongation>(hierarchy, coarse, fine, loops, Pruning::TRIANGLE);
      const Row_parts rows(hierarchy, fine, coarse_parts);
      new_rows = std::make_unique<Rows_by_part>(rows, Index(prolongation->coarse_size()), [&](Index part, Index row) {
        const auto& columns = prolongation->new_row(row).columns;
        return std::all_of(columns.begin(), columns.end(), [&](Index c) { return rows.part_of(c) == part; });
      });
    }
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

  void factorize_coarsest()
  {
    const Block_matrix& a = m_grids.back().matrix;
    std::vector<Matrix_entry> entries;
    entries.reserve(3 * std::size_t(a.number_of_rows()) + 4 * std::size_t(a.first[a.number_of_rows()]));
    for (Index i = 0; i < a.number_of_rows(); ++i) {
      const Block d = a.diagonal_block(i);
      entries.push_back({ 2 * i, 2 * i, d.xx() + m_options.shift });
      entries.push_back({ 2 * i + 1, 2 * i, d.yx() });
      entries.push_back({ 2 * i + 1, 2 * i + 1, d.yy() + m_options.shift });
      for (Index k = a.first[i]; k < a.first[i + 1]; ++k) {
        const Index j = a.columns[k];
        const Block& block = a.blocks[k];
        entries.push_back({ 2 * i, 2 * j, block.xx() });
        entries.push_back({ 2 * i, 2 * j + 1, block.xy() });
        entries.push_back({ 2 * i + 1, 2 * j, block.yx() });
        entries.push_back({ 2 * i + 1, 2 * j + 1, block.yy() });
      }
    }
    if (!m_direct_solver || !m_direct_solver->factorize_again(entries))
      m_direct_solver = factorize_symmetric(2 * a.number_of_rows(), entries);
  }

  Block_multigrid_options m_options;
  Loops m_loops;
  const Collapse_hierarchy_3& m_hierarchy;
  std::vector<Grid> m_grids;            // finest first
  std::unique_ptr<Direct_solver> m_direct_solver;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_BLOCK_MULTIGRID_H
