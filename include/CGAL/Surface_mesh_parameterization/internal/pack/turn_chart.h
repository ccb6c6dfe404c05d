// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_TURN_CHART_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_TURN_CHART_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Flat_chart.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

inline double area(const Flat_chart& chart)
{
  double sum = 0;
  for (const Index_triangle& t : chart.triangles)
    sum += 0.5 * std::abs(doubled_area(chart.points[t[0]], chart.points[t[1]], chart.points[t[2]]));
  return sum;
}

// The unit vector at an angle, a part of the full turn.
inline Vector_2 direction_at(double part)
{
  return Vector_2(std::cos(2 * CGAL_PI * part), std::sin(2 * CGAL_PI * part));
}

// So many, the first one along the x-axis.
inline std::vector<Vector_2> evenly_spaced_directions(std::size_t number)
{
  std::vector<Vector_2> result;
  for (std::size_t i = 0; i < number; ++i)
    result.push_back(direction_at(double(i) / double(number)));
  return result;
}

// The x-axis becomes the direction, a unit vector.
inline Point_2 turned(const Point_2& p, const Vector_2& direction)
{
  return Point_2(direction.x() * p.x() - direction.y() * p.y(), direction.y() * p.x() + direction.x() * p.y());
}

// The box around points that are turned.
inline Bbox_2 box_of(const std::vector<Point_2>& points, const Vector_2& direction = Vector_2(1, 0))
{
  Bbox_2 box;
  for (const Point_2& p : points)
    box += turned(p, direction).bbox();
  return box;
}

inline double width(const Bbox_2& box) { return box.xmax() - box.xmin(); }
inline double height(const Bbox_2& box) { return box.ymax() - box.ymin(); }

// Turns points, and moves them so that the box around them has its lower left corner at a place.
inline void turn_and_move(std::vector<Point_2>& points, const Vector_2& direction, const Vector_2& place)
{
  const Bbox_2 box = box_of(points, direction);
  const Vector_2 move = place - Vector_2(box.xmin(), box.ymin());
  for (Point_2& p : points)
    p = turned(p, direction) + move;
}

inline std::vector<Point_2> convex_hull(const std::vector<Point_2>& points)
{
  typedef Exact_predicates_inexact_constructions_kernel   Kernel;
  std::vector<Kernel::Point_2> exact_points, exact_hull;
  for (const Point_2& p : points)
    exact_points.emplace_back(p.x(), p.y());
  CGAL::convex_hull_2(exact_points.begin(), exact_points.end(), std::back_inserter(exact_hull));
  std::vector<Point_2> hull;
  for (const Kernel::Point_2& p : exact_hull)
    hull.emplace_back(p.x(), p.y());
  return hull;
}

// The directions that lay an edge of a convex polygon along the x-axis; of very many, some.
inline std::vector<Vector_2> directions_of_edges(const std::vector<Point_2>& polygon)
{
  constexpr std::size_t most_directions = 512;
  std::vector<Vector_2> result;
  const std::size_t step = polygon.size() / most_directions + 1;
  for (std::size_t i = 0; i < polygon.size(); i += step) {
    const Vector_2 edge = polygon[next_in_cycle(i, polygon.size())] - polygon[i];
    if (const double length = std::sqrt(edge.squared_length()); length > 0)
      result.emplace_back(edge.x() / length, -edge.y() / length);
  }
  return result;
}

// The direction in which a chart has the box of least cost.
template <class Cost_of_box>
Vector_2 best_direction(const std::vector<Point_2>& points, const std::vector<Vector_2>& directions,
                        const Cost_of_box& cost_of)
{
  Vector_2 best(1, 0);
  double least_cost = (std::numeric_limits<double>::infinity)();
  for (const Vector_2& direction : directions)
    if (const double cost = cost_of(box_of(points, direction)); cost < least_cost) {
      least_cost = cost;
      best = direction;
    }
  return best;
}

// Lays an edge of the convex hull along an axis, so that the box around the chart has little area.
inline void straighten(std::vector<Point_2>& points)
{
  const std::vector<Point_2> hull = convex_hull(points);
  turn_and_move(points, best_direction(hull, directions_of_edges(hull), [](const Bbox_2& box) {
                  return width(box) * height(box);
                }), Vector_2(0, 0));
}

// Turns a chart so that a small square holds it, and moves it into the middle of that square, which has a corner at the
// origin, and a margin: half of `margin`, a part of the side, at each side. Returns the side of the square.
inline double put_in_square(std::vector<Point_2>& points, double margin)
{
  const auto side_of = [](const Bbox_2& box) { return (std::max)(width(box), height(box)); };
  const std::vector<Point_2> hull = convex_hull(points);
  std::vector<Vector_2> directions = directions_of_edges(hull);
  // Where width and height are equal, no edge need lie along an axis.
  constexpr std::size_t number_of_others = 1024;
  for (std::size_t i = 0; i < number_of_others; ++i)
    directions.push_back(direction_at(0.25 * double(i) / number_of_others));
  const Vector_2 direction = best_direction(hull, directions, side_of);
  const Bbox_2 box = box_of(points, direction);
  const double side = side_of(box) / (1 - (std::max)(margin, 1e-6));         // no point lies on a side
  turn_and_move(points, direction, 0.5 * Vector_2(side - width(box), side - height(box)));
  return side;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_TURN_CHART_H
