// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_VERTEX_RELAXATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_VERTEX_RELAXATION_H

#include <CGAL/Surface_mesh_parameterization/internal/border/Border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Turn_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Vertex relaxation on one level: minimizes its energy one vertex at a time.
class Vertex_relaxation
{
public:
  // Steps are `relaxation_factor` times Newton's, as in successive over-relaxation; between 0 and 2. `barrier`, if
  // there is one, keeps the borders apart. With a turn barrier, border vertices move only where that lowers the energy
  // by more than it raises the barrier's.
  Vertex_relaxation(const Level_energy& energy, double relaxation_factor, Border_barrier* barrier = nullptr,
                    const Turn_barrier* turn_barrier = nullptr)
    : m_energy(energy), m_level(energy.level()), m_relaxation_factor(relaxation_factor), m_barrier(barrier),
      m_turn_barrier(turn_barrier)
  { }

  struct Effect
  {
    double decrease = 0;                    // of the energy
    std::size_t visits = 0;                 // of vertices
    std::vector<Index> active_vertices;     // those whose own step lowered the energy by more than was asked
  };

  // Relaxes every vertex, group by group.
  Effect sweep(Level::Uv& uv) const { return sweep_once(uv, infinity); }

  // A sweep, and then steps for the vertices that lower the energy by more than `least_decrease` each, and for their
  // neighbors, as long as they do so. Vertices that were inserted into a bad place, a handful of them, can hold most of
  // the excess energy of a large map, and need many more steps than all the others.
  Effect sweep_and_follow_up(Level::Uv& uv, double least_decrease) const
  {
    Effect effect = sweep_once(uv, least_decrease);
    follow_up(uv, least_decrease, effect);
    return effect;
  }

  // Relaxes the vertices that the level `group` has in addition to the next coarser one, so many times.
  Effect sweep_group(std::size_t group, Level::Uv& uv, int sweeps) const
  {
    set_reach(uv);
    return relax_group(group, uv, infinity, sweeps);
  }

  // Relaxes vertices that are chosen at random by a generator of 32-bit numbers, as the paper does.
  template <class RandomGenerator>
  Effect random_steps(Level::Uv& uv, std::size_t number_of_steps, RandomGenerator& random) const
  {
    const std::unique_ptr<Vertex_relaxer> relaxer = m_energy.make_vertex_relaxer();
    Effect effect;
    for (; effect.visits < number_of_steps; ++effect.visits) {
      if (effect.visits % m_level.number_of_vertices() == 0)
        set_reach(uv);
      effect.decrease += relax(Index((std::uint64_t(random()) * m_level.number_of_vertices()) >> 32), 1, uv, *relaxer);
    }
    return effect;
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  static void add(Effect& sum, const Effect& effect)
  {
    sum.decrease += effect.decrease;
    sum.visits += effect.visits;
    sum.active_vertices.insert(sum.active_vertices.end(), effect.active_vertices.begin(), effect.active_vertices.end());
  }

  // What the barrier lets border vertices go holds until all of them have moved: a vertex is charged for its way.
  void set_reach(const Level::Uv& uv) const
  {
    if (m_barrier)
      m_barrier->set_reach(uv);
  }

  // Relaxes the vertices that the level `group` has in addition to the next coarser one. They share no edge, so that
  // only those on the border, where the angles involve two neighbors, have to go one by one. Those of level 0 have to,
  // too, and get one sweep at a time. An interior vertex takes the steps of several sweeps at once.
  Effect relax_group(std::size_t group, Level::Uv& uv, double least_decrease, int sweeps = 1) const
  {
    const Collapse_hierarchy_3& hierarchy = m_level.hierarchy();
    const Index first = group == 0 ? 0 : Index(hierarchy.number_of_vertices(group - 1)),
                last = Index(hierarchy.number_of_vertices(group));
    const auto relax_if = [&](Index begin, Index end, bool at_border, int steps, Vertex_relaxer& relaxer) {
      Effect effect;
      for (Index v = begin; v < end; ++v)
        if (m_level.is_border(v) == at_border) {
          m_level.prefetch_neighbors_after(v, uv);
          const double decrease = relax(v, steps, uv, relaxer);
          effect.decrease += decrease;
          if (decrease > least_decrease)
            effect.active_vertices.push_back(v);
        }
      return effect;
    };
    const auto make_relaxer = [&] { return m_energy.make_vertex_relaxer(); };
    const Loops loops = group == 0 ? Loops() : m_level.loops();
    Effect effect = loops.reduce_with_scratch(
        first, last, Effect(), make_relaxer,
        [&](Index begin, Index end, std::unique_ptr<Vertex_relaxer>& relaxer) {
          return relax_if(begin, end, false, sweeps, *relaxer);
        },
        add);
    for (int i = 0; i < sweeps; ++i) {
      if (i > 0)
        set_reach(uv);
      add(effect, relax_if(first, last, true, 1, *make_relaxer()));
    }
    effect.visits = std::size_t(sweeps) * (last - first);
    return effect;
  }

  Effect sweep_once(Level::Uv& uv, double least_decrease) const
  {
    Effect effect;
    set_reach(uv);
    for (std::size_t group = 0; group <= m_level.index(); ++group)
      add(effect, relax_group(group, uv, least_decrease));
    return effect;
  }

  // In rounds, at most a quarter of a sweep. Where borders may meet, their vertices are left to the sweeps: it is the
  // interior that new vertices distort, and a border that a few local steps have driven to the bound of its angles
  // hardly leaves it again. Where borders are kept apart, new vertices may be wedged between two of them, and have to
  // push these away; how far they may go then is to be found out for each such round, of which there are not too many.
  void follow_up(Level::Uv& uv, double least_decrease, Effect& effect) const
  {
    constexpr int most_rounds_with_barrier = 50;
    const std::size_t most_visits = effect.visits + effect.visits / 4;
    std::vector<Index> waiting, round;
    std::vector<bool> is_waiting(effect.active_vertices.empty() ? 0 : m_level.number_of_vertices(), false);
    const auto wake = [&](Index v) {
      if (is_waiting[v] || (m_level.is_border(v) && !m_barrier))
        return;
      waiting.push_back(v);
      is_waiting[v] = true;
    };
    const auto wake_star = [&](Index v) {
      wake(v);
      for (const Index w : m_level.one_ring(v))
        wake(w);
    };
    for (const Index v : effect.active_vertices)
      wake_star(v);
    const std::unique_ptr<Vertex_relaxer> relaxer = m_energy.make_vertex_relaxer();
    for (int i = 0; !waiting.empty() && !(m_barrier && i == most_rounds_with_barrier); ++i) {
      round.swap(waiting);
      waiting.clear();
      if (std::any_of(round.begin(), round.end(), [&](Index v) { return m_level.is_border(v); }))
        set_reach(uv);
      for (const Index v : round) {
        if (effect.visits == most_visits)
          return;
        ++effect.visits;
        is_waiting[v] = false;
        const double decrease = relax(v, 1, uv, *relaxer);
        effect.decrease += decrease;
        if (decrease > least_decrease)
          wake_star(v);
      }
    }
  }

  // Returns by how much the energy fell.
  double relax(Index v, int steps, Level::Uv& uv, Vertex_relaxer& relaxer) const
  {
    if (m_level.is_fixed(v))
      return 0;
    if (!m_level.is_border(v))
      return relaxer.relax(v, steps, m_relaxation_factor, infinity, uv);
    const Point_2 start = uv[v];
    const double barrier_before = turn_energy_around(v, uv), reach = m_barrier ? m_barrier->reach(v) : infinity,
                 decrease = relaxer.relax(v, steps, m_relaxation_factor, reach, uv);
    if (turn_energy_around(v, uv) > barrier_before + decrease) {
      uv[v] = start;
      return 0;
    }
    if (m_barrier)
      m_barrier->reach(v) -= std::sqrt((uv[v] - start).squared_length());
    return decrease;
  }

  double turn_energy_around(Index v, const Level::Uv& uv) const
  {
    return m_turn_barrier ? m_turn_barrier->energy_around(v, uv) : 0;
  }

  const Level_energy& m_energy;
  const Level& m_level;
  double m_relaxation_factor;
  Border_barrier* m_barrier;
  const Turn_barrier* m_turn_barrier;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_VERTEX_RELAXATION_H
