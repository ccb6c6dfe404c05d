// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CHART_LAYOUT_H
#define CHART_LAYOUT_H

#include "example_utilities.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

typedef std::vector<Point_2>   Chart_points;

// Lays charts on shelves, the highest ones first.
class Shelves
{
public:
  explicit Shelves(const std::vector<Chart_points>& charts)
    : m_order(charts.size()), m_places(charts.size())
  {
    double area = 0;
    for (const Chart_points& points : charts) {
      m_boxes.push_back(CGAL::bbox_2(points.begin(), points.end()));
      area += width(m_boxes.size() - 1) * height(m_boxes.size() - 1);
    }
    m_gap = 0.01 * std::sqrt(area);
    std::iota(m_order.begin(), m_order.end(), 0);
    std::stable_sort(m_order.begin(), m_order.end(),
                     [&](std::size_t a, std::size_t b) { return height(a) > height(b); });
    choose_width();
  }

  // Into the unit square.
  Point_2 operator()(std::size_t chart, const Point_2& p) const
  {
    return Point_2((m_places[chart].x() + p.x() - m_boxes[chart].xmin()) / m_side,
                   (m_places[chart].y() + p.y() - m_boxes[chart].ymin()) / m_side);
  }

private:
  double width(std::size_t i) const { return m_boxes[i].xmax() - m_boxes[i].xmin(); }
  double height(std::size_t i) const { return m_boxes[i].ymax() - m_boxes[i].ymin(); }

  // That of the shelves for which the square around them is least.
  void choose_width()
  {
    double least = 0, sum = m_gap, best = 0;
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
      least = (std::max)(least, width(i) + 2 * m_gap);
      sum += width(i) + m_gap;
    }
    m_side = (std::numeric_limits<double>::infinity)();
    for (double w = least; w < 1.05 * sum; w *= 1.02)
      if (const double side = (std::max)(w, place(w)); side < m_side) {
        m_side = side;
        best = w;
      }
    place(best);
  }

  // Returns the height of all shelves of this width.
  double place(double shelf_width)
  {
    double x = m_gap, y = m_gap, top = m_gap;
    for (const std::size_t i : m_order) {
      if (x > m_gap && x + width(i) + m_gap > shelf_width) {
        x = m_gap;
        y = top;
      }
      m_places[i] = Point_2(x, y);
      x += width(i) + m_gap;
      top = (std::max)(top, y + height(i) + m_gap);
    }
    return top;
  }

  std::vector<CGAL::Bbox_2> m_boxes;
  std::vector<std::size_t> m_order;
  std::vector<Point_2> m_places;             // of the lower left corners
  double m_gap, m_side;
};

// Moves charts into the unit square, side by side, all scaled alike.
inline void lay_side_by_side(std::vector<Chart_points>& charts)
{
  for (Chart_points& points : charts)
    turn_upright(points);
  const Shelves shelves(charts);
  for (std::size_t i = 0; i < charts.size(); ++i)
    for (Point_2& p : charts[i])
      p = shelves(i, p);
}

#endif // CHART_LAYOUT_H
