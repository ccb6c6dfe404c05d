// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_GUARD_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_GUARD_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Sees to it that a step of a whole map leaves the angles at border vertices, of which the energy knows nothing, below
// a full turn.
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

  // What the angles at a border vertex lack of a full turn, as a linear function of where the vertex and its two border
  // neighbors go.
  struct Gap
  {
    std::array<Index, 3> vertices;
    std::array<Block_vector, 3> gradients;
    double missing;         // how much less the step to the trial should have taken

    template <class Direction>
    double change(const Direction& direction) const
    {
      return inner_product(gradients[0], direction(vertices[0])) + inner_product(gradients[1], direction(vertices[1]))
           + inner_product(gradients[2], direction(vertices[2]));
    }
  };

  // The gaps at the border vertices that turn too far in the trial map.
  std::vector<Gap> lost_gaps(const Level::Uv& uv, const Level::Uv& trial) const
  {
    std::vector<Gap> result;
    for (Index v = 0; v < m_level.number_of_vertices(); ++v)
      if (m_level.is_border(v) && turns_too_far_at(v, uv, trial))
        result.push_back(gap_at(v, uv, trial));
    return result;
  }

private:
  // Whether the angles at a border vertex reach a full turn in the trial, or come so close that there is no room left
  // that was there before.
  bool turns_too_far_at(Index v, const Level::Uv& uv, const Level::Uv& trial) const
  {
    const One_rings& rings = m_level.rings();
    return internal::turns_too_far(rings, Place_of_vertex{ trial }, v) ||
           (leaves_no_room(rings, trial, v) && !leaves_no_room(rings, uv, v));
  }

  // A step may take a part of what the gap has above a small angle.
  Gap gap_at(Index v, const Level::Uv& uv, const Level::Uv& trial) const
  {
    constexpr double least_gap = 2e-3, part_to_lose = 0.8;
    const Index first = m_level.one_ring(v).front(), last = m_level.one_ring(v).back();
    const auto angle = [&](const Level::Uv& map) {
      const Vector_2 a = map[first] - map[v], b = map[last] - map[v];
      return std::atan2(cross(b, a), b * a);
    };
    const double before = angle(uv), gap = before < 0 ? before + 2 * CGAL_PI : before,
                 change = std::remainder(angle(trial) - before, 2 * CGAL_PI);
    const Vector_2 a = uv[first] - uv[v], b = uv[last] - uv[v];
    const Block_vector at_first = Block_vector(-a.y(), a.x()) / a.squared_length(),
                       at_last = Block_vector(b.y(), -b.x()) / b.squared_length();
    return { { v, first, last },
             { -at_first - at_last, at_first, at_last },
             -part_to_lose * (std::max)(gap - least_gap, 0.) - change };
  }

  const Level& m_level;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_GUARD_H
