// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ROUND_CHART_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ROUND_CHART_IMPL_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/round_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/turn_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/move_inward.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Origin.h>

#include <algorithm>
#include <cstddef>
#include <set>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool is_positive(const Flat_chart& chart)
{
  return std::all_of(chart.triangles.begin(), chart.triangles.end(), [&](const Index_triangle& t) {
    return is_left_turn(chart.points[t[0]], chart.points[t[1]], chart.points[t[2]]);
  });
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool is_mirrored(const Flat_chart& chart)
{
  return std::all_of(chart.triangles.begin(), chart.triangles.end(), [&](const Index_triangle& t) {
    return is_left_turn(chart.points[t[0]], chart.points[t[2]], chart.points[t[1]]);
  });
}

// The next three functions are the attempts of round_chart(). If one fails, the chart stays as it was.
inline bool round_places(Flat_chart& chart, const Rounding& round)
{
  const std::vector<Point_2> exact = chart.points;
  for (Point_2& p : chart.points)
    p = round(p);
  if (is_positive(chart))
    return true;
  chart.points = exact;
  const One_rings rings(chart.points.size(), chart.triangles);
  if (round && is_positive(chart) && round_map(rings, round.round, round.exponent, chart.points) && is_positive(chart))
    return true;
  chart.points = exact;
  return false;
}

// Of a chart that is too small for the steps of its coordinates.
inline bool round_places_enlarged(Flat_chart& chart, const std::vector<Point_2>& shape, const Rounding& round,
                                  double most_size)
{
  const auto middle_of = [](const Bbox_2& box) {
    return Vector_2(0.5 * (box.xmin() + box.xmax()), 0.5 * (box.ymin() + box.ymax()));
  };
  const std::vector<Point_2> exact = chart.points;
  const Bbox_2 box = box_of(shape);
  const Vector_2 middle = middle_of(box_of(chart.points));
  for (double factor = 1; factor * (width(box) + height(box)) < most_size; factor *= 4) {
    for (std::size_t i = 0; i < shape.size(); ++i)
      chart.points[i] = CGAL::ORIGIN + (middle + factor * (shape[i] - CGAL::ORIGIN - middle_of(box)));
    if (round_places(chart, round))
      return true;
  }
  chart.points = exact;
  return false;
}

inline bool round_places_repaired(Flat_chart& chart, const Triangulated_surface_3& surface, const Rounding& round)
{
  std::size_t unused_number = 0;
  return repair_map(surface, false, Loops(), chart.points, unused_number) == OK && round_places(chart, round);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool round_chart(Flat_chart& chart, const std::vector<Point_2>& shape, double most_size, const Rounding& round,
                 Function_ref<Triangulated_surface_3()> make_surface)
{
  return round_places(chart, round) || round_places_enlarged(chart, shape, round, most_size) ||
         round_places_repaired(chart, make_surface(), round);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool part_borders(Flat_chart& chart, const std::vector<Point_2>& shape, const Rounding& round)
{
  constexpr double first_part_of_way = 1e-9, greatest_part_of_way = 0.1;
  const One_rings rings(chart.points.size(), chart.triangles);
  const std::vector<Border_edge> edges = border_edges(rings);
  if (!has_crossings(edges, chart.points) || has_crossings(edges, shape))
    return true;
  for (double part = first_part_of_way; part <= greatest_part_of_way; part *= 10) {
    std::set<Index> meeting;
    for_each_crossing(edges, chart.points, [&](std::size_t i, std::size_t j) {
      meeting.insert({ edges[i].source, edges[i].target, edges[j].source, edges[j].target });
    });
    if (meeting.empty())
      return true;
    for (const Index v : meeting)
      move_inward(rings, v, part, chart.points, round);
  }
  return !has_crossings(edges, chart.points);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ROUND_CHART_IMPL_H
