// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_FLAT_TYPES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_FLAT_TYPES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// What the engine works on: flat arrays of doubles and of 32-bit indices, whatever mesh and kernel the user has.
// Predicates are those of exact_predicates.h: the kernel's own ones are not exact.
typedef CGAL::Simple_cartesian<double>   Flat_kernel;
typedef Flat_kernel::Point_2             Point_2;
typedef Flat_kernel::Vector_2            Vector_2;
typedef Flat_kernel::Point_3             Point_3;
typedef Flat_kernel::Vector_3            Vector_3;

typedef std::uint32_t                    Index;
typedef std::array<Index, 3>             Index_triangle;   // counter-clockwise

constexpr Index no_index = (std::numeric_limits<Index>::max)();

// Of a surface, so that its corners and border vertices have indices, also when its holes are closed by triangles.
constexpr std::size_t most_triangles = no_index / 8;
inline constexpr const char* cause_of_size = "the surface has more than 536870911 triangles";

inline double cross(const Vector_2& a, const Vector_2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Twice the area of a triangle; in the plane negative if it is turned clockwise.
inline double doubled_area(const Point_2& a, const Point_2& b, const Point_2& c) { return cross(b - a, c - a); }
inline double doubled_area(const Point_3& a, const Point_3& b, const Point_3& c)
{
  return std::sqrt(CGAL::cross_product(b - a, c - a).squared_length());
}

// Twice the area that a polygon encloses; negative if it runs clockwise.
inline double doubled_area(const std::vector<Point_2>& polygon)
{
  double sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum += doubled_area(polygon[0], polygon[i - 1], polygon[i]);
  return sum;
}

// A point of the user's in doubles.
template <class Point>
Point_2 to_point_2(const Point& p)
{
  return Point_2(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
}

template <class Point>
Point_3 to_point_3(const Point& p)
{
  return Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

inline bool is_finite(const Point_2& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); }
inline bool is_finite(const Point_3& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); }

inline bool are_finite(const std::vector<Point_2>& points)
{
  return std::all_of(points.begin(), points.end(), [](const Point_2& p) { return is_finite(p); });
}

// The place of what has no place.
inline Point_2 nowhere()
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return Point_2(nan, nan);
}

inline void mirror(Point_2& p) { p = Point_2(-p.x(), p.y()); }
inline void mirror(std::vector<Point_2>& points)
{
  for (Point_2& p : points)
    mirror(p);
}

inline std::vector<Point_2> scaled(std::vector<Point_2> points, double factor)
{
  for (Point_2& p : points)
    p = Point_2(factor * p.x(), factor * p.y());
  return points;
}

inline std::size_t next_in_cycle(std::size_t i, std::size_t size) { return i + 1 == size ? 0 : i + 1; }

inline void replace_corner(Index_triangle& t, Index from, Index to)
{
  for (Index& corner : t)
    if (corner == from)
      corner = to;
}

// Where each of the numbers below `end` stands in a list; `no_index` if it does not.
inline std::vector<Index> positions_in(const std::vector<Index>& list, std::size_t end)
{
  std::vector<Index> result(end, no_index);
  for (std::size_t k = 0; k < list.size(); ++k)
    result[list[k]] = Index(k);
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_FLAT_TYPES_H
