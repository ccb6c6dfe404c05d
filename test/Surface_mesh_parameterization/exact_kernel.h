// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EXACT_KERNEL_H
#define EXACT_KERNEL_H

#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <vector>

// The exact predicates of CGAL's own kernel, so that the engine's are not tested by themselves.
namespace test_meshes {

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Exact_kernel;

inline Exact_kernel::Point_2 exact(const Point_2& p) { return Exact_kernel::Point_2(p.x(), p.y()); }

inline CGAL::Orientation orientation_by_CGAL(const Point_2& a, const Point_2& b, const Point_2& c)
{
  return CGAL::orientation(exact(a), exact(b), exact(c));
}

inline bool turns_left(const Point_2& a, const Point_2& b, const Point_2& c)
{
  return orientation_by_CGAL(a, b, c) == CGAL::LEFT_TURN;
}

inline bool are_all_positive(const std::vector<Index_triangle>& triangles, const std::vector<Point_2>& uv)
{
  return std::all_of(triangles.begin(), triangles.end(),
                     [&](const Index_triangle& t) { return turns_left(uv[t[0]], uv[t[1]], uv[t[2]]); });
}

} // namespace test_meshes

#endif // EXACT_KERNEL_H
