// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The place of a vertex that comes back into a map.

#include "exact_kernel.h"
#include "random_shapes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Vertex_inserter.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_vertex_inserter {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;

// ---- inside ----

std::vector<Rest_corner> random_rest_shapes(std::size_t n, Random& random)
{
  std::vector<Rest_corner> corners;
  for (std::size_t i = 0; i < n; ++i)
    corners.push_back(rest_corner(random_point_3(random), random_point_3(random), random_point_3(random)));
  return corners;
}

std::array<double, 3> random_coordinates(Random& random)
{
  const double sigma = random(0, 1), tau = random(0, 1 - sigma);
  return { 1 - sigma - tau, sigma, tau };
}

// Inserts an interior vertex into the star polygon with the corner W0 at `center`, an angle of `turn` there, and `fan`
// coarse triangles. Counts the insertions, which need a coarse map that is valid.
testing::AssertionResult insert_interior_vertex(Index fan, double turn, double least_radius, const Point_2& center,
                                                Random& random, std::size_t& insertions)
{
  // V is vertex 0, W0 vertex 1, Wi vertex i + 1.
  std::vector<Point_2> uv = { center, center };
  const std::vector<double> angles = random_angles(fan + 1, turn * (fan + 1) / fan, CGAL_PI, random);
  for (const double angle : angles)
    uv.push_back(center +
                 (polar(std::exp(random(std::log(least_radius), 0)), angle * turn / angles.back()) - CGAL::ORIGIN));
  for (Index i = 2; i + 1 < uv.size(); ++i)
    if (!turns_left(uv[1], uv[i], uv[i + 1]))
      return testing::AssertionSuccess() << "no coarse map";
  ++insertions;
  const Index ring_size = fan + 2;
  std::vector<Index_triangle> triangles;
  for (Index i = 0; i < ring_size; ++i)
    triangles.push_back({ 0, 1 + i, 1 + (i + 1) % ring_size });
  const One_rings rings(uv.size(), triangles);

  std::vector<bool> is_placed(uv.size(), true);
  is_placed[0] = false;
  Vertex_inserter inserter(rings, uv, is_placed);
  const Index i = 2 + Index(random.below(fan));
  if (!inserter.insert(0, random_rest_shapes(ring_size, random).data(), { 1, i, i + 1 }, random_coordinates(random)))
    return testing::AssertionFailure() << "no place: turn " << turn << ", fan " << fan << ", least radius "
                                       << least_radius;
  if (!is_star_positive(rings, uv, 0))
    return testing::AssertionFailure() << "a flip: turn " << turn << ", fan " << fan;
  return testing::AssertionSuccess();
}

TEST(Vertex_inserter, finds_a_place_in_every_star_polygon_with_a_positive_fan)
{
  Random random(20);
  std::size_t insertions = 0;
  for (int k = 0; k < 2000; ++k)
    EXPECT_TRUE(insert_interior_vertex(1 + k % 9, random(0.2, (std::min)(1.9, 0.9 * (1 + k % 9)) * CGAL_PI), 0.3,
                                       random_point_2(random), random, insertions));
  EXPECT_GT(insertions, 1000u);
}

TEST(Vertex_inserter, finds_a_place_beside_a_reflex_corner_and_in_thin_kernels)
{
  Random random(21);
  std::size_t insertions = 0;
  for (int k = 0; k < 1000; ++k) {
    const Index fan = 3 + k % 7;
    const auto insert = [&](double turn, double least_radius) {
      return insert_interior_vertex(fan, turn, least_radius, random_point_2(random), random, insertions);
    };
    EXPECT_TRUE(insert((2 - std::pow(10, random(-4, 0))) * CGAL_PI, 0.3));
    EXPECT_TRUE(insert(std::pow(10, random(-4, 0)), 0.3));
    EXPECT_TRUE(insert(random(0.5, 1.9) * CGAL_PI, 1e-4));
  }
  EXPECT_GT(insertions, 1500u);
}

TEST(Vertex_inserter, takes_the_stored_place_if_it_is_best)
{
  // A regular hexagon in space and in the plane.
  std::vector<Point_2> uv(1, Point_2(0, 0));
  std::vector<Index_triangle> triangles;
  for (Index i = 0; i < 6; ++i) {
    uv.push_back(Point_2(5, 5) + (polar(1, CGAL_PI / 3 * i) - CGAL::ORIGIN));
    triangles.push_back({ 0, 1 + i, 1 + (i + 1) % 6 });
  }
  const One_rings rings(7, triangles);
  const std::vector<Rest_corner> corners(6, rest_corner(Point_3(0, 0, 0), Point_3(1, 0, 0),
                                                        Point_3(0.5, std::sqrt(0.75), 0)));
  std::vector<bool> is_placed(7, true);
  Vertex_inserter inserter(rings, uv, is_placed);
  ASSERT_TRUE(inserter.insert(0, corners.data(), { 1, 3, 4 }, { 0.5, 0, 0.5 }));    // the middle of opposite corners
  EXPECT_NEAR(uv[0].x(), 5, 1e-14);
  EXPECT_NEAR(uv[0].y(), 5, 1e-14);
}

// ---- on the border ----

// A border vertex C, number 0, whose coarse fan turns by `turn`, with the neighbors 1, .., n + 1. Its last edge, from n
// + 1 to 0, and its first one, from 0 to 1, lie on the border.
struct Coarse_border_fan
{
  std::vector<Point_2> uv;
  std::vector<Index_triangle> triangles;

  Coarse_border_fan(Index n, double turn, Random& random) : uv(1, Point_2(0, 0))
  {
    const std::vector<double> angles = random_angles(n + 1, turn * (n + 1) / n, CGAL_PI, random);
    for (const double angle : angles)
      uv.push_back(polar(random(0.5, 1), angle * turn / angles.back()));
    for (Index i = 0; i < n; ++i)
      triangles.push_back({ 0, 1 + i, 2 + i });
  }

  bool is_valid() const { return is_map_valid(One_rings(uv.size(), triangles), uv); }
};

// Inserts ears on the border edges of C one after the other: `onto_center` says whether they had collapsed onto C.
testing::AssertionResult insert_ears(Index n, double turn, bool onto_center, bool is_second_too, Random& random,
                                     std::size_t& insertions)
{
  Coarse_border_fan fan(n, turn, random);
  auto& [uv, triangles] = fan;
  if (!fan.is_valid())
    return testing::AssertionSuccess() << "no coarse map";
  ++insertions;

  const Index first_ear = n + 2;
  triangles.push_back({ first_ear, 1, 0 });
  uv.push_back(uv[onto_center ? 0 : 1]);
  if (is_second_too) {
    triangles.push_back({ first_ear + 1, 0, n + 1 });
    uv.push_back(uv[onto_center ? 0 : n + 1]);
  }
  const One_rings rings(uv.size(), triangles);
  std::vector<bool> is_placed(uv.size(), true);
  std::fill(is_placed.begin() + first_ear, is_placed.end(), false);
  Vertex_inserter inserter(rings, uv, is_placed);
  for (Index v = first_ear; v < uv.size(); ++v) {
    const Index end = v == first_ear ? 1 : n + 1, kept = onto_center ? 0 : end, other = onto_center ? end : 0;
    if (!inserter.insert(v, random_rest_shapes(1, random).data(), { kept, other, other }, { 0.5, 0.25, 0.25 }))
      return testing::AssertionFailure() << "no place for ear " << v - first_ear << ": turn " << turn
                                         << ", onto center " << onto_center;
    is_placed[v] = true;
  }
  return is_map_valid(rings, uv) ? testing::AssertionSuccess()
                                 : testing::AssertionFailure() << "an invalid map: turn " << turn;
}

TEST(Vertex_inserter, inserts_ears_beside_border_vertices_of_any_turn)
{
  Random random(22);
  std::size_t insertions = 0;
  for (int k = 0; k < 300; ++k)
    for (const bool is_second_too : { false, true }) {
      EXPECT_TRUE(insert_ears(3 + k % 5, random(0.5, 1.9) * CGAL_PI, k % 2 == 0, is_second_too, random, insertions));
      EXPECT_TRUE(insert_ears(3 + k % 5, (2 - std::pow(10, random(-6, 0))) * CGAL_PI, k % 2 == 0, is_second_too, random,
                              insertions));
    }
  EXPECT_GT(insertions, 600u);
}

// Inserts a border vertex V between the last neighbor of C and C; it takes the last `taken` triangles from C. V had
// collapsed onto C or, if it takes one triangle only, onto the other end.
testing::AssertionResult insert_border_vertex(Index n, double turn, Index taken, bool onto_center, Random& random,
                                              std::size_t& insertions)
{
  Coarse_border_fan fan(n, turn, random);
  auto& [uv, triangles] = fan;
  if (!fan.is_valid())
    return testing::AssertionSuccess() << "no coarse map";
  ++insertions;

  const Index v = n + 2, last = n + 1, first = last - taken;
  for (Index i = 1; i <= taken; ++i)
    triangles[n - i][0] = v;
  triangles.push_back({ v, 0, first });
  uv.push_back(uv[onto_center ? 0 : last]);
  const One_rings rings(uv.size(), triangles);
  std::vector<bool> is_placed(uv.size(), true);
  is_placed[v] = false;
  Vertex_inserter inserter(rings, uv, is_placed);
  const double fraction = random(0, 1);
  const Index_triangle parent = onto_center ? Index_triangle{ 0, last - 1, last } : Index_triangle{ last, 0, last - 1 };
  const std::array<double, 3> coordinates = onto_center ? std::array<double, 3>{ 1 - fraction, 0, fraction }
                                                        : std::array<double, 3>{ 1 - fraction, fraction, 0 };
  if (!inserter.insert(v, random_rest_shapes(taken + 1, random).data(), parent, coordinates))
    return testing::AssertionFailure() << "no place: turn " << turn << ", onto center " << onto_center;
  return is_map_valid(rings, uv) ? testing::AssertionSuccess()
                                 : testing::AssertionFailure() << "an invalid map: turn " << turn;
}

TEST(Vertex_inserter, inserts_border_vertices_beside_border_vertices_of_any_turn)
{
  Random random(23);
  std::size_t insertions = 0;
  for (int k = 0; k < 500; ++k)
    for (const double turn : { random(0.5, 1.9), 2 - std::pow(10, random(-6, 0)) }) {
      const Index n = 3 + k % 5;
      EXPECT_TRUE(insert_border_vertex(n, turn * CGAL_PI, 1 + Index(random.below(n - 1)), true, random, insertions));
      EXPECT_TRUE(insert_border_vertex(n, turn * CGAL_PI, 1, false, random, insertions));
    }
  EXPECT_GT(insertions, 1000u);
}

} // namespace test_vertex_inserter
