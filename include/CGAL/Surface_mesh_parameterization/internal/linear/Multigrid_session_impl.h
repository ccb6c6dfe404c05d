// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_SESSION_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_SESSION_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/unknowns_match.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Multigrid_session::Multigrid_session(std::shared_ptr<const Hierarchy_interpolation> interpolation,
                                     Mesh_unknowns unknowns, const Linear_solver_options& options,
                                     Make_linear_solver make_solver, bool defers)
  : m_interpolation(std::move(interpolation)), m_unknowns(std::move(unknowns)), m_options(options),
    m_make_solver(make_solver), m_defers(defers)
{ }

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Multigrid_session::Multigrid_session(Make_hierarchy make_hierarchy, const Linear_solver_options& options,
                                     Make_linear_solver make_solver, bool defers)
  : m_make_hierarchy(std::move(make_hierarchy)), m_options(options), m_make_solver(make_solver), m_defers(defers)
{ }

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Multigrid_session::~Multigrid_session()
{
  m_options.progress = nullptr;     // nobody listens any more
  if (m_waiting_solution.use_count() <= 1)
    return;
  try {
    finish();
  }
  catch (...) { }      // a destructor cannot tell: who waits has no numbers
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Multigrid_session::start_stage(double factor) const
{
  constexpr double residual_of_no_solution = 1;
  Run_progress* const progress = m_options.progress;
  if (!progress)
    return true;
  const double part = factor * m_options.part_of_rest;
  if (m_interpolation) {
    const std::size_t levels = m_interpolation->number_of_levels();
    progress->start_stage(part, levels - 1, levels, m_interpolation->number_of_vertices());
  } else
    progress->start_stage(part);
  return progress->tell(0, residual_of_no_solution, 0);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Multigrid_session::set_up(const Sparse_matrix& matrix, const std::vector<Index>& tied_vertices)
{
  std::shared_ptr<const Sparse_rows<double>> rows = matrix.rows();
  if (m_solver && m_solver->rows() == rows)
    return true;
  finish();
  if (m_solver && m_has_grids)
    m_vain_matrices = m_last_was_direct ? m_vain_matrices + 1 : 0;
  m_solver.reset();
  return matrix.column_dimension() == matrix.row_dimension() && set_up(std::move(rows), tied_vertices);
}

// Where many rows are far from diagonally dominant, as those of authalic weights may be, the matrix is indefinite, and
// iterations arrive late or never. A matrix suits as well as its negative.
CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Multigrid_session::suits_multigrid(const Sparse_rows<double>& rows) const
{
  if (m_options.greatest_row_sum == (std::numeric_limits<double>::infinity)())
    return true;
  std::size_t wild_rows = 0, wild_rows_of_negative = 0;
  for (Index i = 0; i < rows.number_of_rows(); ++i) {
    double diagonal = 0, sum = 0;
    rows.for_each_entry(i, [&](Index column, double value) {
      if (column == i)
        diagonal = value;
      else
        sum += std::abs(value);
    });
    wild_rows += sum != 0 && !(sum <= m_options.greatest_row_sum * diagonal);
    wild_rows_of_negative += sum != 0 && !(sum <= -m_options.greatest_row_sum * diagonal);
  }
  const std::size_t most = (std::min)(m_options.most_wild_rows, rows.number_of_rows() / m_options.rows_for_a_wild_one);
  return (std::min)(wild_rows, wild_rows_of_negative) <= most;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Multigrid_session::find_hierarchy()
{
  if (m_make_hierarchy) {
    m_interpolation = m_make_hierarchy();
    m_make_hierarchy = nullptr;
    if (m_interpolation)
      m_unknowns.emplace(m_interpolation->ranks());
  }
  return m_interpolation != nullptr;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Multigrid_session::set_up(std::shared_ptr<const Sparse_rows<double>> rows, const std::vector<Index>& tied_vertices)
{
  if (m_options.has_grids && m_vain_matrices < m_options.most_vain_matrices && suits_multigrid(*rows))
    return find_hierarchy() && set_up_multigrid(std::move(rows), tied_vertices);
  return make_solver(std::move(rows), {}, {});
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Multigrid_session::set_up_multigrid(std::shared_ptr<const Sparse_rows<double>> rows,
                                         const std::vector<Index>& tied_vertices)
{
  std::vector<Mesh_unknown> unknowns = m_unknowns->in_order(rows->number_of_rows());
  const bool is_of_mesh = unknowns.size() == rows->number_of_rows();
  if (!unknowns_match(*m_interpolation, *rows, unknowns))
    unknowns = m_marks.unknowns();
  if (!unknowns_match(*m_interpolation, *rows, unknowns)) {
    if (m_marks.put_aside(rows->number_of_rows()))
      return true;
    if (!is_of_mesh && !m_marks.are_allowed())
      return false;
    unknowns.clear();
  }
  return make_solver(std::move(rows), std::move(unknowns), tied_vertices);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Multigrid_session::make_solver(std::shared_ptr<const Sparse_rows<double>> rows, std::vector<Mesh_unknown> unknowns,
                                    const std::vector<Index>& tied_vertices)
{
  constexpr double time_for_a_solution = 0.2;
  if (!start_stage(time_for_a_solution))
    return false;
  CGAL::Real_timer timer;
  timer.start();
  m_has_grids = !unknowns.empty();
  m_last_was_direct = false;
  m_solver =
      m_make_solver(m_interpolation.get(), std::move(rows), std::move(unknowns), tied_vertices, m_options.loops);
  ++m_summary.setups;
  m_summary.seconds_setup += timer.time();
  return true;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Multigrid_session::solve(const Sparse_matrix& matrix, const Vector& right_side, Vector& solution)
{
  const bool is_set_up = set_up(matrix);
  m_summary.failures += is_set_up ? 0 : 1;
  const bool is_solved =
      is_set_up && (m_defers && m_solver ? put_off(right_side, solution) : solve(right_side, solution));
  if (!is_solved)
    ++m_failures;
  else if (!m_waiting_solution)       // what waits may still fail
    m_failures = 0;
  if (is_stopped(m_options) || m_failures == m_options.most_failures)
    throw Solver_gives_up();
  return is_solved;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Multigrid_session::solve(const Vector& right_side, Vector& solution)
{
  return m_solver ? solve({ &right_side.values() }, { &solution.values() })
                  : m_marks.give(right_side.values(), solution.values());
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Multigrid_session::solve(std::shared_ptr<const Sparse_rows<double>> rows,
                              const std::vector<const std::vector<double>*>& right_sides,
                              const std::vector<std::vector<double>*>& solutions)
{
  if (set_up(std::move(rows), {}))
    return solve(right_sides, solutions);
  ++m_summary.failures;
  return false;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Multigrid_session::finish()
{
  if (const auto waiting = take_waiting_solution())
    m_all_solved = solve({ &m_waiting_right_side }, { &waiting->values }) && m_all_solved;
  return m_all_solved;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Multigrid_session::put_off(const Vector& right_side, Vector& solution)
{
  const std::vector<double>& b = right_side.values();      // which may be what waits
  if (b.size() != m_solver->rows()->number_of_rows())
    return false;
  if (const auto waiting = take_waiting_solution())
    return solve({ &m_waiting_right_side, &b }, { &waiting->values, &solution.values() });
  m_waiting_right_side = b;
  solution.values().resize(b.size());
  m_waiting_solution = solution.numbers();
  m_waiting_solution->solver = this;
  return true;
}

// What waits no longer. It has no numbers until it is solved.
CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::shared_ptr<Solver_vector::Numbers> Multigrid_session::take_waiting_solution()
{
  if (m_waiting_solution) {
    m_waiting_solution->solver = nullptr;
    std::fill(m_waiting_solution->values.begin(), m_waiting_solution->values.end(),
              std::numeric_limits<double>::quiet_NaN());
  }
  return std::exchange(m_waiting_solution, nullptr);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Multigrid_session::solve(const std::vector<const std::vector<double>*>& right_sides,
                              const std::vector<std::vector<double>*>& solutions)
{
  CGAL::Real_timer timer;
  timer.start();
  const std::size_t n = m_solver->rows()->number_of_rows();
  std::vector<const double*> b;
  for (const std::vector<double>* right_side : right_sides) {
    if (right_side->size() != n)
      return false;
    b.push_back(right_side->data());
  }
  if (!start_stage(1))
    return false;
  std::vector<double*> x;
  std::vector<std::size_t> sizes;       // which a failure leaves
  for (std::vector<double>* solution : solutions) {
    sizes.push_back(solution->size());
    solution->resize((std::max)(n, solution->size()));
    x.push_back(solution->data());
  }
  const Linear_solver_result result = m_solver->solve(b, x, m_options);
  m_summary.right_sides += b.size();
  m_summary.iterations = (std::max)(m_summary.iterations, result.iterations);
  if (result.is_solved)
    m_summary.residual = (std::max)(m_summary.residual, result.residual);
  else
    m_summary.failures += b.size();
  m_summary.direct_solutions += result.is_direct ? b.size() : 0;
  m_last_was_direct = result.is_direct && result.is_solved;
  if (result.is_factorized)
    m_options.make_direct_solver = nullptr;
  for (std::size_t i = 0; i < solutions.size(); ++i)
    solutions[i]->resize(result.is_solved ? n : sizes[i]);
  m_summary.seconds_solve += timer.time();
  return result.is_solved;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_SESSION_IMPL_H
