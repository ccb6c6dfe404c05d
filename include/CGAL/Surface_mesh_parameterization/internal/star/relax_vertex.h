// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_RELAX_VERTEX_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_RELAX_VERTEX_H

#include <CGAL/Surface_mesh_parameterization/internal/star/Star.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The Newton direction. A Hessian that is not positive definite, or hardly, is shifted until it is.
template <class Derivatives>
Vector_2 newton_direction(const Derivatives& d)
{
  constexpr double least_relative_determinant = 1e-8, relative_shift = 1e-2;

  double xx = d.hessian[0], yy = d.hessian[2];
  const double xy = d.hessian[1], trace = xx + yy;
  if (!(trace > 0 && xx * yy - xy * xy > least_relative_determinant * trace * trace)) {
    const double radius = std::hypot(0.5 * (xx - yy), xy), least = 0.5 * trace - radius,
                 greatest = 0.5 * trace + radius;
    const double shift = (std::max)(-least, 0.) + relative_shift * (std::max)(std::abs(least), std::abs(greatest));
    xx += shift;
    yy += shift;
  }
  const double inverse = 1 / (xx * yy - xy * xy);
  return Vector_2((xy * d.gradient[1] - yy * d.gradient[0]) * inverse,
                  (xy * d.gradient[0] - xx * d.gradient[1]) * inverse);
}

// Whether a border vertex and its two border neighbors leave room at the border.
inline bool has_room(const One_rings& rings, const std::vector<Point_2>& uv, Index v)
{
  return !leaves_no_room(rings, uv, v) && !leaves_no_room(rings, uv, rings[v].front()) &&
         !leaves_no_room(rings, uv, rings[v].back());
}

// One step of vertex relaxation (Hormann and Greiner 1999): moves v by a safeguarded Newton step inside the kernel of
// its star and returns by how much the energy fell, 0 if v stayed. The step is `relaxation_factor` times Newton's; it
// is halved until the energy falls and the invariant holds by exact predicates. It is no longer than `reach`.
// Precondition: `star` is gathered from v, and the invariant holds.
template <class Energy>
double relax_vertex(const Star<Energy>& star, const One_rings& rings, Index v, double relaxation_factor,
                    std::vector<Point_2>& uv, double reach = (std::numeric_limits<double>::infinity)())
{
  constexpr int most_halvings = 8;
  constexpr double part_of_longest_step = 0.8, sufficient_decrease = 1e-4, least_relative_decrease = 1e-15;

  const Point_2 start = uv[v];
  const typename Star<Energy>::Derivatives d = star.derivatives(start);
  const Vector_2 direction = newton_direction(d);
  const double slope = d.gradient[0] * direction.x() + d.gradient[1] * direction.y();
  if (!(slope < -least_relative_decrease * d.value))    // converged, or not a number
    return 0;

  double step = (std::min)(relaxation_factor, reach / std::sqrt(direction.squared_length()));
  for (int i = 0; i < most_halvings; ++i, step *= 0.5) {
    const Point_2 trial = start + step * direction;
    const auto energy = star.filtered_energy(trial);
    const double decrease = d.value - energy.value;
    if (!(decrease > -sufficient_decrease * step * slope)) {
      if (!std::isfinite(energy.value))      // outside the kernel
        step = (std::min)(step, 2 * part_of_longest_step * star.longest_step(start, direction));
      continue;
    }
    const bool had_room = !rings.is_border(v) || has_room(rings, uv, v);
    uv[v] = trial;
    if (!Energy::is_flip_free)
      return decrease;
    if (rings.is_border(v) ? is_star_valid(rings, uv, v) && (!had_room || has_room(rings, uv, v))
                           : energy.is_surely_positive || is_star_valid(rings, uv, v))
      return decrease;
    uv[v] = start;
  }
  return 0;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_RELAX_VERTEX_H
