// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The shortest cuts that divide a chart which lies over itself.

#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/covered_triangles.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/read_corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Chart_part.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Minimum_cut.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/overlap_cut.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <tuple>
#include <vector>

namespace test_overlap_cuts {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using internal::Chart_part;

// A cut costs as much as the cheapest of all subsets that have the held vertices on their sides.
TEST(Minimum_cut, is_the_cheapest_of_all)
{
  std::mt19937 random(1);
  constexpr std::size_t n = 9;
  for (int trial = 0; trial < 200; ++trial) {
    internal::Minimum_cut cut(n);
    std::vector<std::tuple<std::size_t, std::size_t, std::int64_t>> edges;
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = a + 1; b < n; ++b)
        if (random() % 2 == 0)
          edges.emplace_back(a, b, 1 + random() % 20);
    for (const auto& [a, b, cost] : edges)
      cut.add_edge(a, b, cost);
    for (const std::size_t v : { 0, 1 })
      cut.hold(v, true);
    for (const std::size_t v : { 2, 3 })
      cut.hold(v, false);
    const auto cost_of = [&](const std::vector<bool>& sides) {
      std::int64_t sum = 0;
      for (const auto& [a, b, cost] : edges)
        sum += sides[a] == sides[b] ? 0 : cost;
      return sum;
    };
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (unsigned int subset = 0; subset < 1u << (n - 4); ++subset) {
      std::vector<bool> sides = { true, true, false, false };
      for (std::size_t i = 0; i < n - 4; ++i)
        sides.push_back(subset >> i & 1);
      least = std::min(least, cost_of(sides));
    }
    const std::vector<bool> sides = cut.sides();
    EXPECT_TRUE(sides[0] && sides[1] && !sides[2] && !sides[3]);
    EXPECT_EQ(cost_of(sides), least);
  }
}

// A whole mesh, without a map.
Chart_part chart_part_of(const Flat_mesh& m)
{
  const Surface_mesh mesh = make<Surface_mesh>(m);
  const CGAL::Constant_property_map<Surface_mesh::Edge_index, bool> no_seam(false);
  Chart_part part{ std::vector<Index>(mesh.number_of_faces()), {}, {} };
  EXPECT_EQ(internal::read_corner_mesh(mesh, no_seam, part.mesh).code, OK);
  std::iota(part.faces.begin(), part.faces.end(), Index(0));
  return part;
}

// A strip of length `columns` and width 3 in space, times `neck` in its middle, laid `turns` times around a point.
Chart_part wound_strip(Index columns, double turns, double neck = 1)
{
  constexpr Index rows = 3;
  Flat_mesh m = grid(columns, rows, flat);
  for (Point_3& p : m.points)
    p = Point_3(columns * p.x(), columns * p.y(), 0);
  Chart_part part = chart_part_of(m);
  for (Point_3& p : part.mesh.points) {
    const double radius = 5 + p.y(), phi = -2 * CGAL_PI * turns * p.x() / columns;
    part.uv.emplace_back(radius * std::cos(phi), radius * std::sin(phi));
    p = Point_3(p.x(), (neck + (1 - neck) * std::abs(2 * p.x() / columns - 1)) * p.y(), 0);
  }
  return part;
}

double covered_part(const Chart_part& part) { return internal::covered_part(triangles_of(part.mesh), part.uv); }

TEST(Overlap_cut, covered_triangles_are_those_under_others)
{
  for (const double turns : { 0.5, 0.99, 1.25, 1.5, 1.75, 2.5, 3. }) {
    const double once = std::max(0., 2 - turns) / turns;      // the part of a strip of 1 to 2 turns that is not covered
    const double expected = turns < 1 ? 0 : 1 - once;
    EXPECT_NEAR(covered_part(wound_strip(240, turns)), expected, 0.02) << turns;
  }
}

// Of a strip that is wound 1.5 times, half a turn is under no other part: the shortest cut is there, straight across
// its neck.
TEST(Overlap_cut, is_as_short_as_can_be)
{
  const Chart_part part = wound_strip(120, 1.5, 0.5);
  const std::vector<Index> cut = internal::overlap_cut(part.mesh, part.uv, 0.2);
  EXPECT_EQ(cut.size(), 3u);
  EXPECT_NEAR(length(part.mesh, cut), 1.5, 1e-12);
  const std::vector<Chart_part> sides = internal::sides_of(part, cut);
  ASSERT_EQ(sides.size(), 2u);
  for (const Chart_part& side : sides)
    EXPECT_EQ(covered_part(side), 0);
}

// A band of 12 rows whose vertices are off the grid by up to a part of its width, laid around a point 1.3 times: the
// ends that lie over each other are ragged.
Chart_part ragged_band(double part_of_width, Random& random)
{
  constexpr Index columns = 80, rows = 12;
  constexpr double turns = 1.3;
  Flat_mesh m = grid(columns, rows, flat);
  for (Point_3& p : m.points)
    p = Point_3(columns * p.x() + part_of_width * random(-1, 1), columns * p.y() + part_of_width * random(-1, 1), 0);
  Chart_part part = chart_part_of(m);
  for (const Point_3& p : part.mesh.points) {
    const double radius = 2 * rows + p.y(), phi = -2 * CGAL_PI * turns * p.x() / columns;
    part.uv.emplace_back(radius * std::cos(phi), radius * std::sin(phi));
  }
  return part;
}

double area_of_map(const Chart_part& part)
{
  double area = 0;
  for (const Index_triangle& t : triangles_of(part.mesh))
    area += 0.5 * internal::doubled_area(part.uv[t[0]], part.uv[t[1]], part.uv[t[2]]);
  return area;
}

// None of less than a fiftieth of the area: here all of them together are less than a twentieth, so each is joined.
TEST(Overlap_cut, leaves_no_small_pieces)
{
  for (unsigned int seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const Chart_part band = ragged_band(0.2, random);
    const std::vector<Index> cut = internal::overlap_cut(band.mesh, band.uv, 0.02);
    const std::vector<Chart_part> sides = internal::sides_of(band, cut);
    EXPECT_GE(sides.size(), 2u);
    for (const Chart_part& side : sides)
      EXPECT_GT(area_of_map(side), 0.02 * area_of_map(band)) << "seed " << seed;
  }
}

// Parts are divided until none lies over itself by more than the bound; all faces are there, with their places.
TEST(Overlap_cut, divides_until_little_is_covered)
{
  for (const double turns : { 1.2, 2.3, 5.7, 70. })
    for (const double bound : { 0., 0.3 }) {
      const Chart_part whole = wound_strip(Index(20 * turns), turns);
      const std::vector<Chart_part> parts = internal::divided_at_overlaps(whole, bound, bound);
      if (covered_part(whole) <= bound) {
        EXPECT_TRUE(parts.empty());
        continue;
      }
      EXPECT_GE(double(parts.size()), bound == 0 ? turns : 2);
      EXPECT_LE(double(parts.size()), 2 * turns + 1);
      std::vector<Index> faces;
      for (const Chart_part& part : parts) {
        EXPECT_LE(covered_part(part), bound);
        for (Index h = 0; h < part.mesh.number_of_halfedges(); ++h)
          EXPECT_EQ(part.uv[part.mesh.vertex[h]], whole.uv[whole.mesh.vertex[part.halfedge_of_atlas(h)]]);
        faces.insert(faces.end(), part.faces.begin(), part.faces.end());
      }
      std::sort(faces.begin(), faces.end());
      EXPECT_EQ(faces, whole.faces);
    }
}

TEST(Overlap_cut, leaves_what_lies_over_itself_little_or_has_flips)
{
  const Chart_part once = wound_strip(120, 0.9), little = wound_strip(120, 1.05);
  EXPECT_TRUE(internal::overlap_cut(once.mesh, once.uv, 0).empty());
  EXPECT_TRUE(internal::overlap_cut(little.mesh, little.uv, 0.2).empty());
  EXPECT_FALSE(internal::overlap_cut(little.mesh, little.uv, 0).empty());
  Chart_part flipped = wound_strip(120, 1.5);
  EXPECT_TRUE(internal::overlap_cut(flipped.mesh, flipped.uv, 1).empty());
  flipped.uv[flipped.mesh.vertex[0]] = Point_2(100, 100);
  EXPECT_TRUE(internal::overlap_cut(flipped.mesh, flipped.uv, 0.2).empty());
}

} // namespace test_overlap_cuts
