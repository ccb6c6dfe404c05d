// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_SHAPES_H
#define RANDOM_SHAPES_H

#include "test_meshes.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

// Random points, angles and polygons.
namespace test_meshes {

inline Point_2 polar(double radius, double angle)
{
  return Point_2(radius * std::cos(angle), radius * std::sin(angle));
}

inline double length(const Vector_2& v) { return std::sqrt(v.squared_length()); }

inline Point_3 random_point_3(Random& random)
{
  const double x = random(-1, 1), y = random(-1, 1);
  return Point_3(x, y, random(-1, 1));
}

inline Point_2 random_point_2(Random& random)
{
  const double x = random(-1, 1);
  return Point_2(x, random(-1, 1));
}

// `n` increasing angles from 0 on; neither two neighbors nor the last and the first one are more than `widest` apart.
inline std::vector<double> random_angles(std::size_t n, double turn, double widest, Random& random)
{
  for (;;) {
    std::vector<double> parts, angles(1, 0.);
    for (std::size_t i = 0; i < n; ++i)
      parts.push_back(random(0.1, 1));
    const double sum = std::accumulate(parts.begin(), parts.end(), 0.);
    if (*std::max_element(parts.begin(), parts.end()) / sum * turn > widest)
      continue;
    for (std::size_t i = 0; i + 1 < n; ++i)
      angles.push_back(angles.back() + parts[i] / sum * turn);
    return angles;
  }
}

// A polygon whose kernel holds `center`.
inline std::vector<Point_2> random_star_polygon(std::size_t n, const Point_2& center, Random& random)
{
  std::vector<Point_2> polygon;
  for (const double angle : random_angles(n, 2 * CGAL_PI, 0.9 * CGAL_PI, random))
    polygon.push_back(center + (polar(random(0.2, 1), angle) - CGAL::ORIGIN));
  return polygon;
}

} // namespace test_meshes

#endif // RANDOM_SHAPES_H
