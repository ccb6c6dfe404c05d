// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_EXACT_PREDICATES_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_EXACT_PREDICATES_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>

#include <CGAL/MP_Float.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Orientation unfiltered_orientation(const Point_2& a, const Point_2& b, const Point_2& c)
{
  const bool do_coincide = a == b || b == c || c == a;      // as where triangles have a vertex in common
  if (do_coincide || !is_finite(a) || !is_finite(b) || !is_finite(c))
    return COLLINEAR;
  const MP_Float ax(a.x()), ay(a.y());
  return CGAL::compare((MP_Float(b.x()) - ax) * (MP_Float(c.y()) - ay),
                       (MP_Float(b.y()) - ay) * (MP_Float(c.x()) - ax));
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double exact_doubled_area(const Point_2& a, const Point_2& b, const Point_2& c, int exponent)
{
  const MP_Float ax(a.x()), ay(a.y()), unit(std::ldexp(1., -exponent)),
                 plus = (MP_Float(b.x()) - ax) * (MP_Float(c.y()) - ay),
                 minus = (MP_Float(b.y()) - ay) * (MP_Float(c.x()) - ax);
  return CGAL::to_double((plus - minus) * unit * unit);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool do_segments_meet(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& d)
{
  const Orientation side_c = exact_orientation(a, b, c), side_d = exact_orientation(a, b, d);
  if (side_c != COLLINEAR && side_c == side_d)
    return false;
  const Orientation side_a = exact_orientation(c, d, a), side_b = exact_orientation(c, d, b);
  if (side_a != COLLINEAR && side_a == side_b)
    return false;
  if (side_a != COLLINEAR || side_b != COLLINEAR || side_c != COLLINEAR || side_d != COLLINEAR)
    return true;
  // On one line, or in one point, they meet unless one ends before the other begins.
  return !is_less_xy((std::max)(a, b, is_less_xy), (std::min)(c, d, is_less_xy)) &&
         !is_less_xy((std::max)(c, d, is_less_xy), (std::min)(a, b, is_less_xy));
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_EXACT_PREDICATES_IMPL_H
