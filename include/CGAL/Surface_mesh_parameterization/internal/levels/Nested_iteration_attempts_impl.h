// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_ATTEMPTS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_ATTEMPTS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/Option_defaults.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/input_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/vertex_order.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration_attempts.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/best_similarity.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/cracks.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/holes.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/orientation_of_places.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Nested_iteration_attempts::Nested_iteration_attempts(Refinable_method& method, const Nested_iteration_options& options,
                                                     Any_hierarchy_visitor* visitor, Parameterization_summary& summary)
  : m_method(method), m_options(options), m_visitor(visitor), m_progress(visitor), m_summary(summary)
{
  m_options.hierarchy.progress = &m_progress;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code Nested_iteration_attempts::run(Triangulated_surface_3 surface, CGAL::Real_timer& timer,
                                          std::vector<Point_2>& uv)
{
  constexpr double part_of_hierarchy = 0.05;      // of the time, more or less
  m_start = { std::exchange(uv, {}), true };
  Nested_iteration::Start start_of_user = m_options.places_at_end.empty() ? Nested_iteration::Start() : m_start;
  double seconds_hierarchy = 0, seconds_parameterize = 0;      // of all attempts
  for (;;) {
    m_progress.start_stage(part_of_hierarchy);
    const Collapse_hierarchy_3 hierarchy(std::move(surface), m_options.hierarchy, m_method.loops());
    m_summary = Parameterization_summary();
    m_summary.seconds_hierarchy = seconds_hierarchy = timer.time() - seconds_parameterize;
    Next next = Next::MIRROR_PLACES;
    if (!std::exchange(m_options.may_mirror_places, false) || !suit_mirror_image(hierarchy)) {
      find_start_on_closed_surface(hierarchy);
      next = attempt(hierarchy, uv);
    }
    m_summary.seconds_parameterize = seconds_parameterize = timer.time() - seconds_hierarchy;
    if (next == Next::NOTHING)
      return m_summary.error.code;
    surface = input_surface(hierarchy);
    if (next == Next::MIRROR_PLACES) {
      mirror_places(surface);
      m_has_mirrored_places = true;
    } else if (next == Next::HOLD_PLACES) {
      surface.fixed_vertices = std::exchange(m_options.places_at_end, {});
      m_start = std::move(start_of_user);
      m_has_closed_surface = false;
    }
  }
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Nested_iteration_attempts::Next Nested_iteration_attempts::attempt(const Collapse_hierarchy_3& hierarchy,
                                                                   std::vector<Point_2>& uv)
{
  Level::Uv uv_by_rank;
  uv_by_rank.reserve(hierarchy.number_of_vertices());
  Nested_iteration iteration(m_method, m_options, m_visitor, m_progress, m_summary);
  Error_code status = iteration.run(hierarchy, std::exchange(m_start, {}), uv_by_rank);
  if (status == OK && !m_progress.finish())
    status = ERROR_STOPPED;
  m_summary.error.code = status;
  m_summary.converged = m_summary.converged && status == OK;
  if (status == OK)
    uv = in_input_order(hierarchy, uv_by_rank);
  Next next = Next::NOTHING;
  if (status == ERROR_NO_1_TO_1_MAPPING && !m_progress.is_stopped()) {
    if (iteration.has_lost_places())
      next = Next::HOLD_PLACES;
    else if (find_start_at_scale_of_places(hierarchy) || (!iteration.is_finished() && prepare_another_way(hierarchy)))
      next = Next::ATTEMPT;
  }
  if (status != OK && m_progress.is_stopped()) {
    m_summary.error = { ERROR_STOPPED, Parameterization_error::NOWHERE, 0 };
    next = Next::NOTHING;
  }
  return next;
}

// A run on another surface than the user's, within a stage: no visitor is told of its levels.
class Run_in_stage final
  : public Progress_listener
{
public:
  explicit Run_in_stage(Run_progress& stage) : m_stage(stage) { }

  bool progressed(const Parameterization_progress& progress) override
  {
    return m_stage.tell_again(progress.part_done);
  }

private:
  Run_progress& m_stage;
};

// The length up to which a hole in the surface of a level is small, as in an atlas.
inline double greatest_length_of_small_holes(const Level& level)
{
  double area = 0;
  for (const Level::Triangle& t : level.triangles())
    area += 0.5 * doubled_area(level.point(t[0]), level.point(t[1]), level.point(t[2]));
  return Option_defaults::hole_bound * std::sqrt(area);
}

inline std::vector<Point_3> places_in_space(const Border& border, const Level& level)
{
  return places_of(border, [&](Index v) { return level.point(v); });
}

// The holes of a level up to a length.
inline std::vector<Border> small_holes(const Level& level, double greatest_length)
{
  std::vector<Border> result = level.rings().borders();
  result.erase(std::remove_if(result.begin(), result.end(),
                              [&](const Border& border) {
                                return level.hierarchy().is_on_outer_border(border.front()) ||
                                       perimeter(places_in_space(border, level)) > greatest_length;
                              }),
               result.end());
  return result;
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
bool Nested_iteration_attempts::suit_mirror_image(const Collapse_hierarchy_3& hierarchy)
{
  constexpr double good_fit = 0.005, less = 0.9, much_less = 0.1, part_of_run = 0.05;
  const Level coarsest(hierarchy);
  Nested_iteration_options options = m_options;
  options.hierarchy.coarsest_size = (std::min)(options.hierarchy.coarsest_size, Hierarchy_options().coarsest_size);
  const std::vector<Point_2> map = find_map(surface_by_rank(coarsest), options, part_of_run);
  if (map.empty())
    return false;
  std::vector<Wanted_move> moves, mirrored_moves;
  for (const Index v : fixed_vertices(coarsest)) {
    Point_2 place = coarsest.fixed_place(v);
    moves.push_back({ map[v], place });
    mirror(place);
    mirrored_moves.push_back({ map[v], place });
  }
  const double rest = unexplained_variance(moves);
  return unexplained_variance(mirrored_moves) < (rest > good_fit ? less : much_less) * rest;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Nested_iteration_attempts::find_start_at_scale_of_places(const Collapse_hierarchy_3& hierarchy)
{
  if (m_has_other_scale || hierarchy.fixed_places().empty())
    return false;
  m_has_other_scale = true;
  Triangulated_surface_3 surface = input_surface(hierarchy);
  const int exponent = scale_exponent_of_places(surface);
  if (exponent == 0)
    return false;
  for (Point_3& p : surface.points)
    p = times_power_of_two(p, exponent);
  return find_start(std::move(surface));
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Nested_iteration_attempts::find_start_on_closed_surface(const Collapse_hierarchy_3& hierarchy)
{
  constexpr std::size_t least_vertices_at_hole = 3;
  if (m_has_closed_surface || !m_start.uv.empty() || !m_method.is_flip_free())
    return;
  const Level coarsest(hierarchy);
  const double greatest_length = greatest_length_of_small_holes(coarsest);
  const std::vector<Border> holes = small_holes(coarsest, greatest_length);
  const auto is_crack_of_coarsest = [&](const Border& hole) { return is_crack(places_in_space(hole, coarsest)); };
  const std::size_t size = m_options.hierarchy.coarsest_size;
  const bool has_many_holes = coarsest.number_of_vertices() > size && least_vertices_at_hole * holes.size() > size,
             may_have_cracks = hierarchy.number_of_levels() > 1 &&
                               std::any_of(holes.begin(), holes.end(), is_crack_of_coarsest);
  if (!has_many_holes && !may_have_cracks)
    return;
  m_has_closed_surface = true;
  Closed_surface closed = close_cracks(input_surface(hierarchy), greatest_length);
  const bool has_cracks = !closed.vertices.empty();
  if (has_many_holes)
    fill_holes(closed.surface);
  if ((!has_many_holes && !has_cracks) || !find_start(std::move(closed.surface)))
    return;
  if (has_cracks)
    m_start.uv = open_cracks(input_surface(hierarchy), closed, m_start.uv);
  else
    m_start.uv.resize(hierarchy.number_of_vertices());
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Nested_iteration_attempts::find_start(Triangulated_surface_3 surface)
{
  constexpr double part_of_run = 0.4;
  m_start = { find_map(std::move(surface), m_options, part_of_run), false };
  return !m_start.uv.empty();
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Point_2> Nested_iteration_attempts::find_map(Triangulated_surface_3 surface,
                                                         Nested_iteration_options options, double part_of_rest)
{
  m_progress.start_stage(part_of_rest);
  Run_in_stage listener(m_progress);
  Run_progress progress(m_progress.is_watched() ? &listener : nullptr);
  options.hierarchy.progress = &progress;
  options.places_at_end.clear();
  const Collapse_hierarchy_3 hierarchy(std::move(surface), options.hierarchy, m_method.loops());
  Parameterization_summary summary;
  Level::Uv uv;
  if (Nested_iteration(m_method, options, nullptr, progress, summary).run(hierarchy, {}, uv) != OK)
    return {};
  return in_input_order(hierarchy, uv);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Nested_iteration_attempts::prepare_another_way(const Collapse_hierarchy_3& hierarchy)
{
  constexpr unsigned int most_seeds = 3;
  if (!m_method.is_flip_free())
    return false;
  const bool has_coarsest_map = !m_summary.levels.empty();
  if (has_coarsest_map) {
    m_was_flat = m_was_flat || hierarchy.number_of_levels() == 1;
    ++m_options.hierarchy.random_seed;
    ++m_number_of_seeds;
    if ((m_number_of_seeds < most_seeds && !m_was_flat) || m_method.leave_room())
      return true;
  }
  if (m_was_flat)
    return false;
  const bool may_be_coarser = hierarchy.number_of_vertices(0) <= m_options.hierarchy.coarsest_size;
  m_was_flat = has_coarsest_map || !may_be_coarser;
  m_options.hierarchy.coarsest_size =
      m_was_flat ? hierarchy.number_of_vertices() : hierarchy.number_of_vertices(0) / 2;
  return true;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_ATTEMPTS_IMPL_H
