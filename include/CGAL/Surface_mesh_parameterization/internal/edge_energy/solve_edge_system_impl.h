// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_SOLVE_EDGE_SYSTEM_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_SOLVE_EDGE_SYSTEM_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/solve_edge_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

template <bool is_symmetric>
Error_code solve_directly(const Edge_system& system, Level::Uv& uv)
{
  const Level& level = system.level();
  uv.assign(system.size(), Point_2(0, 0));
  std::vector<Index> unknown(system.size(), no_index);
  Index n = 0;
  for (Index i = 0; i < system.size(); ++i)
    if (level.is_fixed(i))
      uv[i] = level.fixed_place(i);
    else
      unknown[i] = n++;
  if (n == 0)
    return OK;
  if (n == system.size())
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;

  std::vector<Matrix_entry> entries;
  entries.reserve(n + level.rings().number_of_slots());
  std::vector<double> right_sides(2 * std::size_t(n), 0.), solutions(2 * std::size_t(n));
  for (Index i = 0; i < system.size(); ++i) {
    const Index row = unknown[i];
    if (row == no_index)
      continue;
    entries.push_back({ row, row, system.sum_of_weights(i) });
    const Level::Ring ring = level.one_ring(i);
    for (std::size_t k = 0; k < ring.size(); ++k)
      if (const Index column = unknown[ring[k]]; column != no_index)
        entries.push_back({ row, column, -system.weight(i, k) });
      else {
        right_sides[row] += system.weight(i, k) * uv[ring[k]].x();
        right_sides[n + row] += system.weight(i, k) * uv[ring[k]].y();
      }
  }
  std::unique_ptr<Direct_solver> solver;
  if constexpr (is_symmetric)
    solver = factorize_symmetric(n, entries);
  else
    solver = factorize(n, entries);
  if (!solver)
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  solver->solve(right_sides.data(), solutions.data(), 2);
  for (Index i = 0; i < system.size(); ++i)
    if (const Index row = unknown[i]; row != no_index) {
      uv[i] = Point_2(solutions[row], solutions[n + row]);
      if (!is_finite(uv[i]))
        return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    }
  return OK;
}

// The residuals that a sweep meets are about those that it leaves; only when they are small enough the true ones are
// computed.
CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code solve_by_sweeps(const Edge_system& system, Relaxation_factor& factor, double tolerance,
                           std::size_t most_sweeps, Level::Uv& uv, Level_summary& summary)
{
  constexpr double coarse_residual = 1e-3;      // the levels below the finest only have to hand on a good start
  constexpr std::size_t sweeps_for_an_energy = 16;      // for a visitor: it takes as long as a sweep
  const Level& level = system.level();
  const double wanted_residual = level.is_finest() ? tolerance : (std::max)(tolerance, coarse_residual);
  summary.energy_start = summary.energy_end = system.energy(uv);
  summary.converged = system.relative_residual(uv) <= wanted_residual;
  factor.start(system.size());
  bool may_go_on = level.progressed(summary, 0);
  while (may_go_on && !summary.converged && summary.iterations < most_sweeps) {
    const double residual = system.sweep(uv, factor.value());
    factor.learn(residual);
    ++summary.iterations;
    summary.converged = residual <= wanted_residual && system.relative_residual(uv) <= wanted_residual;
    if (level.is_watched() && summary.iterations % sweeps_for_an_energy == 0)
      summary.energy_end = system.energy(uv);
    may_go_on =
        level.progressed(summary, part_of_iteration(residual, wanted_residual, summary.iterations, most_sweeps));
  }
  if (!may_go_on)
    return ERROR_STOPPED;
  summary.energy_end = system.energy(uv);
  summary.vertex_visits = summary.iterations * system.size();
  return std::isfinite(summary.energy_end) ? OK : ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_SOLVE_EDGE_SYSTEM_IMPL_H
