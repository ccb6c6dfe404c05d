// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MAP_FINISHER_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MAP_FINISHER_IMPL_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/input_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Map_finisher.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/move_to_places.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Map_finisher::Map_finisher(Refinable_method& method, const Nested_iteration_options& options, bool must_keep_apart,
                           Parameterization_summary& summary)
  : m_method(method), m_options(options), m_must_keep_apart(must_keep_apart), m_summary(summary)
{ }

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Map_finisher::remember_start(const Level::Uv& uv)
{
  if (m_options.flips.policy == Flip_policy::REPAIR && m_method.has_flip_free_alternative())
    m_start = uv;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Map_finisher::finish(const Level& level, Level::Uv& uv)
{
  m_summary.energy = m_summary.levels.back().energy_end;
  m_summary.converged = m_summary.levels.back().converged;
  Error_code status = settle_flips(level, true, uv);
  if (status == ERROR_NO_1_TO_1_MAPPING && !m_start.empty())
    status = settle_flips(level, false, uv);
  if (status == OK && !m_options.places_at_end.empty())
    status = go_to_places(level, uv);
  else if (status == OK && m_options.round)
    status = round(level, uv);
  return status;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Map_finisher::settle_flips(const Level& level, bool may_give_up, Level::Uv& uv)
{
  Flip_settlement settlement = m_options.flips;
  settlement.may_give_up = may_give_up && !m_start.empty();
  const Error_code status = m_method.settle_flips(
      settlement, level.rings(), [&] { return surface_by_rank(level); }, uv, m_summary);
  const bool is_repaired = m_summary.moved_vertices > 0;
  if (is_repaired && m_method.has_energy())
    m_summary.energy = m_method.energy(level, uv);
  if (m_start.empty() || (status == OK && !is_repaired))
    return status;
  constexpr double greatest_factor = 1.01;      // of the energy, by a repair whose map stays without comparison
  const bool is_good = status == OK && !leaves_little(m_summary.moved_vertices, uv.size()) &&
                       m_summary.energy <= greatest_factor * m_summary.levels.back().energy_end &&
                       displaced_vertices(level, uv).empty();
  return is_good ? OK : replace_map(level, may_give_up, status, uv);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Map_finisher::Other_map Map_finisher::make_other_map(const Level& level)
{
  Other_map other;
  if (!is_map_valid(level.rings(), m_start, level.loops()))
    return other;
  other.uv = m_start;
  Level_summary& of_level = m_summary.levels.back();
  Level_summary summary = of_level;      // its iterations go on
  summary.converged = false;
  other.status = m_method.refine_without_flips(level, other.uv, summary);
  if (other.status == OK) {
    of_level.iterations = summary.iterations;
    of_level.cycles = summary.cycles;
    other.energy = m_method.energy(level, other.uv);
    other.converged = summary.converged;
  }
  // What the method minimizes without flips is another energy, which may lead away from a good start.
  const double energy_of_start = m_method.energy(level, m_start);
  const bool is_worse = other.status == ERROR_NO_1_TO_1_MAPPING ||
                        (other.status == OK && energy_of_start < other.energy);
  if (is_worse && displaced_vertices(level, m_start).empty())
    return { OK, m_start, energy_of_start, false };
  return other;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Map_finisher::replace_map(const Level& level, bool may_give_up, Error_code status, Level::Uv& uv)
{
  constexpr double greatest_factor = 2;      // of the energy, by a map that is taken before all of the repair is tried
  if (!m_other)
    m_other = make_other_map(level);
  if (m_other->status == ERROR_STOPPED)
    return ERROR_STOPPED;
  if (m_other->status != OK)
    return status;
  const auto displaced = [&](const Level::Uv& map) { return displaced_vertices(level, map).size(); };
  const bool replaces_failure = status != OK && (!may_give_up || m_other->energy <= greatest_factor * m_summary.energy),
             replaces_repair = status == OK && (m_other->energy < m_summary.energy ||
                                                displaced(m_other->uv) < displaced(uv));
  if (!replaces_failure && !replaces_repair)
    return status;
  uv.swap(m_other->uv);
  m_summary.energy = m_other->energy;
  m_summary.converged = m_other->converged;
  m_summary.moved_vertices = uv.size();
  m_summary.is_replaced = true;
  return OK;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Map_finisher::go_to_places(const Level& level, Level::Uv& uv)
{
  Level::Uv moved = uv;
  const bool is_good =
      move_to_places(level, m_options.places_at_end, m_options.round, m_must_keep_apart, moved) &&
      !(m_method.has_energy() && has_risen(level, uv, moved));
  if (!is_good) {
    m_has_lost_places = true;
    m_summary.error.place = Parameterization_error::VERTEX;
    m_summary.error.index = m_options.places_at_end.front().vertex;
    return ERROR_NO_1_TO_1_MAPPING;
  }
  uv.swap(moved);
  if (m_method.has_energy())
    m_summary.energy = m_method.energy(level, uv);
  return OK;
}

// What counts for energies whose minimum is 0 is how they grow when lengths are doubled.
CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Map_finisher::has_risen(const Level& level, const Level::Uv& before, const Level::Uv& after) const
{
  constexpr double greatest_rise = 0.01, rounding = 1e-6;
  const double energy = m_method.energy(level, before), of_double = m_method.energy(level, scaled(before, 2));
  return !(m_method.energy(level, after) - energy <=
           greatest_rise * std::abs(energy) + rounding * std::abs(of_double - energy));
}

// What is promised of the map is promised of what the user gets.
CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Map_finisher::round(const Level& level, Level::Uv& uv)
{
  if (m_options.flips.policy == Flip_policy::KEEP &&
      (!m_method.is_flip_free() || !is_map_valid(level.rings(), uv, level.loops())))
    return OK;
  const auto crosses_itself = [&] { return has_crossings(level.rings(), uv); };
  const bool must_stay_apart = m_must_keep_apart && !crosses_itself();
  const bool is_good = round_map(level.rings(), m_options.round, level.scale_exponent(), uv, level.loops()) &&
                       !(must_stay_apart && crosses_itself());
  if (is_good)
    return OK;
  if (are_finite(uv))
    return ERROR_NO_1_TO_1_MAPPING;
  m_summary.error.cause = cause_of_overflow;
  return ERROR_WRONG_PARAMETER;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Map_finisher::check_places(const Level& level, const Level::Uv& uv, Error_code status)
{
  if ((status != OK && status != ERROR_NO_1_TO_1_MAPPING) || uv.size() < level.number_of_vertices())
    return status;
  const std::vector<Index> displaced = displaced_vertices(level, uv);
  if (displaced.empty())
    return status;
  const auto distance = [&](Index v) { return (uv[v] - level.fixed_place(v)).squared_length(); };
  const Index farthest = *std::max_element(displaced.begin(), displaced.end(),
                                           [&](Index v, Index w) { return distance(v) < distance(w); });
  m_summary.error.place = Parameterization_error::VERTEX;
  m_summary.error.index = level.hierarchy().input_vertex(farthest);
  return ERROR_NO_1_TO_1_MAPPING;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MAP_FINISHER_IMPL_H
