// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_REFINER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_REFINER_H

#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_multigrid.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Vertex_relaxation.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <random>

namespace CGAL::Surface_mesh_parameterization::internal {

// Minimizes an energy on one level, from a valid map to a better one.
template <class Energy>
class Level_refiner
{
public:
  // The steps of sweeps, in Newton steps of a vertex: as in successive over-relaxation this cuts the number of sweeps by a multiple.
  static constexpr double over_relaxation = 1.8;

  Level_refiner(const Level& level, Level::Uv& uv, const Refinement_options& options, Level_summary& summary, const Energy& energy = Energy())
    : m_level(level), m_uv(uv), m_options(options), m_summary(summary), m_energy(level, options.triangle_weight, energy),
      m_total_weight(m_energy.total_weight()), m_current(m_energy(uv))
  {
    constexpr double relative_stiffness = 0.1;
    if (options.is_globally_injective)
      m_barrier = std::make_unique<Border_barrier>(level, relative_stiffness * m_total_weight / double(level.number_of_faces()));
  }

  // Energies are reported as the sum over the triangles, or as the mean over the area if triangles are weighted so.
  void run()
  {
    m_summary.energy_start = m_current / m_energy.unit();
    if (m_options.number_of_local_steps > 0)
      take_local_steps();
    else {
      settle_new_vertices();
      if (m_options.optimizer == Optimizer::NEWTON)
        iterate_newton();
      else
        relax_until_convergence();
    }
    m_summary.energy_end = m_energy(m_uv) / m_energy.unit();
  }

private:
  bool is_coarsest_of_many() const { return m_level.index() == 0 && !m_level.is_finest(); }
  std::size_t size() const { return m_level.number_of_vertices(); }
  double excess() const { return m_current - Energy::minimum * m_total_weight; }

  // Subtracts what an iteration gained. After a deep fall, from a triangle that was almost degenerate, the difference means nothing.
  void lower_by(double decrease)
  {
    m_current -= decrease;
    if (!(decrease < m_current && m_current < (std::numeric_limits<double>::infinity)()))
      m_current = m_energy(m_uv);
  }

  void count(const typename Vertex_relaxation<Energy>::Effect& effect)
  {
    lower_by(effect.decrease);
    m_summary.vertex_visits += effect.visits;
  }

  // On a level with inserted vertices, those whose place is bad get as many steps as they need.
  void sweep(const Vertex_relaxation<Energy>& relaxation)
  {
    const double never = (std::numeric_limits<double>::infinity)(), mean_of_vertex = little(1 / double(size()));
    count(relaxation.sweep_and_follow_up(m_uv, m_level.index() == 0 ? never : mean_of_vertex));
  }

  // The paper's experiment: nothing but so many steps.
  void take_local_steps()
  {
    std::mt19937 random(m_options.random_seed);
    Vertex_relaxation<Energy>(m_energy, 1, m_barrier.get()).random_steps(m_uv, m_options.number_of_local_steps, random);
    m_summary.vertex_visits = m_options.number_of_local_steps;
    m_summary.iterations = (m_summary.vertex_visits + size() - 1) / size();
  }

  // Lets vertices that were just inserted find their places among their neighbors, before these move.
  void settle_new_vertices()
  {
    constexpr int sweeps = 3;
    const Vertex_relaxation<Energy> relaxation(m_energy, 1, m_barrier.get());
    for (int i = 0; i < sweeps && m_level.index() > 0; ++i)
      count(relaxation.sweep_group(m_level.index(), m_uv));
  }

  // The coarsest of several levels gets as many sweeps as it needs: they cost nothing, and what it lacks no finer level can make good.
  void relax_until_convergence()
  {
    constexpr std::size_t most_sweeps_on_coarsest_level = 2000;
    const std::size_t most_sweeps = is_coarsest_of_many() ? (std::max)(m_options.number_of_iterations, most_sweeps_on_coarsest_level)
                                                           : m_options.number_of_iterations;
    const bool is_random = m_options.optimizer == Optimizer::RANDOM_VERTICES;
    const Vertex_relaxation<Energy> relaxation(m_energy, is_random ? 1 : over_relaxation, m_barrier.get());
    std::mt19937 random(m_options.random_seed);
    while (m_summary.iterations < most_sweeps && !m_summary.converged) {
      const double before = m_current;
      lower_by(is_random ? relaxation.random_steps(m_uv, size(), random) : relaxation.sweep(m_uv));
      m_summary.vertex_visits += size();
      m_summary.converged = is_little(before - m_current, m_options.tolerance);
      ++m_summary.iterations;
    }
  }

  // Newton's method pays on the levels that the V-cycle has as grids; in between a sweep carries the map over.
  void iterate_newton()
  {
    const std::size_t groups_above = m_level.hierarchy().number_of_levels() - 1 - m_level.index();
    const bool is_grid = groups_above % V_cycle::groups_per_grid == 0 || m_level.index() == 0;

    const Vertex_relaxation<Energy> relaxation(m_energy, over_relaxation, m_barrier.get());
    if (is_grid) {
      sweep_while_it_pays(relaxation);
      take_newton_steps(relaxation);
    } else
      sweep(relaxation);
  }

  // A sweep costs little beside a Newton step and is better at what is wrong in small places.
  void sweep_while_it_pays(const Vertex_relaxation<Energy>& relaxation)
  {
    constexpr std::size_t most_sweeps = 6;
    constexpr double least_decrease = 0.05;
    double before;
    std::size_t sweeps = 0;
    do {
      before = m_current;
      sweep(relaxation);
    } while (++sweeps < most_sweeps && !is_little(before - m_current, least_decrease));
  }

  // Levels below the finest only have to hand on a good start.
  void take_newton_steps(const Vertex_relaxation<Energy>& relaxation)
  {
    constexpr double coarse_tolerance = 5e-3, residual_tolerance = 0.07, short_step = 0.3, great_decrease = 0.01;
    const double tolerance = m_level.is_finest() ? m_options.tolerance : coarse_tolerance;

    Newton_multigrid<Energy> newton(m_energy, m_barrier.get());
    while (m_summary.iterations < m_options.number_of_iterations && !m_summary.converged) {
      const auto step = newton.step(m_uv, m_current, residual_tolerance);
      if (m_barrier)      // the step may have paid for a gap with energy
        m_current = m_energy(m_uv);
      else
        lower_by(step.decrease);
      ++m_summary.iterations;
      m_summary.cycles += step.cycles;
      const double before_sweep = m_current;
      // A few triangles that are about to vanish can hold up a step of the whole map, or are where its quadratic model fails: these are for relaxation.
      if (step.length < short_step || !is_little(step.decrease, great_decrease))
        sweep(relaxation);
      m_summary.converged = is_little(step.decrease + (before_sweep - m_current), tolerance);
    }
  }

  // A part of the excess energy. On a surface that lies in the plane without distortion, the excess is mere rounding.
  double little(double part) const
  {
    constexpr double rounding = 1e-12;
    return (std::max)(part * excess(), rounding * m_total_weight);
  }

  // Whether a decrease that led to the current energy is next to nothing.
  bool is_little(double decrease, double tolerance) const { return !(decrease > little(tolerance)); }

  const Level& m_level;
  Level::Uv& m_uv;
  const Refinement_options& m_options;
  Level_summary& m_summary;
  Level_energy<Energy> m_energy;
  std::unique_ptr<Border_barrier> m_barrier;      // none unless the map has to be globally injective
  const double m_total_weight;
  double m_current;       // the energy of m_uv
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_REFINER_H
