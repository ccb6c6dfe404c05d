// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SCALAR_MULTIGRID_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SCALAR_MULTIGRID_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Complex.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Values.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Pruned_prolongation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Grid_transfer.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Incomplete_LU.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/k_cycle.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/v_cycle.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

struct Scalar_multigrid_options
{
  std::size_t groups_per_grid = 4;        // collapse groups from one grid to the next
  std::size_t coarsest_size = 500;        // a grid of so many unknowns is solved directly
  // Where angles are obtuse, cotangent weights are negative, and incomplete factors need not exist: a diagonal that is
  // a little greater helps. Much more costs cycles, 10 % a third. Where all entries beside the diagonal are negative,
  // as those of uniform or mean value weights are, it would cost some for nothing.
  double enlargement_of_diagonal = 1.02;
  // Of a symmetric matrix, one that leaves a pivot less than this times its diagonal entry is not enough: a single
  // negative pivot may cost a hundred cycles. Others may be indefinite themselves.
  double least_pivot = 0.05;
  Pruning pruning = Pruning::GREATEST_WEIGHTS;      // where the hierarchy has no points, there is no other one
};

// Those for a matrix of both coordinates of vertices in the plane, as that of least squares conformal maps, whose
// energy conformal motions hardly change.
inline Scalar_multigrid_options scalar_multigrid_options_in_plane()
{
  Scalar_multigrid_options options;
  options.groups_per_grid = 5;
  options.enlargement_of_diagonal = 1.03;
  options.pruning = Pruning::TRIANGLE;
  return options;
}

// The same for a matrix of complex numbers, see complex_rows(), which costs less, and a factorization of it far less.
inline Scalar_multigrid_options complex_multigrid_options()
{
  Scalar_multigrid_options options = scalar_multigrid_options_in_plane();
  options.groups_per_grid = 4;
  options.coarsest_size = 10000;
  options.enlargement_of_diagonal = 1.02;
  return options;
}

// V-cycles, or K-cycles on request, for a matrix whose unknowns sit at the vertices of a hierarchy: Galerkin operators
// over every few collapse groups, incomplete LU as the smoother before and after, a direct solution at the bottom.
// With a symmetric matrix the V-cycle is symmetric, too.
//
// `Number` is float, double, or a Complex one.
template <class Number>
class Scalar_multigrid
{
public:
  // `matrix` has a row, with ascending columns, for each of `unknowns`. These are best in the order of the hierarchy's
  // input, for the cache and for threads, see Elimination_order. `tied_vertices` have none, but may have some on
  // coarser grids, see Grid_transfer.
  Scalar_multigrid(const Hierarchy_interpolation& hierarchy, const std::vector<Mesh_unknown>& unknowns,
                   Sparse_rows<Number> matrix, const std::vector<Index>& tied_vertices = {},
                   const Scalar_multigrid_options& options = Scalar_multigrid_options(), const Loops& loops = Loops())
    : m_loops(loops)
  {
    std::size_t fine = hierarchy.number_of_levels() - 1;
    const Pruning pruning = hierarchy.has_points() ? options.pruning : Pruning::GREATEST_WEIGHTS;
    const double enlargement = has_positive_entries(matrix) ? options.enlargement_of_diagonal : 1;
    m_grids.emplace_back(std::move(matrix), enlargement, options.least_pivot, loops);
    for (const std::vector<Mesh_unknown>* fine_unknowns = &unknowns;
         fine > 0 && fine_unknowns->size() > options.coarsest_size;) {
      const std::size_t coarse = fine > options.groups_per_grid ? fine - options.groups_per_grid : 0;
      m_transfers.emplace_back(Pruned_prolongation(hierarchy, coarse, fine, loops, pruning), *fine_unknowns,
                               tied_vertices, loops);
      if (m_transfers.back().coarse_unknowns().empty()) {     // the values of all coarse vertices are known
        m_transfers.pop_back();
        break;
      }
      fine_unknowns = &m_transfers.back().coarse_unknowns();
      m_grids.emplace_back(m_transfers.back().template galerkin_product<Number>(m_grids.back()), enlargement,
                           options.least_pivot, loops);
      fine = coarse;
    }
    factorize_coarsest();
  }

  // Whether the direct solver at the bottom could factorize its matrix.
  bool is_ready() const { return m_direct_solver != nullptr; }

  // The vectors that cycles for so many right sides work on, one of each kind for every grid, and the parts of a cycle,
  // see v_cycle().
  template <int columns>
  class Space
  {
    typedef Values<Number, columns>         Value;
    typedef Value_vector<Number, columns>   Vector;

  public:
    explicit Space(const Scalar_multigrid& multigrid) : m_multigrid(multigrid)
    {
      for (const Incomplete_LU<Number>& grid : multigrid.m_grids)
        for (auto* vectors : { &m_right_side, &m_solution, &m_scratch })
          vectors->emplace_back(grid.size());
      m_second_solution.resize(m_solution.size());
      m_image.resize(m_solution.size());
    }

    // From now on, cycles take two steps of conjugate gradients on each coarse grid, see take_second_step(). The matrix
    // must be symmetric, with one right side.
    void use_k_cycles() { m_has_k_cycles = true; }

    bool is_coarsest(std::size_t g) const { return g + 1 == m_multigrid.m_grids.size(); }
    Vector& right_side(std::size_t g) { return m_right_side[g]; }
    Vector& solution(std::size_t g) { return m_solution[g]; }
    Vector& scratch(std::size_t g) { return m_scratch[g]; }
    void solve(const Vector& b, Vector& x) const { m_multigrid.solve_coarsest(b, x); }
    void smooth_from_zero(std::size_t g, const Vector& b, Vector& x) const { m_multigrid.m_grids[g].solve(b, x); }
    void smooth(std::size_t g, const Vector& b, Vector& x) { m_multigrid.m_grids[g].relax(b, x, m_scratch[g]); }

    void restrict_residual(std::size_t g, const Vector& b, const Vector& x)
    {
      m_multigrid.m_transfers[g].restrict([&](Index i) { return m_multigrid.m_grids[g].residual(i, b, x); },
                                          m_right_side[g + 1]);
    }

    void solve_coarse(std::size_t g)
    {
      v_cycle(*this, g, m_right_side[g], m_solution[g]);
      if constexpr (columns == 1)
        if (m_has_k_cycles && !is_coarsest(g))
          take_second_step(*this, g);
    }

    void add_correction(std::size_t g, Vector& x) const
    {
      m_multigrid.m_transfers[g].add_prolongation(m_solution[g + 1], x);
    }

    // What take_second_step() needs.
    typedef Number   Scalar;
    const Loops& loops() const { return m_multigrid.m_loops; }
    Vector& second_solution(std::size_t g) { return m_second_solution[g]; }
    Vector& image(std::size_t g) { return m_image[g]; }
    void multiply(std::size_t g, const Vector& x, Vector& ax) const { m_multigrid.m_grids[g].multiply(x, ax); }
    static double product(const Value& a, const Value& b) { return inner_product(a[0], b[0]); }
    double energy_of_row(std::size_t g, Index i, const Vector& x) const
    {
      return product(x[i], m_multigrid.m_grids[g].row_times(i, x));
    }

  private:
    const Scalar_multigrid& m_multigrid;
    std::vector<Vector> m_right_side, m_solution, m_scratch, m_second_solution, m_image;
    bool m_has_k_cycles = false;
  };

  // One cycle from 0: `space.solution(0)` for `space.right_side(0)`.
  template <int columns>
  void cycle(Space<columns>& space, std::size_t g = 0) const
  {
    v_cycle(space, g, space.right_side(g), space.solution(g));
  }

  // Full multigrid: the solution of every grid starts from that of the next coarser one, and is improved by a cycle.
  // Changes `space.right_side(0)`.
  template <int columns>
  void full_cycle(Space<columns>& space) const
  {
    typedef Value_vector<Number, columns>   Vector;
    space.scratch(0) = space.right_side(0);      // the right side of a grid, until there is a cycle on it
    for (std::size_t g = 0; g + 1 < m_grids.size(); ++g)
      m_transfers[g].restrict([&](Index i) { return space.scratch(g)[i]; }, space.scratch(g + 1));

    std::size_t g = m_grids.size() - 1;
    Vector coarse(m_grids[g].size());
    solve_coarsest(space.scratch(g), coarse);
    while (g-- > 0) {
      Vector x(m_grids[g].size(), Values<Number, columns>::zero());
      m_transfers[g].add_prolongation(coarse, x);
      m_loops.for_each(0, Index(x.size()),
                       [&](Index i) { space.right_side(g)[i] = m_grids[g].residual(i, space.scratch(g), x); });
      cycle(space, g);
      m_loops.for_each(0, Index(x.size()), [&](Index i) { x[i] += space.solution(g)[i]; });
      coarse.swap(x);
    }
    space.solution(0).swap(coarse);
  }

private:
  typedef decltype(in_double_precision(Number()))   Double_number;

  template <class Real>
  static bool is_positive(Real a) { return a > 0; }
  template <class Real>
  static bool is_positive(const Complex<Real>&) { return true; }       // or negative, or neither

  static bool has_positive_entries(const Sparse_rows<Number>& matrix)      // beside the diagonal
  {
    bool result = false;
    for (Index i = 0; i < matrix.number_of_rows() && !result; ++i)
      matrix.for_each_entry(i, [&](Index column, const Number& value) {
        result = result || (column != i && is_positive(value));
      });
    return result;
  }

  void factorize_coarsest()
  {
    const Incomplete_LU<Number>& grid = m_grids.back();
    Sparse_rows<Double_number> rows;
    std::vector<std::pair<Index, Double_number>> row;
    for (Index i = 0; i < grid.size(); ++i) {
      row.assign(1, { i, Double_number(grid.diagonal(i)) });
      grid.for_each_entry(i, [&](Index column, const Number& value) {
        row.emplace_back(column, Double_number(value));
      });
      std::sort(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      for (const auto& [column, value] : row)
        rows.add_entry(column, value);
      rows.end_row();
    }
    if constexpr (std::is_same<Double_number, double>::value)
      m_direct_solver = factorize_rows(rows);
    else
      m_direct_solver = factorize_hermitian<double>(rows);
  }

  template <int columns>
  void solve_coarsest(const Value_vector<Number, columns>& right_side, Value_vector<Number, columns>& solution) const
  {
    m_direct_solver->solve_side_by_side([&](Index i) { return right_side[i].template cast<Double_number>(); },
                                        solution);
  }

  Loops m_loops;
  std::vector<Incomplete_LU<Number>> m_grids;      // finest first
  std::vector<Grid_transfer> m_transfers;        // from the next coarser grid
  std::unique_ptr<Direct_solver> m_direct_solver;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SCALAR_MULTIGRID_H
