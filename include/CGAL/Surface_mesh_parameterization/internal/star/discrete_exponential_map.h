// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_DISCRETE_EXPONENTIAL_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_DISCRETE_EXPONENTIAL_MAP_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The discrete exponential map (Hormann, Greiner, Campagna 1999, section 1): lays the ring W0..Wn of V around the
// origin, at the lengths |Wi - V|, with the angles between consecutive edges scaled to one full turn. An open ring,
// that of a border vertex, keeps its angles unless they exceed a turn. A ring without any angle (all of it lies on V or
// on one ray) is spread evenly.
inline void discrete_exponential_map(const Point_3& v, const std::vector<Point_3>& ring, bool is_closed,
                                     std::vector<Vector_2>& flat_ring)
{
  constexpr double full_turn = 2 * CGAL_PI, most_of_a_turn = 0.95 * full_turn;
  const std::size_t size = ring.size(), number_of_angles = is_closed ? size : size - 1;

  flat_ring.resize(size);
  double total = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const Vector_3 from = ring[i] - v, to = ring[next_in_cycle(i, size)] - v;
    const double angle = std::atan2(std::sqrt(CGAL::cross_product(from, to).squared_length()), from * to);
    flat_ring[i] = Vector_2(std::sqrt(from.squared_length()), angle);   // polar, for now
    if (i < number_of_angles)
      total += angle;
  }

  const bool has_angles = total > 0;
  const double scale = !has_angles ? 0 : is_closed ? full_turn / total : (std::min)(1., most_of_a_turn / total);
  double direction = 0;
  for (Vector_2& w : flat_ring) {
    const double length = w.x(), angle = w.y();
    w = Vector_2(length * std::cos(direction), length * std::sin(direction));
    direction += has_angles ? scale * angle : (is_closed ? full_turn : CGAL_PI) / double(number_of_angles);
  }
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_DISCRETE_EXPONENTIAL_MAP_H
