// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_EXACT_PREDICATES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_EXACT_PREDICATES_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal {

// The same as exact_orientation(), for points that doubles do not tell. Three points of which one is not finite count as collinear.
Orientation unfiltered_orientation(const Point_2& a, const Point_2& b, const Point_2& c);

// The side of c, seen from a in the direction of b, exactly.
inline Orientation exact_orientation(const Point_2& a, const Point_2& b, const Point_2& c)
{
  // A determinant of rounded differences is off by less than 4 * 2^-53 times the sum of its two products, unless these
  // underflow.
  constexpr double relative_error = 1e-15, least_determinant = 1e-290;
  const double plus = (b.x() - a.x()) * (c.y() - a.y()), minus = (b.y() - a.y()) * (c.x() - a.x()),
               determinant = plus - minus;
  const double bound = relative_error * (std::abs(plus) + std::abs(minus)) + least_determinant;
  if (determinant > bound)
    return LEFT_TURN;
  if (determinant < -bound)
    return RIGHT_TURN;
  return unfiltered_orientation(a, b, c);
}

// Twice the area of a triangle in units of 2^exponent: exact but for one rounding.
// Precondition: the points are finite, and the exponent is from -1000 to 1000.
double exact_doubled_area(const Point_2& a, const Point_2& b, const Point_2& c, int exponent);

inline bool is_left_turn(const Point_2& a, const Point_2& b, const Point_2& c)
{
  return exact_orientation(a, b, c) == LEFT_TURN;
}

// The lexicographical order.
inline bool is_less_xy(const Point_2& p, const Point_2& q)
{
  return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
}

inline bool are_strictly_ordered_xy(const Point_2& p, const Point_2& q, const Point_2& r)
{
  return (is_less_xy(p, q) && is_less_xy(q, r)) || (is_less_xy(r, q) && is_less_xy(q, p));
}

// Whether the segments ab and cd have a point in common.
bool do_segments_meet(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& d);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_EXACT_PREDICATES_H
