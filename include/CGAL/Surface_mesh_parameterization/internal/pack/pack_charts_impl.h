// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PACK_CHARTS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PACK_CHARTS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/pack/Bitmap.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/pack_charts.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

inline double area(const Chart& chart)
{
  double sum = 0;
  for (const Index_triangle& t : chart.triangles)
    sum += 0.5 * std::abs(cross(chart.points[t[1]] - chart.points[t[0]], chart.points[t[2]] - chart.points[t[0]]));
  return sum;
}

// Turned by the angle whose cosine and sine are the coordinates of a vector, and moved.
inline void turn(std::vector<Point_2>& points, const Vector_2& direction, const Vector_2& move)
{
  for (Point_2& p : points)
    p = Point_2(direction.x() * p.x() - direction.y() * p.y() + move.x(),
                direction.y() * p.x() + direction.x() * p.y() + move.y());
}

inline Bbox_2 box_of(const std::vector<Point_2>& points)
{
  Bbox_2 box;
  for (const Point_2& p : points)
    box += p.bbox();
  return box;
}

// Lays an edge of the convex hull along an axis, so that the box around the chart is small: so is its area, or its
// longer side if that is greater than `longest`. The box has a corner at the origin then.
inline void straighten(std::vector<Point_2>& points, double longest)
{
  typedef Exact_predicates_inexact_constructions_kernel   Kernel;
  std::vector<Kernel::Point_2> exact_points, exact_hull;
  for (const Point_2& p : points)
    exact_points.emplace_back(p.x(), p.y());
  CGAL::convex_hull_2(exact_points.begin(), exact_points.end(), std::back_inserter(exact_hull));
  std::vector<Point_2> hull;
  for (const Kernel::Point_2& p : exact_hull)
    hull.emplace_back(p.x(), p.y());

  Vector_2 best(1, 0);
  double least_cost = (std::numeric_limits<double>::infinity)();
  const auto rate = [&](const Vector_2& direction) {
    std::vector<Point_2> turned = hull;
    turn(turned, direction, Vector_2(0, 0));
    const Bbox_2 box = box_of(turned);
    const double width = box.xmax() - box.xmin(), height = box.ymax() - box.ymin();
    const double too_long = (std::max)(1., (std::max)(width, height) / longest),
                 cost = width * height * std::pow(too_long, 4);
    if (cost < least_cost) {
      least_cost = cost;
      best = direction;
    }
  };
  constexpr std::size_t most_directions = 512;
  const std::size_t step = hull.size() / most_directions + 1;
  for (std::size_t i = 0; i < hull.size(); i += step) {
    const Vector_2 edge = hull[(i + 1) % hull.size()] - hull[i];
    if (const double edge_length = std::sqrt(edge.squared_length()); edge_length > 0) {
      const Vector_2 direction(edge.x() / edge_length, -edge.y() / edge_length);
      rate(direction);
      // On the diagonal.
      rate(Vector_2(direction.x() - direction.y(), direction.x() + direction.y()) * std::sqrt(0.5));
    }
  }
  turn(points, best, Vector_2(0, 0));
  const Bbox_2 box = box_of(points);
  turn(points, Vector_2(1, 0), Vector_2(-box.xmin(), -box.ymin()));
}

// The cells that the triangles of a chart meet. Its box has a corner at the origin.
inline Bitmap rasterize(const Chart& chart, double cell)
{
  const Bbox_2 box = box_of(chart.points);
  Bitmap result(std::size_t(box.xmax() / cell) + 1, std::size_t(box.ymax() / cell) + 1);
  for (const Index_triangle& triangle : chart.triangles) {
    const std::array<Point_2, 3> t = { chart.points[triangle[0]], chart.points[triangle[1]],
                                       chart.points[triangle[2]] };
    const double sign = cross(t[1] - t[0], t[2] - t[0]) < 0 ? -1 : 1;
    // A cell is outside if all of it is beyond an edge, and not only just.
    const auto is_outside = [&](const Point_2& center) {
      constexpr double tolerance = 1e-9;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector_2 edge = t[(i + 1) % 3] - t[i];
        const double reach = 0.5 * cell * (std::abs(edge.x()) + std::abs(edge.y()));
        if (sign * cross(edge, center - t[i]) < -(1 + tolerance) * reach)
          return true;
      }
      return false;
    };
    const Bbox_2 b = t[0].bbox() + t[1].bbox() + t[2].bbox();
    for (std::size_t y = std::size_t(b.ymin() / cell); y <= std::size_t(b.ymax() / cell); ++y)
      for (std::size_t x = std::size_t(b.xmin() / cell); x <= std::size_t(b.xmax() / cell); ++x)
        if (!is_outside(Point_2((double(x) + 0.5) * cell, (double(y) + 0.5) * cell)))
          result.set(x, y);
  }
  return result;
}

// A chart on the grid, in one of four directions.
struct Chart_mask
{
  Bitmap cells;
  std::vector<std::vector<Bitmap::Run>> runs_with_margin;      // of each row, with those of the margin

  Chart_mask(const Bitmap& bitmap, std::size_t margin) : cells(bitmap)
  {
    const Bitmap grown = bitmap.grown(margin);
    for (std::size_t y = 0; y < grown.height(); ++y)
      runs_with_margin.push_back(grown.runs(y));
  }
};

// A strip of some width that grows upwards, and the cells in it that are taken. There is a margin at its sides.
class Strip
{
public:
  struct Place
  {
    std::size_t x, y, top;
  };

  Strip(std::size_t width, std::size_t margin) : m_cells(width, 0), m_taken(width), m_margin(margin) { }

  std::size_t top() const { return m_top; }

  // The side of the square that holds what is in the strip.
  std::size_t side() const { return (std::max)(m_right, m_top); }

  static constexpr Place nowhere() { return { 0, 0, (std::numeric_limits<std::size_t>::max)() }; }

  // The lowest place for a mask with its margin, at or above a row; `top` is that of the mask. Nowhere if it is too
  // wide, or if that place does not end below `most_top`. Below the row y that the caller gets there is no place.
  Place find(const Chart_mask& mask, std::size_t& y, std::size_t most_top)
  {
    const std::size_t width = mask.cells.width() + 2 * m_margin, height = mask.cells.height() + 2 * m_margin;
    if (width > m_cells.width())
      return nowhere();
    const std::size_t end = m_cells.width() - width + 1;
    for (; y + height < most_top; ++y) {
      m_cells.raise(y + height);
      m_taken.clear();
      std::size_t x = 0;
      for (std::size_t row = 0; row < height && x < end; ++row) {
        for (const Bitmap::Run& run : mask.runs_with_margin[row])
          add_collisions(m_cells.row(y + row), run);
        x = m_taken.first_empty(end);
      }
      if (x < end)
        return { x, y, y + height };
    }
    return nowhere();
  }

  void put(const Chart_mask& mask, const Place& place)
  {
    for (std::size_t y = 0; y < mask.cells.height(); ++y)
      for (const Bitmap::Run& run : mask.cells.runs(y))
        for (std::size_t x = run.first; x < run.second; ++x)
          m_cells.set(place.x + m_margin + x, place.y + m_margin + y);
    m_top = (std::max)(m_top, place.top);
    m_right = (std::max)(m_right, place.x + mask.cells.width() + 2 * m_margin);
  }

private:
  // Adds the places x for which a cell of x + run is taken.
  void add_collisions(const Bit_row& row, const Bitmap::Run& run)
  {
    const std::size_t length = run.second - run.first;
    std::size_t spread_length = 1;       // so many cells from x on are looked at
    for (m_spread = row; 2 * spread_length <= length; spread_length *= 2)
      m_spread.or_shifted(m_spread, spread_length);
    m_taken.or_shifted(m_spread, run.first);
    m_taken.or_shifted(m_spread, run.second - spread_length);
  }

  Bitmap m_cells;
  Bit_row m_taken, m_spread;             // scratch of find()
  std::size_t m_margin, m_right = 0, m_top = 0;
};

// All charts on one grid.
class Grid_packer
{
public:
  struct Result
  {
    std::size_t side = (std::numeric_limits<std::size_t>::max)();
    std::size_t top = 0;                      // the height of the strip
    std::vector<Strip::Place> places;         // of the charts
    std::vector<std::size_t> directions;      // right angles that each is turned by
  };

  Grid_packer(const std::vector<Chart>& charts, double cell, std::size_t margin) : m_margin(margin)
  {
    for (const Chart& chart : charts) {
      std::vector<Chart_mask>& masks = m_masks.emplace_back();
      Bitmap bitmap = rasterize(chart, cell);
      for (int direction = 0; direction < 4; ++direction, bitmap = bitmap.turned())
        masks.emplace_back(bitmap, margin);
    }
    m_order.resize(charts.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    std::stable_sort(m_order.begin(), m_order.end(), [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
  }

  // In the first direction.
  const Bitmap& cells(std::size_t chart) const { return m_masks[chart].front().cells; }

  // How much longer the margin makes the side of the square, about.
  double growth() const
  {
    double boxes = 0, grown_boxes = 0;
    for (const std::size_t chart : m_order) {
      const double width = double(cells(chart).width()), height = double(cells(chart).height());
      boxes += width * height;
      grown_boxes += (width + double(m_margin)) * (height + double(m_margin));
    }
    return std::sqrt(grown_boxes / boxes);
  }

  // The least width that holds every chart.
  std::size_t least_width() const
  {
    std::size_t result = 0;
    for (const std::size_t chart : m_order)
      result = (std::max)(result, (std::min)(cells(chart).width(), cells(chart).height()));
    return result + 2 * m_margin;
  }

  // Packs a strip of some width.
  Result pack(std::size_t width) const
  {
    Result result;
    result.places.resize(m_order.size());
    result.directions.resize(m_order.size());
    Strip strip(width, m_margin);
    std::map<std::pair<int, int>, std::size_t> first_rows;       // where charts of about a size begin to fit
    for (const std::size_t chart : m_order) {
      Strip::Place best = Strip::nowhere();
      std::size_t best_direction = 0;
      for (std::size_t direction = 0; direction < 4; ++direction) {
        const Chart_mask& mask = m_masks[chart][direction];
        std::size_t& first_row = first_rows[{ size_class(mask.cells.width()), size_class(mask.cells.height()) }];
        const Strip::Place place = strip.find(mask, first_row, best.top);
        if (place.top < best.top) {
          best = place;
          best_direction = direction;
        }
      }
      if (best.top == Strip::nowhere().top)
        return Result();
      strip.put(m_masks[chart][best_direction], best);
      result.places[chart] = best;
      result.directions[chart] = best_direction;
    }
    result.side = strip.side();
    result.top = strip.top();
    return result;
  }

private:
  static int size_class(std::size_t length) { return int(4 * std::log2(double(length))); }

  // Large charts come first: long ones are large.
  std::size_t size(std::size_t chart) const
  {
    const std::size_t width = cells(chart).width(), height = cells(chart).height(), longest = (std::max)(width, height);
    return longest * longest + width * height;
  }

  std::vector<std::vector<Chart_mask>> m_masks;       // of each chart, in the four directions
  std::vector<std::size_t> m_order;
  std::size_t m_margin;
};

// Packs strips of several widths, each the mean of width and height of the one before, or a little less; the best is the
// one of the smallest square.
inline Grid_packer::Result pack_best(const Grid_packer& packer, std::size_t width, std::size_t number_of_widths)
{
  Grid_packer::Result best;
  double next_width = double(width);
  for (std::size_t i = 0; i < number_of_widths; ++i) {
    const std::size_t this_width = (std::max)(packer.least_width(), std::size_t(next_width));
    Grid_packer::Result other = packer.pack(this_width);
    next_width = i % 2 == 0 ? std::sqrt(double(this_width) * double(other.top)) : 0.98 * double(this_width);
    if (other.side < best.side)
      best = std::move(other);
  }
  return best;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Packing pack_charts(std::vector<Chart>& charts, const Pack_options& options)
{
  constexpr double guessed_part = 0.8;
  const double total_area = std::accumulate(charts.begin(), charts.end(), 0.,
                                            [](double sum, const Chart& chart) { return sum + area(chart); });
  if (!(total_area > 0))
    return {};
  const double guessed_side = std::sqrt(total_area / guessed_part);
  for (Chart& chart : charts)
    straighten(chart.points, guessed_side);
  const std::size_t cells = std::clamp(std::size_t(double(options.cells_of_chart) * std::sqrt(double(charts.size()))),
                                       options.least_cells, options.most_cells);
  const std::size_t number_of_widths = std::clamp(options.most_placements / charts.size(), std::size_t(1),
                                                  options.most_widths);
  const double cell = guessed_side / double(cells);

  // The margin is a part of a side that only the packing tells. Charts keep half of it from the sides. The side grows
  // with the margin, and without end if the margins of so many charts would fill the square.
  const double margin_part = (std::min)(options.margin, 0.25 / std::sqrt(double(charts.size())));
  for (std::size_t margin = (std::max)(std::size_t(1), std::size_t(margin_part * double(cells)));;) {
    const Grid_packer packer(charts, cell, margin);
    const std::size_t width = std::size_t(packer.growth() * double(cells));
    const Grid_packer::Result result = pack_best(packer, width, number_of_widths);
    const double side = double(result.side - margin);
    if (double(margin) < margin_part * side) {
      margin = std::size_t(std::ceil(margin_part * side));
      continue;
    }
    for (std::size_t i = 0; i < charts.size(); ++i) {
      const double columns = double(packer.cells(i).width()), rows = double(packer.cells(i).height());
      const std::array<Vector_2, 4> directions = { Vector_2(1, 0), Vector_2(0, 1), Vector_2(-1, 0), Vector_2(0, -1) },
                                    origins = { Vector_2(0, 0), Vector_2(rows, 0), Vector_2(columns, rows),
                                                Vector_2(0, columns) };
      const std::size_t direction = result.directions[i];
      const Vector_2 place(double(result.places[i].x) + 0.5 * double(margin),
                           double(result.places[i].y) + 0.5 * double(margin));
      turn(charts[i].points, directions[direction], cell * (origins[direction] + place));
    }
    return { side * cell, total_area / (side * cell * side * cell) };
  }
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PACK_CHARTS_IMPL_H
