// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_DECREASES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_DECREASES_H

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
class Lull
{
public:
  explicit Lull(double energy) : m_least(energy) { }

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

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_DECREASES_H
