// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_METHOD_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_METHOD_H

#include <CGAL/Surface_mesh_parameterization/internal/border/Border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Turn_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Guarded_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
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
    double length = 0;            // 1 for the whole step; greater where that did not go far enough
    std::size_t cycles = 0;       // of multigrid
    double slack = 0;             // a bound of what the barrier at the full turn costs
    double missed = 0;            // what the model could be lowered by, about, where its minimum was not found
    std::size_t lost_gaps = 0;    // angles at the border for which alone no step was possible, while no barrier acts

    // The decrease along the slope at the start, by a part of the step.
    double promised_by_slope(double part) const { return 2 * part * predicted; }
  };

  // `barrier`, if there is one, keeps the borders apart; its energy is minimized along with the level's.
  explicit Newton_method(const Level_energy& energy, Border_barrier* barrier = nullptr,
                         const Newton_options& options = Newton_options())
    : m_energy(energy), m_level(energy.level()), m_options(options), m_objective(energy, barrier),
      m_system(energy, m_options),
      m_accuracy{ energy.is_flip_free() ? m_options.greatest_forcing : m_options.forcing_with_flips, 0,
                  m_options.most_cycles_after_short_step }
  {
    m_system.set_indefinite_part(m_energy.is_flip_free() ? 0 : first_indefinite_part());
  }

  const Turn_barrier& turn_barrier() const { return m_objective.turn_barrier(); }

  // Lets no step move the given vertices, see Newton_system.
  void fix_vertices(std::vector<Index> vertices) { m_system.fix_vertices(std::move(vertices)); }

  // One step from `uv`, whose energy is given. A cycle that would lower it by no more than `negligible` is not made.
  Step step(Level::Uv& uv, double energy, double negligible = 0)
  {
    m_accuracy.negligible = negligible;
    Step result = try_step(uv, energy);
    const auto try_again = [&] {
      const std::size_t cycles_before = result.cycles;
      result = try_step(uv, energy);
      result.cycles += cycles_before;
    };
    if (result.length == 0 && result.lost_gaps > 0) {
      m_objective.begin_turn_barrier(uv, m_options.first_slack * result.predicted / double(result.lost_gaps));
      try_again();
    }
    if (result.length == 0 && m_system.indefinite_part() > 0) {
      m_system.set_indefinite_part(0);
      try_again();
    }
    adapt_accuracy(result);
    adapt_grids(result);
    adapt_indefinite_part(result);
    m_objective.settle_turn_barrier();
    lower_turn_barrier(result);
    return result;
  }

  // One whole step at the end, where energies in doubles no longer tell what a step gains, and no barrier acts. It is
  // taken if the model promises less than `greatest_promise`, as it does on the way to a minimum, and the energy rises
  // by no more than `rounding`. The Hessian is the true one, so that such steps converge quadratically.
  Step last_step(Level::Uv& uv, double greatest_promise, double rounding)
  {
    m_system.set_indefinite_part(1);
    m_accuracy = { m_options.forcing_of_last_steps, 0, m_options.most_cycles };
    m_other_end.clear();      // the solution is exact: the step before has nothing to add
    Step result;
    if (!find_direction(uv, result) || !(result.predicted < greatest_promise))
      return result;
    m_other_end.resize(uv.size());
    go(uv, 1, m_system.moves(), m_other_end);
    if (m_energy(m_other_end) <= m_energy(uv) + rounding && m_objective.is_valid(uv, m_other_end)) {
      uv.swap(m_other_end);
      result.length = 1;
    }
    return result;
  }

private:
  double first_indefinite_part() const
  {
    return m_energy.is_flip_free() ? m_options.indefinite_part : m_options.indefinite_part_with_flips;
  }

  // Where the model is good, its minimum is worth more cycles.
  void adapt_accuracy(const Step& step)
  {
    m_accuracy.most_cycles = step.length >= 1 ? m_options.most_cycles : m_options.most_cycles_after_short_step;
    if (step.length > 0 && m_energy.is_flip_free())
      m_accuracy.forcing =
          (std::max)(m_options.least_forcing, (std::min)(m_options.forcing_per_error * error_of_prediction(step),
                                                         m_options.greatest_forcing));
  }

  static double error_of_prediction(const Step& step) { return std::abs(step.decrease / step.predicted - 1); }

  void adapt_grids(const Step& step)
  {
    if (step.length >= 1 && error_of_prediction(step) < m_options.greatest_error_without_setup)
      m_system.keep_coarse_grids();
  }

  // Where a step cannot be taken in full length, or gains little, the model is indefinite, or no good. Where it gains
  // more than predicted, the model has too little negative curvature.
  void adapt_indefinite_part(const Step& step)
  {
    const double part = m_system.indefinite_part(), relative_decrease = step.decrease / step.predicted;
    if (!(step.length >= 1 && relative_decrease > m_options.least_part_of_prediction))
      m_system.set_indefinite_part(0);
    else if (part > 0 && relative_decrease > m_options.great_part_of_prediction)
      m_system.set_indefinite_part(0.5 * (part + 1));
    else
      m_system.set_indefinite_part(first_indefinite_part());
  }

  // Where the map is as good as it gets with the barrier, a lower one serves.
  void lower_turn_barrier(Step& step)
  {
    const double stiffness = turn_barrier().stiffness();
    if (stiffness == 0)
      return;
    if (step.length > 0)
      step.slack = stiffness * double(m_objective.contacts().size());
    if (step.predicted < step.slack)
      m_objective.lower_turn_barrier(m_options.decrease_of_slack);
  }

  Step try_step(Level::Uv& uv, double energy)
  {
    Step result;
    energy += m_objective.find_contacts(uv);
    if (find_direction(uv, result)) {
      search_line(uv, m_system.moves(), energy, result);
      if (is_worth_bending(result))
        bend_step(uv, energy, result);
    }
    return result;
  }

  // Computes the moves of a step, and what the model promises. Returns whether they lower the energy.
  bool find_direction(const Level::Uv& uv, Step& result)
  {
    if (!m_system.assemble(uv, m_objective.contacts())) {
      result.missed = m_system.decrease_by_relaxation();
      return false;
    }
    result.cycles = m_system.solve(m_accuracy);
    if (m_other_end.size() == uv.size())
      m_system.add_previous_step(m_other_end, uv);
    result.predicted = m_system.predicted_decrease();
    if (!(result.predicted > 0))
      result.missed = m_system.decrease_by_relaxation();
    return result.predicted > 0;
  }

  // Halves the step until the energy falls and the map is valid. Ends early at a trial that fails only by the angles at
  // the border, while no barrier holds them.
  void search_line(Level::Uv& uv, const Block_vectors& direction, double energy, Step& result)
  {
    const double longest = m_options.part_of_longest_step * m_objective.longest_step(uv, direction);
    double length = (std::min)(1., longest);
    m_other_end.resize(uv.size());
    for (int i = 0; i < m_options.most_halvings; ++i, length *= 0.5) {
      go(uv, length, direction, m_other_end);
      const double decrease = energy - m_objective(m_other_end);
      if (!(decrease > m_options.sufficient_decrease * result.promised_by_slope(length)))
        continue;
      if (m_objective.is_valid(uv, m_other_end)) {
        uv.swap(m_other_end);
        result.decrease = decrease;
        result.length = length;
        if (!(decrease > m_options.poor_part_of_prediction * length * result.predicted))
          shorten_step(m_other_end, uv, direction, energy, result);
        else if (m_objective.has_barrier())
          lengthen_step(m_other_end, uv, direction, energy, longest, result);
        return;
      }
      result.lost_gaps = m_objective.has_barrier() ? 0 : m_objective.lost_gaps(uv, m_other_end);
      if (result.lost_gaps > 0)
        return;
    }
  }

  // After a step from `start` to `uv` that gained little because it went too far: goes back to the minimum of the
  // parabola that has the slope at its start and the energy at its end, if that is lower.
  void shorten_step(const Level::Uv& start, Level::Uv& uv, const Block_vectors& direction, double energy,
                    Step& result) const
  {
    const double promise = result.promised_by_slope(result.length),
                 length = 0.5 * result.length * promise / (promise - result.decrease);
    Level::Uv trial(uv.size());
    go(start, length, direction, trial);
    const double decrease = energy - m_objective(trial);
    if (decrease > result.decrease && m_objective.is_valid(start, trial)) {
      uv.swap(trial);
      result.decrease = decrease;
      result.length = length;
    }
  }

  // Doubles a step from `start` to `uv`, up to the length `longest`, while it lowers the energy by more than the model
  // says. Where borders are close the model is too stiff, and its step a small part of the way.
  void lengthen_step(const Level::Uv& start, Level::Uv& uv, const Block_vectors& direction, double energy,
                     double longest, Step& result) const
  {
    Level::Uv trial(uv.size());
    while (2 * result.length <= longest &&
           result.decrease > m_options.good_part_of_prediction * result.length * result.predicted) {
      go(start, 2 * result.length, direction, trial);
      const double decrease = energy - m_objective(trial);
      if (!(decrease > result.decrease) || !m_objective.is_valid(start, trial))
        return;
      uv.swap(trial);
      result.decrease = decrease;
      result.length *= 2;
    }
  }

  // A part of the map that turns moves along circles, and what turns along straight lines is stretched: where long
  // parts turn, this cuts steps short. An energy that scales do not change hardly minds.
  bool is_worth_bending(const Step& step) const
  {
    return step.length < 1 && step.cycles >= m_options.least_cycles_before_bend && m_energy.is_flip_free() &&
           !m_energy.is_scale_invariant();
  }

  // Replaces a step along a line by one along a parabola, if there is a longer one that lowers the energy more.
  // Source: Transtrum, Sethna, Improvements to the Levenberg-Marquardt algorithm for nonlinear least-squares
  // minimization, 2012 (geodesic acceleration).
  void bend_step(Level::Uv& uv, double energy, Step& result)
  {
    const Block_vectors direction = m_system.moves();
    if (result.length == 0)
      m_other_end = uv;
    const Level::Uv& start = m_other_end;
    const double t = m_options.difference_for_bend * (std::min)(1., m_objective.longest_step(start, direction));
    const Newton_system::Accuracy accuracy = { m_accuracy.forcing, 0, m_options.most_cycles_of_bend };
    result.cycles += m_system.solve_for_bend(start, direction, t, accuracy);
    const Block_vectors& bend = m_system.moves();
    Level::Uv trial(uv.size());
    for (double length = 1; length > (std::max)(result.length, std::exp2(-m_options.most_halvings)); length *= 0.5) {
      m_level.for_each_vertex([&](Index v) {
        const Block_vector move = length * (direction[v] + length * bend[v]);
        trial[v] = start[v] + Vector_2(move.x, move.y);
      });
      const double decrease = energy - m_objective(trial);
      const double least_decrease = m_options.sufficient_decrease * result.promised_by_slope(length);
      if (decrease > (std::max)(result.decrease, least_decrease) && m_objective.is_valid(start, trial)) {
        uv.swap(trial);
        result.decrease = decrease;
        result.length = length;
        return;
      }
    }
  }

  void go(const Level::Uv& start, double length, const Block_vectors& direction, Level::Uv& end) const
  {
    m_level.for_each_vertex(
        [&](Index v) { end[v] = start[v] + Vector_2(length * direction[v].x, length * direction[v].y); });
  }

  const Level_energy& m_energy;
  const Level& m_level;
  Newton_options m_options;
  Guarded_energy m_objective;
  Newton_system m_system;
  Newton_system::Accuracy m_accuracy;
  // Of the step that was tried last: its start if it was taken, else its end. Solutions are joined with that direction.
  Level::Uv m_other_end;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_METHOD_H
