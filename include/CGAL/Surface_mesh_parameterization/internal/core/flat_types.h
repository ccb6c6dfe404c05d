// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_FLAT_TYPES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_FLAT_TYPES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Surface_mesh_parameterization::internal {

// What the rooms below the parameterizers work on: flat arrays of doubles and of 32-bit indices, whatever mesh
// and kernel the user has. The kernel's predicates are exact, so a triangle that they call positive is positive.
typedef CGAL::Exact_predicates_inexact_constructions_kernel   Flat_kernel;
typedef Flat_kernel::Point_2                                   Point_2;
typedef Flat_kernel::Vector_2                                  Vector_2;
typedef Flat_kernel::Point_3                                   Point_3;
typedef Flat_kernel::Vector_3                                  Vector_3;

typedef std::uint32_t                                          Index;
typedef std::array<Index, 3>                                   Index_triangle;   // counter-clockwise

constexpr Index no_index = (std::numeric_limits<Index>::max)();

inline double cross(const Vector_2& a, const Vector_2& b) { return a.x() * b.y() - a.y() * b.x(); }
inline bool is_finite(const Point_2& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); }
inline bool is_left_turn(const Point_2& a, const Point_2& b, const Point_2& c) { return orientation(a, b, c) == LEFT_TURN; }

inline void replace_corner(Index_triangle& t, Index from, Index to)
{
  for (Index& corner : t)
    if (corner == from)
      corner = to;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_FLAT_TYPES_H
