// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_METHOD_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_METHOD_H

#include <CGAL/Surface_mesh_parameterization/internal/border/Border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Border_guard.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/level_triangles.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Newton's method for the energy of a level, with a line search that keeps the map valid, if the energy keeps triangles
// positive.
class Newton_method
{
public:
  struct Step
  {
    double decrease = 0;          // of the energy, with the barrier's; 0 if no step was possible
    double predicted = 0;         // decrease of the quadratic model by the whole step
    double length = 0;            // 1 for the whole step
    std::size_t cycles = 0;       // V-cycles
  };

  // `barrier`, if there is one, keeps the borders apart; its energy is minimized along with the level's.
  explicit Newton_method(const Level_energy& energy, Border_barrier* barrier = nullptr,
                         const Newton_options& options = Newton_options())
    : m_energy(energy), m_level(energy.level()), m_options(options), m_barrier(barrier), m_border_guard(energy.level()),
      m_system(energy, m_options)
  {
    m_system.keep_negative_twist(!m_energy.is_flip_free());
    m_direction.resize(m_level.number_of_vertices());
  }

  // Lets no step move the given vertices, see Newton_system.
  void fix_vertices(std::vector<Index> vertices) { m_system.fix_vertices(std::move(vertices)); }

  // One step from `uv`, whose energy is given.
  Step step(Level::Uv& uv, double energy)
  {
    Step result = try_step(uv, energy);
    if (result.length == 0 && m_system.keeps_negative_twist()) {
      m_system.keep_negative_twist(false);
      result = try_step(uv, energy);
    }
    m_system.keep_negative_twist(is_model_good(result));
    return result;
  }

private:
  // Where a step cannot be taken in full length, or gains little, the model is indefinite, or no good.
  bool is_model_good(const Step& step) const
  {
    return step.length == 1 && step.decrease > m_options.least_part_of_prediction * step.predicted;
  }

  Step try_step(Level::Uv& uv, double energy)
  {
    Step result;
    if (m_barrier) {
      m_barrier->set_gaps(uv);
      energy += (*m_barrier)(uv);
    }
    if (!m_system.assemble(uv, m_barrier))
      return result;
    result.cycles = m_system.solve();
    if (m_trial.size() == uv.size())
      m_system.add_previous_step(m_trial, uv);      // the line search left the map before that step in m_trial
    for_each_vertex([&](Index v) { m_direction[v] = m_system.move(v); });

    const double slope = dot_with_gradient();
    result.predicted = -0.5 * slope;
    if (slope < 0)
      search_line(uv, energy, slope, result);
    return result;
  }

  // The energy that steps lower.
  double objective(const Level::Uv& uv) const { return m_energy(uv) + (m_barrier ? (*m_barrier)(uv) : 0); }

  template <class Function>
  void for_each_vertex(const Function& f) const { m_level.loops().for_each(0, Index(m_direction.size()), f); }

  double dot_with_gradient() const { return inner_product(m_level.loops(), m_system.gradient(), m_direction); }

  // The least t > 0 at which a triangle vanishes on the way to uv + t direction.
  double longest_step(const Level::Uv& uv) const
  {
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    return m_level.loops().min(0, Index(uv.size()), infinity, [&](Index v) {
      m_level.rings().prefetch_neighbors_after(v, uv);
      double least = infinity;
      for_each_triangle_of_least_vertex(m_level, v, [&](Index a, Index b, const Rest_corner&) {
        const Vector_2 p = uv[a] - uv[v], q = uv[b] - uv[v];
        const Block_vector d = m_direction[a] - m_direction[v], e = m_direction[b] - m_direction[v];
        const Vector_2 dp(d.x, d.y), dq(e.x, e.y);
        const double c0 = cross(p, q), c1 = cross(p, dq) + cross(dp, q), c2 = cross(dp, dq);
        // The least positive root of c0 + c1 t + c2 t^2, c0 > 0, in the form that does not cancel.
        const double discriminant = c1 * c1 - 4 * c0 * c2;
        const double root = discriminant < 0 || (c1 >= 0 && c2 >= 0) ? 0 : 2 * c0 / (std::sqrt(discriminant) - c1);
        if (root > 0)
          least = (std::min)(least, root);
      });
      return least;
    });
  }

  // Goes along the direction as far as the energy falls and the map stays valid. Where the angles at a border vertex
  // would reach a full turn, of which the energy knows nothing, the direction is corrected so that they do not, and at
  // last cut off: the rest of the map need not wait for them.
  void search_line(Level::Uv& uv, double energy, double slope, Step& result)
  {
    for (int i = 0; i < m_options.most_rounds && slope < 0; ++i) {
      try_lengths(uv, energy, slope, result);
      if (result.length > 0 || !m_energy.is_flip_free())
        return;
      const std::vector<Border_guard::Gap> gaps = m_border_guard.lost_gaps(uv, m_trial);
      if (gaps.empty())
        return;
      if (i < m_options.most_corrections)
        result.cycles += correct_direction(gaps);
      else
        cut_off(gaps);
      slope = dot_with_gradient();
    }
  }

  // Changes the direction as little as is needed, in the norm of the Hessian, for no gap to lose too much, to first
  // order: so the neighbors go along. Returns the number of V-cycles.
  std::size_t correct_direction(const std::vector<Border_guard::Gap>& gaps)
  {
    std::vector<Newton_system::Force> forces;
    for (const Border_guard::Gap& gap : gaps)
      for (int i = 0; i < 3 && gap.missing > 0; ++i)
        forces.push_back({ gap.vertices[i], gap.missing * gap.gradients[i] });
    const std::size_t cycles = m_system.solve(forces);
    const auto correction = [&](Index v) { return m_system.move(v); };
    double factor = 0;
    std::vector<Border_guard::Gap> hopeless;
    for (const Border_guard::Gap& gap : gaps)
      if (const double change = gap.change(correction); gap.missing > 0 && change > 0)
        factor = (std::max)(factor, gap.missing / change);
      else
        hopeless.push_back(gap);
    for_each_vertex([&](Index v) { m_direction[v] += factor * correction(v); });
    cut_off(hopeless);
    return cycles;
  }

  void cut_off(const std::vector<Border_guard::Gap>& gaps)
  {
    for (const Border_guard::Gap& gap : gaps)
      for (const Index v : gap.vertices)
        m_direction[v] = Block_vector(0, 0);
  }

  // Halves the step until it is acceptable; ends early at one that fails only by the angles at the border.
  void try_lengths(Level::Uv& uv, double energy, double slope, Step& result)
  {
    double length = m_energy.is_flip_free() ? (std::min)(1., m_options.part_of_longest_step * longest_step(uv)) : 1;
    if (m_barrier)
      length = (std::min)(length, m_options.part_of_longest_step * m_barrier->longest_step(uv, m_direction));
    m_trial.resize(uv.size());
    for (int i = 0; i < m_options.most_halvings; ++i, length *= 0.5) {
      for_each_vertex(
          [&](Index v) { m_trial[v] = uv[v] + Vector_2(length * m_direction[v].x, length * m_direction[v].y); });
      const double decrease = energy - objective(m_trial);
      if (!(decrease > -m_options.sufficient_decrease * length * slope))
        continue;
      if (!m_energy.is_flip_free() ||
          (!m_border_guard.turns_too_far(uv, m_trial) && is_map_valid(m_level.rings(), m_trial, m_level.loops()) &&
           (!m_barrier || m_barrier->keeps_apart(m_trial)))) {
        uv.swap(m_trial);
        result.decrease = decrease;
        result.length = length;
        return;
      }
      if (m_border_guard.turns_too_far(uv, m_trial))
        return;
    }
  }

  const Level_energy& m_energy;
  const Level& m_level;
  Newton_options m_options;
  Border_barrier* m_barrier;
  Border_guard m_border_guard;
  Newton_system m_system;
  Block_vectors m_direction;
  Level::Uv m_trial;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_METHOD_H
