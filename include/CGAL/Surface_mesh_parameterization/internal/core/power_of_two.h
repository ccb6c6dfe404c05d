// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_POWER_OF_TWO_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_POWER_OF_TWO_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

// Scaling by powers of two, which does not round unless doubles underflow.

namespace CGAL::Surface_mesh_parameterization::internal {

// Half of the longest side of a box.
template <class Bbox>
double half_width_of(const Bbox& box)
{
  double result = 0;
  for (int i = 0; i < box.dimension(); ++i)
    result = (std::max)(result, 0.5 * box.max(i) - 0.5 * box.min(i));
  return result;
}

// The exponent of the power that scales a box to a half width from 1 to 2; 0 for a point.
template <class Bbox>
int scale_exponent_of(const Bbox& box)
{
  const double half_width = half_width_of(box);
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

// Scales points to about size 1, unless they are so far away that their coordinates would overflow. Returns the
// exponent.
template <class Point>
int normalize(std::vector<Point>& points)
{
  decltype(points.front().bbox()) box;
  for (const Point& p : points)
    box += p.bbox();
  double greatest = 0;
  for (int i = 0; i < box.dimension(); ++i)
    greatest = (std::max)({ greatest, std::abs(box.min(i)), std::abs(box.max(i)) });
  int exponent = scale_exponent_of(box);
  if (greatest > 0)
    exponent = (std::min)(exponent, std::numeric_limits<double>::max_exponent - 2 - std::ilogb(greatest));
  for (Point& p : points)
    p = times_power_of_two(p, exponent);
  return exponent;
}

// Scales a map, by the nearest power of two where the result is not good: that does not round.
inline void scale_map(double scale, Function_ref<bool(const std::vector<Point_2>&)> is_good, std::vector<Point_2>& uv)
{
  std::vector<Point_2> result = scaled(uv, scale);
  if (!is_good(result))
    result = scaled(std::move(uv), std::exp2(std::round(std::log2(scale))));
  uv = std::move(result);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_POWER_OF_TWO_H
