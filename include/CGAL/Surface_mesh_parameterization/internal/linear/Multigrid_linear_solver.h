// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_LINEAR_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_LINEAR_SOLVER_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Complex.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Values.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Krylov_methods.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_iteration.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Scalar_multigrid.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Scaled_right_sides.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/complex_rows.h>

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
// it is not diagonally dominant. They are preconditioned by V-cycles, from the first guess of full multigrid. Where
// they do not arrive, it solves directly.
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
                          std::vector<Mesh_unknown> unknowns, const std::vector<Index>& tied_vertices = {},
                          const Loops& loops = Loops())
    : m_system(hierarchy, std::move(rows), unknowns, loops)
  {
    const std::vector<Index>& free_unknowns = m_system.free_unknowns();
    if (!m_system.is_regular() || free_unknowns.empty() || unknowns.empty())
      return;
    std::vector<Mesh_unknown> grid_unknowns;
    grid_unknowns.reserve(free_unknowns.size());
    for (const Index i : free_unknowns)
      grid_unknowns.push_back(unknowns[i]);
    std::vector<Mesh_unknown>().swap(unknowns);
    make_grids(*hierarchy, grid_unknowns, tied_vertices);
  }

  const std::shared_ptr<const Sparse_rows<double>>& rows() const override { return m_system.rows(); }

  // What is far from the origin is solved for near it, if that is so for all unknowns of a right side: else a residual
  // that is small for the distance would not be so for the solution's extent.
  Linear_solver_result solve(const std::vector<const double*>& right_sides, const std::vector<double*>& solutions,
                             const Linear_solver_options& options) override
  {
    std::vector<const double*> near_right_sides = right_sides;
    std::vector<double> distances(right_sides.size());
    std::vector<std::vector<double>> moved(right_sides.size());
    for (std::size_t c = 0; c < right_sides.size(); ++c)
      if (const double distance = m_system.distance_from_origin(right_sides[c]); distance != 0) {
        moved[c] = moved_right_side(right_sides[c], distance);
        if (std::all_of(moved[c].begin(), moved[c].end(), [](double b) { return std::isfinite(b); })) {
          near_right_sides[c] = moved[c].data();
          distances[c] = distance;
        }
      }
    const Linear_solver_result result = solve_near_origin(near_right_sides, solutions, options);
    for (std::size_t c = 0; c < right_sides.size() && result.is_solved; ++c)
      if (distances[c] != 0)
        for (Index i = 0; i < m_system.size(); ++i)
          solutions[c][i] += distances[c];
    return result;
  }

private:
  typedef Scalar_multigrid<Real>             Multigrid;
  typedef Scalar_multigrid<Complex<Real>>    Complex_multigrid;
  typedef Values<double, columns>            Value;
  typedef Value_vector<double, columns>      Vector;
  typedef Scaled_right_sides<columns>        Right_sides;

  // That of the solution less a number.
  std::vector<double> moved_right_side(const double* right_side, double number) const
  {
    std::vector<double> result(right_side, right_side + m_system.size());
    for (Index i = 0; i < m_system.size(); ++i)
      rows()->for_each_entry(i, [&](Index, double value) { result[i] -= value * number; });
    return result;
  }

  Linear_solver_result solve_near_origin(const std::vector<const double*>& right_sides,
                                         const std::vector<double*>& solutions,
                                         const Linear_solver_options& given_options)
  {
    Linear_solver_options options = given_options;
    options.tolerance = (std::max)(options.tolerance, options.rounding_error);
    Approximation a = first_approximation(right_sides);
    Linear_solver_result result;
    if (m_multigrid || m_complex_multigrid)
      result = iterate(a, options);
    else if (m_system.is_regular() && m_system.free_unknowns().empty())
      result.is_solved = m_system.backward_error(a.b, a.x) <= options.worst_backward_error;
    if (!result.is_solved && !is_stopped(options))
      solve_directly(a, options, result);
    if (result.is_solved)
      for (std::size_t i = 0; i < a.x.size(); ++i)
        for (std::size_t c = 0; c < solutions.size(); ++c)
          solutions[c][i] = a.x[i][int(c)] / a.b.scales[int(c)];
    return result;
  }

  // The grids are of complex numbers if the matrix is: they take half of the time and of the memory.
  void make_grids(const Hierarchy_interpolation& hierarchy, const std::vector<Mesh_unknown>& unknowns,
                  const std::vector<Index>& tied_vertices)
  {
    Sparse_rows<Real> rows = m_system.template free_part<Real>();
    if constexpr (columns == 1)
      if (m_system.is_symmetric() && are_parts_of_complex(unknowns))
        if (auto complex = complex_rows(rows)) {
          rows = Sparse_rows<Real>();
          make_if_ready(m_complex_multigrid, hierarchy, complex_unknowns(unknowns), std::move(*complex), tied_vertices,
                        complex_multigrid_options(), m_system.loops());
          return;
        }
    const bool is_in_plane =
        std::any_of(unknowns.begin(), unknowns.end(), [](const Mesh_unknown& u) { return u.component > 0; });
    Scalar_multigrid_options options = is_in_plane ? scalar_multigrid_options_in_plane() : Scalar_multigrid_options();
    if (!m_system.is_symmetric())
      options.least_pivot = -(std::numeric_limits<double>::infinity)();
    make_if_ready(m_multigrid, hierarchy, unknowns, std::move(rows), tied_vertices, options, m_system.loops());
  }

  template <class Grids, class... Arguments>
  static void make_if_ready(std::unique_ptr<Grids>& grids, Arguments&&... arguments)
  {
    grids = std::make_unique<Grids>(std::forward<Arguments>(arguments)...);
    if (!grids->is_ready())
      grids.reset();
  }

  // The powers of two that bring the right sides to about size 1, in rows of unit diagonal: so no square of a residual
  // over- or underflows.
  Value scales_of(const std::vector<const double*>& right_sides) const
  {
    constexpr int greatest_exponent = 1000;
    Value result = Value::all(1);
    for (std::size_t c = 0; c < right_sides.size(); ++c) {
      int exponent = (std::numeric_limits<int>::min)();
      for (Index i = 0; i < m_system.size(); ++i)
        if (const double b = right_sides[c][i]; std::isfinite(b) && b != 0)
          exponent = (std::max)(exponent, std::ilogb(b) + std::ilogb(m_system.inverse_diagonal(i)));
      if (exponent > (std::numeric_limits<int>::min)())
        result[int(c)] = std::ldexp(1., -std::clamp(exponent, -greatest_exponent, greatest_exponent));
    }
    return result;
  }

  // The solutions as far as they are known, and what they leave of the right sides.
  struct Approximation
  {
    Right_sides b;
    Vector x, r;             // b less the matrix times x
    Value norms_at_start;    // of the residuals r
  };

  // 0 where the rows do not give the unknowns right away.
  Approximation first_approximation(const std::vector<const double*>& right_sides) const
  {
    Approximation a{ { right_sides, scales_of(right_sides) }, {}, {}, {} };
    m_system.set_to_fixed_unknowns(a.b, a.x);
    a.r.resize(a.x.size());
    compute_residual(a);
    a.norms_at_start = m_system.norm(a.r);
    return a;
  }

  void compute_residual(Approximation& a) const { m_system.compute_residual(a.b, a.x, a.r); }

  // The greatest of all right sides.
  double relative_residual(const Approximation& a) const
  {
    return greatest(quotient(m_system.norm(a.r), a.norms_at_start));
  }

  Linear_solver_result iterate(Approximation& a, const Linear_solver_options& options) const
  {
    if constexpr (columns == 1)
      if (m_complex_multigrid)
        return iterate(*m_complex_multigrid, a, options);
    return iterate(*m_multigrid, a, options);
  }

  // Improves the first approximation.
  template <class Grids>
  Linear_solver_result iterate(const Grids& grids, Approximation& a, const Linear_solver_options& options) const
  {
    Multigrid_iteration<Grids, columns> iteration(m_system, grids, options.tolerance * a.norms_at_start, options);
    iteration.full_multigrid(a.r, a.x);
    compute_residual(a);
    if (!is_less_or_equal(m_system.norm(a.r), a.norms_at_start)) {
      m_system.set_to_fixed_unknowns(a.b, a.x);
      compute_residual(a);
    }
    Linear_solver_result result;
    for (int i = 0; i < options.most_starts && result.iterations < options.most_iterations &&
                    !iteration.is_solved(a.r) && !is_stopped(options);
         ++i) {
      const std::size_t left = options.most_iterations - result.iterations;
      if (m_system.is_symmetric()) {
        Vector direction(a.x.size());
        result.iterations += conjugate_gradients(iteration, a.x, a.r, direction, left);
      } else if (iteration.has_minimal_residuals())
        result.iterations +=
            generalized_minimal_residuals(iteration, a.x, a.r, (std::min)(left, options.most_residuals));
      else
        result.iterations += stabilized_biconjugate_gradients(iteration, a.x, a.r, left);
      compute_residual(a);
    }
    result.residual = relative_residual(a);
    result.is_solved = result.residual <= options.tolerance
                           ? iteration.is_solved(a.r)      // the residual may pass over a NaN, the norms over infinity
                           : result.residual <= options.worst_residual &&
                                 m_system.backward_error_of_free_unknowns(a.b, a.x) <= options.rounding_error;
    return result;
  }

  // Solves by the solver that the options name. Where its solution is not good enough, or none is named, by a
  // factorization of the rows, scaled to unit diagonal: of rows of very different size, a factorization takes bad
  // pivots, and an iteration that looks at the whole residual does not see the small ones.
  void solve_directly(Approximation& a, const Linear_solver_options& options, Linear_solver_result& result)
  {
    if (!options.may_solve_directly)
      return;
    result.is_direct = true;
    if (!m_is_factorized) {
      if (options.make_direct_solver) {
        if (!m_direct_solver)
          m_direct_solver = options.make_direct_solver(*m_system.rows());
        apply_direct_solver(a, options, result);
        if (result.is_solved || is_stopped(options))
          return;
      }
      m_direct_solver.reset();      // its memory, before the factorization needs some
      m_direct_solver = factorize_rows(m_system.rows_of_unit_diagonal());
      m_is_factorized = true;
    }
    apply_direct_solver(a, options, result);
    result.is_factorized = result.is_solved;
    if (result.is_solved) {      // that takes less time now than iterations in vain
      m_multigrid.reset();
      m_complex_multigrid.reset();
    }
  }

  // Writes the approximation, and what `result` tells of it, if there is a direct solver. The residual that rounding
  // leaves to a factorization may be above the tolerance.
  void apply_direct_solver(Approximation& a, const Linear_solver_options& options, Linear_solver_result& result) const
  {
    if (!m_direct_solver)
      return;
    m_direct_solver->solve_side_by_side(
        [&](Index i) { return m_is_factorized ? m_system.inverse_diagonal(i) * a.b[i] : a.b[i]; }, a.x);
    compute_residual(a);
    result.residual = relative_residual(a);
    result.is_solved = m_system.backward_error(a.b, a.x) <= options.worst_backward_error &&
                       result.residual <= (m_is_factorized ? options.worst_residual : options.tolerance);
  }

  Mesh_system m_system;
  std::unique_ptr<Multigrid> m_multigrid;                     // null where a factorization has to solve
  std::unique_ptr<Complex_multigrid> m_complex_multigrid;     // if the matrix is complex, in place of the other
  std::unique_ptr<Direct_solver> m_direct_solver;     // made when it is needed
  bool m_is_factorized = false;                       // the direct solver, if there is one, is of the scaled rows
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_LINEAR_SOLVER_H
