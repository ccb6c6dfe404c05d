// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Where a chart is divided: chords of polygons, and paths along the edges of its map.

#include "mesh_conversions.h"
#include "random_shapes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/read_corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Plane_path.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/best_chord.h>

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/enum.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace test_division_cuts {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;

typedef CGAL::Polygon_2<Kernel>   Polygon;

// The part of a polygon from one vertex to another, over the last one if need be.
Polygon part(const std::vector<Point_2>& polygon, std::size_t begin, std::size_t end)
{
  Polygon result;
  for (std::size_t i = begin;; i = (i + 1) % polygon.size()) {
    result.push_back(polygon[i]);
    if (i == end)
      return result;
  }
}

// GCC takes the traits of Polygon_2::area() for uninitialized.
double area(const Polygon& polygon)
{
  const Kernel kernel{};
  return CGAL::polygon_area_2(polygon.vertices_begin(), polygon.vertices_end(), kernel);
}

double area_of_box(const Polygon& polygon, double side_of_square)
{
  return internal::area_of_box(std::vector<Point_2>(polygon.vertices_begin(), polygon.vertices_end()), side_of_square);
}

// Whether a segment between two vertices lies within a polygon: both parts are simple, and turn the same way.
bool divides(const std::vector<Point_2>& polygon, std::size_t begin, std::size_t end)
{
  for (const Polygon& side : { part(polygon, begin, end), part(polygon, end, begin) })
    if (!side.is_simple() || side.orientation() != CGAL::COUNTERCLOCKWISE)
      return false;
  return true;
}

TEST(Best_chord, has_the_least_cost_of_all_that_lie_in_the_polygon)
{
  Random random(3);
  for (const std::size_t corners : { 5, 12, 40 }) {
    const std::vector<Point_2> polygon = random_star_polygon(corners, Point_2(2, 1), random);
    const double total_area = area(Polygon(polygon.begin(), polygon.end())), least_area = 0.1 * total_area;
    for (const auto& [side, cost_of_length] :
         { std::make_pair(9., 0.), std::make_pair(9., 1.), std::make_pair(1., 0.2) }) {
      double least_cost = (std::numeric_limits<double>::infinity)();
      for (std::size_t begin = 0; begin < corners; ++begin)
        for (std::size_t end = begin + 2; end < corners; ++end)
          if (divides(polygon, begin, end)) {
            const Polygon one = part(polygon, begin, end), other = part(polygon, end, begin);
            if ((std::min)(area(one), area(other)) >= least_area)
              least_cost = (std::min)(least_cost, area_of_box(one, side) + area_of_box(other, side) +
                                                      cost_of_length * length(polygon[end] - polygon[begin]));
          }
      const internal::Chord chord = internal::best_chord(polygon, side, least_area, cost_of_length);
      EXPECT_NEAR(chord.cost, least_cost, 1e-5 * least_cost) << corners;
      EXPECT_TRUE(divides(polygon, chord.begin, chord.end));
    }
  }
}

TEST(Best_chord, makes_two_boxes_of_a_corner)
{
  const std::vector<Point_2> polygon = { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 }, { 0, 1 } };
  EXPECT_NEAR(internal::area_of_box(polygon, 9), 6, 1e-5);
  EXPECT_NEAR(internal::area_of_box(polygon, 2), 9, 1e-5);
  const internal::Chord chord = internal::best_chord(polygon, 9, 0.5, 0.25);
  EXPECT_EQ(chord.begin, 3u);
  EXPECT_EQ(chord.end, 6u);
  EXPECT_NEAR(chord.cost, 4 + 0.25, 1e-5);
}

// A strip that is longer than the square is cut, though it fills its box.
TEST(Best_chord, shortens_strips)
{
  const std::vector<Point_2> strip = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 4, 0 }, { 4, 1 }, { 3, 1 }, { 2, 1 },
                                       { 1, 1 }, { 0, 1 } };
  EXPECT_NEAR(internal::area_of_box(strip, 5), 4, 1e-5);
  EXPECT_NEAR(internal::area_of_box(strip, 2), 12.5, 1e-5);        // of the diagonal
  const internal::Chord chord = internal::best_chord(strip, 2, 0.5, 1);
  EXPECT_EQ(strip[chord.begin].x(), 2);
  EXPECT_EQ(strip[chord.end].x(), 2);
  EXPECT_NEAR(chord.cost, 4 + 1, 1e-5);
}

// There is none that leaves so much on both sides.
TEST(Best_chord, may_not_exist)
{
  const std::vector<Point_2> square = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  EXPECT_TRUE(std::isfinite(internal::best_chord(square, 9, 0.49, 0).cost));
  EXPECT_FALSE(std::isfinite(internal::best_chord(square, 9, 0.51, 0).cost));
  EXPECT_FALSE(std::isfinite(internal::best_chord({ square[0], square[1], square[2] }, 9, 0, 0).cost));
}

// A mesh in the plane, which is its own map.
struct Flat_corners
{
  internal::Corner_mesh mesh;
  std::vector<Point_2> uv;

  explicit Flat_corners(const Flat_mesh& m)
  {
    const auto surface = make<Surface_mesh>(m);
    const CGAL::Constant_property_map<Surface_mesh::Edge_index, bool> no_seam(false);
    EXPECT_EQ(internal::read_corner_mesh(surface, no_seam, mesh).code, OK);
    for (const Point_3& p : mesh.points)
      uv.emplace_back(p.x(), p.y());
  }

  std::vector<Index> path(const Point_2& from, const Point_2& to) const
  {
    return internal::Plane_path(mesh, uv, vertex_at(from), vertex_at(to)).halfedges();
  }
  Index vertex_at(const Point_2& p) const { return Index(std::find(uv.begin(), uv.end(), p) - uv.begin()); }
  double length_of(Index h) const { return length(uv[mesh.source(h)] - uv[mesh.target(h)]); }
};

// Over a square whose edges and diagonals lie along three directions, the shortest path is as long as in the plane.
TEST(Plane_path, is_shortest_and_avoids_the_border)
{
  constexpr Index n = 8;
  const Flat_corners corners(grid(n, n, flat));
  const internal::Outer_border border = internal::outer_border(corners.mesh, corners.uv);
  ASSERT_EQ(border.halfedges.size(), std::size_t(4 * n));
  EXPECT_NEAR(border.area, 1, 1e-12);
  const auto expect_path = [&](const Point_2& from, const Point_2& to, double expected_length) {
    double sum = 0;
    Index v = corners.vertex_at(to);
    for (const Index h : corners.path(from, to)) {
      const Index source = corners.mesh.source(h), target = corners.mesh.target(h);
      sum += corners.length_of(h);
      EXPECT_TRUE(source == v || target == v);
      EXPECT_FALSE(corners.mesh.is_border(h));
      v = source == v ? target : source;
    }
    EXPECT_EQ(v, corners.vertex_at(from));
    EXPECT_NEAR(sum, expected_length, 1e-12);
  };
  expect_path(Point_2(0.25, 0), Point_2(0.25, 1), 1);
  expect_path(Point_2(1, 0.5), Point_2(0, 0.5), 1);
}

TEST(Plane_path, takes_what_is_cut_already_for_nothing)
{
  constexpr double width = 0.125;
  Flat_corners corners(frame(8, width));
  double length_of_cut = 0;
  for (const Index h : corners.path(Point_2(0, 0.5), Point_2(1, 0.5))) {
    if (!corners.mesh.is_border(h))
      length_of_cut += corners.length_of(h);
    corners.mesh.sever(h);
  }
  EXPECT_NEAR(length_of_cut, 2 * width, 1e-12);
  EXPECT_EQ(internal::connected_components(corners.mesh).size(), 2u);
}

} // namespace test_division_cuts
