// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Halfedge collapses: the parent triangle, the quality of what is left, groups of collapses, and their metric.

#include "exact_kernel.h"
#include "hierarchies.h"
#include "mesh_conversions.h"
#include "random_shapes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Collapse_group.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Parent_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Ring_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Unit_edge_metric.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/discrete_exponential_map.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test_collapse {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

// ---- one collapse ----

TEST(Parent_triangle, holds_the_origin)
{
  Random random(18);
  int tried = 0;
  for (int k = 0; k < 300; ++k) {
    const std::size_t n = 3 + k % 8;
    std::vector<Vector_2> flat_ring;
    for (const Point_2& p : random_star_polygon(n, Point_2(0, 0), random))
      flat_ring.push_back(p - CGAL::ORIGIN);
    for (std::size_t w0 = 0; w0 < n; ++w0) {
      if (worst_quality_after_collapse(flat_ring, w0) <= 1e-4)
        continue;
      ++tried;
      const Parent_triangle parent = find_parent_triangle(flat_ring, w0);
      const double sigma = parent.coordinates[0], tau = parent.coordinates[1], rho = 1 - sigma - tau;
      EXPECT_EQ(parent.slots[0], w0);
      EXPECT_EQ((parent.slots[1] + 1) % n, parent.slots[2]);
      EXPECT_GE(sigma, 0);
      EXPECT_GE(tau, 0);
      EXPECT_GE(rho, -1e-15);
      EXPECT_NEAR(length(rho * flat_ring[w0] + sigma * flat_ring[parent.slots[1]] + tau * flat_ring[parent.slots[2]]),
                  0, 1e-12);
    }
  }
  EXPECT_GT(tried, 300);
}

// A needle far from the origin, whose area in doubles may be 0 or negative, does not hold it.
TEST(Parent_triangle, is_no_needle)
{
  Random random(1);
  int tried = 0;
  for (int i = 0; i < 100000; ++i) {
    const double size = std::pow(10., -random(4, 5.5)), turn = random(0, 2 * CGAL_PI),
                 direction = random(0, 2 * CGAL_PI);
    const Vector_2 along(size * std::cos(turn), size * std::sin(turn)), across(-along.y(), along.x()),
        far = polar(1, direction) - CGAL::ORIGIN;
    std::vector<Vector_2> flat_ring = { far, far + random(0.3, 0.7) * along - std::pow(10., -random(1, 6)) * across,
                                        far + along };
    std::sort(flat_ring.begin(), flat_ring.end(), [](const Vector_2& a, const Vector_2& b) { return cross(a, b) > 0; });
    for (const double angle : { 2.1, 4.2 })
      flat_ring.push_back(polar(random(0.5, 1.5), direction + angle + random(-0.3, 0.3)) - CGAL::ORIGIN);
    for (std::size_t w0 = 0; w0 < 3; ++w0) {
      if (!(worst_quality_after_collapse(flat_ring, w0) > 1e-6))
        continue;
      ++tried;
      const Parent_triangle parent = find_parent_triangle(flat_ring, w0);
      const double sigma = parent.coordinates[0], tau = parent.coordinates[1], rho = 1 - sigma - tau;
      ASSERT_LT(length(rho * flat_ring[w0] + sigma * flat_ring[parent.slots[1]] + tau * flat_ring[parent.slots[2]]),
                0.5);
    }
  }
  EXPECT_GT(tried, 1000);
}

TEST(Parent_triangle, at_the_border_is_a_place_on_the_coarse_border_edge_by_arc_length)
{
  for (std::size_t size : { 2, 3, 5 })
    for (const std::size_t w0 : { std::size_t(0), size - 1 }) {
      std::vector<Vector_2> flat_ring;
      for (std::size_t i = 0; i < size; ++i)
        flat_ring.push_back(polar(1. + double(i), CGAL_PI * double(i) / double(size - 1)) - CGAL::ORIGIN);
      const std::size_t other = size - 1 - w0;
      const Parent_triangle parent = find_parent_border_edge(flat_ring, w0);
      double at_other = 0, elsewhere = 0;
      for (int i = 0; i < 2; ++i)
        (parent.slots[i + 1] == other ? at_other : elsewhere) += parent.coordinates[i];
      EXPECT_EQ(parent.slots[0], w0);
      EXPECT_DOUBLE_EQ(at_other, length(flat_ring[w0]) / (length(flat_ring[w0]) + length(flat_ring[other])));
      EXPECT_EQ(elsewhere, 0);
      EXPECT_EQ(size == 2,
                parent.slots[1] == parent.slots[2]);      // an ear: as Collapse_hierarchy_3::parent_triangle() says
    }
}

TEST(Collapse_quality, is_negative_exactly_if_a_triangle_flips)
{
  Random random(19);
  for (int k = 0; k < 300; ++k) {
    const std::size_t n = 3 + k % 8;
    const std::vector<Point_2> polygon = random_star_polygon(n, Point_2(0, 0), random);
    std::vector<Vector_2> flat_ring;
    for (const Point_2& p : polygon)
      flat_ring.push_back(p - CGAL::ORIGIN);
    for (const bool is_closed : { true, false })
      for (std::size_t w0 = 0; w0 < n; w0 += is_closed ? 1 : n - 1) {
        bool flips = false;
        for (std::size_t i = 0; i + (is_closed ? 0 : 1) < n; ++i)
          if (i != w0 && (i + 1) % n != w0)
            flips = flips || !turns_left(polygon[w0], polygon[i], polygon[(i + 1) % n]);
        const double worst = worst_quality_after_collapse(flat_ring, w0);
        EXPECT_EQ(worst <= 0, flips);
        for (const double bound : { worst - 0.1, worst, worst + 0.1 })      // a search that may stop early
          EXPECT_EQ(worst_quality_after_collapse(flat_ring, w0, bound) > bound, worst > bound);
      }
  }
}

// ---- groups of them ----

// Against the triangles with their corners replaced, group after group: the rings are those of the triangles that are
// left.
TEST(Ring_mesh, collapses_as_its_triangles_do)
{
  std::vector<std::pair<std::string, Flat_mesh>> meshes = named_meshes();
  meshes.push_back({ "crumpled grid", crumpled_grid(20, 1) });
  for (auto& [name, m] : meshes) {
    SCOPED_TRACE(name);
    internal::Ring_mesh rings(m.points.size(), m.triangles, internal::Loops());
    std::vector<Index_triangle> triangles = m.triangles;
    std::vector<Point_3> points = m.points;
    std::mt19937 random(1);
    internal::Collapse_group group;
    for (int i = 0; i < 4; ++i) {
      group.choose({ rings, points, std::vector<bool>(points.size(), false) }, 3, random, internal::Loops());
      std::vector<unsigned char> is_removed(points.size(), 0);
      for (const internal::Collapse_group::Collapse& c : group.collapses())
        is_removed[c.removed_vertex] = 1;
      std::vector<Index> number(points.size());
      std::vector<Point_3> kept_points;
      for (Index v = 0; v < points.size(); ++v)
        if (!is_removed[v]) {
          number[v] = Index(kept_points.size());
          kept_points.push_back(points[v]);
        }
      for (const internal::Collapse_group::Collapse& c : group.collapses())
        number[c.removed_vertex] = number[c.parent[0]];

      rings.collapse(is_removed, number, internal::Loops());
      points = kept_points;
      for (Index_triangle& t : triangles)
        t = { number[t[0]], number[t[1]], number[t[2]] };
      triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                     [](const Index_triangle& t) {
                                       return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
                                     }),
                      triangles.end());
      ASSERT_EQ(rings.number_of_vertices(), points.size());
      const One_rings expected(points.size(), triangles);
      for (Index v = 0; v < points.size(); ++v) {
        const internal::Ring_mesh::Ring ring = rings[v];
        EXPECT_EQ(ring.is_closed, !expected.is_border(v));
        std::vector<Index> neighbors(ring.begin(), ring.end());
        if (ring.is_closed)       // it may start at any neighbor
          std::rotate(neighbors.begin(), std::find(neighbors.begin(), neighbors.end(), expected[v].front()),
                      neighbors.end());
        EXPECT_EQ(neighbors, std::vector<Index>(expected[v].begin(), expected[v].end()));
      }
    }
  }
}

// ---- the metric ----

// Every star of a regular grid becomes a regular hexagon, however the grid was stretched.
TEST(Unit_edge_metric, makes_edges_equally_long)
{
  const Flat_mesh m = affine_image(grid(6, 6, flat), 5, 2, -1, 0.3);
  const internal::Ring_mesh rings(m.points.size(), m.triangles, internal::Loops());
  const internal::Unit_edge_metric metric(m.points, rings);
  for (Index v = 0; v < m.points.size(); ++v) {
    const internal::Ring_mesh::Ring ring = rings[v];
    if (!ring.is_closed)
      continue;
    std::vector<Point_3> ring_points;
    for (const Index w : ring)
      ring_points.push_back(m.points[w]);
    std::vector<Vector_2> star;
    internal::discrete_exponential_map(m.points[v], ring_points, true, star);
    metric.transform(v, m.points[v], ring_points, star);
    for (Index i = 0; i < ring.size; ++i)
      EXPECT_NEAR((star[i] - star[ring.following(i)]).squared_length() / star[0].squared_length(), 1, 1e-5);
  }
}

// The mean quality of the triangles of all coarse levels, were every vertex where it is in `m`.
double mean_quality(const Collapse_hierarchy_3& h, const Flat_mesh& m)
{
  const auto place = [&](Index v) {
    return Vector_2(m.points[h.input_vertex(v)].x(), m.points[h.input_vertex(v)].y());
  };
  double sum = 0;
  std::size_t triangles = 0;
  for (std::size_t level = 0; level + 1 < h.number_of_levels(); ++level)
    for (const Index_triangle& t : triangles_of_level(h, level)) {
      sum += internal::shape_quality(place(t[0]), place(t[1]), place(t[2]));
      ++triangles;
    }
  return sum / double(triangles);
}

// However a plane mesh was stretched, the coarse triangles are as round as if it had not been.
TEST(Unit_edge_metric, keeps_coarse_triangles_of_stretched_meshes_round)
{
  for (const Flat_mesh& m :
       { delaunay_patch(2000, 1, flat), affine_image(grid(40, 40, flat), 1, -0.5, 0, std::sqrt(0.75)) }) {
    const Flat_mesh image = affine_image(m, 5, 2, -1, 0.3);
    const auto hierarchy = [](const Flat_mesh& mesh, bool unit_edges) {
      return Collapse_hierarchy_3(surface(mesh), parameters::unit_edges(unit_edges));
    };
    const double expected = mean_quality(hierarchy(m, false), m);
    EXPECT_NEAR(mean_quality(hierarchy(m, true), m), expected, 0.03 * expected);
    EXPECT_NEAR(mean_quality(hierarchy(image, true), m), expected, 0.03 * expected);
    EXPECT_LT(mean_quality(hierarchy(image, false), m), 0.9 * expected);
  }
}

} // namespace test_collapse
