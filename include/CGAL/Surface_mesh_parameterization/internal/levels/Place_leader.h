// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_PLACE_LEADER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_PLACE_LEADER_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_with_springs.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_method.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/soften_springs.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Brings the vertices of a level whose places are given there, round by round: springs pull those that are elsewhere,
// against the energy of the triangles, which keeps them positive; then those that have come near go to their places,
// where the map stays valid, and are held there from then on.
//
// One that triangles keep from its place gets stiffer springs, and pays with distortion. The user's own springs become
// as stiff as they are in the same rounds: at once they would crush triangles in their way, for good.
class Place_leader
{
public:
  Place_leader(const Level_energy_with_springs& energy, bool borders_must_not_meet, Level::Uv& uv,
               Level_summary& summary)
    : m_energy(energy), m_level(energy.level()), m_uv(uv), m_summary(summary),
      m_displaced(displaced_vertices(m_level, uv))
  {
    if (borders_must_not_meet && !is_done())
      m_barrier = std::make_unique<Border_barrier>(m_level, Newton_options().barrier_stiffness * energy.mean_weight());
  }

  bool are_fixed_vertices_at_places() const { return m_displaced.empty(); }

  // Returns false if a visitor stopped the run.
  bool run()
  {
    const double greatest_stiffness = m_level.is_finest() ? last_stiffness : last_stiffness_on_coarse;
    const std::size_t rounds = has_grid_of_finest_level(m_energy) ? most_rounds : most_rounds_between_grids;
    double stiffness = first_stiffness;
    settle(near_part);
    if (!is_done() && !tell())
      return false;
    for (std::size_t round = 0; !is_done() && round < rounds && stiffness <= greatest_stiffness; ++round) {
      const double before = distance();
      if (!pull(stiffness))
        return false;
      if (!(distance() < (1 - least_approach) * before))
        stiffness *= growth;
      settle(near_part);
    }
    settle((std::numeric_limits<double>::infinity)());
    return true;
  }

private:
  typedef Triangulated_surface_3::Spring   Spring;

  // Of the springs, relative to what the energy has at a vertex whose triangles are hardly distorted: at first, the
  // factor from one round to the next where a round no longer brings the vertices nearer by this part, and at last: on
  // the finest level, and on others, that may be too coarse for the places.
  static constexpr double first_stiffness = 1, growth = 10, least_approach = 0.1, last_stiffness = 1e8,
                          last_stiffness_on_coarse = 1e4;
  // A level on which Newton's method does not pay gets a few rounds, for the vertices that were inserted near their
  // places.
  static constexpr std::size_t most_rounds = 60, most_rounds_between_grids = 3, most_steps_of_round = 10;
  // A round ends when a step lowers the energy by less than this part of what the springs have.
  static constexpr double least_decrease = 0.03;
  // A vertex that is nearer to its place than this part of the way to the opposite edges of its triangles goes there at
  // once.
  static constexpr double near_part = 0.2;

  // Tells of the energy without the springs that lead. Returns whether the run may go on.
  bool tell()
  {
    if (m_level.is_watched())
      m_summary.energy_end = m_energy(m_uv) / m_energy.unit();
    return m_level.progressed(m_summary, 0);
  }

  bool is_done() const
  {
    return are_fixed_vertices_at_places() &&
           (m_has_springs_in_full || m_energy.energy_of_springs(m_uv) <= m_energy.without_springs()(m_uv));
  }

  const Point_2& place(Index v) const { return m_level.fixed_place(v); }

  // The greatest distance of a vertex from its place.
  double distance() const
  {
    double result = 0;
    for (const Index v : m_displaced)
      result = (std::max)(result, (place(v) - m_uv[v]).squared_length());
    return std::sqrt(result);
  }

  // Newton's method with springs of that stiffness, and with the user's up to it.
  bool pull(double stiffness)
  {
    const Level_energy_with_springs energy(m_energy.without_springs(), springs_up_to(stiffness));
    Newton_method newton(energy, m_barrier.get());
    newton.fix_vertices(settled_vertices());
    double current = energy(m_uv);
    for (std::size_t i = 0; i < most_steps_of_round; ++i) {
      const auto step = newton.step(m_uv, current);
      current = energy(m_uv);
      ++m_summary.iterations;
      m_summary.cycles += step.cycles;
      if (!tell())
        return false;
      if (!(step.decrease > least_decrease * energy.energy_of_springs(m_uv)))
        break;
    }
    return true;
  }

  std::vector<Spring> springs_up_to(double stiffness)
  {
    std::vector<Spring> result = m_energy.springs();
    m_has_springs_in_full = !soften_springs(m_energy, stiffness, m_uv, result);
    for (const Index v : m_displaced)
      result.push_back({ v, place(v), stiffness * unit_of_stiffness(v) });
    std::sort(result.begin(), result.end(), [](const Spring& s, const Spring& t) { return s.vertex < t.vertex; });
    return result;
  }

  std::vector<Index> settled_vertices() const
  {
    const std::vector<Index> all = fixed_vertices(m_level);
    std::vector<Index> result;
    std::set_difference(all.begin(), all.end(), m_displaced.begin(), m_displaced.end(), std::back_inserter(result));
    return result;
  }

  double unit_of_stiffness(Index v) const
  {
    double squares = 0;
    for (const Index w : m_level.one_ring(v))
      squares += (m_uv[w] - m_uv[v]).squared_length();
    return stiffness_of_triangles(m_energy, v, squares);
  }

  // Lets vertices that are nearer to their places than that part of the way to the opposite edges go there.
  void settle(double part)
  {
    std::vector<std::pair<Index, Point_2>> moved;
    for (const Index v : m_displaced)
      if (is_near(v, part)) {
        const Point_2 before = std::exchange(m_uv[v], place(v));
        if (is_star_valid(m_level.rings(), m_uv, v))
          moved.push_back({ v, before });
        else
          m_uv[v] = before;
      }
    if (m_barrier && !m_barrier->keeps_apart(m_uv))
      for (auto it = moved.rbegin(); it != moved.rend(); ++it)
        m_uv[it->first] = it->second;
    m_displaced = displaced_vertices(m_level, m_uv);
  }

  bool is_near(Index v, double part) const
  {
    const Level::Ring ring = m_level.one_ring(v);
    const double way = std::sqrt((place(v) - m_uv[v]).squared_length());
    for (std::size_t i = 0; i < m_level.number_of_triangles(v); ++i) {
      const Point_2 &a = m_uv[ring[i]], &b = m_uv[ring[next_in_cycle(i, ring.size())]];
      const double height = cross(b - a, m_uv[v] - a) / std::sqrt((b - a).squared_length());
      if (!(way < part * height))
        return false;
    }
    return true;
  }

  const Level_energy_with_springs& m_energy;
  const Level& m_level;
  Level::Uv& m_uv;
  Level_summary& m_summary;
  bool m_has_springs_in_full = m_energy.springs().empty();      // the user's, in the last round
  std::vector<Index> m_displaced;
  std::unique_ptr<Border_barrier> m_barrier;      // none unless borders must not meet
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_PLACE_LEADER_H
