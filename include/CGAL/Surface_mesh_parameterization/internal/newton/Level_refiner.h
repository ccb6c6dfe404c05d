// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_REFINER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_REFINER_H

#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Current_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_refiner_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_convergence.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_method.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Vertex_relaxation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <random>

namespace CGAL::Surface_mesh_parameterization::internal {

// Minimizes an energy on one level, from a valid map to a better one.
class Level_refiner
{
public:
  Level_refiner(const Level_energy& energy, Level::Uv& uv, const Refinement_options& refinement, Level_summary& summary,
                const Level_refiner_options& options = Level_refiner_options())
    : m_energy(energy), m_level(energy.level()), m_uv(uv), m_refinement(refinement), m_options(options),
      m_summary(summary), m_iterations_before(summary.iterations), m_unit(m_energy.unit()),
      m_current(energy, uv, m_options)
  {
    if (refinement.is_globally_injective)
      m_barrier =
          std::make_unique<Border_barrier>(m_level, m_options.newton.barrier_stiffness * m_energy.mean_weight());
  }

  // Energies are reported in the unit of the level's energy, see there.
  // Returns `OK`, `ERROR_STOPPED` if a visitor stopped the run, or `GIVEN_UP` if keeping borders apart is in vain.
  Error_code run()
  {
    m_summary.converged = false;
    m_summary.energy_start = m_current.value() / m_unit;
    if (tell(0)) {
      if (m_refinement.number_of_local_steps > 0)
        take_local_steps();
      else {
        settle_new_vertices();
        if (m_refinement.optimizer == Optimizer::NEWTON)
          iterate_newton();
        else
          relax_until_convergence();
      }
    }
    m_summary.energy_end = (m_level.is_finest() ? m_energy(m_uv) : m_current.value()) / m_unit;
    m_summary.converged = m_summary.converged && std::isfinite(m_summary.energy_end);
    return m_status;
  }

private:
  // Tells that this part of the work on the level is done. Returns whether the run may go on.
  bool tell(double part)
  {
    m_summary.energy_end = m_current.value() / m_unit;
    if (!m_level.progressed(m_summary, part))
      m_status = ERROR_STOPPED;
    else if (m_barrier && is_in_vain(m_summary.energy_end))
      m_status = GIVEN_UP;
    return m_status == OK;
  }

  bool is_in_vain(double energy) const
  {
    return (iterations() >= m_options.most_steps_in_vain && m_level.is_given_up_at(energy)) ||
           (iterations() >= m_options.most_steps_far_above && m_level.is_given_up_at(energy / m_options.far_above));
  }

  // Those of this refinement: the summary may have others before them.
  std::size_t iterations() const { return m_summary.iterations - m_iterations_before; }

  // The part that is done when an iteration has lowered the energy by `decrease`, and the last one lowers the excess
  // energy by less than the part `least_decrease`.
  double part_done(double decrease, double least_decrease) const
  {
    return part_of_iteration(decrease / m_current.excess(), least_decrease, iterations(),
                             m_refinement.number_of_iterations);
  }

  bool is_coarsest_of_many() const { return m_level.index() == 0 && !m_level.is_finest(); }
  std::size_t size() const { return m_level.number_of_vertices(); }
  void count(const Vertex_relaxation::Effect& effect)
  {
    m_current.lower_by(effect.decrease);
    m_summary.vertex_visits += effect.visits;
  }

  // On a level with inserted vertices, those whose place is bad get as many steps as they need. Returns by how much the
  // energy is lower.
  double sweep(const Vertex_relaxation& relaxation)
  {
    const double before = m_current.value();
    const double never = (std::numeric_limits<double>::infinity)(),
                 mean_of_vertex = m_current.little(1 / double(size()));
    count(relaxation.sweep_and_follow_up(m_uv, m_level.index() == 0 ? never : mean_of_vertex));
    return before - m_current.value();
  }

  // The paper's experiment: nothing but so many steps.
  void take_local_steps()
  {
    const Vertex_relaxation relaxation(m_energy, 1, m_barrier.get());
    std::mt19937 random(m_refinement.random_seed);
    std::size_t steps_left = m_refinement.number_of_local_steps;
    do {
      const std::size_t steps = (std::min)(size(), steps_left);
      count(relaxation.random_steps(m_uv, steps, random));
      steps_left -= steps;
      ++m_summary.iterations;
    } while (tell(1 - double(steps_left) / double(m_refinement.number_of_local_steps)) && steps_left > 0);
  }

  void settle_new_vertices()
  {
    const Vertex_relaxation relaxation(m_energy, 1, m_barrier.get());
    if (m_level.index() > 0)
      count(relaxation.sweep_group(m_level.index(), m_uv, m_options.sweeps_of_new_vertices));
  }

  void relax_until_convergence()
  {
    const std::size_t most_sweeps =
        is_coarsest_of_many() ? (std::max)(m_refinement.number_of_iterations, m_options.most_sweeps_on_coarsest_level)
                              : m_refinement.number_of_iterations;
    const bool is_random = m_refinement.optimizer == Optimizer::RANDOM_VERTICES;
    const Vertex_relaxation relaxation(m_energy, is_random ? 1 : m_options.over_relaxation, m_barrier.get());
    std::mt19937 random(m_refinement.random_seed);
    while (m_status == OK && iterations() < most_sweeps && !m_summary.converged) {
      const double before = m_current.value();
      count(is_random ? relaxation.random_steps(m_uv, size(), random) : relaxation.sweep(m_uv));
      m_summary.converged = m_current.is_little(before - m_current.value(), m_refinement.tolerance);
      ++m_summary.iterations;
      tell(part_done(before - m_current.value(), m_refinement.tolerance));
    }
  }

  // Newton's method pays on the levels that its multigrid cycle has as grids; in between a sweep carries the map over.
  // Borders that are kept apart slide along each other by an edge or so in a step: the longer the edges are, the sooner
  // they get to their places.
  void iterate_newton()
  {
    const Vertex_relaxation relaxation(m_energy, m_options.over_relaxation, m_barrier.get());
    const std::size_t levels_to_finest = m_level.hierarchy().number_of_levels() - 1 - m_level.index();
    if (has_grid_of_finest_level(m_energy) || (m_barrier && levels_to_finest % m_options.stride_with_barrier == 0)) {
      if (sweep_while_it_pays(relaxation))
        take_newton_steps();
    } else
      sweep(relaxation);
  }

  // A sweep costs little beside a Newton step and is better at what is wrong in small places. Returns whether the run
  // may go on.
  bool sweep_while_it_pays(const Vertex_relaxation& relaxation)
  {
    double decrease;
    std::size_t sweeps = 0;
    do
      decrease = sweep(relaxation);
    while (tell(0) && ++sweeps < m_options.most_first_sweeps &&
           !m_current.is_little(decrease, m_options.least_decrease_of_first_sweeps));
    return m_status == OK;
  }

  void take_newton_steps()
  {
    Newton_method newton(m_energy, m_barrier.get(), m_options.newton);
    newton.fix_vertices(fixed_vertices(m_level));
    const Vertex_relaxation relaxation(m_energy, m_options.over_relaxation, m_barrier.get(), &newton.turn_barrier());
    const double least_decrease = least_decrease_of_newton_steps();
    Newton_convergence convergence(m_current, m_barrier != nullptr, least_decrease, m_options);
    while (m_status == OK && iterations() < m_refinement.number_of_iterations && !convergence.has_arrived()) {
      const Newton_method::Step step = take_newton_step(newton);
      double decrease = step.decrease + step.slack;
      if (wants_sweep(step, convergence.last_decrease()))
        decrease += sweep(relaxation);
      convergence.add(decrease, is_regular(step), is_jammed());
      m_summary.converged = convergence.has_arrived() && (has_barrier(newton) || !is_stuck(step, least_decrease));
      tell(part_done(decrease, least_decrease));
    }
    if (m_summary.converged && asks_for_last_digits() && !has_barrier(newton))
      take_last_steps(newton);
  }

  double least_decrease_of_newton_steps() const
  {
    if (m_level.is_draft())
      return m_options.decrease_of_drafts;
    return m_barrier ? (std::max)(m_refinement.tolerance, m_options.least_decrease_with_barrier)
                     : m_refinement.tolerance;
  }

  Newton_method::Step take_newton_step(Newton_method& newton)
  {
    const double negligible =
        m_energy.is_flip_free() ? m_options.negligible_part * m_refinement.tolerance * m_current.excess() : 0;
    const Newton_method::Step step = newton.step(m_uv, m_current.value(), negligible);
    if (has_barrier(newton))      // the step may have paid for room with energy
      m_current.compute();
    else
      m_current.lower_by(step.decrease);
    ++m_summary.iterations;
    m_summary.cycles += step.cycles;
    return step;
  }

  // Whether there is something else to be minimized than the energy.
  bool has_barrier(const Newton_method& newton) const { return m_barrier || newton.turn_barrier().stiffness() > 0; }

  // Whether vertices are wedged between borders that are kept apart, and may still come free: much of a great energy is
  // at one of them.
  bool is_jammed() const
  {
    return m_barrier && m_energy.minimum() > 0 && iterations() < m_options.most_steps_in_jam &&
           m_current.value() > m_options.least_ratio_of_jam * m_energy.minimum_of_map() &&
           m_energy.greatest_of_vertices(m_uv) > m_options.least_part_of_jam * m_current.value();
  }

  // Whether the tolerance is below what energies in doubles tell.
  bool asks_for_last_digits() const { return !m_level.is_draft() && m_refinement.tolerance < m_options.rounding; }

  // The energy is above its minimum by the square of what the map is off: maps of the same energy in doubles may differ
  // by 1e-8, and by more where some motions hardly cost energy.
  void take_last_steps(Newton_method& newton)
  {
    double greatest_promise = (std::numeric_limits<double>::infinity)();
    while (m_status == OK && iterations() < m_refinement.number_of_iterations) {
      const auto step = newton.last_step(m_uv, greatest_promise, m_options.rounding * std::abs(m_current.value()));
      m_summary.cycles += step.cycles;
      if (step.length == 0)
        break;
      ++m_summary.iterations;
      greatest_promise = m_options.decrease_of_promise * step.predicted;
      tell(1);
    }
  }

  // Whether a step tells how Newton's method converges: long, and lowering the energy as the model predicts.
  bool is_regular(const Newton_method::Step& step) const
  {
    return m_energy.is_flip_free() && step.slack == 0 && step.length >= m_options.long_step &&
           step.decrease > m_options.newton.least_part_of_prediction * step.predicted;
  }

  // Whether what holds up a step, or makes it slow, may be in small places. Energies that do not keep triangles
  // positive converge slowly all over.
  bool wants_sweep(const Newton_method::Step& step, double last_decrease) const
  {
    const bool is_slow = m_energy.is_flip_free() && last_decrease > 0 &&
                         step.decrease > m_options.slow_convergence * last_decrease;
    return is_slow || step.length < m_options.short_step ||
           !m_current.is_little(step.decrease, m_options.great_decrease);
  }

  // Whether no step was possible although there is more to be gained, as far as the model tells. At a barrier that is
  // no wonder.
  bool is_stuck(const Newton_method::Step& step, double least_decrease) const
  {
    return step.length == 0 && !m_current.is_least() &&
           !((std::max)(step.missed, step.predicted) <= m_current.little(least_decrease));
  }

  const Level_energy& m_energy;
  const Level& m_level;
  Level::Uv& m_uv;
  const Refinement_options& m_refinement;
  const Level_refiner_options m_options;
  Level_summary& m_summary;
  const std::size_t m_iterations_before;
  std::unique_ptr<Border_barrier> m_barrier;      // none unless the map has to be globally injective
  const double m_unit;
  Current_energy m_current;
  Error_code m_status = OK;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_REFINER_H
