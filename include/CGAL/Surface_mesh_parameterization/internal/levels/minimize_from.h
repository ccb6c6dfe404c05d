// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_FROM_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_FROM_H

#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/separate_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/unfolding.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Current_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_refiner.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_refiner_options.h>

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

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_FROM_H
