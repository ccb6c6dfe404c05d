// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FIRST_MAPS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FIRST_MAPS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/scale_of_area.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/best_similarity.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/first_maps.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/unfolding.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_with_springs.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The moves that given places ask for, and springs as far as they are stiff.
inline std::vector<Wanted_move> wanted_moves(const Level& level, const Level::Uv& uv)
{
  std::vector<Wanted_move> result;
  for (const Index v : fixed_vertices(level))
    result.push_back({ uv[v], level.fixed_place(v) });
  double greatest_stiffness = 0;
  for (const Triangulated_surface_3::Spring& s : springs_of(level))
    greatest_stiffness = (std::max)(greatest_stiffness, s.stiffness);
  for (const Triangulated_surface_3::Spring& s : springs_of(level))
    if (s.stiffness > 0)
      result.push_back({ uv[s.vertex], s.place, s.stiffness / greatest_stiffness });
  return result;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void move_near_places(const Level& level, Level::Uv& uv)
{
  if (const std::vector<Wanted_move> moves = wanted_moves(level, uv); !moves.empty())
    move_by(best_similarity(moves), level.rings(), level.loops(), uv);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void follow_springs(const Level_energy_with_springs& energy, Level::Uv& uv)
{
  const Level& level = energy.level();
  const std::vector<Wanted_move> moves = wanted_moves(level, uv);
  if (moves.empty() || !fixed_vertices(level).empty())
    return;
  double least = energy(uv);
  Level::Uv best = uv;
  for (const Similarity_2& similarity : { best_motion(moves), best_similarity(moves) }) {
    Level::Uv moved = uv;
    if (!move_by(similarity, level.rings(), level.loops(), moved))
      continue;
    if (const double value = energy(moved); value < least) {
      least = value;
      best = std::move(moved);
    }
  }
  uv = std::move(best);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code compute_first_map(const Level& level, Level::Uv& uv)
{
  const bool must_meet_places = level.is_finest() && !fixed_vertices(level).empty();
  if (must_meet_places && compute_Tutte_embedding_at_places(level, uv) == OK)
    return OK;
  const Error_code status = compute_Tutte_embedding(level, uv);
  if (status == OK) {
    scale_to_area(level, false, uv);
    move_near_places(level, uv);
  }
  return status;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void scale_to_energy(const Level_energy& energy, Level::Uv& uv)
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

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool unfold_to_lower_energy(const Level_energy& energy, bool has_map, const Refinement_options& options,
                            Level::Uv& uv)
{
  const Level& level = energy.level();
  Level::Uv unfolded;
  const bool is_better = unfold(level, unfolded) && !(has_map && !(energy(unfolded) < energy(uv))) &&
                         !(options.is_globally_injective && has_crossings(level.rings(), unfolded));
  if (is_better)
    uv.swap(unfolded);
  return is_better;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code choose_first_map(const Level_energy& energy, const Refinement_options& options, Level::Uv& uv)
{
  const Level& level = energy.level();
  const Error_code status = compute_first_map(level, uv);
  const bool is_at_places = status == OK && !fixed_vertices(level).empty() && displaced_vertices(level, uv).empty();
  if (is_at_places || !unfold_to_lower_energy(energy, status == OK, options, uv))
    return status;
  move_near_places(level, uv);
  return OK;
}

// Whether a map that was scaled is still valid, and its borders apart if they must be.
inline bool is_good_after_scaling(const Level& level, bool borders_must_not_meet, const Level::Uv& uv)
{
  return is_map_valid(level.rings(), uv, level.loops()) && !(borders_must_not_meet && has_crossings(level.rings(), uv));
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void scale_to_area(const Level& level, bool borders_must_not_meet, Level::Uv& uv)
{
  const auto is_good = [&](const Level::Uv& result) {
    return is_good_after_scaling(level, borders_must_not_meet, result);
  };
  if (const double scale = scale_of_area(level, uv); scale > 0)
    scale_map(scale, is_good, uv);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double scale_to_area(const Level_energy& energy, bool borders_must_not_meet, Level::Uv& uv)
{
  const Level& level = energy.level();
  double value = (std::numeric_limits<double>::infinity)();
  const auto is_good = [&](const Level::Uv& result) {
    if (!is_good_after_scaling(level, borders_must_not_meet, result))
      return false;
    value = energy(result);
    return std::isfinite(value) || !std::isfinite(energy(uv));
  };
  if (const double scale = scale_of_area(level, uv); scale > 0)
    scale_map(scale, is_good, uv);
  return std::isfinite(value) ? value : energy(uv);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FIRST_MAPS_IMPL_H
