// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_PRECONDITIONER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_PRECONDITIONER_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Pruned_prolongation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Grid_transfer.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Incomplete_LU.h>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// V-cycles for a matrix whose unknowns sit at the vertices of a hierarchy: Galerkin operators over every fourth collapse group, incomplete LU
// as the smoother before and after, a direct solution at the bottom. With a symmetric matrix the cycle is symmetric, too.
template <class Real>
class Multigrid_preconditioner
{
public:
  static constexpr std::size_t groups_per_grid = 4;
  static constexpr std::size_t coarsest_size = 500;      // unknowns; is solved directly

  // `matrix` has a row, with ascending columns, for each of `unknowns`. These are best in the order of the hierarchy's input, for the cache.
  // `tied_vertices` have none, but may have some on coarser grids, see Grid_transfer.
  Multigrid_preconditioner(const Hierarchy_interpolation& hierarchy, const std::vector<Mesh_unknown>& unknowns, Sparse_rows<Real> matrix,
                           const std::vector<Index>& tied_vertices = {})
  {
    std::size_t fine = hierarchy.number_of_levels() - 1;
    const Real enlargement = enlargement_of_diagonal(matrix);
    m_grids.emplace_back(std::move(matrix), enlargement);
    for (const std::vector<Mesh_unknown>* fine_unknowns = &unknowns; fine > 0 && fine_unknowns->size() > coarsest_size;) {
      const std::size_t coarse = fine > groups_per_grid ? fine - groups_per_grid : 0;
      m_transfers.emplace_back(Pruned_prolongation(hierarchy, coarse, fine, Loops()), *fine_unknowns, tied_vertices);
      m_grids.emplace_back(m_transfers.back().template galerkin_product<Real>(m_grids.back()), enlargement);
      fine_unknowns = &m_transfers.back().coarse_unknowns();
      fine = coarse;
    }
    factorize_coarsest();
  }

  // Whether the direct solver at the bottom could factorize its matrix.
  bool is_ready() const { return m_solver.info() == Eigen::Success; }

  // The vectors that cycles work on, one of each kind for every grid.
  template <int columns>
  struct Space
  {
    explicit Space(const Multigrid_preconditioner& multigrid)
    {
      for (const Incomplete_LU<Real>& grid : multigrid.m_grids)
        for (auto* vectors : { &right_side, &solution, &scratch })
          vectors->emplace_back(grid.size());
    }
    std::vector<Value_vector<Real, columns>> right_side, solution, scratch;
  };

  // One cycle from 0: `space.solution[0]` for `space.right_side[0]`.
  template <int columns>
  void cycle(Space<columns>& space, std::size_t g = 0) const
  {
    auto &b = space.right_side[g], &x = space.solution[g];
    if (g + 1 == m_grids.size()) {
      solve_coarsest(b, x);
      return;
    }
    m_grids[g].solve(b, x);
    m_transfers[g].restrict([&](Index i) -> Values<Real, columns> { return m_grids[g].residual(i, b, x); }, space.right_side[g + 1]);
    cycle(space, g + 1);
    m_transfers[g].add_prolongation(space.solution[g + 1], x);
    m_grids[g].relax(b, x, space.scratch[g]);
  }

  // Full multigrid: the solution of every grid starts from that of the next coarser one, and is improved by a cycle. Changes `space.right_side[0]`.
  template <int columns>
  void full_cycle(Space<columns>& space) const
  {
    typedef Value_vector<Real, columns>   Vector;
    std::vector<Vector>& right_side = space.scratch;      // of a grid, until there is a cycle on it
    right_side[0] = space.right_side[0];
    for (std::size_t g = 0; g + 1 < m_grids.size(); ++g)
      m_transfers[g].restrict([&](Index i) { return right_side[g][i]; }, right_side[g + 1]);

    std::size_t g = m_grids.size() - 1;
    Vector coarse(m_grids[g].size());
    solve_coarsest(right_side[g], coarse);
    while (g-- > 0) {
      Vector x(m_grids[g].size(), Values<Real, columns>::Zero());
      m_transfers[g].add_prolongation(coarse, x);
      for (Index i = 0; i < x.size(); ++i)
        space.right_side[g][i] = m_grids[g].residual(i, right_side[g], x);
      cycle(space, g);
      for (Index i = 0; i < x.size(); ++i)
        x[i] += space.solution[g][i];
      coarse.swap(x);
    }
    space.solution[0].swap(coarse);
  }

private:
  // Where angles are obtuse, cotangent weights are negative, and incomplete factors need not exist: a diagonal that is a little greater helps. Much more costs
  // cycles, 10 % a third. Where all entries beside the diagonal are negative, as those of uniform or mean value weights are, it would cost some for nothing.
  static Real enlargement_of_diagonal(const Sparse_rows<Real>& matrix)
  {
    for (Index i = 0; i < matrix.number_of_rows(); ++i)
      for (Index k = matrix.first[i]; k < matrix.first[i + 1]; ++k)
        if (matrix.columns[k] != i && matrix.values[k] > 0)
          return Real(1.02);
    return 1;
  }

  void factorize_coarsest()
  {
    const Incomplete_LU<Real>& grid = m_grids.back();
    std::vector<Eigen::Triplet<double>> entries;
    for (Index i = 0; i < grid.size(); ++i) {
      entries.emplace_back(i, i, grid.diagonal(i));
      grid.for_each_entry(i, [&](Index column, Real value) { entries.emplace_back(i, column, value); });
    }
    Eigen::SparseMatrix<double> matrix(grid.size(), grid.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    m_solver.compute(matrix);
  }

  template <int columns>
  void solve_coarsest(const Value_vector<Real, columns>& right_side, Value_vector<Real, columns>& solution) const
  {
    Eigen::Matrix<double, Eigen::Dynamic, columns> b(right_side.size(), columns);
    for (std::size_t i = 0; i < right_side.size(); ++i)
      b.row(i) = right_side[i].matrix().transpose().template cast<double>();
    const Eigen::Matrix<double, Eigen::Dynamic, columns> x = m_solver.solve(b);
    for (std::size_t i = 0; i < right_side.size(); ++i)
      solution[i] = x.row(i).transpose().array().template cast<Real>();
  }

  std::vector<Incomplete_LU<Real>> m_grids;      // finest first
  std::vector<Grid_transfer> m_transfers;        // from the next coarser grid
  Eigen::SparseLU<Eigen::SparseMatrix<double>> m_solver;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_PRECONDITIONER_H
