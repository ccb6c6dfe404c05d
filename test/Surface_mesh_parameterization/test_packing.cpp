// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The packing of charts that are polygons: hundreds and thousands of them.

#include "random_shapes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Bitmap.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Chart_mask.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Grid_packer.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Strip.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/turn_chart.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace test_packing {

using namespace test_meshes;
using namespace CGAL::Surface_mesh_parameterization::internal;

typedef CGAL::Simple_cartesian<double>::Segment_2   Segment_2;

// A fan of triangles around the first point.
Flat_chart fan(const Point_2& center, const std::vector<Point_2>& polygon, double scale)
{
  Flat_chart chart;
  chart.points.push_back(center);
  for (const Point_2& p : polygon)
    chart.points.push_back(center + scale * (p - center));
  for (Index i = 0; i < polygon.size(); ++i)
    chart.triangles.push_back({ 0, 1 + i, Index(1 + (i + 1) % polygon.size()) });
  return chart;
}

Flat_chart regular_polygon(Index corners, double radius)
{
  std::vector<Point_2> polygon;
  for (Index i = 0; i < corners; ++i)
    polygon.push_back(polar(1, 2 * CGAL_PI * i / corners));
  return fan(Point_2(0, 0), polygon, radius);
}

// Polygons of three to twenty corners, whose sizes differ more with `spread`.
std::vector<Flat_chart> polygons(std::size_t number, double spread)
{
  Random random(7);
  std::vector<Flat_chart> charts;
  for (std::size_t i = 0; i < number; ++i)
    charts.push_back(regular_polygon(Index(3 + random.below(18)), std::exp(random(-spread, spread))));
  return charts;
}

// Stars, some of them a hundred times as long as others.
std::vector<Flat_chart> few_large_stars_and_many_small_ones(std::size_t number)
{
  Random random(7);
  std::vector<Flat_chart> charts;
  for (std::size_t i = 0; i < number; ++i)
    charts.push_back(fan(Point_2(3, 4), random_star_polygon(12, Point_2(3, 4), random), i < 5 ? 100 : random(0.5, 4)));
  return charts;
}

std::vector<Triangle_2> triangles_of(const std::vector<Flat_chart>& charts)
{
  std::vector<Triangle_2> triangles;
  for (const Flat_chart& chart : charts)
    for (const Index_triangle& t : chart.triangles)
      triangles.push_back({ chart.points[t[0]], chart.points[t[1]], chart.points[t[2]] });
  return triangles;
}

// The least distance between points of two charts and outlines of the others, as far as it is less than `reach`.
double least_distance(const std::vector<Flat_chart>& charts, double reach)
{
  std::vector<CGAL::Bbox_2> boxes;
  for (const Flat_chart& chart : charts) {
    boxes.emplace_back();
    for (const Point_2& p : chart.points)
      boxes.back() += p.bbox();
  }
  const auto box_around = [&](const CGAL::Bbox_2& box) {
    return CGAL::Bbox_2(box.xmin() - reach, box.ymin() - reach, box.xmax() + reach, box.ymax() + reach);
  };
  double least = reach * reach;
  for (std::size_t i = 0; i < charts.size(); ++i)
    for (std::size_t j = 0; j < charts.size(); ++j)
      if (i != j && CGAL::do_overlap(box_around(boxes[i]), boxes[j]))
        for (const Point_2& p : charts[i].points)
          for (const Index_triangle& t : charts[j].triangles)
            least = (std::min)(least, CGAL::squared_distance(p, Segment_2(charts[j].points[t[1]],
                                                                         charts[j].points[t[2]])));
  return std::sqrt(least);
}

// The charts lie in the square, no two of their triangles overlap, by exact predicates, and the margin is kept.
void expect_packed(const std::vector<Flat_chart>& charts, const Packing& packing, double margin)
{
  for (const Flat_chart& chart : charts)
    for (const Point_2& p : chart.points)
      EXPECT_TRUE(p.x() > 0 && p.x() < packing.side && p.y() > 0 && p.y() < packing.side) << p;
  EXPECT_EQ(number_of_overlapping_pairs(triangles_of(charts)), 0u);
  EXPECT_GE(least_distance(charts, 2 * margin * packing.side), margin * packing.side);
}

double total_area(const std::vector<Flat_chart>& charts)
{
  double sum = 0;
  for (const Triangle_2& t : triangles_of(charts))
    sum += 0.5 * cross(t[1] - t[0], t[2] - t[0]);
  return sum;
}

TEST(Pack_charts, keeps_the_margin_and_fills_the_square)
{
  for (const std::vector<Flat_chart>& original :
       { polygons(100, 0.5), polygons(1000, 0.), polygons(1000, 2.), polygons(3000, 0.5),
         few_large_stars_and_many_small_ones(2000) }) {
    SCOPED_TRACE(original.size());
    std::vector<Flat_chart> charts = original;
    const Packing packing = pack_charts(charts, Pack_options());
    expect_packed(charts, packing, (std::min)(1. / 256, 1 / (32 * std::sqrt(double(charts.size())))));
    EXPECT_NEAR(total_area(charts), total_area(original), 1e-9 * total_area(original));
    EXPECT_NEAR(packing.used_part, total_area(original) / (packing.side * packing.side), 1e-9);
    EXPECT_GE(packing.used_part, 0.65);
  }
}

// Right-angled triangles fit beside each other by halves of squares, in whatever direction there is room.
TEST(Grid_packer, turns_charts_into_all_directions)
{
  Random random(3);
  std::vector<Flat_chart> charts;
  for (int i = 0; i < 200; ++i) {
    const double size = random(1, 3);
    charts.push_back({ { Point_2(0, 0), Point_2(size, 0), Point_2(0, size) }, { { 0, 1, 2 } } });
  }
  const std::vector<Vector_2> four = evenly_spaced_directions(4);
  Grid_packer packer(charts, std::vector<std::vector<Vector_2>>(charts.size(), four), 0.05, 1);
  const std::vector<std::size_t> directions = packer.pack({ packer.order_by_size(), 500 }).directions;
  for (std::size_t d = 0; d < four.size(); ++d)
    EXPECT_GE(std::count(directions.begin(), directions.end(), d), 10) << d;
}

TEST(Grid_packer, puts_charts_at_given_places_where_they_are_free)
{
  Random random(5);
  std::vector<Flat_chart> charts;
  for (int i = 0; i < 20; ++i)
    charts.push_back(fan(Point_2(1, 1), random_star_polygon(9, Point_2(1, 1), random), random(0.3, 1)));
  const std::vector<Vector_2> one = evenly_spaced_directions(1);
  Grid_packer packer(charts, std::vector<std::vector<Vector_2>>(charts.size(), one), 0.05, 1);
  Grid_packer::Plan plan{ packer.order_by_size(), 150 };
  const Grid_packer::Result packed = packer.pack(plan);
  const auto expect_same = [&](const Grid_packer::Result& other) {
    EXPECT_EQ(other.side, packed.side);
    for (std::size_t i = 0; i < charts.size(); ++i)
      EXPECT_TRUE(other.places[i].x == packed.places[i].x && other.places[i].y == packed.places[i].y) << i;
  };
  Grid_packer::Plan backwards = plan;
  std::reverse(backwards.order.begin(), backwards.order.end());
  for (const std::size_t chart : backwards.order)
    backwards.places.push_back(packed.places[chart]);
  expect_same(packer.pack(backwards));

  plan.places.assign(charts.size(), packed.places[plan.order[0]]);
  expect_same(packer.pack(plan));
}

TEST(Pack_charts, keeps_wide_margins)
{
  for (const std::size_t number : { 1, 2, 3, 10, 100 }) {
    SCOPED_TRACE(number);
    std::vector<Flat_chart> charts = polygons(number, 1);
    Pack_options options;
    options.margin = 0.025;
    options.margin_of_chart = 0.25;
    const Packing packing = pack_charts(charts, options);
    expect_packed(charts, packing, options.margin);
  }
}

TEST(Pack_charts, gives_the_same_bytes_again)
{
  std::vector<Flat_chart> charts = few_large_stars_and_many_small_ones(50), again = charts;
  pack_charts(charts, Pack_options());
  pack_charts(again, Pack_options());
  EXPECT_EQ(triangles_of(charts), triangles_of(again));
}

// No square around a triangle of equal sides is smaller than that of side cos(15 degrees), nor one around a square than
// the square; and a strip lies on the diagonal.
TEST(Pack_charts, puts_a_chart_into_the_least_square)
{
  Pack_options options;
  options.margin = 0;
  std::vector<Flat_chart> triangle(1, regular_polygon(3, std::sqrt(1. / 3))),
      square(1, regular_polygon(4, std::sqrt(0.5)));
  EXPECT_NEAR(pack_charts(triangle, options).side, std::cos(CGAL_PI / 12), 1e-5);
  EXPECT_NEAR(pack_charts(square, options).side, 1, 1e-5);
  Flat_chart strip;
  strip.points = { Point_2(0, 0), Point_2(10, 0), Point_2(10, 0.1), Point_2(0, 0.1) };
  strip.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  std::vector<Flat_chart> strips(1, strip);
  EXPECT_NEAR(pack_charts(strips, options).side, 10.1 * std::sqrt(0.5), 1e-4);
}

// A strip that is far longer than the square that its area would fill takes no more memory than others.
TEST(Pack_charts, packs_very_long_charts)
{
  std::vector<Flat_chart> charts = polygons(10, 1);
  Flat_chart strip;
  strip.points = { Point_2(0, 0), Point_2(1e6, 0), Point_2(1e6, 1e-3), Point_2(0, 1e-3) };
  strip.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  charts.push_back(strip);
  const Packing packing = pack_charts(charts, Pack_options());
  expect_packed(charts, packing, 1. / 256);
}

bool is_taken(const Chart_mask& mask, Index x, Index y)
{
  return std::any_of(mask.squares.begin(), mask.squares.end(), [&](const Chart_mask::Square& s) {
    const Index side = Index(1) << s.level;
    return s.x <= x && x < s.x + side && s.y <= y && y < s.y + side;
  });
}

// A mask has every cell that a point of a triangle lies in, and no cell that no triangle is near.
TEST(Chart_mask, has_the_cells_of_the_triangles)
{
  Random random(3);
  const double cell = 0.01;
  for (int repetition = 0; repetition < 5; ++repetition) {
    Flat_chart chart = fan(Point_2(2, 2), random_star_polygon(9, Point_2(2, 2), random), 0.6);
    const Chart_mask mask = make_mask(rasterize(chart, cell));
    const std::vector<Triangle_2> triangles = triangles_of({ chart });
    for (Index i = 0; i < 2000; ++i) {
      const Triangle_2& t = triangles[i % triangles.size()];
      const double a = random(0, 1), b = random(0, 1 - a);
      const Point_2 p = t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0]);
      EXPECT_TRUE(is_taken(mask, Index(p.x() / cell), Index(p.y() / cell)));
    }
    double area = 0;
    for (Index y = 0; y < mask.height; ++y)
      for (Index x = 0; x < mask.width; ++x)
        area += is_taken(mask, x, y) ? cell * cell : 0;
    double perimeter = 0;
    for (const Triangle_2& t : triangles)
      perimeter += length(t[2] - t[1]);
    EXPECT_LE(area, total_area({ chart }) + 1.5 * cell * perimeter + 10 * cell * cell);
  }
}

// Cell by cell, on strips of several words, which begin anew where the one before has ended.
TEST(Strip, finds_the_lowest_place_and_there_the_leftmost)
{
  constexpr Index height = 900, margin = 2;
  Random random(4);
  std::vector<Chart_mask> masks;
  unsigned int levels = 0;
  for (int i = 0; i < 25; ++i) {
    const Point_2 center(1.1, 1.1);
    masks.push_back(make_mask(rasterize(fan(center, random_star_polygon(9, center, random), random(0.3, 1)), 0.03)));
    levels = (std::max)(levels, masks.back().number_of_levels());
  }
  Strip strip(margin);
  for (const Index width : { 230, 150, 300 }) {
    strip.start(width, levels);
    std::vector<std::vector<bool>> is_full(height, std::vector<bool>(width, false));
    for (const Chart_mask& mask : masks) {
      std::vector<std::pair<Index, Index>> cells;
      for (Index j = 0; j < mask.height; ++j)
        for (Index i = 0; i < mask.width; ++i)
          if (is_taken(mask, i, j))
            cells.emplace_back(i, j);
      Index x = 0, y = 0;
      const auto is_empty = [&](const auto& cell) { return !is_full[y + cell.second][x + cell.first]; };
      while (!std::all_of(cells.begin(), cells.end(), is_empty))
        if (++x + mask.width > width) {
          x = 0;
          ++y;
        }
      std::size_t first_row = 0;
      const Strip::Place place = strip.find(mask, first_row, height);
      ASSERT_EQ(place.x, x);
      ASSERT_EQ(place.y, y);
      strip.put(mask, place, levels);
      for (const auto& [i, j] : cells) {
        const Index left = x + i - (std::min)(x + i, margin), right = (std::min)(x + i + margin, width - 1),
                    bottom = y + j - (std::min)(y + j, margin), top = y + j + margin;
        for (Index row = bottom; row <= top; ++row)
          for (Index column = left; column <= right; ++column)
            is_full[row][column] = true;
      }
    }
  }
}

} // namespace test_packing
