// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_LINEAR_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_LINEAR_SOLVER_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Krylov_methods.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_preconditioner.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Solves a linear system whose unknowns sit at the vertices of a hierarchy, for any number of right sides: conjugate gradients if it is symmetric,
// stabilized bi-conjugate gradients if not, preconditioned by V-cycles, from the first guess of full multigrid. Where these do not arrive, it solves directly.
class Multigrid_linear_solver
{
public:
  // `unknowns[i]` tells where unknown i sits. At `tied_vertices` there is none, since the values of others give theirs.
  Multigrid_linear_solver(const Hierarchy_interpolation& hierarchy, std::shared_ptr<const Sparse_rows<double>> rows, std::vector<Mesh_unknown> unknowns,
                          const std::vector<Index>& tied_vertices = {})
    : m_system(hierarchy, std::move(rows), unknowns)
  {
    const std::vector<Index>& free_unknowns = m_system.free_unknowns();
    if (!m_system.is_regular() || free_unknowns.empty())
      return;
    std::vector<Mesh_unknown> grid_unknowns;
    grid_unknowns.reserve(free_unknowns.size());
    for (const Index i : free_unknowns)
      grid_unknowns.push_back(unknowns[i]);
    std::vector<Mesh_unknown>().swap(unknowns);
    m_multigrid = std::make_unique<Multigrid>(hierarchy, grid_unknowns, m_system.free_part<Real>(), tied_vertices);
  }

  const std::shared_ptr<const Sparse_rows<double>>& rows() const { return m_system.rows(); }

  struct Options
  {
    double tolerance = 1e-10;             // of the residual, relative to that of the free unknowns at 0; rows scaled to unit diagonal
    std::size_t most_iterations = 300;
  };

  struct Result
  {
    bool is_solved = false;
    bool is_direct = false;       // by the direct solver
    std::size_t iterations = 0;
    double residual = 0;          // the relative one, computed at the end; the greatest of the right sides
  };

  // `b[i]` tells what the right sides have in row i.
  template <int columns, class Right_sides>
  Result solve(const Right_sides& b, Value_vector<double, columns>& x, const Options& options)
  {
    m_system.set_to_fixed_unknowns(b, x);
    Value_vector<double, columns> r(x.size());
    m_system.compute_residual(b, x, r);
    const Values<double, columns> start = m_system.norm(r);

    Result result;
    if (m_multigrid && m_multigrid->is_ready())
      result = iterate(b, x, r, start, options);
    else if (m_system.is_regular() && m_system.free_unknowns().empty())
      result.is_solved = m_system.backward_error(b, x) <= worst_backward_error;
    if (!result.is_solved)
      solve_directly(b, x, r, start, result);
    return result;
  }

private:
  // Of a solution without iteration: of a nearly singular matrix, no solution has a small residual.
  static constexpr double worst_backward_error = 1e-10;

  typedef float                            Real;      // the grids' numbers: half the memory, and exact enough for a preconditioner
  typedef Multigrid_preconditioner<Real>   Multigrid;

  // The system as the Krylov methods see it.
  template <int columns>
  class Iteration
  {
    typedef Values<double, columns>          Value;
    typedef Value_vector<double, columns>    Vector;

  public:
    Iteration(const Multigrid_linear_solver& solver, const Value& target)
      : m_system(solver.m_system), m_multigrid(*solver.m_multigrid), m_space(m_multigrid), m_target(target)
    { }

    Index number_of_rows() const { return m_system.size(); }
    const Loops& loops() const { return m_system.loops(); }
    Value row_times(Index i, const Vector& x) const { return m_system.row_times(i, x); }
    bool is_solved(const Vector& r) const { return (m_system.norm(r) <= m_target).all(); }

    // Of an indefinite matrix the residual may wander about for ever.
    bool is_finished(const Vector& r)
    {
      constexpr int patience = 60;
      const double excess = quotient(m_system.norm(r), m_target).maxCoeff();
      if (excess < m_least_excess / 2) {
        m_least_excess = excess;
        m_idle_steps = 0;
      }
      return !(excess > 1) || ++m_idle_steps > patience;
    }

    // z := M^-1 r
    void precondition(const Vector& r, Vector& z)
    {
      const Value scale = give_to_grid(r);
      m_multigrid.cycle(m_space);
      z.assign(z.size(), Value::Zero());
      add_from_grid(scale, z);
    }

    // x := x + the approximate solution for r by full multigrid
    void full_multigrid(const Vector& r, Vector& x)
    {
      const Value scale = give_to_grid(r);
      m_multigrid.full_cycle(m_space);
      add_from_grid(scale, x);
    }

  private:
    // Writes r, scaled to the size of 1, to the finest grid; returns that scale.
    Value give_to_grid(const Vector& r)
    {
      Value greatest = Value::Zero();
      for (const Value& value : r)
        greatest = greatest.max(value.abs());
      const Value inverse = quotient(Value(Value::Ones()), greatest);
      const std::vector<Index>& unknowns = m_system.free_unknowns();
      for (std::size_t k = 0; k < unknowns.size(); ++k)
        m_space.right_side[0][k] = (r[unknowns[k]] * inverse).template cast<Real>();
      return greatest * m_system.free_part_scale();
    }

    void add_from_grid(const Value& scale, Vector& x) const
    {
      const std::vector<Index>& unknowns = m_system.free_unknowns();
      for (std::size_t k = 0; k < unknowns.size(); ++k)
        x[unknowns[k]] += scale * m_space.solution[0][k].template cast<double>();
    }

    const Mesh_system& m_system;
    const Multigrid& m_multigrid;
    Multigrid::Space<columns> m_space;
    Value m_target;
    double m_least_excess = (std::numeric_limits<double>::infinity)();      // of the residual over its target
    int m_idle_steps = 0;         // since the excess was halved
  };

  // Changes x, where the free unknowns are 0, and its residual r, whose norms are `start`.
  template <class Right_sides, class Vector, class Value>
  Result iterate(const Right_sides& b, Vector& x, Vector& r, const Value& start, const Options& options) const
  {
    // Rounding lets the residual that an iteration carries along drift away from the true one: then it starts again from there.
    constexpr int most_starts = 3;
    Iteration<Value::RowsAtCompileTime> iteration(*this, options.tolerance * start);
    iteration.full_multigrid(r, x);
    m_system.compute_residual(b, x, r);
    if (!(m_system.norm(r) <= start).all()) {
      m_system.set_to_fixed_unknowns(b, x);
      m_system.compute_residual(b, x, r);
    }
    Result result;
    for (int i = 0; i < most_starts && result.iterations < options.most_iterations && !iteration.is_solved(r); ++i) {
      const std::size_t left = options.most_iterations - result.iterations;
      result.iterations += m_system.is_symmetric() ? conjugate_gradients(iteration, x, r, left) : stabilized_biconjugate_gradients(iteration, x, r, left);
      m_system.compute_residual(b, x, r);
    }
    result.residual = quotient(m_system.norm(r), start).maxCoeff();
    result.is_solved = result.residual <= options.tolerance && iteration.is_solved(r);     // the residual may pass over a NaN, the norms over infinity
    return result;
  }

  // Writes x, its residual r, and what `result` tells of them.
  template <class Right_sides, class Vector, class Value>
  void solve_directly(const Right_sides& b, Vector& x, Vector& r, const Value& start, Result& result)
  {
    result.is_direct = true;
    if (!m_direct_solver)
      m_direct_solver = std::make_unique<Direct_solver>(*m_system.rows());
    if (!m_direct_solver->is_ready())
      return;
    m_direct_solver->solve(b, x);
    m_system.compute_residual(b, x, r);
    result.residual = quotient(m_system.norm(r), start).maxCoeff();
    result.is_solved = m_system.backward_error(b, x) <= worst_backward_error;
  }

  Mesh_system m_system;
  std::unique_ptr<Multigrid> m_multigrid;
  std::unique_ptr<Direct_solver> m_direct_solver;     // made when it is needed
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_LINEAR_SOLVER_H
