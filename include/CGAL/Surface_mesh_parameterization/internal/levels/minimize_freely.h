// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_FREELY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_FREELY_H

#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/separate_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/first_maps.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/unfolding.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Current_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_refiner.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_refiner_options.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// Starts from the unfolding of a surface that has one with hardly any distortion, if that is better by more than
// rounding: a map of the user's that is as good stays where it is.
inline void start_unfolded(const Level_energy& energy, const Refinement_options& options, Level::Uv& uv)
{
  const bool is_experiment = options.number_of_local_steps > 0;
  if (energy.level().is_finest() && !is_experiment && is_almost_developable(energy.level()) &&
      !Current_energy(energy, uv, Level_refiner_options()).is_least())
    unfold_to_lower_energy(energy, true, options, uv);
}

inline Error_code refine_map(const Level_energy& energy, Level::Uv& uv, const Refinement_options& options,
                             Level_summary& summary)
{
  return Level_refiner(energy, uv, options, summary).run();
}

// Minimizes the energy from `uv`. What keeps borders apart is paid for with energy: where that leads astray, `uv`
// stays.
inline Error_code minimize_from(const Level_energy& energy, Level::Uv& uv, const Refinement_options& options,
                                Level_summary& summary)
{
  const bool borders_must_not_meet = options.is_globally_injective;
  if (!borders_must_not_meet)
    return refine_map(energy, uv, options, summary);
  summary.energy_start = energy(uv) / energy.unit();      // told where there is no refinement, too
  if (!separate_borders(energy.level(), uv))
    return ERROR_NO_1_TO_1_MAPPING;
  const Level::Uv start = uv;
  if (const Error_code status = refine_map(energy, uv, options, summary); status != OK)
    return status;
  if (!(energy(uv) <= energy(start)) || has_crossings(energy.level().rings(), uv)) {
    uv = start;
    summary.energy_end = summary.energy_start;
    summary.converged = false;
  }
  return OK;
}

// Whether another start costs little.
inline bool is_small(const Level& level)
{
  constexpr std::size_t most_vertices = 5000;
  return level.number_of_vertices() <= most_vertices;
}

// Whether the energy is so high that another start may lead to a better map.
inline bool is_far_above_minimum(const Level_energy& energy, double value)
{
  constexpr double greatest_ratio_of_small = 2, greatest_ratio_of_large = 4;
  const double minimum = energy.minimum_of_map();
  return minimum > 0 &&
         !(value <= (is_small(energy.level()) ? greatest_ratio_of_small : greatest_ratio_of_large) * minimum);
}

// Whether a run on a small surface has ended where much may be left, and not at a low limit of its user's.
inline bool has_not_arrived(const Level_energy& energy, double value, const Refinement_options& options,
                            std::size_t iterations)
{
  constexpr double least_ratio = 1.01;
  constexpr std::size_t many_iterations = 100;
  const double minimum = energy.minimum_of_map();
  return energy.level().is_finest() && is_small(energy.level()) && minimum > 0 && value > least_ratio * minimum &&
         (iterations < options.number_of_iterations || iterations >= many_iterations);
}

// Replaces a result by what comes of another start, if that is better; on a large level only if the start is, too.
inline void start_again(const Level_energy& energy, Level::Uv start, Level::Uv& uv, const Refinement_options& options,
                        Level_summary& summary, Error_code& status)
{
  const double value = energy(uv);
  if (status == OK && !is_small(energy.level()) && !(energy(start) < value))
    return;
  const Level_summary before = summary;
  summary.converged = false;
  const Error_code other_status = minimize_from(energy, start, options, summary);
  const bool is_better = other_status == OK && !(status == OK && !(energy(start) < value));
  summary.energy_start = before.energy_start;
  if (other_status == ERROR_STOPPED)
    status = ERROR_STOPPED;
  if (is_better) {
    uv.swap(start);
    status = OK;
  } else {
    summary.energy_end = before.energy_end;
    summary.converged = before.converged;
  }
}

// What coarse levels decide may be wrong where they have little in common with the surface. So a bad result is compared
// with what comes of a first map of the finest level, and of the same at the scale of least energy: surfaces that do
// not arrive from the one may do so from the other.
inline void start_again_from_first_map(const Level_energy& energy, Level::Uv& uv, const Refinement_options& options,
                                       Level_summary& summary, Error_code& status)
{
  const bool began_there = energy.level().index() == 0;
  Level::Uv first;
  if ((began_there && energy.is_scale_invariant()) || choose_first_map(energy, options, first) != OK)
    return;
  if (!began_there)
    start_again(energy, first, uv, options, summary, status);
  if (!energy.is_scale_invariant() && status != ERROR_STOPPED &&
      (status != OK || is_far_above_minimum(energy, energy(uv)))) {
    scale_to_energy(energy, first);
    start_again(energy, first, uv, options, summary, status);
  }
}

// Minimizes the energy from `uv` without regard to places, or from another start where that is far better.
inline Error_code minimize_freely(const Level_energy& energy, Level::Uv& uv, const Refinement_options& options,
                                  Level_summary& summary)
{
  const bool is_experiment = options.number_of_local_steps > 0;
  const std::size_t iterations_before = summary.iterations;
  Error_code status = minimize_from(energy, uv, options, summary);
  if (status == ERROR_STOPPED || status == GIVEN_UP || energy.level().is_draft())
    return status;
  const double value = summary.energy_end * energy.unit();
  const bool is_bad =
      is_far_above_minimum(energy, value) ||
      (!summary.converged && has_not_arrived(energy, value, options, summary.iterations - iterations_before));
  if (status != OK || (!is_experiment && is_bad))
    start_again_from_first_map(energy, uv, options, summary, status);
  return status;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_FREELY_H
