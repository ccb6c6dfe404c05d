// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_IMPL_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/input_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/insert_new_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Nested_iteration::Nested_iteration(Refinable_method& method, const Nested_iteration_options& options,
                                   Any_hierarchy_visitor* visitor, Parameterization_summary& summary)
  : m_method(method), m_options(options), m_visitor(visitor), m_progress(visitor), m_summary(summary)
{
  m_options.hierarchy.progress = &m_progress;
  m_timer_of_level.start();
  m_must_keep_apart = m_method.keep_borders_apart(true);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::run(Triangulated_surface_3 surface, CGAL::Real_timer& timer, std::vector<Point_2>& uv)
{
  constexpr double part_of_hierarchy = 0.05;      // of the time, more or less
  m_start.swap(uv);
  double seconds_hierarchy = 0, seconds_parameterize = 0;      // of all attempts
  for (;;) {
    m_progress.start_stage(part_of_hierarchy);
    const Collapse_hierarchy_3 hierarchy(std::move(surface), m_options.hierarchy, m_method.loops());
    m_summary = Parameterization_summary();
    m_summary.seconds_hierarchy = seconds_hierarchy = timer.time() - seconds_parameterize;

    Level::Uv uv_by_rank;
    uv_by_rank.reserve(hierarchy.number_of_vertices());
    const Error_code status = m_summary.error.code = parameterize(hierarchy, uv_by_rank);
    m_summary.seconds_parameterize = seconds_parameterize = timer.time() - seconds_hierarchy;
    m_summary.converged = m_summary.converged && status == OK;
    if (status == OK) {
      uv.resize(uv_by_rank.size());
      for (Index rank = 0; rank < uv.size(); ++rank)
        uv[hierarchy.input_vertex(rank)] = uv_by_rank[rank];
      return OK;
    }
    if (status != ERROR_NO_1_TO_1_MAPPING ||
        !(find_start_at_scale_of_places(hierarchy) || can_try_another_way(hierarchy)))
      return m_progress.is_stopped() ? m_summary.error.code = ERROR_STOPPED : status;
    surface = input_surface(hierarchy);
  }
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::parameterize(const Collapse_hierarchy_3& hierarchy, Level::Uv& uv)
{
  if (m_progress.is_stopped() || (m_visitor && !m_visitor->hierarchy_built(hierarchy)))
    return ERROR_STOPPED;

  Level level(hierarchy, 0, m_method.loops(), &m_progress);
  Error_code status = ERROR_NO_1_TO_1_MAPPING;
  if (!m_start.empty())
    status = refine_start(level, uv);
  if (status == ERROR_NO_1_TO_1_MAPPING)
    status = parameterize_level_by_level(level, uv);
  if (status == OK)
    status = finish(level, uv);
  return m_options.must_hold_places && level.is_finest() ? check_places(level, uv, status) : status;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::check_places(const Level& level, const Level::Uv& uv, Error_code status)
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

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::refine_start(Level& level, Level::Uv& uv)
{
  m_timer_of_level.reset();
  level.go_to(level.hierarchy().number_of_levels() - 1);
  start_stage(level);
  for (Index rank = 0; rank < level.number_of_vertices(); ++rank)
    uv.push_back(m_start[level.hierarchy().input_vertex(rank)]);
  m_start = std::vector<Point_2>();      // another attempt starts anew
  if (is_free(level) && !bring_to_scale(level, m_must_keep_apart, uv))
    return ERROR_NO_1_TO_1_MAPPING;
  return refine(level, uv);
}

// The algorithm of the paper, section 3: with the levels built, parameterizes the coarsest one; then, for each finer
// level, inserts the vertices that it has in addition and lets the method refine the map from there.
//
// What keeps borders apart costs time, and shuts the way to maps in which they would not meet in the end. So it acts
// only from where they do.
CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::parameterize_level_by_level(Level& level, Level::Uv& uv)
{
  m_summary.levels.clear();
  m_method.keep_borders_apart(false);
  m_watches_borders = m_must_keep_apart;
  m_map_apart.clear();
  m_level_apart = 0;
  level.go_to(0);
  Error_code status = parameterize_coarsest(level, uv);
  if (status == OK)
    status = climb(level, uv);
  if (status == OK && m_watches_borders && m_map_apart.size() < uv.size())
    status = climb_with_borders_apart(level, uv);
  return status;
}

// The time that a level takes is about proportional to its vertices, and the finest one has to converge.
CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Nested_iteration::start_stage(const Level& level)
{
  constexpr double factor_of_finest_level = 10, part_of_end = 0.1;
  const Collapse_hierarchy_3& hierarchy = level.hierarchy();
  const double work = double(level.number_of_vertices());
  double rest = (factor_of_finest_level + part_of_end) * double(hierarchy.number_of_vertices());
  for (std::size_t i = level.index(); i + 1 < hierarchy.number_of_levels(); ++i)
    rest += double(hierarchy.number_of_vertices(i));
  m_progress.start_stage((level.is_finest() ? factor_of_finest_level : 1) * work / rest, level.index(),
                         hierarchy.number_of_levels(), level.number_of_vertices());
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::climb(Level& level, Level::Uv& uv)
{
  Error_code status = OK;
  while (status == OK && !level.is_finest()) {
    m_timer_of_level.reset();
    level.go_to(level.index() + 1);
    start_stage(level);
    status = insert_vertices(level, uv);
    if (status == OK)
      status = refine(level, uv);
  }
  return status;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::climb_with_borders_apart(Level& level, Level::Uv& uv)
{
  m_watches_borders = false;
  m_method.keep_borders_apart(true);
  level.go_to(m_level_apart);
  m_summary.levels.resize(m_map_apart.empty() ? 0 : m_level_apart + 1);
  Error_code status = OK;
  if (m_map_apart.empty())
    status = parameterize_coarsest(level, uv);
  else
    uv.swap(m_map_apart);
  return status == OK ? climb(level, uv) : status;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::parameterize_coarsest(const Level& level, Level::Uv& uv)
{
  m_timer_of_level.reset();
  start_stage(level);
  const Error_code status = m_method.parameterize_coarsest(level, uv);
  if (m_progress.is_stopped())
    return ERROR_STOPPED;
  return status == OK ? refine(level, uv) : status;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::refine(const Level& level, Level::Uv& uv)
{
  m_summary.levels.emplace_back();
  Level_summary& summary = m_summary.levels.back();
  summary.vertices = level.number_of_vertices();
  summary.faces = level.number_of_faces();
  if (level.is_finest() && m_options.flips.policy == Flip_policy::REPAIR && m_method.has_other_way())
    m_map_before = uv;
  const Error_code status = m_method.refine(level, uv, summary);
  summary.seconds = m_timer_of_level.time();
  if (m_progress.is_stopped() || (status == OK && !level.progressed(summary, 1)))
    return ERROR_STOPPED;
  if (status != OK)
    return status;
  if (m_watches_borders && !has_crossings(border_edges(level.rings()), uv)) {
    m_map_apart = uv;
    m_level_apart = level.index();
  }
  return !m_visitor || m_visitor->level_parameterized(level, uv, summary) ? OK : ERROR_STOPPED;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::insert_vertices(const Level& level, Level::Uv& uv) const
{
  if (m_method.is_flip_free())
    return insert_new_vertices(level, uv) == no_index ? OK : ERROR_NO_1_TO_1_MAPPING;
  insert_at_stored_places(level, uv);
  return OK;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::finish(const Level& level, Level::Uv& uv)
{
  m_summary.energy = m_summary.levels.back().energy_end;
  m_summary.converged = m_summary.levels.back().converged;
  m_is_finished = true;
  Error_code status = settle_flips(level, uv);
  if (status == OK && m_options.round)
    status = round(level, uv);
  if (status != OK)
    return status;
  return m_progress.finish() ? OK : ERROR_STOPPED;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::settle_flips(const Level& level, Level::Uv& uv)
{
  constexpr std::size_t greatest_part_moved = 10;      // a tenth of the vertices
  const Error_code status = m_method.settle_flips(
      m_options.flips, level.rings(), [&] { return surface_by_rank(level); }, uv, m_summary);
  if (m_map_before.empty() || (status == OK && m_summary.moved_vertices == 0))
    return status;
  m_summary.energy = m_method.energy(level, uv);
  const bool leaves_little = m_summary.moved_vertices > uv.size() / greatest_part_moved;
  return status == OK && !leaves_little && displaced_vertices(level, uv).empty() ? OK : replace_map(level, status, uv);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::replace_map(const Level& level, Error_code status, Level::Uv& uv)
{
  if (!is_map_valid(level.rings(), m_map_before))
    return status;
  Level_summary summary = m_summary.levels.back();      // its iterations go on
  summary.converged = false;
  const Error_code other_status = m_method.refine_without_flips(level, m_map_before, summary);
  if (m_progress.is_stopped())
    return ERROR_STOPPED;
  if (other_status != OK)
    return status;
  m_summary.levels.back().iterations = summary.iterations;
  m_summary.levels.back().cycles = summary.cycles;
  const double energy = m_method.energy(level, m_map_before);
  const bool is_better = status != OK || energy < m_summary.energy ||
                         displaced_vertices(level, m_map_before).size() < displaced_vertices(level, uv).size();
  if (!is_better)
    return status;
  uv.swap(m_map_before);
  m_summary.energy = energy;
  m_summary.converged = summary.converged;
  m_summary.moved_vertices = uv.size();
  m_summary.is_replaced = true;
  return OK;
}

// What is promised of the map is promised of what the user gets.
CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::round(const Level& level, Level::Uv& uv)
{
  if (!m_method.is_flip_free() && m_options.flips.policy == Flip_policy::KEEP)
    return OK;
  const bool is_good = round_map(level.rings(), m_options.round, level.scale_exponent(), uv) &&
                       !(m_must_keep_apart && has_crossings(border_edges(level.rings()), uv));
  return is_good ? OK : ERROR_NO_1_TO_1_MAPPING;
}

// The power of two by which the box of the fixed vertices' places is greater than that of the vertices, more or less.
inline int scale_exponent_of_places(const Triangulated_surface_3& surface)
{
  CGAL::Bbox_2 places;
  CGAL::Bbox_3 points;
  for (const Triangulated_surface_3::Fixed_vertex& fixed : surface.fixed_vertices) {
    places += fixed.place.bbox();
    points += surface.points[fixed.vertex].bbox();
  }
  const double ratio = std::hypot(places.x_span(), places.y_span()) /
                       std::hypot(points.x_span(), points.y_span(), points.z_span());
  return std::isnormal(ratio) ? int(std::lround(std::log2(ratio))) : 0;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Nested_iteration::find_start_at_scale_of_places(const Collapse_hierarchy_3& hierarchy)
{
  if (m_has_other_scale || hierarchy.fixed_places().empty())
    return false;
  m_has_other_scale = true;
  Triangulated_surface_3 surface = input_surface(hierarchy);
  const int exponent = scale_exponent_of_places(surface);
  if (exponent == 0)
    return false;
  for (Point_3& p : surface.points)
    p = Point_3(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent));
  const Parameterization_summary summary = m_summary;
  const bool is_finished = std::exchange(m_is_finished, false);
  const Collapse_hierarchy_3 scaled(std::move(surface), m_options.hierarchy, m_method.loops());
  Level::Uv uv;
  const Error_code status = parameterize(scaled, uv);
  m_summary = summary;
  m_is_finished = is_finished && status != OK;
  if (status != OK)
    return false;
  m_start.resize(uv.size());
  for (Index rank = 0; rank < uv.size(); ++rank)
    m_start[scaled.input_vertex(rank)] = uv[rank];
  return true;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Nested_iteration::can_try_another_way(const Collapse_hierarchy_3& hierarchy)
{
  constexpr unsigned int most_seeds = 3;
  if (!m_method.is_flip_free() || m_is_finished)
    return false;
  const bool has_coarsest_map = !m_summary.levels.empty();
  m_is_flat = m_is_flat || (has_coarsest_map && hierarchy.number_of_levels() == 1);
  if (has_coarsest_map) {
    ++m_options.hierarchy.random_seed;
    if ((++m_number_of_seeds < most_seeds && !m_is_flat) || m_method.leave_room())
      return true;
  }
  if (m_is_flat)
    return false;
  m_is_flat = has_coarsest_map || hierarchy.number_of_vertices(0) > m_options.hierarchy.coarsest_size;
  m_options.hierarchy.coarsest_size = m_is_flat ? hierarchy.number_of_vertices() : hierarchy.number_of_vertices(0) / 2;
  return true;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_IMPL_H
