// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_BEST_CHORD_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_BEST_CHORD_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/turn_chart.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// How far points reach in directions that are evenly spaced over the half turn, for the least box around them.
class Extents
{
public:
  static constexpr std::size_t number_of_directions = 128;
  typedef std::array<float, number_of_directions>   Projections;

  static Projections projections(const Point_2& p)
  {
    static const std::vector<Vector_2> directions = evenly_spaced_directions(2 * number_of_directions);
    Projections result;
    for (std::size_t i = 0; i < number_of_directions; ++i)
      result[i] = float(directions[i].x() * p.x() + directions[i].y() * p.y());
    return result;
  }

  Extents()
  {
    m_least.fill((std::numeric_limits<float>::max)());
    m_greatest.fill(std::numeric_limits<float>::lowest());
  }

  void add(const Projections& p)
  {
    for (std::size_t i = 0; i < number_of_directions; ++i) {
      m_least[i] = (std::min)(m_least[i], p[i]);
      m_greatest[i] = (std::max)(m_greatest[i], p[i]);
    }
  }

  // The area of the least box with sides along two of the directions; of a box that is longer than a side of the square
  // that has to hold it, that of the square around it.
  double area_of_box(double side_of_square) const
  {
    constexpr std::size_t quarter = number_of_directions / 2;
    const float side = float(side_of_square);
    float least = (std::numeric_limits<float>::max)();
    for (std::size_t i = 0; i < quarter; ++i) {
      const float width = m_greatest[i] - m_least[i], height = m_greatest[i + quarter] - m_least[i + quarter],
                  longest = (std::max)(width, height);
      least = (std::min)(least, longest > side ? longest * longest : width * height);
    }
    return least;
  }

private:
  Projections m_least, m_greatest;
};

// The area of the least box around points, nearly, in a square of such a side.
inline double area_of_box(const std::vector<Point_2>& points, double side_of_square)
{
  Extents extents;
  for (const Point_2& p : points)
    extents.add(Extents::projections(p));
  return extents.area_of_box(side_of_square);
}

// Whether the segment between two vertices of a polygon lies within it. If it meets a vertex, either answer may come.
inline bool is_chord(const std::vector<Point_2>& polygon, std::size_t begin, std::size_t end)
{
  const Point_2 &a = polygon[begin], &b = polygon[end];
  const Point_2 middle(0.5 * (a.x() + b.x()), 0.5 * (a.y() + b.y()));
  const auto is_left = [](const Point_2& p, const Point_2& q, const Point_2& r) { return cross(q - p, r - p) > 0; };
  bool is_middle_inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = next_in_cycle(i, polygon.size());
    const Point_2 &p = polygon[i], &q = polygon[j];
    if ((p.y() > middle.y()) != (q.y() > middle.y()) && is_left(p, q, middle) == (q.y() > p.y()))
      is_middle_inside = !is_middle_inside;
    if (i != begin && i != end && j != begin && j != end && is_left(a, b, p) != is_left(a, b, q) &&
        is_left(p, q, a) != is_left(p, q, b))
      return false;
  }
  return is_middle_inside;
}

// A segment between two vertices of a polygon that lies within it, and divides it.
struct Chord
{
  std::size_t begin, end;
  double cost;          // the areas of the least boxes around both sides, and that of the length
};

// The chord of least cost that leaves so much area on each side; of none, the cost is infinite. The polygon is
// counter-clockwise, and the boxes have to lie in a square. Takes quadratic time, and in unlucky cases cubic time.
inline Chord best_chord(const std::vector<Point_2>& polygon, double side_of_square, double least_area,
                        double cost_of_length)
{
  const std::size_t n = polygon.size();
  std::vector<Extents::Projections> projections;
  std::vector<double> doubled_areas(1, 0);            // between the border up to each vertex and the first one
  for (std::size_t i = 0; i < n; ++i) {
    projections.push_back(Extents::projections(polygon[i]));
    doubled_areas.push_back(doubled_areas.back() +
                            cross(polygon[i] - polygon[0], polygon[next_in_cycle(i, n)] - polygon[0]));
  }
  // Of the vertices from the first to the second one, over the last one if need be.
  std::vector<double> boxes(n * n);
  for (std::size_t begin = 0; begin < n; ++begin) {
    Extents extents;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t end = (begin + i) % n;
      extents.add(projections[end]);
      boxes[begin * n + end] = extents.area_of_box(side_of_square);
    }
  }

  std::vector<Chord> chords;
  for (std::size_t begin = 0; begin < n; ++begin)
    for (std::size_t end = begin + 2; end < n; ++end) {
      const double area = 0.5 * (doubled_areas[end] - doubled_areas[begin] -
                                 cross(polygon[begin] - polygon[0], polygon[end] - polygon[0]));
      if ((std::min)(area, 0.5 * doubled_areas[n] - area) >= least_area)
        chords.push_back({ begin, end,
                           boxes[begin * n + end] + boxes[end * n + begin] +
                               cost_of_length * std::sqrt((polygon[end] - polygon[begin]).squared_length()) });
    }
  std::stable_sort(chords.begin(), chords.end(), [](const Chord& a, const Chord& b) { return a.cost < b.cost; });
  for (const Chord& chord : chords)
    if (is_chord(polygon, chord.begin, chord.end))
      return chord;
  return { 0, 0, (std::numeric_limits<double>::infinity)() };
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_BEST_CHORD_H
