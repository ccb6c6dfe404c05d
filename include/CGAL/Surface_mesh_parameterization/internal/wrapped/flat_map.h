// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_FLAT_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_FLAT_MAP_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The places of a map in doubles, of any point type of the user's.
template <class Point>
std::vector<Point_2> flat_map(const std::vector<Point>& points)
{
  std::vector<Point_2> map;
  map.reserve(points.size());
  for (const Point& p : points)
    map.push_back(to_point_2(p));
  return map;
}

// Whether they are finite numbers.
template <class Point>
bool is_finite_map(const std::vector<Point>& points)
{
  return std::all_of(points.begin(), points.end(), [](const Point& p) { return is_finite(to_point_2(p)); });
}

// Places that a parameterizer is to give: what it leaves out is not finite, if the numbers can be so.
template <class Point>
std::vector<Point> places_not_given(std::size_t size)
{
  typedef std::decay_t<decltype(std::declval<const Point&>().x())>   Number;
  const Number nan = std::numeric_limits<Number>::has_quiet_NaN ? std::numeric_limits<Number>::quiet_NaN() : Number(0);
  return std::vector<Point>(size, Point(nan, nan));
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_FLAT_MAP_H
