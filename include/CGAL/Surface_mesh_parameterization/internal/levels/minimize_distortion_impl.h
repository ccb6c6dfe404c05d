// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_DISTORTION_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_DISTORTION_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/separate_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/best_similarity.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/lead_to_places.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/minimize_distortion.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/unfolding.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Conformal_refiner.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_with_springs.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_refiner.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Brings a map as near to the places that are given or wished for as a similarity does.
inline void move_near_places(const Level& level, Level::Uv& uv)
{
  std::vector<std::pair<Point_2, Point_2>> pairs;
  for (const Index v : fixed_vertices(level))
    pairs.push_back({ uv[v], level.fixed_place(v) });
  for (const Triangulated_surface_3::Spring& s : springs(level))
    pairs.push_back({ uv[s.vertex], s.place });
  if (!pairs.empty())
    apply_if_valid(best_similarity(pairs), level, uv);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code compute_first_map(const Level& level, Level::Uv& uv)
{
  const Error_code status = compute_Tutte_embedding(level, uv);
  if (status == OK) {
    scale_to_area(level, false, uv);
    move_near_places(level, uv);
  }
  return status;
}

// Scales a map so that the energy is about least: Tutte's map of a long surface is far too small in most places if it
// has the right area.
inline void scale_to_energy(const Level_energy& energy, Level::Uv& uv)
{
  constexpr double least_step = 0.01;
  double exponent = 0, least = energy(uv);
  const auto try_exponent = [&](double other) {
    const double value = energy(scaled(uv, std::exp2(other)));
    if (!(value < least))
      return false;
    least = value;
    exponent = other;
    return true;
  };
  for (double step = 1; step > least_step; step /= 4)
    while (try_exponent(exponent + step) || try_exponent(exponent - step))
      ;
  Level::Uv result = scaled(uv, std::exp2(exponent));
  if (is_map_valid(energy.level().rings(), result, energy.level().loops()))
    uv.swap(result);
}

// Replaces a map by the unfolded level, if that is a map of less energy, or there is none yet.
inline bool unfold_to_lower_energy(const Level_energy& energy, bool has_map, const Refinement_options& options,
                                   Level::Uv& uv)
{
  const Level& level = energy.level();
  Level::Uv unfolded;
  const bool is_better = unfold(level, unfolded) && !(has_map && !(energy(unfolded) < energy(uv))) &&
                         !(options.is_globally_injective && has_crossings(border_edges(level.rings()), unfolded));
  if (is_better)
    uv.swap(unfolded);
  return is_better;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code choose_first_map(const Level_energy& energy, const Refinement_options& options, Level::Uv& uv)
{
  const Level& level = energy.level();
  const Error_code status = compute_first_map(level, uv);
  if (!unfold_to_lower_energy(energy, status == OK, options, uv))
    return status;
  move_near_places(level, uv);
  return OK;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double scale_of_area(const Level& level, const Level::Uv& uv)
{
  double area = 0, image_area = 0;
  for (const Level::Triangle& t : level.triangles()) {
    area += doubled_area(level.point(t[0]), level.point(t[1]), level.point(t[2]));
    image_area += doubled_area(uv[t[0]], uv[t[1]], uv[t[2]]);
  }
  return std::sqrt(area / image_area);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void scale_to_area(const Level& level, bool borders_must_not_meet, Level::Uv& uv)
{
  const double scale = scale_of_area(level, uv);
  if (!(scale > 0))
    return;
  Level::Uv result = scaled(uv, scale);
  const bool is_spoilt = !is_map_valid(level.rings(), result, level.loops()) ||
                         (borders_must_not_meet && has_crossings(border_edges(level.rings()), result));
  if (is_spoilt)
    result = scaled(uv, std::exp2(std::round(std::log2(scale))));
  uv.swap(result);
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
  summary.energy_start = energy(uv) / energy.unit();
  if (!separate_borders(energy.level(), uv))
    return ERROR_NO_1_TO_1_MAPPING;
  const Level::Uv start = uv;
  if (const Error_code status = refine_map(energy, uv, options, summary); status != OK)
    return status;
  if (!(energy(uv) <= energy(start)) || has_crossings(border_edges(energy.level().rings()), uv)) {
    uv = start;
    summary.energy_end = summary.energy_start;
    summary.converged = false;
  }
  return OK;
}

// The springs of a level, whose stiffness is relative to the sum of the triangles' energies. Weighted by area it is in
// units of the level.
inline std::vector<Triangulated_surface_3::Spring> springs_of_energy(const Level_energy& energy, Triangle_weight weight)
{
  std::vector<Triangulated_surface_3::Spring> result = springs(energy.level());
  if (weight == Triangle_weight::AREA)
    for (Triangulated_surface_3::Spring& s : result)
      s.stiffness = std::ldexp(s.stiffness, 2 * energy.level().scale_exponent());
  return result;
}

// What a stiff spring asks of one vertex is for all its neighbors to follow: only Newton's method moves it.
inline Refinement_options options_with_springs(Refinement_options options)
{
  options.optimizer = Optimizer::NEWTON;
  options.number_of_local_steps = 0;
  return options;
}

// The same with the springs of the level and with vertices at given places. A coarse level may have no room for one of
// these: it waits for a finer one.
inline Error_code minimize_with_places(const Level_energy& free_energy, Level::Uv& uv,
                                       const Refinement_options& given_options, Level_summary& summary)
{
  const Level& level = free_energy.level();
  const Refinement_options options =
      level.hierarchy().springs().empty() ? given_options : options_with_springs(given_options);
  const Level_energy_with_springs energy(free_energy, springs_of_energy(free_energy, options.triangle_weight));
  const bool borders_must_not_meet = options.is_globally_injective;
  go_to_places(energy, uv);
  if (borders_must_not_meet && !separate_borders(level, uv))
    return ERROR_NO_1_TO_1_MAPPING;
  const double energy_start = energy(uv) / energy.unit();
  Error_code status = energy.is_flip_free() ? lead_to_places(energy, borders_must_not_meet, uv, summary) : OK;
  if (status != ERROR_STOPPED && (status == OK || !level.is_finest()))
    status = minimize_from(energy, uv, options, summary);
  summary.energy_start = energy_start;
  return status;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code minimize_energy(const Level_energy& energy, Level::Uv& uv, const Refinement_options& options,
                           Level_summary& summary)
{
  return is_free(energy.level()) ? refine_map(energy, uv, options, summary)
                                 : minimize_with_places(energy, uv, options, summary);
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
  const double greatest_ratio = is_small(energy.level()) ? 2 : 4;
  const double minimum = energy.minimum() * energy.total_weight();
  return minimum > 0 && !(value <= greatest_ratio * minimum);
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

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code minimize_flip_free(const Level_energy& energy, bool scales_to_area, Level::Uv& uv,
                              const Refinement_options& options, Level_summary& summary)
{
  const Level& level = energy.level();
  if (!is_free(level))
    return minimize_with_places(energy, uv, options, summary);
  const bool is_experiment = options.number_of_local_steps > 0;
  if (level.is_finest() && !is_experiment && is_almost_developable(level))
    unfold_to_lower_energy(energy, true, options, uv);
  Error_code status = minimize_from(energy, uv, options, summary);
  if (status == ERROR_STOPPED || status == GIVEN_UP)
    return status;
  const double value = summary.energy_end * energy.unit();
  if (!level.is_draft() && (status != OK || (!is_experiment && is_far_above_minimum(energy, value))))
    start_again_from_first_map(energy, uv, options, summary, status);
  if (status == OK && scales_to_area) {
    scale_to_area(level, options.is_globally_injective, uv);
    summary.energy_end = energy(uv) / energy.unit();      // rounding may matter in tiny triangles
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
