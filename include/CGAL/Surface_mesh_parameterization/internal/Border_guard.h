// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_GUARD_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_GUARD_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/star_validity.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal {

// Sees to it that a step of a whole map leaves the angles at border vertices, of which the energy knows nothing, below a full turn.
class Border_guard
{
public:
  explicit Border_guard(const Level& level) : m_level(level) { }

  // Whether the angles at a border vertex turn too far in the trial map, to which a step from `uv` led.
  bool turns_too_far(const Level::Uv& uv, const Level::Uv& trial) const
  {
    for (Index v = 0; v < m_level.number_of_vertices(); ++v)
      if (m_level.is_border(v) && turns_too_far_at(v, uv, trial))
        return true;
    return false;
  }

  // Changes the direction of a step at the border vertices that turn too far in the trial map: bends it, or where that does not help or must not be, cuts it off.
  // Returns whether there are any.
  bool bend(const Level::Uv& uv, const Level::Uv& trial, Pair_vector& direction, bool may_bend) const
  {
    bool result = false;
    for (Index v = 0; v < m_level.number_of_vertices(); ++v)
      if (m_level.is_border(v) && turns_too_far_at(v, uv, trial)) {
        const Index first = m_level.one_ring(v).front(), last = m_level.one_ring(v).back();
        if (!may_bend || !keep_gap(uv, v, first, last, direction))
          direction[v] = direction[first] = direction[last] = Pair(0, 0);
        result = true;
      }
    return result;
  }

private:
  // Whether the angles at a border vertex reach a full turn in the trial, or come so close that there is no room left that was there before.
  bool turns_too_far_at(Index v, const Level::Uv& uv, const Level::Uv& trial) const
  {
    const One_rings& rings = m_level.rings();
    return internal::turns_too_far(rings, Place_of_vertex{ trial }, v) || (leaves_no_room(rings, trial, v) && !leaves_no_room(rings, uv, v));
  }

  // Changes the direction of a border vertex v and its border neighbors as little as is needed for the gap, what the angles at v lack of a full turn, to lose, to
  // first order, no more than a part of what it has above a small angle. Returns whether a change was needed.
  static bool keep_gap(const Level::Uv& uv, Index v, Index first, Index last, Pair_vector& direction)
  {
    constexpr double least_gap = 2e-3, part_to_lose = 0.8;
    const Vector_2 a = uv[first] - uv[v], b = uv[last] - uv[v];
    const double angle = std::atan2(cross(b, a), b * a), gap = angle < 0 ? angle + 2 * CGAL_PI : angle;
    const Pair at_first = Pair(-a.y(), a.x()) / a.squared_length(), at_last = Pair(b.y(), -b.x()) / b.squared_length(), at_v = -at_first - at_last;
    const double change = at_first.dot(direction[first]) + at_last.dot(direction[last]) + at_v.dot(direction[v]);
    const double excess = -part_to_lose * (std::max)(gap - least_gap, 0.) - change;
    if (!(excess > 0))
      return false;
    const double factor = excess / (at_first.squaredNorm() + at_last.squaredNorm() + at_v.squaredNorm());
    direction[first] += factor * at_first;
    direction[last] += factor * at_last;
    direction[v] += factor * at_v;
    return true;
  }

  const Level& m_level;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_GUARD_H
