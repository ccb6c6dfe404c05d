// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PACK_CHARTS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PACK_CHARTS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Run_watch.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Grid_packer.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/large_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/turn_chart.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Origin.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// The side of a square that should hold charts of these areas, each grown by the part of its box that it covers when
// the box grows by the margin, a part of that side.
inline double guessed_side(const std::vector<Flat_chart>& charts, const std::vector<double>& areas, double margin)
{
  constexpr double guessed_part = 0.75;
  constexpr int most_repetitions = 10;
  double side = std::sqrt(std::accumulate(areas.begin(), areas.end(), 0.) / guessed_part);
  for (int i = 0; i < most_repetitions; ++i) {
    double sum = 0, greatest_diagonal = 0;
    for (std::size_t j = 0; j < charts.size(); ++j) {
      const Bbox_2 box = box_of(charts[j].points);
      const double area_of_box = width(box) * height(box), growth = margin * side,
                   covered_part = area_of_box > areas[j] ? areas[j] / area_of_box : 1;
      sum += areas[j] + covered_part * growth * (width(box) + height(box) + growth);
      greatest_diagonal = (std::max)(greatest_diagonal, std::hypot(width(box), height(box)));
    }
    side = (std::max)(std::sqrt(sum / guessed_part), std::sqrt(0.5) * greatest_diagonal);
  }
  return side;
}

// The best of several packings, which is the one of the smallest square.
class Packing_search
{
public:
  Packing_search(Grid_packer& packer, Run_watch* watch) : m_packer(packer), m_watch(watch) { }

  const Grid_packer::Result& best() const { return m_best; }

  // Returns the height of the strip.
  std::size_t try_plan(const Grid_packer::Plan& plan)
  {
    Grid_packer::Result result = m_packer.pack(plan);
    const std::size_t top = result.top;
    if (result.side < m_best.side)
      m_best = std::move(result);
    return top;
  }

  // Strips of several widths: each the mean of width and height of the one before, or a little less. Goes on until that
  // many have been tried, or one, if the watch stops it.
  void try_widths(Grid_packer::Plan plan, std::size_t most_widths)
  {
    for (; m_number_of_widths < most_widths && (m_number_of_widths == 0 || goes_on(m_watch)); ++m_number_of_widths) {
      plan.width = (std::max)(m_packer.least_width(), m_next_width > 0 ? std::size_t(m_next_width) : plan.width);
      const std::size_t top = try_plan(plan);
      m_next_width = m_number_of_widths % 2 == 0 ? std::sqrt(double(plan.width) * double(top))
                                                 : 0.98 * double(plan.width);
    }
  }

private:
  Grid_packer& m_packer;
  Run_watch* m_watch;
  Grid_packer::Result m_best;
  double m_next_width = 0;              // 0 for that of the plan
  std::size_t m_number_of_widths = 0;
};

// The large charts as they were found, then the others by size.
inline Grid_packer::Plan make_plan(const Grid_packer& packer, const Large_charts& large, std::size_t width)
{
  Grid_packer::Plan plan{ large.order, width };
  std::vector<bool> is_large(packer.number_of_charts(), false);
  for (const std::size_t i : large.order)
    is_large[i] = true;
  for (const std::size_t i : packer.order_by_size())
    if (!is_large[i])
      plan.order.push_back(i);
  return plan;
}

// The same with the large charts where they were found: on another grid they may fall otherwise, and worse.
inline Grid_packer::Plan with_places(Grid_packer::Plan plan, const Large_charts& large, double cell)
{
  plan.width = std::size_t(std::ceil(large.side / cell));
  for (const Vector_2& place : large.places)
    plan.places.push_back({ std::size_t(place.x() / cell + 0.5), std::size_t(place.y() / cell + 0.5) });
  return plan;
}

struct Grid_packing
{
  double side;          // of the square
  double distance;      // between charts
};

// Packs several charts. The margin is a part of the side.
inline Grid_packing pack_on_grid(std::vector<Flat_chart>& charts, const std::vector<double>& areas, double margin,
                                 const Pack_options& options)
{
  const double root = std::sqrt(double(charts.size()));
  double cells = std::clamp(double(options.cells_of_chart) * root, double(options.least_cells),
                            double(options.most_cells));
  const std::size_t margin_cells = std::size_t((std::max)(1., std::floor(margin * cells))),
                    number_of_widths = std::clamp(options.most_placements / charts.size(), std::size_t(2),
                                                  options.most_widths);
  // A margin that is far below a cell becomes one cell.
  if (double(margin_cells) <= 2 * margin * cells)
    cells = double(margin_cells) / margin;

  double side = guessed_side(charts, areas, margin);
  const Large_charts large = search_large_charts(charts, areas, side, margin, options);
  std::vector<std::vector<Vector_2>> directions(charts.size(), evenly_spaced_directions(4));
  for (std::size_t i = 0; i < large.order.size(); ++i)
    directions[large.order[i]] = { large.directions[i] };

  // The margin is known when the side is: until it is wide enough, cells become larger.
  constexpr std::size_t widths_that_show_the_side = 2;
  for (side = (std::max)(side, large.side);;) {
    const double cell = side / cells;
    Grid_packer packer(charts, directions, cell, margin_cells);
    const Grid_packer::Plan plan =
        make_plan(packer, large, std::size_t(large.width > 0 ? large.width / cell : cells));
    Packing_search search(packer, options.watch);
    if (!large.places.empty())
      search.try_plan(with_places(plan, large, cell));
    search.try_widths(plan, widths_that_show_the_side);
    const Grid_packer::Result& result = search.best();
    if (double(margin_cells) < margin * double(result.side)) {
      side *= 1.002 * margin * double(result.side) / double(margin_cells);
      continue;
    }
    search.try_widths(plan, number_of_widths);
    for (std::size_t i = 0; i < charts.size(); ++i)
      turn_and_move(charts[i].points, directions[i][result.directions[i]],
                    cell * Vector_2(double(result.places[i].x) + 0.5 * double(margin_cells),
                                    double(result.places[i].y) + 0.5 * double(margin_cells)));
    return { double(result.side) * cell, double(margin_cells) * cell };
  }
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Packing pack_charts(std::vector<Flat_chart>& charts, const Pack_options& options)
{
  std::vector<double> areas;
  for (const Flat_chart& chart : charts)
    areas.push_back(area(chart));
  const double total_area = std::accumulate(areas.begin(), areas.end(), 0.);
  if (!(total_area > 0 && std::isfinite(total_area)))
    return {};
  const double margin = (std::min)(options.margin, options.margin_of_chart / std::sqrt(double(charts.size())));
  // Where a chart was far away, its coordinates have few digits; in differences of them nothing is lost.
  for (Flat_chart& chart : charts) {
    const Vector_2 first = chart.points.front() - CGAL::ORIGIN;
    for (Point_2& p : chart.points)
      p = p - first;
  }
  Grid_packing packing;
  if (charts.size() == 1) {
    packing.side = put_in_square(charts[0].points, margin);
    packing.distance = margin * packing.side;
  } else {
    for (Flat_chart& chart : charts)
      straighten(chart.points);
    packing = pack_on_grid(charts, areas, margin, options);
  }
  if (!std::isfinite(packing.side))
    return {};
  return { packing.side, total_area / (packing.side * packing.side), packing.distance };
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PACK_CHARTS_IMPL_H
