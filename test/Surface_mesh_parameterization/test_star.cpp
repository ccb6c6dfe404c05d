// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of one star, and the move of its vertex to where that is less.

#include "energy_archetype.h"
#include "measures.h"
#include "random_shapes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Star.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/relax_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace test_star {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;

constexpr double infinity = std::numeric_limits<double>::infinity();

// The star of vertex 0, closed or open, with random rest shapes, in a random flip-free map.
struct Random_star
{
  Flat_mesh mesh;
  std::vector<Point_2> uv;
  One_rings rings;
  std::vector<Rest_corner> corners;

  Random_star(Index triangles, bool is_closed, Random& random) : mesh(is_closed ? fan(triangles) : open_fan(triangles))
  {
    for (Point_3& p : mesh.points)
      p = p + 0.3 * (random_point_3(random) - CGAL::ORIGIN);
    uv.push_back(Point_2(0, 0));
    const double turn = is_closed ? 2 * CGAL_PI : random(0.5, 0.8 * CGAL_PI * (std::min)(triangles, Index(2)));
    for (const double angle : random_angles(is_closed ? triangles : triangles + 1, turn, 0.8 * CGAL_PI, random))
      uv.push_back(polar(random(0.3, 1), angle));
    rings.build(mesh.points.size(), mesh.triangles, Loops());
    const One_rings::Ring ring = rings[0];
    for (std::size_t i = 0; i < rings.number_of_triangles(0); ++i)
      corners.push_back(rest_corner(mesh.points[0], mesh.points[ring[i]], mesh.points[ring[(i + 1) % ring.size()]]));
  }

  template <class Energy>
  Star<Energy> star(Triangle_weight weight = Triangle_weight::ONE) const
  {
    Star<Energy> result;
    result.gather(rings, uv, 0, corners.data(), weight);
    return result;
  }

  // A place for vertex 0 near the first one, at which no triangle is flipped.
  Point_2 random_place(Random& random) const
  {
    for (double radius = 1; ; radius *= 0.95) {
      std::vector<Point_2> moved = uv;
      moved[0] = Point_2(random(-radius, radius), random(-radius, radius));
      if (is_star_positive(rings, moved, 0))
        return moved[0];
    }
  }
};

// ---- its energy ----

template <class Energy>
class Star_of : public testing::Test { };
TYPED_TEST_SUITE(Star_of, Energies, );

TYPED_TEST(Star_of, energy_is_the_sum_over_the_triangles)
{
  Random random(9);
  for (int k = 0; k < 200; ++k) {
    const Random_star s(3 + k % 6, k % 2 == 0, random);
    const Point_2 place = s.random_place(random);
    double sum = 0, weighted = 0;
    for (const Index_triangle& t : s.mesh.triangles) {
      const std::vector<Point_3>& p = s.mesh.points;
      const Singular_values values = singular_values(p[0], p[t[1]], p[t[2]], place, s.uv[t[1]], s.uv[t[2]]);
      const double energy =
          TypeParam().value(values.greatest * values.greatest + values.least * values.least, values.determinant);
      sum += energy;
      weighted += values.area * energy;
    }
    EXPECT_NEAR(s.star<TypeParam>().energy(place) / sum, 1, 1e-8);
    EXPECT_NEAR(s.star<TypeParam>(Triangle_weight::AREA).energy(place) / weighted, 1, 1e-8);
  }
}

TYPED_TEST(Star_of, gradient_and_hessian_match_differences)
{
  Random random(10);
  for (int k = 0; k < 200; ++k) {
    const Random_star s(3 + k % 6, k % 2 == 0, random);
    const Star<TypeParam> star = s.star<TypeParam>(k % 4 < 2 ? Triangle_weight::ONE : Triangle_weight::AREA);
    const Point_2 p = s.random_place(random);
    const auto d = star.derivatives(p);
    EXPECT_NEAR(d.value / star.energy(p), 1, 1e-12);
    // The nearest edge decides how far a difference may reach, and how good it can be.
    double room = 1;
    for (int i = 0; i < 16; ++i)
      room = (std::min)(room, star.longest_step(p, polar(1, i * CGAL_PI / 8) - CGAL::ORIGIN));
    const double h = 1e-5 * room, gradient_tolerance = 1e-5 * d.value / room,
                 hessian_tolerance = gradient_tolerance / room;
    for (int i = 0; i < 2; ++i) {
      const Vector_2 step = i == 0 ? Vector_2(h, 0) : Vector_2(0, h);
      EXPECT_NEAR(d.gradient[i], (star.energy(p + step) - star.energy(p - step)) / (2 * h), gradient_tolerance);
      const auto plus = star.derivatives(p + step), minus = star.derivatives(p - step);
      for (int j = 0; j < 2; ++j)
        EXPECT_NEAR(d.hessian[i + j], (plus.gradient[j] - minus.gradient[j]) / (2 * h), hessian_tolerance);
    }
  }
}

TYPED_TEST(Star_of, energy_is_infinite_exactly_outside_the_kernel)
{
  Random random(11);
  for (int k = 0; k < 300; ++k) {
    Random_star s(3 + k % 6, k % 2 == 0, random);
    const Star<TypeParam> star = s.star<TypeParam>();
    s.uv[0] = Point_2(random(-1, 1), random(-1, 1));
    EXPECT_EQ(std::isfinite(star.energy(s.uv[0])), is_star_positive(s.rings, s.uv, 0));
    const Vector_2 direction = polar(1, random(0, 7)) - CGAL::ORIGIN;
    const double longest = star.longest_step(Point_2(0, 0), direction);
    if (longest < infinity) {
      EXPECT_TRUE(std::isfinite(star.energy(Point_2(0, 0) + 0.999 * longest * direction)));
      EXPECT_EQ(star.energy(Point_2(0, 0) + 1.001 * longest * direction), infinity);
    }
  }
  const Random_star s(3, true, random);
  EXPECT_EQ(s.star<TypeParam>().energy(s.uv[1]), infinity);   // the triangle has no area
}

TYPED_TEST(Star_of, filter_is_sure_of_positive_triangles_only)
{
  Random random(12);
  std::size_t sure = 0, unsure = 0;
  for (int k = 0; k < 2000; ++k) {
    Random_star s(3, true, random);
    const Vector_2 edge = s.uv[2] - s.uv[1];    // next to the edge, up to rounding errors
    const double distance = random(-1, 1) * std::pow(10, random(-17, -12));
    s.uv[0] = s.uv[1] + random(0, 1) * edge + distance * Vector_2(-edge.y(), edge.x());
    const bool is_sure = s.star<TypeParam>().filtered_energy(s.uv[0]).is_surely_positive;
    EXPECT_TRUE(!is_sure || is_star_positive(s.rings, s.uv, 0));
    ++(is_sure ? sure : unsure);
  }
  EXPECT_GT(sure, 100u);
  EXPECT_GT(unsure, 100u);
}

TEST(Star, MIPS_energy_is_convex_in_the_kernel)
{
  Random random(13);
  for (int k = 0; k < 500; ++k) {
    const Random_star s(3 + k % 6, k % 2 == 0, random);
    const Star<MIPS_energy_2> star = s.star<MIPS_energy_2>();
    const Point_2 p = s.random_place(random), q = s.random_place(random);
    for (const double t : { 0.1, 0.5, 0.9 })
      EXPECT_LE(star.energy(p + t * (q - p)), ((1 - t) * star.energy(p) + t * star.energy(q)) * (1 + 1e-12));
  }
}

// ---- moves of its vertex ----

template <class Energy>
class Relax_vertex : public testing::Test { };
TYPED_TEST_SUITE(Relax_vertex, Energies, );

TYPED_TEST(Relax_vertex, never_raises_the_energy_and_keeps_the_star_valid)
{
  Random random(14);
  int stars = 0;
  for (int k = 0; k < 400; ++k) {
    Random_star s(3 + k % 6, k % 2 == 0, random);
    s.uv[0] = s.random_place(random);
    if (turns_too_far(s.rings, Place_of_vertex{ s.uv }, 0))
      continue;
    ++stars;
    const Star<TypeParam> star = s.star<TypeParam>();
    for (int i = 0; i < 20; ++i) {
      const double before = star.energy(s.uv[0]),
                   decrease = relax_vertex(star, s.rings, 0, i % 2 == 0 ? 1. : 1.8, s.uv);
      EXPECT_GE(decrease, 0);
      EXPECT_NEAR(star.energy(s.uv[0]), before - decrease, 1e-12 * before);
      EXPECT_TRUE(is_star_valid(s.rings, s.uv, 0));
    }
  }
  EXPECT_GT(stars, 200);
}

TYPED_TEST(Relax_vertex, ends_where_the_gradient_vanishes)
{
  Random random(15);
  for (int k = 0; k < 200; ++k) {
    Random_star s(3 + k % 6, true, random);
    s.uv[0] = s.random_place(random);
    const Star<TypeParam> star = s.star<TypeParam>();
    for (int i = 0; i < 100; ++i)
      relax_vertex(star, s.rings, 0, 1, s.uv);
    const auto d = star.derivatives(s.uv[0]);
    EXPECT_LT(std::hypot(d.gradient[0], d.gradient[1]), 1e-5 * (1 + d.hessian[0] + d.hessian[2]));
  }
}

// A border vertex with five angles of 100 degrees in space, that would like to turn by more than a full turn in the
// plane.
TEST(Relax_vertex, keeps_the_angles_at_the_border_below_a_full_turn)
{
  const double angle = CGAL_PI / 1.8;
  const Point_3 hub(0, 0, 0), first(1, 0, 0), second(std::cos(angle), std::sin(angle), 0);
  const Flat_mesh m = open_fan(5);
  const One_rings rings(m.points.size(), m.triangles);
  for (int k = 0; k < 3; ++k) {
    std::vector<Point_2> uv(1, Point_2(0, 0));
    for (int i = 0; i <= 5; ++i)
      uv.push_back(polar(1, (1.9 + 0.03 * k) * CGAL_PI * i / 5));
    ASSERT_TRUE(is_map_valid(rings, uv));
    for (int sweep = 0; sweep < 50; ++sweep)
      for (Index v = 0; v <= 6; ++v) {
        std::vector<Rest_corner> corners;
        for (const Index w : rings[v])    // the triangle (v, w, next of w)
          corners.push_back(v == 0   ? rest_corner(hub, first, second)
                            : w == 0 ? rest_corner(second, hub, first)
                                     : rest_corner(first, second, hub));
        Star<MIPS_energy_2> star;
        star.gather(rings, uv, v, corners.data(), Triangle_weight::ONE);
        relax_vertex(star, rings, v, 1.8, uv);
        ASSERT_TRUE(is_map_valid(rings, uv));
      }
  }
}

} // namespace test_star
