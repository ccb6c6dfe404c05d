// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_LARGE_CHARTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_LARGE_CHARTS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Run_watch.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Chart_mask.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Flat_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Grid_packer.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/turn_chart.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// How charts that are a great part of all are packed.
struct Large_charts
{
  std::vector<std::size_t> order;             // their numbers, in which they are put
  std::vector<Vector_2> directions, places;   // of each in that order: how it is turned, and its lower left corner
  double width = 0;                           // of the strip; 0 if there is no large chart
  double side = 0;                            // of the square that holds them
};

// A chart of many triangles as bars on a grid, which cover it. Its box has a corner at the origin.
inline Flat_chart as_bars(const Flat_chart& chart, double cell)
{
  const Bitmap cells = rasterize(chart, cell);
  Flat_chart bars;
  const auto add_bar = [&](std::size_t y, std::size_t begin, std::size_t end) {
    const Index first = Index(bars.points.size());
    for (const std::size_t x : { begin, end })
      for (const std::size_t z : { y, y + 1 })
        bars.points.emplace_back(double(x) * cell, double(z) * cell);
    bars.triangles.push_back({ first, first + 2, first + 1 });
    bars.triangles.push_back({ first + 1, first + 2, first + 3 });
  };
  for (std::size_t y = 0; y < cells.height(); ++y)
    for (std::size_t x = 0; x < cells.width(); ++x)
      if (cells.at(x, y)) {
        const std::size_t begin = x;
        while (x < cells.width() && cells.at(x, y))
          ++x;
        add_bar(y, begin, x);
      }
  return bars;
}

// Orders and widths are changed at random, and kept where they make the square smaller, until that has been in vain for
// long. Charts with corners fit best in few directions, each with rows of its own; round ones are in need of many
// trials rather than that.
inline std::pair<Grid_packer::Plan, Grid_packer::Result> search_plan(Grid_packer& packer, std::size_t width,
                                                                     std::size_t margin, std::size_t number_of_trials,
                                                                     Run_watch* watch)
{
  constexpr Grid_packer::Directions directions[] = { { false, 1 }, { true, 8 }, { true, 4 }, { true, 1 } };
  Grid_packer::Plan best_plan{ packer.order_by_size(), (std::max)(packer.least_width(), width), directions[0] };
  Grid_packer::Result best = packer.pack(best_plan);
  const auto try_plan = [&](Grid_packer::Plan plan) {
    Grid_packer::Result other = packer.pack(plan, best.side - margin + 1);
    const bool is_better = other.side < best.side;
    if (other.side <= best.side) {
      best = std::move(other);
      best_plan = std::move(plan);
    }
    return is_better;
  };
  try_plan({ best_plan.order, best_plan.width, directions[1] });

  const std::size_t most_vain_trials = (std::min)(std::size_t(300), 60 * packer.number_of_charts());
  std::mt19937 random(1);
  for (std::size_t trial = 0, vain_trials = 0;
       trial < number_of_trials && vain_trials < most_vain_trials && goes_on(watch); ++trial) {
    Grid_packer::Plan plan = best_plan;
    plan.directions = directions[trial % std::size(directions)];
    for (std::size_t swaps = 0; swaps <= trial % 2; ++swaps) {
      const std::size_t i = random() % plan.order.size(), j = random() % plan.order.size();
      std::swap(plan.order[i], plan.order[j]);
    }
    plan.width = (std::max)(packer.least_width(), best.side - margin - random() % (best.side / 20 + 1));
    vain_trials = try_plan(std::move(plan)) ? 0 : vain_trials + 1;
  }
  return { std::move(best_plan), std::move(best) };
}

// Searches on a coarse grid; the charts are about to lie in a square of this side. The margin is a part of it.
inline Large_charts search_large_charts(const std::vector<Flat_chart>& charts, const std::vector<double>& areas,
                                        double side, double margin, const Pack_options& options)
{
  if (options.most_trials == 0)
    return {};
  constexpr double least_part = 0.005;                // of the square
  constexpr std::size_t cells = 256, most_placements = 15000, number_of_directions = 32,
                        most_triangles = 5000;        // of a chart that is turned as it is
  const double cell = side / cells;
  const std::size_t margin_cells = (std::max)(std::size_t(1), std::size_t(margin * cells));
  std::vector<std::size_t> numbers;
  std::vector<Flat_chart> large;
  for (std::size_t i = 0; i < charts.size(); ++i)
    if (areas[i] > least_part * side * side) {
      numbers.push_back(i);
      large.push_back(charts[i].triangles.size() > most_triangles ? as_bars(charts[i], 0.25 * cell) : charts[i]);
    }
  if (large.empty())
    return {};

  const std::vector<Vector_2> directions = evenly_spaced_directions(number_of_directions);
  Grid_packer packer(large, std::vector<std::vector<Vector_2>>(large.size(), directions), cell, margin_cells);
  const auto [plan, packed] =
      search_plan(packer, cells, margin_cells, (std::min)(options.most_trials, most_placements / large.size()),
                  options.watch);
  Large_charts result;
  for (const std::size_t i : plan.order) {
    result.order.push_back(numbers[i]);
    result.directions.push_back(directions[packed.directions[i]]);
    result.places.push_back(cell * Vector_2(double(packed.places[i].x), double(packed.places[i].y)));
  }
  result.width = double(plan.width) * cell;
  result.side = double(packed.side) * cell;
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_LARGE_CHARTS_H
