// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_OVERLAPPING_PAIRS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_OVERLAPPING_PAIRS_H

#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

typedef std::array<Point_2, 3>   Triangle_2;

// Whether the interiors of two positive triangles have a point in common: unless an edge of one of them has the other one on its outer side.
inline bool do_interiors_meet(const Triangle_2& s, const Triangle_2& t)
{
  const auto separates = [](const Triangle_2& a, const Triangle_2& b) {
    for (int i = 0; i < 3; ++i) {
      const Point_2 &p = a[i], &q = a[(i + 1) % 3];
      if (!is_left_turn(p, q, b[0]) && !is_left_turn(p, q, b[1]) && !is_left_turn(p, q, b[2]))
        return true;
    }
    return false;
  };
  return !separates(s, t) && !separates(t, s);
}

// The number of pairs of triangles whose interiors meet. Triangles that lie on a line have no interior; flipped ones count like others.
// After `most_tests` pairs that are near each other counting ends. Precondition: no coordinate is infinite or no number.
inline std::size_t number_of_overlapping_pairs(std::vector<Triangle_2> triangles, std::size_t most_tests = 100'000'000)
{
  typedef CGAL::Box_intersection_d::Box_with_info_d<double, 2, const Triangle_2*>   Box;
  struct Enough { };

  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (Triangle_2& t : triangles) {
    const Orientation turn = orientation(t[0], t[1], t[2]);
    if (turn == COLLINEAR)
      continue;
    if (turn == RIGHT_TURN)
      std::swap(t[1], t[2]);
    boxes.emplace_back(t[0].bbox() + t[1].bbox() + t[2].bbox(), &t);
  }
  std::size_t pairs = 0, tests = 0;
  try {
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      pairs += do_interiors_meet(*a.info(), *b.info());
      if (++tests == most_tests)
        throw Enough();
    });
  } catch (const Enough&) { }
  return pairs;
}

// Whether the borders of a map of positive triangles show that it is one-to-one: no two edges cross, and of the closed curves just one turns left. Then it winds
// at most once around a point of the plane, and as often as it winds around it, so many triangles lie over it.
inline bool are_borders_one_to_one(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv)
{
  std::vector<Index> next(uv.size(), no_index);
  for (const Border_edge& e : edges) {
    if (next[e.source] != no_index)
      return false;
    next[e.source] = e.target;
  }
  if (has_crossings(edges, uv))
    return false;

  const auto is_less = [&](Index a, Index b) { return compare_xy(uv[a], uv[b]) == SMALLER; };
  std::vector<bool> is_seen(uv.size(), false);
  int left_turning = 0;
  for (const Border_edge& e : edges) {
    if (is_seen[e.source])
      continue;
    Index before_least = e.source;     // the least vertex of the curve is an extreme one
    Index v = e.source;
    for (; next[v] != no_index && !is_seen[v]; v = next[v]) {
      is_seen[v] = true;
      if (is_less(next[v], next[before_least]))
        before_least = v;
    }
    if (v != e.source)
      return false;
    const Index least = next[before_least];
    left_turning += is_left_turn(uv[before_least], uv[least], uv[next[least]]);
  }
  return left_turning == 1;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_OVERLAPPING_PAIRS_H
