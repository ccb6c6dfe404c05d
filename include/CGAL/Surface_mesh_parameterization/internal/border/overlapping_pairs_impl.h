// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_OVERLAPPING_PAIRS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_OVERLAPPING_PAIRS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/border/box_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// Whether the interiors of two positive triangles have a point in common: unless an edge of one of them has the other
// one on its outer side.
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

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::size_t number_of_overlapping_pairs(const std::vector<Triangle_2>& triangles, std::size_t most_tests)
{
  struct Enough { };
  std::vector<Triangle_2> positive;
  std::vector<Bbox_2> boxes;
  for (Triangle_2 t : triangles) {
    const Orientation turn = exact_orientation(t[0], t[1], t[2]);
    if (turn == COLLINEAR)
      continue;
    if (turn == RIGHT_TURN)
      std::swap(t[1], t[2]);
    positive.push_back(t);
    boxes.push_back(t[0].bbox() + t[1].bbox() + t[2].bbox());
  }

  std::size_t pairs = 0, tests = 0;
  try {
    for_each_pair_of_boxes(boxes, [&](std::size_t i, std::size_t j) {
      pairs += do_interiors_meet(positive[i], positive[j]);
      if (++tests == most_tests)
        throw Enough();
    });
  } catch (const Enough&) { }
  return pairs;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool are_borders_one_to_one(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv)
{
  std::vector<Index> next(uv.size(), no_index);
  for (const Border_edge& e : edges) {
    if (next[e.source] != no_index)
      return false;
    next[e.source] = e.target;
  }
  if (has_crossings(edges, uv))
    return false;

  const auto is_less = [&](Index a, Index b) { return is_less_xy(uv[a], uv[b]); };
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

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_OVERLAPPING_PAIRS_IMPL_H
