// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_CONVERGENCE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_CONVERGENCE_H

#include <CGAL/Surface_mesh_parameterization/internal/newton/Current_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_refiner_options.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// By how much the steps of an iteration have lowered the energy, and what that tells of the steps to come.
class Decreases
{
public:
  // A decrease is sudden if it is less than this part of the one before.
  explicit Decreases(double sudden_fall) : m_sudden_fall(sudden_fall) { }

  // `is_regular`: whether the step tells how the iteration converges.
  void add(double decrease, bool is_regular)
  {
    m_is_sudden = decrease < m_sudden_fall * std::exchange(m_last, decrease);
    if (is_regular)
      m_regular = { m_regular[1], m_regular[2], decrease };
    m_number_of_regular = is_regular ? m_number_of_regular + 1 : 0;
  }

  // 0 before the first step.
  double last() const { return m_last; }

  // Whether the last step has suddenly gained nothing, which tells of that step rather than of the map.
  bool is_sudden() const { return m_is_sudden; }

  // What the energy will fall yet if it goes on as by the last three steps: if each gains at most the same part of what
  // the one before did. Infinite if they are not regular, or gain more and more.
  double remainder() const
  {
    const double ratio = (std::max)(m_regular[2] / m_regular[1], m_regular[1] / m_regular[0]);
    return m_number_of_regular >= m_regular.size() && ratio < 1 ? m_regular[2] * ratio / (1 - ratio)
                                                                 : (std::numeric_limits<double>::infinity)();
  }

private:
  double m_sudden_fall, m_last = 0;
  bool m_is_sudden = false;
  std::array<double, 3> m_regular = {};      // the last ones
  std::size_t m_number_of_regular = 0;       // in a row
};

// Steps in a row that have not brought the energy below what it was before.
class Stagnation
{
public:
  explicit Stagnation(double energy) : m_least(energy) { }

  // A step has led to `energy`; what it is lower by counts if it is more than `little`.
  void add(double energy, double little)
  {
    if (energy < m_least - little) {
      m_least = energy;
      m_number_of_steps = 0;
    } else
      ++m_number_of_steps;
  }

  std::size_t number_of_steps() const { return m_number_of_steps; }

private:
  double m_least;
  std::size_t m_number_of_steps = 0;
};

// Tells from the steps of Newton's method whether they have arrived.
class Newton_convergence
{
public:
  // A step is little that lowers the excess of `current` by less than the part `least_decrease`.
  Newton_convergence(const Current_energy& current, bool has_border_barrier, double least_decrease,
                     const Level_refiner_options& options)
    : m_current(current), m_options(options), m_has_border_barrier(has_border_barrier),
      m_least_decrease(least_decrease), m_decreases(options.sudden_fall), m_stagnation(current.value())
  { }

  // A step has led to the current energy, lower by `decrease`. `is_regular`: whether it tells how the method converges;
  // `is_jammed`: whether vertices are still to come free, so no step is too small to go on.
  void add(double decrease, bool is_regular, bool is_jammed)
  {
    m_decreases.add(decrease, is_regular);
    m_stagnation.add(m_current.value(),
                     m_current.little(is_jammed ? m_options.least_decrease_with_barrier : m_least_decrease));
    const bool is_slow = m_current.is_little(decrease, m_least_decrease) ||
                         m_decreases.remainder() <= m_least_decrease * m_current.excess(),
               falls_no_more = m_has_border_barrier &&
                               m_stagnation.number_of_steps() >= m_options.most_steps_without_fall;
    m_has_arrived = ((is_slow && !is_jammed) || falls_no_more) && !m_decreases.is_sudden();
  }

  bool has_arrived() const { return m_has_arrived; }

  // 0 before the first step.
  double last_decrease() const { return m_decreases.last(); }

private:
  const Current_energy& m_current;
  const Level_refiner_options& m_options;
  const bool m_has_border_barrier;
  const double m_least_decrease;
  Decreases m_decreases;
  Stagnation m_stagnation;
  bool m_has_arrived = false;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_CONVERGENCE_H
