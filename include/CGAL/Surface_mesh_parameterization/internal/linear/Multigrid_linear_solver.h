// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_LINEAR_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_LINEAR_SOLVER_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Values.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Krylov_methods.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Scalar_multigrid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Solves a linear system whose unknowns sit at the vertices of a hierarchy, for as many right sides as it has
// `columns`: conjugate gradients if it is symmetric; if not, stabilized bi-conjugate gradients, or minimal residuals if
// it is not diagonally dominant. They are preconditioned by V-cycles, from the first guess of full multigrid. Where they
// do not arrive, it solves directly.
//
// `Real` is the type of the grids' numbers: with single precision they take half the memory, and are exact enough for a
// preconditioner.
template <class Real, int columns>
class Multigrid_linear_solver final
  : public Linear_solver
{
public:
  // `unknowns[i]` tells where unknown i sits; where there are none, all is solved directly, and there need be no
  // hierarchy. At `tied_vertices` there is no unknown, since the values of others give theirs.
  Multigrid_linear_solver(const Hierarchy_interpolation* hierarchy, std::shared_ptr<const Sparse_rows<double>> rows,
                          std::vector<Mesh_unknown> unknowns, const std::vector<Index>& tied_vertices = {})
    : m_system(hierarchy, std::move(rows), unknowns)
  {
    const std::vector<Index>& free_unknowns = m_system.free_unknowns();
    if (!m_system.is_regular() || free_unknowns.empty() || unknowns.empty())
      return;
    std::vector<Mesh_unknown> grid_unknowns;
    grid_unknowns.reserve(free_unknowns.size());
    for (const Index i : free_unknowns)
      grid_unknowns.push_back(unknowns[i]);
    std::vector<Mesh_unknown>().swap(unknowns);
    const bool is_in_plane = std::any_of(grid_unknowns.begin(), grid_unknowns.end(),
                                         [](const Mesh_unknown& u) { return u.component > 0; });
    m_multigrid = std::make_unique<Multigrid>(
        *hierarchy, grid_unknowns, m_system.template free_part<Real>(), tied_vertices,
        is_in_plane ? scalar_multigrid_options_in_plane() : Scalar_multigrid_options());
  }

  const std::shared_ptr<const Sparse_rows<double>>& rows() const override { return m_system.rows(); }

  Linear_solver_result solve(const std::vector<const double*>& right_sides, const std::vector<double*>& solutions,
                             const Linear_solver_options& options) override
  {
    const Side_by_side b{ right_sides, scales_of(right_sides) };
    Vector x;
    m_system.set_to_fixed_unknowns(b, x);
    Vector r(x.size());
    m_system.compute_residual(b, x, r);
    const Value start = m_system.norm(r);

    Linear_solver_result result;
    if (m_multigrid && m_multigrid->is_ready())
      result = iterate(b, x, r, start, options);
    else if (m_system.is_regular() && m_system.free_unknowns().empty())
      result.is_solved = m_system.backward_error(b, x) <= options.worst_backward_error;
    if (!result.is_solved && !is_stopped(options))
      solve_directly(b, x, r, start, options, result);
    if (result.is_solved)
      for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t c = 0; c < solutions.size(); ++c)
          solutions[c][i] = x[i][int(c)] / b.scales[int(c)];
    return result;
  }

private:
  typedef Scalar_multigrid<Real>           Multigrid;
  typedef Values<double, columns>          Value;
  typedef Value_vector<double, columns>    Vector;

  // Right sides, each times its scale, as one vector of their values. What there is less than columns is 0.
  struct Side_by_side
  {
    const std::vector<const double*>& right_sides;
    Value scales;

    Value operator[](Index i) const
    {
      Value values = Value::zero();
      for (int c = 0; c < columns; ++c)
        if (std::size_t(c) < right_sides.size())
          values[c] = scales[c] * right_sides[c][i];
      return values;
    }
  };

  // The powers of two that bring the right sides to about size 1, in rows of unit diagonal: so no square of a residual
  // over- or underflows.
  Value scales_of(const std::vector<const double*>& right_sides) const
  {
    constexpr int greatest_exponent = 1000;
    Value result = Value::all(1);
    for (std::size_t c = 0; c < right_sides.size(); ++c) {
      int exponent = -greatest_exponent;
      for (Index i = 0; i < m_system.size(); ++i)
        if (const double b = right_sides[c][i]; std::isfinite(b) && b != 0)
          exponent = (std::max)(exponent, std::ilogb(b) + std::ilogb(m_system.inverse_diagonal(i)));
      if (exponent > -greatest_exponent)
        result[int(c)] = std::ldexp(1., -(std::min)(exponent, greatest_exponent));
    }
    return result;
  }

  // The system as the Krylov methods see it.
  class Iteration
  {
  public:
    Iteration(const Multigrid_linear_solver& solver, const Value& target, const Linear_solver_options& options)
      : m_system(solver.m_system), m_multigrid(*solver.m_multigrid), m_space(m_multigrid),
        m_correction(m_system.size()), m_target(target), m_options(options)
    { }

    Index number_of_rows() const { return m_system.size(); }
    const Loops& loops() const { return m_system.loops(); }
    Value row_times(Index i, const Vector& x) const { return m_system.row_times(i, x); }
    Value multiply(const Vector& x, Vector& y, const Vector& z) const { return multiply_by_rows(*this, x, y, z); }
    Value squared_size(Index i, const Value& r) const { return m_system.squared_size(i, r); }

    // Incomplete factors may be indefinite, and the iteration arrives all the same.
    Value direction_factor(const Value& product, const Value& last_product) const
    {
      return quotient(product, last_product);
    }
    bool is_solved(const Vector& r) const { return is_less_or_equal(m_system.norm(r), m_target); }

    bool is_finished(const Value& squared_norm)
    {
      const double excess = greatest(quotient(sqrt(squared_norm), m_target));
      if (m_options.progress && !tell(m_options.tolerance * excess))
        return true;
      if (excess < m_least_excess / 2) {
        m_least_excess = excess;
        m_idle_steps = 0;
      }
      return !(excess > 1) || ++m_idle_steps > (has_minimal_residuals() ? m_options.patience_of_minimal_residuals
                                                                        : m_options.patience);
    }

    bool has_minimal_residuals() const { return !m_system.is_symmetric() && !m_system.is_diagonally_dominant(); }

    // M^-1 r
    Vector& precondition(const Vector& r)
    {
      const Value scale = give_to_grid(r);
      if (++m_cycles > m_options.most_v_cycles && columns == 1 && m_system.is_symmetric())
        m_space.use_k_cycles();
      m_multigrid.cycle(m_space);
      m_correction.assign(m_correction.size(), Value::zero());
      add_from_grid(scale, m_correction);
      return m_correction;
    }

    // x := x + the approximate solution for r by full multigrid
    void full_multigrid(const Vector& r, Vector& x)
    {
      const Value scale = give_to_grid(r);
      m_multigrid.full_cycle(m_space);
      add_from_grid(scale, x);
    }

  private:
    // Tells of a relative residual.
    bool tell(double residual) const
    {
      const std::size_t iterations = m_cycles / (m_system.is_symmetric() || has_minimal_residuals() ? 1 : 2);
      const double part =
          part_of_iteration(residual, m_options.tolerance, iterations, m_options.most_iterations);
      return m_options.progress->tell(iterations, residual, part);
    }

    // Writes r, scaled to the size of 1, to the finest grid; returns that scale.
    Value give_to_grid(const Vector& r)
    {
      Value greatest = Value::zero();
      for (const Value& value : r)
        greatest = max(greatest, abs(value));
      const Value inverse = quotient(Value::all(1), greatest);
      const std::vector<Index>& unknowns = m_system.free_unknowns();
      for (std::size_t k = 0; k < unknowns.size(); ++k)
        m_space.right_side(0)[k] = (r[unknowns[k]] * inverse).template cast<Real>();
      return m_system.free_part_scale() * greatest;
    }

    void add_from_grid(const Value& scale, Vector& x)
    {
      const std::vector<Index>& unknowns = m_system.free_unknowns();
      for (std::size_t k = 0; k < unknowns.size(); ++k)
        x[unknowns[k]] += scale * m_space.solution(0)[k].template cast<double>();
    }

    const Mesh_system& m_system;
    const Multigrid& m_multigrid;
    typename Multigrid::template Space<columns> m_space;
    Vector m_correction;
    Value m_target;
    const Linear_solver_options& m_options;
    double m_least_excess = (std::numeric_limits<double>::infinity)();      // of the residual over its target
    int m_idle_steps = 0;         // since the excess was halved
    std::size_t m_cycles = 0;
  };

  // Changes x, where the free unknowns are 0, and its residual r, whose norms are `start`.
  Linear_solver_result iterate(const Side_by_side& b, Vector& x, Vector& r, const Value& start,
                               const Linear_solver_options& options) const
  {
    Iteration iteration(*this, options.tolerance * start, options);
    iteration.full_multigrid(r, x);
    m_system.compute_residual(b, x, r);
    if (!is_less_or_equal(m_system.norm(r), start)) {
      m_system.set_to_fixed_unknowns(b, x);
      m_system.compute_residual(b, x, r);
    }
    Linear_solver_result result;
    for (int i = 0; i < options.most_starts && result.iterations < options.most_iterations && !iteration.is_solved(r) &&
                    !is_stopped(options);
         ++i) {
      const std::size_t left = options.most_iterations - result.iterations;
      if (m_system.is_symmetric()) {
        Vector direction(x.size());
        result.iterations += conjugate_gradients(iteration, x, r, direction, left);
      } else if (iteration.has_minimal_residuals())
        result.iterations += generalized_minimal_residuals(iteration, x, r, (std::min)(left, options.most_residuals));
      else
        result.iterations += stabilized_biconjugate_gradients(iteration, x, r, left);
      m_system.compute_residual(b, x, r);
    }
    result.residual = greatest(quotient(m_system.norm(r), start));
    result.is_solved = result.residual <= options.tolerance &&
                       iteration.is_solved(r);      // the residual may pass over a NaN, the norms over infinity
    return result;
  }

  // Solves by the solver that the options name. Where its solution is not good enough, a factorization of the rows takes
  // over, scaled to unit diagonal: of rows of very different size, a factorization takes bad pivots, and an iteration
  // that looks at the whole residual does not see the small ones.
  void solve_directly(const Side_by_side& b, Vector& x, Vector& r, const Value& start,
                      const Linear_solver_options& options, Linear_solver_result& result)
  {
    if (!options.may_solve_directly)
      return;
    result.is_direct = true;
    if (!m_direct_solver && !m_has_scaled_rows)
      m_direct_solver = options.make_direct_solver ? options.make_direct_solver(*m_system.rows())
                                                   : factorize_rows(*m_system.rows());
    apply_direct_solver(b, x, r, start, options, result);
    if (result.is_solved || m_has_scaled_rows || !m_system.is_regular() || is_stopped(options))
      return;
    m_direct_solver.reset();
    m_direct_solver = factorize_rows(m_system.rows_of_unit_diagonal());
    m_has_scaled_rows = true;
    apply_direct_solver(b, x, r, start, options, result);
  }

  // Writes x, its residual r, and what `result` tells of them, if there is a direct solver. The residual that rounding
  // leaves to a factorization may be above the tolerance.
  void apply_direct_solver(const Side_by_side& b, Vector& x, Vector& r, const Value& start,
                           const Linear_solver_options& options, Linear_solver_result& result) const
  {
    if (!m_direct_solver)
      return;
    m_direct_solver->solve_side_by_side(
        [&](Index i) { return m_has_scaled_rows ? m_system.inverse_diagonal(i) * b[i] : b[i]; }, x);
    m_system.compute_residual(b, x, r);
    result.residual = greatest(quotient(m_system.norm(r), start));
    const bool is_factorization = m_has_scaled_rows || !options.make_direct_solver;
    result.is_solved = m_system.backward_error(b, x) <= options.worst_backward_error &&
                       result.residual <= (is_factorization ? options.worst_residual : options.tolerance);
  }

  Mesh_system m_system;
  std::unique_ptr<Multigrid> m_multigrid;
  std::unique_ptr<Direct_solver> m_direct_solver;     // made when it is needed
  bool m_has_scaled_rows = false;                     // the direct solver
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_LINEAR_SOLVER_H
