// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_ITERATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_ITERATION_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Complex.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Values.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Krylov_methods.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Scalar_multigrid.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A linear system on a mesh and its grids, as the Krylov methods see them, which iterate until the norm of the residual
// is at most `target` times the options' aim. The system, the grids and the options must live as long.
//
// Grids of complex numbers have an unknown for each two of the system, its parts.
template <class Multigrid, int columns>
class Multigrid_iteration
{
public:
  typedef Values<double, columns>          Value;
  typedef Value_vector<double, columns>    Vector;

  Multigrid_iteration(const Mesh_system& system, const Multigrid& multigrid, const Value& target,
                      const Linear_solver_options& options)
    : m_system(system), m_multigrid(multigrid), m_space(multigrid), m_correction(system.size()), m_target(target),
      m_options(options)
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
    return !(excess > aim()) || ++m_idle_steps > patience(excess);
  }

  bool has_minimal_residuals() const { return !m_system.is_symmetric() && !m_system.is_diagonally_dominant(); }

  // M^-1 r
  Vector& precondition(const Vector& r)
  {
    const Value scale = give_to_grid(r);
    ++m_cycles;
    if ((m_cycles > m_options.most_v_cycles || m_idle_steps > m_options.patience / 2) && columns == 1 &&
        m_system.is_symmetric())
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
  double aim() const
  {
    return (std::min)(1., (std::max)(m_options.aim, m_options.rounding_error / m_options.tolerance));
  }

  int patience(double excess) const
  {
    if (!(excess > 1))
      return m_options.patience_below_tolerance;
    return has_minimal_residuals() ? m_options.patience_of_minimal_residuals : m_options.patience;
  }

  // Tells of a relative residual.
  bool tell(double residual) const
  {
    const std::size_t iterations = m_cycles / (m_system.is_symmetric() || has_minimal_residuals() ? 1 : 2);
    const double part = part_of_iteration(residual, m_options.tolerance, iterations, m_options.most_iterations);
    return m_options.progress->tell(iterations, residual, part);
  }

  // Writes r, scaled to the size of 1, to the finest grid; returns that scale.
  Value give_to_grid(const Vector& r)
  {
    const Value greatest = loops().reduce(0, Index(r.size()), Value::zero(), [&](Index begin, Index end) {
      Value result = Value::zero();
      for (Index i = begin; i < end; ++i)
        result = max(result, abs(r[i]));
      return result;
    }, [](Value& a, const Value& b) { a = max(a, b); });
    const Value inverse = quotient(Value::all(1), greatest);
    const std::vector<Index>& unknowns = m_system.free_unknowns();
    loops().for_each(0, Index(unknowns.size()),
                     [&](Index k) { set_unknown(m_space.right_side(0), k, r[unknowns[k]] * inverse); });
    return m_system.free_part_scale() * greatest;
  }

  void add_from_grid(const Value& scale, Vector& x)
  {
    const std::vector<Index>& unknowns = m_system.free_unknowns();
    loops().for_each(0, Index(unknowns.size()),
                     [&](Index k) { x[unknowns[k]] += scale * unknown(m_space.solution(0), k); });
  }

  template <class Real>
  static void set_unknown(Value_vector<Real, columns>& x, std::size_t k, const Value& value)
  {
    x[k] = value.template cast<Real>();
  }

  template <class Real>
  static void set_unknown(Value_vector<Complex<Real>, columns>& x, std::size_t k, const Value& value)
  {
    (k % 2 == 0 ? x[k / 2][0].re : x[k / 2][0].im) = Real(value[0]);
  }

  template <class Real>
  static Value unknown(const Value_vector<Real, columns>& x, std::size_t k)
  {
    return x[k].template cast<double>();
  }

  template <class Real>
  static Value unknown(const Value_vector<Complex<Real>, columns>& x, std::size_t k)
  {
    return { { k % 2 == 0 ? x[k / 2][0].re : x[k / 2][0].im } };
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

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_ITERATION_H
