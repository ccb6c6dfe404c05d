// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_DISTORTION_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_DISTORTION_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/border/separate_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Free_minimizer.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/first_maps.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/lead_to_places.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/minimize_distortion.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Conformal_refiner.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_with_springs.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/soften_springs.h>

#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The springs of a level, whose stiffness is relative to the sum of the triangles' energies. Weighted by area it is in
// units of the level. On a coarse level, which may have no room for their places, springs that are much stiffer than
// triangles would crush these.
inline std::vector<Triangulated_surface_3::Spring> springs_of_energy(const Level_energy& energy, Triangle_weight weight,
                                                                     const Level::Uv& uv)
{
  constexpr double greatest_stiffness_on_coarse = 10;
  const Level& level = energy.level();
  std::vector<Triangulated_surface_3::Spring> result = springs_of(level);
  if (weight == Triangle_weight::AREA)
    for (Triangulated_surface_3::Spring& s : result)
      s.stiffness = std::ldexp(s.stiffness, 2 * level.scale_exponent());
  if (!level.is_finest())
    soften_springs(energy, greatest_stiffness_on_coarse, uv, result);
  return result;
}

// What a stiff spring asks of one vertex is for all its neighbors to follow: only Newton's method moves it.
inline Refinement_options options_with_springs(Refinement_options options)
{
  options.optimizer = Optimizer::NEWTON;
  options.number_of_local_steps = 0;
  return options;
}

// Whether the map of a level is a first one, not the user's, from which springs are to pull.
inline bool has_first_map_and_springs(const Level& level)
{
  return level.index() == 0 && !level.is_finest() && fixed_vertices(level).empty() &&
         !level.hierarchy().springs().empty();
}

// Springs that pull at triangles in which a first map has next to no area crush them for good.
inline Error_code minimize_near_places(const Level_energy& free_energy, Level::Uv& uv,
                                       const Refinement_options& options)
{
  Level_summary unused;
  const Error_code status = Free_minimizer(free_energy, options, uv, unused).run();
  if (status == OK)
    move_near_places(free_energy.level(), uv);
  return status;
}

// Leads the map of a level to given places. A first map that gets lost on the way is replaced by Tutte's with the
// border at its places, if that is one: not sooner, since from there minima may be a little higher.
inline Error_code lead_map_to_places(const Level_energy_with_springs& energy, bool borders_must_not_meet,
                                     Level::Uv& uv, Level_summary& summary)
{
  const Error_code status = lead_to_places(energy, borders_must_not_meet, uv, summary);
  Level::Uv other;
  if (status != ERROR_NO_1_TO_1_MAPPING || energy.level().index() > 0 ||
      compute_Tutte_embedding_at_places(energy.level(), other) != OK)
    return status;
  uv.swap(other);
  return lead_to_places(energy, borders_must_not_meet, uv, summary);
}

// Minimizes the energy together with that of the level's springs, and with vertices at given places. A coarse level may
// have no room for one of these: it waits for a finer one.
inline Error_code minimize_with_places(const Level_energy& free_energy, Level::Uv& uv,
                                       const Refinement_options& given_options, Level_summary& summary)
{
  const Level& level = free_energy.level();
  const Refinement_options options =
      level.hierarchy().springs().empty() ? given_options : options_with_springs(given_options);
  const bool borders_must_not_meet = options.is_globally_injective;
  if (has_first_map_and_springs(level) && minimize_near_places(free_energy, uv, given_options) == ERROR_STOPPED)
    return ERROR_STOPPED;
  const auto springs_at_uv = [&] { return springs_of_energy(free_energy, options.triangle_weight, uv); };
  follow_springs(Level_energy_with_springs(free_energy, springs_at_uv()), uv);
  const Level_energy_with_springs energy(free_energy, springs_at_uv());
  take_better_places(energy, uv);
  move_to_single_place(level, uv);
  if (borders_must_not_meet && !separate_borders(level, uv))
    return ERROR_NO_1_TO_1_MAPPING;
  const double energy_start = energy(uv) / energy.unit();
  Error_code status =
      energy.is_flip_free() ? lead_map_to_places(energy, borders_must_not_meet, uv, summary) : OK;
  if (status != ERROR_STOPPED && (status == OK || !level.is_finest()))
    status = minimize_from(energy, uv, options, summary);
  summary.energy_start = energy_start;
  return status;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code minimize_energy(const Level_energy& energy, Level::Uv& uv, const Refinement_options& options,
                           Level_summary& summary)
{
  if (!is_free(energy.level()))
    return minimize_with_places(energy, uv, options, summary);
  start_unfolded(energy, options, uv);
  return refine_map(energy, uv, options, summary);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code minimize_flip_free(const Level_energy& energy, bool scales_to_area, Level::Uv& uv,
                              const Refinement_options& options, Level_summary& summary)
{
  if (!is_free(energy.level()))
    return minimize_with_places(energy, uv, options, summary);
  start_unfolded(energy, options, uv);
  const Error_code status = Free_minimizer(energy, options, uv, summary).run();
  if (status == OK && scales_to_area) {
    // Rounding may matter in tiny triangles.
    summary.energy_end = scale_to_area(energy, options.is_globally_injective, uv) / energy.unit();
    summary.converged = summary.converged && std::isfinite(summary.energy_end);
  }
  return status;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code minimize_conformal_energy(const Level& level, Level::Uv& uv, const Refinement_options& options,
                                     Level_summary& summary)
{
  return Conformal_refiner(level, uv, options, summary).run() ? OK : ERROR_STOPPED;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_DISTORTION_IMPL_H
