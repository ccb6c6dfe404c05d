// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_TURN_BARRIER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_TURN_BARRIER_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Contact.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/logarithmic_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/time_on_one_line.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Keeps the angles at border vertices, of which the energy of triangles knows nothing, below a full turn: by an energy
// of what they lack of it, the gap, beyond the least one
//
//        first
//       /           see barrier_energy()
//     v  gap
//       \           .
//        last
//
// As in interior-point methods the stiffness goes to 0: what the optimum is off by then is at most the stiffness times
// the number of contacts.
class Turn_barrier
{
public:
  explicit Turn_barrier(const Level& level) : m_rings(level.rings())
  {
    for (Index v = 0; v < level.number_of_vertices(); ++v)
      if (level.is_border(v))
        m_corners.push_back({ v, m_rings[v].front(), m_rings[v].back() });
  }

  // The barrier does nothing as long as it is 0, as it is at first.
  double stiffness() const { return m_stiffness; }

  // Makes the barrier act from this map on. Where it has less than twice the least gap, half of that has to be left.
  void begin(const Level::Uv& uv, double stiffness)
  {
    m_stiffness = m_stiffness_of_contacts = stiffness;
    for (Corner& c : m_corners)
      c.least_gap = (std::min)(internal::least_gap, 0.5 * gap_at(c, uv));
  }

  // Lowers the barrier. The gaps are still where it was in balance before: until settle() contacts have the curvature
  // that they had there. With the new one, a step to where the gaps belong now would go too far.
  // Source: Wright, Primal-dual interior-point methods, 1997.
  void lower(double factor) { m_stiffness *= factor; }
  void settle() { m_stiffness_of_contacts = m_stiffness; }

  // The number of border vertices at which the angles reach a full turn in the trial map, to which a step from `uv`
  // led, or come so close that there is no room left that was there before.
  std::size_t number_of_lost_gaps(const Level::Uv& uv, const Level::Uv& trial) const
  {
    const auto has_no_room_left = [&](const Corner& c) {
      return m_stiffness > 0 ? room_at(c, trial) <= 0
                             : leaves_no_room(m_rings, trial, c.vertex) && !leaves_no_room(m_rings, uv, c.vertex);
    };
    return std::count_if(m_corners.begin(), m_corners.end(), [&](const Corner& c) {
      return turns_too_far(m_rings, Place_of_vertex{ trial }, c.vertex) || has_no_room_left(c);
    });
  }

  double operator()(const Level::Uv& uv) const
  {
    double sum = 0;
    for (const Corner& c : m_corners)
      sum += energy_at(c, uv);
    return sum;
  }

  // The part of the energy that changes when the border vertex v moves.
  double energy_around(Index v, const Level::Uv& uv) const
  {
    double sum = 0;
    for (const Index w : { v, m_rings[v].front(), m_rings[v].back() })
      sum += energy_at(corner_of(w), uv);
    return sum;
  }

  void add_contacts(const Level::Uv& uv, Contacts& contacts) const
  {
    if (m_stiffness == 0)
      return;
    const double curvature_factor = m_stiffness_of_contacts / m_stiffness;
    for (const Corner& c : m_corners) {
      const double room = room_at(c, uv);
      if (room >= range)
        continue;
      const Vector_2 to_first = uv[c.first] - uv[c.vertex], to_last = uv[c.last] - uv[c.vertex];
      const Block_vector at_first = Block_vector(-to_first.y(), to_first.x()) / to_first.squared_length(),
                         at_last = Block_vector(to_last.y(), -to_last.x()) / to_last.squared_length();
      const Barrier_derivatives d = barrier_derivatives(room, range, m_stiffness);
      contacts.push_back({ { c.vertex, c.first, c.last },
                           { -at_first - at_last, at_first, at_last },
                           d.first,
                           curvature_factor * d.second });
    }
  }

  // The length of the step `direction` at which a gap is down to the least one, infinite if there is none.
  double longest_step(const Level::Uv& uv, const Block_vectors& direction) const
  {
    double longest = (std::numeric_limits<double>::infinity)();
    for (const Corner& c : m_corners) {
      const auto move = [&](Index w) {
        const Block_vector d = direction[w] - direction[c.vertex];
        return Vector_2(d.x, d.y);
      };
      const double cosine = std::cos(c.least_gap), sine = std::sin(c.least_gap);
      const auto turned = [&](const Vector_2& v) {
        return Vector_2(cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y());
      };
      const double t = time_on_one_line(turned(uv[c.last] - uv[c.vertex]), turned(move(c.last)),
                                        uv[c.first] - uv[c.vertex], move(c.first),
                                        [](const Vector_2& a, const Vector_2& b) { return a * b > 0; });
      longest = (std::min)(longest, t);
    }
    return longest;
  }

private:
  static constexpr double range = 0.5;      // an angle

  struct Corner
  {
    Index vertex, first, last;
    double least_gap = 0;
  };

  const Corner& corner_of(Index v) const
  {
    return *std::lower_bound(m_corners.begin(), m_corners.end(), v,
                             [](const Corner& c, Index w) { return c.vertex < w; });
  }

  static double gap_at(const Corner& c, const Level::Uv& uv)
  {
    const Vector_2 to_first = uv[c.first] - uv[c.vertex], to_last = uv[c.last] - uv[c.vertex];
    const double angle = std::atan2(cross(to_last, to_first), to_last * to_first);
    return angle > 0 ? angle : angle + 2 * CGAL_PI;      // 0 is the angle of an ear without area
  }

  static double room_at(const Corner& c, const Level::Uv& uv) { return gap_at(c, uv) - c.least_gap; }

  double energy_at(const Corner& c, const Level::Uv& uv) const
  {
    if (m_stiffness == 0)
      return 0;
    const double room = room_at(c, uv);
    return room > 0 ? barrier_energy(room, range, m_stiffness) : (std::numeric_limits<double>::infinity)();
  }

  const One_rings& m_rings;
  std::vector<Corner> m_corners;      // by vertex
  double m_stiffness = 0, m_stiffness_of_contacts = 0;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_TURN_BARRIER_H
