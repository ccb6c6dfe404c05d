// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_POWER_OF_TWO_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_POWER_OF_TWO_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <algorithm>
#include <cmath>

// Scaling by powers of two, which does not round.

namespace CGAL::Surface_mesh_parameterization::internal {

// The exponent of the power that scales a box to a half width from 1 to 2; 0 for a point.
template <class Bbox>
int scale_exponent_of(const Bbox& box)
{
  double half_width = 0;
  for (int i = 0; i < box.dimension(); ++i)
    half_width = (std::max)(half_width, 0.5 * box.max(i) - 0.5 * box.min(i));
  return half_width > 0 ? -std::ilogb(half_width) : 0;
}

inline Point_2 times_power_of_two(const Point_2& p, int exponent)
{
  return Point_2(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent));
}

inline Point_3 times_power_of_two(const Point_3& p, int exponent)
{
  return Point_3(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent));
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_POWER_OF_TWO_H
