// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_IMPL_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/covered_triangles.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/vertex_order.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/insert_new_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/starting_map.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Nested_iteration::Nested_iteration(Refinable_method& method, const Nested_iteration_options& options,
                                   Any_hierarchy_visitor* visitor, Run_progress& progress,
                                   Parameterization_summary& summary)
  : m_method(method), m_visitor(visitor), m_progress(progress), m_summary(summary),
    m_must_hold_places(options.must_hold_places), m_overlap_bound(options.overlap_bound),
    m_must_keep_apart(method.keep_borders_apart(true)),
    m_finisher(method, options, m_must_keep_apart, summary)
{
  m_timer_of_level.start();
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::run(const Collapse_hierarchy_3& hierarchy, Start start, Level::Uv& uv)
{
  if (!m_progress.is_stopped() && m_visitor && !m_visitor->hierarchy_built(hierarchy))
    m_progress.stop();
  if (m_progress.is_stopped())
    return ERROR_STOPPED;

  Level level(hierarchy, 0, m_method.loops(), &m_progress);
  Error_code status = ERROR_NO_1_TO_1_MAPPING;
  if (!start.uv.empty())
    status = refine_start(level, std::move(start), uv);
  if (status == ERROR_NO_1_TO_1_MAPPING)
    status = parameterize_level_by_level(level, uv);
  if (status == OK)
    status = finish(level, uv);
  return m_must_hold_places && level.is_finest() ? m_finisher.check_places(level, uv, status) : status;
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
  if (m_must_keep_apart)
    m_watch.begin();
  level.go_to(0);
  Error_code status = parameterize_coarsest(level, uv);
  if (status == OK)
    status = climb(level, uv);
  return status == OK ? keep_borders_apart_if_they_met(level, uv) : status;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::parameterize_coarsest(Level& level, Level::Uv& uv)
{
  m_timer_of_level.reset();
  start_stage(level);
  const Error_code status = m_method.parameterize_coarsest(level, uv);
  if (m_progress.is_stopped())
    return ERROR_STOPPED;
  return status == OK ? refine(level, uv) : status;
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
Error_code Nested_iteration::refine_start(Level& level, Start start, Level::Uv& uv)
{
  m_timer_of_level.reset();
  level.go_to(level.hierarchy().number_of_levels() - 1);
  uv = by_rank(level.hierarchy(), std::exchange(start.uv, {}));
  if (is_free(level) && !bring_to_scale(level, m_must_keep_apart, uv))
    return ERROR_NO_1_TO_1_MAPPING;
  if (m_must_keep_apart && !start.is_users) {
    m_method.keep_borders_apart(false);
    m_watch.begin_at(level, uv);
  }
  start_stage(level);
  const Error_code status = refine(level, uv);
  return status == OK ? keep_borders_apart_if_they_met(level, uv) : status;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::keep_borders_apart_if_they_met(Level& level, Level::Uv& uv)
{
  if (!m_watch.have_met())
    return OK;
  if (m_overlap_bound == 1)
    return climb_with_borders_apart(level, uv);
  return keep_borders_apart_if_that_pays(level, uv);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::climb_with_borders_apart(Level& level, Level::Uv& uv)
{
  m_watch.end();
  m_method.keep_borders_apart(true);
  if (Level::Uv start = m_watch.take_start(); !start.empty()) {
    m_summary.levels.clear();
    m_timer_of_level.reset();
    uv = std::move(start);
    return refine(level, uv);
  }
  auto [map_apart, index] = m_watch.take_map_apart();
  level.go_to(index);
  m_summary.levels.resize(map_apart.empty() ? 0 : index + 1);
  Error_code status = OK;
  if (map_apart.empty())
    status = parameterize_coarsest(level, uv);
  else
    uv = std::move(map_apart);
  return status == OK ? climb(level, uv) : status;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::keep_borders_apart_if_that_pays(Level& level, Level::Uv& uv)
{
  constexpr double greatest_rise_of_energy = 0.02, hopeless_rise_of_energy = 1;      // relative
  const double covered = covered_part(level.triangles(), uv);
  if (covered > m_overlap_bound)
    return OK;
  Level::Uv free = uv;
  std::vector<Level_summary> levels = m_summary.levels;
  const double energy = levels.back().energy_end;
  if (covered > 0 && energy != 0)
    level.give_up_above(energy + hopeless_rise_of_energy * std::abs(energy));
  const Error_code status = climb_with_borders_apart(level, uv);
  level.give_up_above((std::numeric_limits<double>::infinity)());
  const bool pays = status == OK && m_summary.levels.back().energy_end - energy <=
                                        greatest_rise_of_energy * std::abs(energy);
  const bool has_failed = status == ERROR_NO_1_TO_1_MAPPING || status == GIVEN_UP;
  if (pays || covered == 0 || (status != OK && !has_failed))
    return status;
  level.go_to(level.hierarchy().number_of_levels() - 1);
  uv.swap(free);
  m_summary.levels.swap(levels);
  return OK;
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
Error_code Nested_iteration::refine(Level& level, Level::Uv& uv)
{
  m_summary.levels.emplace_back();
  Level_summary& summary = m_summary.levels.back();
  summary.vertices = level.number_of_vertices();
  summary.faces = level.number_of_faces();
  if (level.is_finest())
    m_finisher.remember_start(uv);
  const Error_code status =
      begins_with_draft(level) ? refine_draft(level, uv, summary) : refine_once(level, uv, summary);
  if (status != OK)
    return status;
  if (m_visitor && !m_visitor->level_parameterized(level, uv, summary))
    m_progress.stop();
  return m_progress.is_stopped() ? ERROR_STOPPED : OK;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::refine_draft(Level& level, Level::Uv& uv, Level_summary& summary)
{
  const Level::Uv start = uv;
  const Level_summary summary_at_start = summary;
  level.set_draft(true);
  const Error_code status = refine_once(level, uv, summary);
  level.set_draft(false);
  summary.converged = false;
  if (status == ERROR_STOPPED || (status == OK && m_watch.have_met()))
    return status;
  uv = start;
  summary = summary_at_start;
  m_watch.forget_last_map();
  start_stage(level);
  return refine_once(level, uv, summary);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::refine_once(const Level& level, Level::Uv& uv, Level_summary& summary)
{
  const Error_code status = m_method.refine(level, uv, summary);
  summary.seconds = m_timer_of_level.time();
  if (m_progress.is_stopped() || (status == OK && !level.progressed(summary, 1)))
    return ERROR_STOPPED;
  if (status == OK)
    m_watch.look_at(level, uv);
  return status;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration::finish(const Level& level, Level::Uv& uv)
{
  m_is_finished = true;
  const Error_code status = m_finisher.finish(level, uv);
  return m_progress.is_stopped() ? ERROR_STOPPED : status;
}

// The time that a level takes is about proportional to its vertices, and the finest one has to converge.
CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Nested_iteration::start_stage(const Level& level)
{
  constexpr double factor_of_finest_level = 10, factor_of_draft = 3, part_of_end = 0.1;
  const Collapse_hierarchy_3& hierarchy = level.hierarchy();
  const double work = double(level.number_of_vertices());
  double rest = (factor_of_finest_level + part_of_end) * double(hierarchy.number_of_vertices());
  for (std::size_t i = level.index(); i + 1 < hierarchy.number_of_levels(); ++i)
    rest += double(hierarchy.number_of_vertices(i));
  const double factor = begins_with_draft(level) ? factor_of_draft : level.is_finest() ? factor_of_finest_level : 1;
  m_progress.start_stage(factor * work / rest, level.index(), hierarchy.number_of_levels(),
                         level.number_of_vertices());
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_IMPL_H
