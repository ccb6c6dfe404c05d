// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether a star has no flips and turns by less than a full turn.

#include "random_shapes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace test_star_validity {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;

// Whether a fan around vertex 0, at the origin, turns too far, with the given neighbors.
bool fan_turns_too_far(std::vector<Point_2> ring, bool is_closed)
{
  std::vector<Index_triangle> triangles;
  const Index n = Index(ring.size());
  for (Index i = 0; i < (is_closed ? n : n - 1); ++i)
    triangles.push_back({ 0, 1 + i, 1 + (i + 1) % n });
  ring.insert(ring.begin(), Point_2(0, 0));
  const One_rings rings(ring.size(), triangles);
  EXPECT_TRUE(is_star_positive(rings, ring, 0));
  EXPECT_EQ(rings.is_border(0), !is_closed);
  return turns_too_far(rings, Place_of_vertex{ ring }, 0);
}

TEST(Turns_too_far, below_at_and_above_one_turn)
{
  const Point_2 east(1, 0), north(0, 1), west(-1, 0), south(0, -1), far_east(3, 0), near_east(0.5, 0);
  const double tiny = 1e-300;
  EXPECT_FALSE(fan_turns_too_far({ east, north, west, south, Point_2(1, -0.5) }, false));
  EXPECT_FALSE(fan_turns_too_far({ east, north, west, south, Point_2(1, -tiny) }, false));
  EXPECT_TRUE(fan_turns_too_far({ east, north, west, south, east }, false));
  EXPECT_TRUE(fan_turns_too_far({ east, north, west, south, far_east }, false));
  EXPECT_TRUE(fan_turns_too_far({ east, north, west, south, near_east }, false));
  EXPECT_TRUE(fan_turns_too_far({ east, north, west, south, Point_2(1, tiny) }, false));
  EXPECT_TRUE(fan_turns_too_far({ east, north, west, south, Point_2(1, 0.5), north, west }, false));
}

TEST(Turns_too_far, with_collinear_neighbors)
{
  const Point_2 east(1, 0), north(0, 1), west(-1, 0), south(0, -1);
  EXPECT_FALSE(fan_turns_too_far({ east, north }, false));
  EXPECT_FALSE(fan_turns_too_far({ east, north, west }, false));           // half a turn, exactly
  EXPECT_FALSE(fan_turns_too_far({ east, north, Point_2(-2, 0), south }, false));
  EXPECT_FALSE(fan_turns_too_far({ east, Point_2(0.5, 0.1), north, Point_2(-1, 0.1) }, false));
  EXPECT_FALSE(
      fan_turns_too_far({ Point_2(1, 2), Point_2(-3, 1), Point_2(-1, -2), Point_2(0, -1), Point_2(1, 1.5) }, false));
  EXPECT_TRUE(
      fan_turns_too_far({ Point_2(1, 2), Point_2(-3, 1), Point_2(-1, -2), Point_2(0, -1), Point_2(0.5, 1) }, false));
}

TEST(Turns_too_far, around_an_interior_vertex_is_one_turn_and_not_two)
{
  const Point_2 east(1, 0), north(0, 1), west(-1, 0), south(0, -1);
  EXPECT_FALSE(fan_turns_too_far({ east, north, west, south }, true));
  EXPECT_FALSE(fan_turns_too_far({ east, Point_2(-1, 1), Point_2(-1, -1) }, true));
  EXPECT_TRUE(fan_turns_too_far(
      { east, Point_2(-1, 1), Point_2(-1, -1), Point_2(1, 0.1), Point_2(-1, 1.2), Point_2(-1, -1.2) }, true));
  std::vector<Point_2> twice;   // two turns of five steps
  for (int i = 0; i < 5; ++i)
    twice.push_back(polar(1, 0.8 * CGAL_PI * i));
  EXPECT_TRUE(fan_turns_too_far(twice, true));
}

TEST(Star_validity, looks_at_the_border_neighbors_too)
{
  // Around vertex 0 the neighbors 1..5 turn; vertex 5 moves past vertex 1, no triangle flips.
  const std::vector<Index_triangle> triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 5 } };
  const One_rings rings(6, triangles);
  std::vector<Point_2> uv = { Point_2(0, 0),  Point_2(1, 0),  Point_2(0, 1),
                              Point_2(-1, 0), Point_2(0, -1), Point_2(1, -0.25) };
  EXPECT_TRUE(is_star_valid(rings, uv, 5));
  EXPECT_TRUE(is_map_valid(rings, uv));
  uv[5] = Point_2(1, 0.25);
  EXPECT_TRUE(is_star_positive(rings, uv, 5));
  EXPECT_FALSE(is_star_valid(rings, uv, 5));
  EXPECT_FALSE(is_map_valid(rings, uv));
  uv[5] = Point_2(-1, -2);
  EXPECT_FALSE(is_star_positive(rings, uv, 5));
  EXPECT_FALSE(is_map_valid(rings, uv));
}

// ---- rounding ----

double to_integer(double x, int) { return std::round(x); }

// Patches of planar triangles whose edges are a few units long.
TEST(Round_map, keeps_a_map_valid)
{
  int rounding_alone = 0, results = 0;
  for (unsigned int seed = 0; seed < 40; ++seed) {
    const Flat_mesh m = delaunay_patch(60, seed, flat);
    const One_rings rings(m.points.size(), m.triangles);
    std::vector<Point_2> uv, rounded;
    for (const Point_3& p : m.points) {
      uv.emplace_back(40 * p.x(), 40 * p.y());
      rounded.emplace_back(std::round(uv.back().x()), std::round(uv.back().y()));
    }
    if (!is_map_valid(rings, uv))      // a border vertex of the hull may be seen under half a turn
      continue;
    rounding_alone += is_map_valid(rings, rounded);
    if (!round_map(rings, &to_integer, 0, uv))
      continue;
    ++results;
    EXPECT_TRUE(is_map_valid(rings, uv));
    for (const Point_2& p : uv)
      EXPECT_TRUE(p.x() == std::round(p.x()) && p.y() == std::round(p.y()));
    EXPECT_TRUE(uv == rounded || !is_map_valid(rings, rounded));      // nothing moves without need
  }
  EXPECT_GT(results, 2 * rounding_alone);
}

TEST(Round_map, tells_that_there_is_no_room)
{
  const One_rings rings(3, { { 0, 1, 2 } });
  std::vector<Point_2> uv = { Point_2(0.1, 0.1), Point_2(0.4, 0.1), Point_2(0.1, 0.4) };
  EXPECT_FALSE(round_map(rings, &to_integer, 0, uv));
}

} // namespace test_star_validity
