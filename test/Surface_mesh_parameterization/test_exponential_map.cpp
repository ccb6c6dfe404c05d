// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The discrete exponential map: a star of triangles in space, laid out in the plane.

#include "random_shapes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/star/discrete_exponential_map.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_exponential_map {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;

double angle_between(const Vector_3& a, const Vector_3& b)
{
  return std::acos((std::max)(-1., (std::min)(1., a * b / std::sqrt(a.squared_length() * b.squared_length()))));
}

// The angle from a to b, counter-clockwise, in [0, 2 pi).
double turn_between(const Vector_2& a, const Vector_2& b)
{
  const double angle = std::atan2(cross(a, b), a * b);
  return angle < 0 ? angle + 2 * CGAL_PI : angle;
}

std::vector<Point_3> random_ring(std::size_t n, const Point_3& v, Random& random)
{
  std::vector<Point_3> ring;
  for (std::size_t i = 0; i < n; ++i) {
    const Point_2 p = polar(random(0.3, 1), 2 * CGAL_PI * double(i) / double(n));
    ring.push_back(v + Vector_3(p.x(), p.y(), random(-0.4, 0.4)));
  }
  return ring;
}

TEST(Discrete_exponential_map, keeps_lengths_and_scales_angles_to_a_full_turn)
{
  Random random(16);
  for (int k = 0; k < 200; ++k) {
    const std::size_t n = 3 + k % 8;
    const Point_3 v = random_point_3(random);
    const std::vector<Point_3> ring = random_ring(n, v, random);
    std::vector<Vector_2> flat_ring;
    discrete_exponential_map(v, ring, true, flat_ring);
    ASSERT_EQ(flat_ring.size(), n);
    double total = 0, flat_total = 0;
    for (std::size_t i = 0; i < n; ++i) {
      total += angle_between(ring[i] - v, ring[(i + 1) % n] - v);
      flat_total += turn_between(flat_ring[i], flat_ring[(i + 1) % n]);
    }
    EXPECT_NEAR(flat_total, 2 * CGAL_PI, 1e-12);   // not 4 pi: the order is kept
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_NEAR(length(flat_ring[i]), std::sqrt(CGAL::squared_distance(v, ring[i])), 1e-13);
      EXPECT_NEAR(turn_between(flat_ring[i], flat_ring[(i + 1) % n]),
                  2 * CGAL_PI / total * angle_between(ring[i] - v, ring[(i + 1) % n] - v), 1e-7);
    }
  }
}

TEST(Discrete_exponential_map, reproduces_a_planar_ring_up_to_rotation)
{
  Random random(17);
  for (int k = 0; k < 100; ++k) {
    const std::vector<Point_2> polygon = random_star_polygon(3 + k % 8, Point_2(0, 0), random);
    std::vector<Point_3> ring;
    for (const Point_2& p : polygon)   // in a plane across space
      ring.push_back(Point_3(1, 2, 3) + p.x() * Vector_3(0.6, 0, 0.8) + p.y() * Vector_3(0, 1, 0));
    for (const bool is_closed : { true, false }) {
      std::vector<Vector_2> flat_ring;
      if (!is_closed && turn_between(polygon.front() - CGAL::ORIGIN, polygon.back() - CGAL::ORIGIN) > 1.8 * CGAL_PI)
        continue;   // a border vertex with so wide an angle is closed a little
      discrete_exponential_map(Point_3(1, 2, 3), ring, is_closed, flat_ring);
      for (std::size_t i = 0; i < ring.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_NEAR(length(flat_ring[i] - flat_ring[j]), std::sqrt(CGAL::squared_distance(ring[i], ring[j])), 1e-12);
    }
  }
}

TEST(Discrete_exponential_map, lays_out_degenerate_rings)
{
  const Point_3 o(0, 0, 0), x(1, 0, 0);
  for (const bool is_closed : { true, false })
    for (const std::vector<Point_3>& ring :
         { std::vector<Point_3>(5, o), std::vector<Point_3>(5, x), std::vector<Point_3>{ x, o, x, o } }) {
      std::vector<Vector_2> flat_ring;
      discrete_exponential_map(o, ring, is_closed, flat_ring);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        EXPECT_TRUE(std::isfinite(flat_ring[i].x()) && std::isfinite(flat_ring[i].y()));
        EXPECT_NEAR(length(flat_ring[i]), std::sqrt(CGAL::squared_distance(o, ring[i])), 1e-15);
      }
    }
}

} // namespace test_exponential_map
