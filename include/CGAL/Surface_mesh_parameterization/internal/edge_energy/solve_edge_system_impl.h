// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_SOLVE_EDGE_SYSTEM_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_SOLVE_EDGE_SYSTEM_IMPL_H

#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/solve_edge_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// How the vertices of a map have to move for the residuals of their edge system to vanish.
class Map_correction
{
public:
  // For the matrix of the system, which may have rows of unit sum.
  Map_correction(const Edge_system& system, std::vector<Index> free_vertices, const Level::Uv& uv,
                 bool has_unit_sums = false)
    : m_vertices(std::move(free_vertices)), m_right_side(2 * m_vertices.size()), m_solution(2 * m_vertices.size())
  {
    const std::size_t n = m_vertices.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Vector_2 b = has_unit_sums ? system.residual(m_vertices[k], uv) : system.right_side(m_vertices[k], uv);
      m_right_side[k] = b.x();
      m_right_side[n + k] = b.y();
    }
  }

  // Those of x, and then those of y.
  const double* right_side() const { return m_right_side.data(); }
  double* solution() { return m_solution.data(); }

  // Returns whether the map is finite.
  bool apply(Level::Uv& uv) const
  {
    const std::size_t n = m_vertices.size();
    for (std::size_t k = 0; k < n; ++k) {
      Point_2& p = uv[m_vertices[k]];
      p = p + Vector_2(m_solution[k], m_solution[n + k]);
      if (!is_finite(p))
        return false;
    }
    return true;
  }

private:
  std::vector<Index> m_vertices;
  std::vector<double> m_right_side, m_solution;
};

// A factorization of rows whose sums are very different takes bad pivots. Only symmetric ones keep them.
template <bool is_symmetric>
Error_code solve_directly(const Edge_system& system, Level::Uv& uv)
{
  const std::vector<Index> vertices = system.free_vertices();
  if (vertices.size() == system.size())
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  system.put_in_one_point(uv);
  if (vertices.empty())
    return OK;
  std::unique_ptr<Direct_solver> solver;
  if constexpr (is_symmetric)
    if (!system.has_replaced_rows())
      solver = factorize_symmetric_rows(system.matrix(vertices));
  const bool has_unit_sums = !solver;
  if (!solver)
    solver = factorize_rows(system.matrix(vertices, has_unit_sums));
  if (!solver)
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  Map_correction correction(system, vertices, uv, has_unit_sums);
  solver->solve(correction.right_side(), correction.solution(), 2);
  return correction.apply(uv) ? OK : ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
}

// Hands on what a linear solver tells, as iterations on a level.
class Iterations_on_level final
  : public Progress_listener
{
public:
  Iterations_on_level(const Level& level, Level_summary& summary) : m_level(level), m_summary(summary) { }

  bool progressed(const Parameterization_progress& progress) override
  {
    m_summary.iterations = progress.iterations;
    return m_level.progressed(m_summary, progress.part_done);
  }

private:
  const Level& m_level;
  Level_summary& m_summary;
};

inline Linear_solver_result correct_by_multigrid(const Edge_system& system, const Linear_solver_options& options,
                                                 Level::Uv& uv)
{
  const Level& level = system.level();
  const std::vector<Index> vertices = system.free_vertices();
  std::vector<Mesh_unknown> unknowns;
  unknowns.reserve(vertices.size());
  for (const Index v : vertices)
    unknowns.push_back({ v, 0 });
  Map_correction correction(system, vertices, uv);
  const Hierarchy_interpolation interpolation(level.hierarchy().vertices(), level.index());
  const auto solver =
      make_multigrid_linear_solver<2>(&interpolation, std::make_shared<Sparse_rows<double>>(system.matrix(vertices)),
                                      std::move(unknowns), {}, level.loops());
  const std::size_t n = vertices.size();
  Linear_solver_result result = solver->solve({ correction.right_side(), correction.right_side() + n },
                                              { correction.solution(), correction.solution() + n }, options);
  if (result.is_solved)
    result.is_solved = correction.apply(uv);
  return result;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code solve_by_multigrid(const Edge_system& system, double tolerance, std::size_t most_iterations, Level::Uv& uv,
                              Level_summary& summary)
{
  constexpr double coarse_residual = 1e-2;      // the levels below the finest only have to hand on a good start
  constexpr double safety = 0.99;               // for rounding
  const Level& level = system.level();
  const double wanted_residual = level.is_finest() ? tolerance : (std::max)(tolerance, coarse_residual);
  double residual = system.relative_residual(uv);
  summary.energy_start = summary.energy_end = system.energy(uv);
  summary.converged = residual <= wanted_residual;
  if (!level.progressed(summary, 0))
    return ERROR_STOPPED;
  if (summary.converged)
    return OK;
  if (!std::isfinite(residual))
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  if (residual > 1) {      // a start that is worse than none
    system.put_in_one_point(uv);
    residual = 1;
  }

  Iterations_on_level listener(level, summary);
  Run_progress progress(level.is_watched() ? &listener : nullptr);
  Linear_solver_options options;
  options.tolerance = safety * wanted_residual / residual;
  options.most_iterations = most_iterations;
  options.progress = &progress;
  options.may_solve_directly = level.is_finest();
  const Linear_solver_result result = correct_by_multigrid(system, options, uv);
  summary.iterations = result.iterations;
  summary.converged = result.is_solved;
  summary.energy_end = system.energy(uv);
  if (progress.is_stopped() || !level.progressed(summary, 1))
    return ERROR_STOPPED;
  return result.is_solved || !level.is_finest() ? OK : ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_SOLVE_EDGE_SYSTEM_IMPL_H
