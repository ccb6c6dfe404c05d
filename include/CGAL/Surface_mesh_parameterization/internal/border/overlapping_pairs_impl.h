// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_OVERLAPPING_PAIRS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_OVERLAPPING_PAIRS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/border/box_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

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

// Whether is_enough(do_interiors_meet) holds for any pair of triangles that are near each other; the search ends there.
inline bool any_near_pair(const std::vector<Triangle_2>& triangles, Function_ref<bool(bool)> is_enough)
{
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

  return any_pair_of_boxes(
      boxes, [&](std::size_t i, std::size_t j) { return is_enough(do_interiors_meet(positive[i], positive[j])); });
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::size_t number_of_overlapping_pairs(const std::vector<Triangle_2>& triangles, std::size_t most_tests)
{
  std::size_t pairs = 0, tests = 0;
  any_near_pair(triangles, [&](bool do_meet) {
    pairs += do_meet;
    return ++tests == most_tests;
  });
  return pairs;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool has_overlapping_pairs(const std::vector<Triangle_2>& triangles)
{
  return any_near_pair(triangles, [](bool do_meet) { return do_meet; });
}

// A closed curve of a border.
struct Border_curve
{
  std::size_t first_edge;
  Index least;            // its least vertex, which is an extreme one
  bool turns_left;
};

// Returns whether the edges form closed curves that share no vertex.
inline bool follow_curves(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv,
                          std::vector<Border_curve>& curves)
{
  std::vector<Index> next(uv.size(), no_index);
  for (const Border_edge& e : edges) {
    if (next[e.source] != no_index)
      return false;
    next[e.source] = e.target;
  }
  const auto is_less = [&](Index a, Index b) { return is_less_xy(uv[a], uv[b]); };
  std::vector<bool> is_seen(uv.size(), false);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Index start = edges[i].source;
    if (is_seen[start])
      continue;
    Index before_least = start, v = start;
    for (; next[v] != no_index && !is_seen[v]; v = next[v]) {
      is_seen[v] = true;
      if (is_less(next[v], next[before_least]))
        before_least = v;
    }
    if (v != start)
      return false;
    const Index least = next[before_least];
    curves.push_back({ i, least, is_left_turn(uv[before_least], uv[least], uv[next[least]]) });
  }
  return true;
}

// How often closed curves wind around points that lie on none of them. Their edges are sorted into strips of equal
// height: a chart with a long border may have many others in its holes.
class Winding_numbers
{
public:
  Winding_numbers(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv) : m_uv(uv)
  {
    constexpr double most_strips_of_edge = 3;     // on average
    double height_of_edges = 0, highest = uv[edges.front().source].y();
    m_lowest = highest;
    for (const Border_edge& e : edges) {
      height_of_edges += std::abs(uv[e.target].y() - uv[e.source].y());
      m_lowest = (std::min)(m_lowest, uv[e.source].y());
      highest = (std::max)(highest, uv[e.source].y());
    }
    const double height = highest - m_lowest, n = double(edges.size()),
                 strips = (std::min)(std::sqrt(n), most_strips_of_edge * n * height / height_of_edges);
    m_number_of_strips = strips >= 1 ? Index(strips) : 1;
    m_strips_per_length = height > 0 ? double(m_number_of_strips) / height : 0;
    m_strips = Compressed_lists<Border_edge>(m_number_of_strips, [&](const auto& add) {
      for (const Border_edge& e : edges) {
        const Index first = strip(uv[e.source].y()), last = strip(uv[e.target].y());
        for (Index i = (std::min)(first, last); i <= (std::max)(first, last); ++i)
          add(i, e);
      }
    });
  }

  int operator()(const Point_2& p) const
  {
    int result = 0;
    for (const Border_edge& e : m_strips[strip(p.y())]) {
      const Point_2 &a = m_uv[e.source], &b = m_uv[e.target];
      if (a.y() <= p.y() && p.y() < b.y())
        result += is_left_turn(a, b, p);
      else if (b.y() <= p.y() && p.y() < a.y())
        result -= is_left_turn(b, a, p);
    }
    return result;
  }

private:
  // Grows with y, and so the strips from one end of an edge to the other hold what lies between them.
  Index strip(double y) const
  {
    const double position = (y - m_lowest) * m_strips_per_length;
    return position < double(m_number_of_strips) ? Index((std::max)(0., position)) : m_number_of_strips - 1;
  }

  const std::vector<Point_2>& m_uv;
  double m_lowest, m_strips_per_length;
  Index m_number_of_strips;
  Compressed_lists<Border_edge> m_strips;
};

// Whether of charts whose borders do not meet one lies in another. A vertex on the border of each chart tells.
inline bool is_one_in_another(const std::vector<Border_edge>& edges, const std::vector<Index>& chart_of,
                              const std::vector<Index>& vertex_of, const std::vector<Point_2>& uv)
{
  std::vector<std::vector<Border_edge>> edges_of(vertex_of.size());
  std::vector<Bbox_2> boxes(vertex_of.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    edges_of[chart_of[i]].push_back(edges[i]);
    boxes[chart_of[i]] += uv[edges[i].source].bbox();
  }
  std::vector<std::optional<Winding_numbers>> winding_numbers(vertex_of.size());
  const auto is_in = [&](std::size_t i, std::size_t j) {
    const Point_2& p = uv[vertex_of[i]];
    if (!do_overlap(p.bbox(), boxes[j]))
      return false;
    if (!winding_numbers[j])
      winding_numbers[j].emplace(edges_of[j], uv);
    return (*winding_numbers[j])(p) != 0;
  };
  return any_pair_of_boxes(boxes, [&](std::size_t i, std::size_t j) { return is_in(i, j) || is_in(j, i); });
}

inline std::size_t number_of_charts(const std::vector<Index>& chart_of)
{
  return chart_of.empty() ? 0 : 1 + std::size_t(*std::max_element(chart_of.begin(), chart_of.end()));
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool are_charts_apart(const std::vector<Border_edge>& edges, const std::vector<Index>& chart_of,
                      const std::vector<Point_2>& uv)
{
  if (has_crossings(edges, uv, [&](std::size_t i, std::size_t j) { return chart_of[i] != chart_of[j]; }))
    return false;
  std::vector<Index> vertex_of(number_of_charts(chart_of));
  for (std::size_t i = 0; i < edges.size(); ++i)
    vertex_of[chart_of[i]] = edges[i].source;
  return !is_one_in_another(edges, chart_of, vertex_of, uv);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool are_charts_one_to_one(const std::vector<Border_edge>& edges, const std::vector<Index>& chart_of,
                           const std::vector<Point_2>& uv)
{
  std::vector<Border_curve> curves;
  if (edges.empty() || !follow_curves(edges, uv, curves) || has_crossings(edges, uv))
    return false;
  std::vector<Index> outermost(number_of_charts(chart_of), no_index);      // a vertex on the curve that turns left
  for (const Border_curve& c : curves)
    if (Index& v = outermost[chart_of[c.first_edge]]; c.turns_left) {
      if (v != no_index)
        return false;
      v = c.least;
    }
  return std::find(outermost.begin(), outermost.end(), no_index) == outermost.end() &&
         !is_one_in_another(edges, chart_of, outermost, uv);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool are_borders_one_to_one(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv)
{
  return are_charts_one_to_one(edges, std::vector<Index>(edges.size(), 0), uv);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_OVERLAPPING_PAIRS_IMPL_H
