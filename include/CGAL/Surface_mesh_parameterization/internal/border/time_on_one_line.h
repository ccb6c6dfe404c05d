// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_TIME_ON_ONE_LINE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_TIME_ON_ONE_LINE_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Surface_mesh_parameterization::internal {

// The two times t at which the vectors p + t dp and q + t dq lie on one line; infinite or no numbers if there are not
// two.
inline std::array<double, 2> times_on_one_line(const Vector_2& p, const Vector_2& dp, const Vector_2& q,
                                               const Vector_2& dq)
{
  constexpr double never = (std::numeric_limits<double>::infinity)();
  const double c0 = cross(p, q), c1 = cross(p, dq) + cross(dp, q), c2 = cross(dp, dq),
               discriminant = c1 * c1 - 4 * c0 * c2;
  if (discriminant < 0)
    return { never, never };
  // The roots of c0 + c1 t + c2 t^2 are s / c2 and c0 / s.
  const double s = -0.5 * (c1 + std::copysign(std::sqrt(discriminant), c1));
  return { s / c2, c0 / s };
}

// The least t >= 0 at which the vectors p + t dp and q + t dq lie on one line and fulfill a condition; infinite if
// there is none.
template <class Condition>
double time_on_one_line(const Vector_2& p, const Vector_2& dp, const Vector_2& q, const Vector_2& dq,
                        const Condition& condition)
{
  double first = (std::numeric_limits<double>::infinity)();
  for (const double t : times_on_one_line(p, dp, q, dq))
    if (t >= 0 && t < first && condition(p + t * dp, q + t * dq))
      first = t;
  return first;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_TIME_ON_ONE_LINE_H
