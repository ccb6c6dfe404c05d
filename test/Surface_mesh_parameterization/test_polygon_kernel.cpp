// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The kernel of a polygon.

#include "exact_kernel.h"
#include "random_shapes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/star/Polygon_kernel_2.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace test_polygon_kernel {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;

bool is_left_of_all_edges(const Point_2& p, const std::vector<Point_2>& polygon)
{
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (!turns_left(polygon[i], polygon[(i + 1) % polygon.size()], p))
      return false;
  return true;
}

Point_2 area_centroid(const std::vector<Point_2>& polygon)
{
  double area = 0, x = 0, y = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector_2 a = polygon[i] - polygon[0], b = polygon[(i + 1) % polygon.size()] - polygon[0];
    area += cross(a, b);
    x += cross(a, b) * (a.x() + b.x()) / 3;
    y += cross(a, b) * (a.y() + b.y()) / 3;
  }
  return polygon[0] + Vector_2(x / area, y / area);
}

Polygon_kernel_2 kernel_of(const std::vector<Point_2>& polygon, const Point_2& origin, double half_width)
{
  Polygon_kernel_2 result;
  result.reset(origin, half_width);
  for (std::size_t i = 0; i < polygon.size(); ++i)
    result.clip(polygon[i], polygon[(i + 1) % polygon.size()]);
  return result;
}

// The kernel's corners by brute force: those intersections of two edges' lines that lie on no wrong side, by their
// angle around `inside`.
std::vector<Point_2> kernel_corners(const std::vector<Point_2>& polygon, const Point_2& inside)
{
  const std::size_t n = polygon.size();
  std::vector<std::pair<double, Point_2>> corners;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const Vector_2 d = polygon[(i + 1) % n] - polygon[i], e = polygon[(j + 1) % n] - polygon[j];
      const Point_2 p = polygon[i] + cross(polygon[j] - polygon[i], e) / cross(d, e) * d;
      bool is_corner = true;
      for (std::size_t k = 0; k < n; ++k)
        is_corner = is_corner && (k == i || k == j || cross(polygon[(k + 1) % n] - polygon[k], p - polygon[k]) >= 0);
      if (is_corner)
        corners.push_back({ std::atan2(p.y() - inside.y(), p.x() - inside.x()), p });
    }
  std::sort(corners.begin(), corners.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Point_2> result;
  for (const auto& corner : corners)
    result.push_back(corner.second);
  return result;
}

TEST(Polygon_kernel_2, centroid_lies_left_of_all_edges)
{
  Random random(1);
  for (int k = 0; k < 500; ++k) {
    const Point_2 center(random(-5, 5), random(-5, 5));
    const std::vector<Point_2> polygon = random_star_polygon(3 + k % 10, center, random);
    const Polygon_kernel_2 kernel = kernel_of(polygon, polygon[0], 3);
    ASSERT_FALSE(kernel.is_empty());
    EXPECT_TRUE(is_left_of_all_edges(kernel.centroid(), polygon));
  }
}

TEST(Polygon_kernel_2, is_the_intersection_of_the_half_planes)
{
  Random random(2);
  for (int k = 0; k < 200; ++k) {
    const std::vector<Point_2> polygon = random_star_polygon(4 + k % 8, Point_2(0, 0), random);
    const Point_2 expected = area_centroid(kernel_corners(polygon, Point_2(0, 0))),
                  found = kernel_of(polygon, polygon[0], 3).centroid();
    EXPECT_NEAR(found.x(), expected.x(), 1e-9);
    EXPECT_NEAR(found.y(), expected.y(), 1e-9);
  }
}

TEST(Polygon_kernel_2, of_a_convex_polygon_is_the_polygon)
{
  Random random(3);
  for (int k = 0; k < 100; ++k) {
    std::vector<Point_2> polygon;
    for (const double angle : random_angles(3 + k % 9, 2 * CGAL_PI, 0.9 * CGAL_PI, random))
      polygon.push_back(Point_2(3, -7) + Vector_2(2 * std::cos(angle), std::cos(angle) + 0.5 * std::sin(angle)));
    const Point_2 expected = area_centroid(polygon), found = kernel_of(polygon, Point_2(3, -7), 10).centroid();
    EXPECT_NEAR(found.x(), expected.x(), 1e-12);
    EXPECT_NEAR(found.y(), expected.y(), 1e-12);
  }
}

TEST(Polygon_kernel_2, of_a_polygon_that_is_not_star_shaped_is_empty)
{
  const std::vector<Point_2> u_shape = { Point_2(0, 0), Point_2(3, 0), Point_2(3, 2), Point_2(2, 2),
                                         Point_2(2, 1), Point_2(1, 1), Point_2(1, 2), Point_2(0, 2) };
  EXPECT_TRUE(kernel_of(u_shape, Point_2(1, 1), 5).is_empty());
  const std::vector<Point_2> clockwise = { Point_2(0, 0), Point_2(0, 1), Point_2(1, 0) };
  EXPECT_TRUE(kernel_of(clockwise, Point_2(0, 0), 5).is_empty());
}

TEST(Polygon_kernel_2, without_edges_is_the_box)
{
  Polygon_kernel_2 kernel;
  kernel.reset(Point_2(3, 4), 2);
  EXPECT_FALSE(kernel.is_empty());
  EXPECT_EQ(kernel.centroid(), Point_2(3, 4));
  kernel.clip(Point_2(3, 0), Point_2(3, 1));    // its left half
  EXPECT_EQ(kernel.centroid(), Point_2(2, 4));
}

TEST(Polygon_kernel_2, without_interior_is_empty)
{
  Polygon_kernel_2 kernel;
  kernel.reset(Point_2(0, 0), 1);
  kernel.clip(Point_2(0, 0), Point_2(1, 0));
  EXPECT_FALSE(kernel.is_empty());
  kernel.clip(Point_2(1, 0), Point_2(0, 0));
  EXPECT_TRUE(kernel.is_empty());
}

} // namespace test_polygon_kernel
