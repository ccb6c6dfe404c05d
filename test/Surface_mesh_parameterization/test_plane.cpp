// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Floors 0 and 1: the plane, energies, one star.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Halfedge_collapse.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Mapped_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Polygon_kernel_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Scale_bounded_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Star.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Vertex_inserter.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/discrete_exponential_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/relax_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;

constexpr double infinity = std::numeric_limits<double>::infinity();

Point_2 polar(double radius, double angle) { return Point_2(radius * std::cos(angle), radius * std::sin(angle)); }

// `n` increasing angles from 0 on; neither two neighbors nor the last and the first one are more than `widest` apart.
std::vector<double> random_angles(std::size_t n, double turn, double widest, Random& random)
{
  for (;;) {
    std::vector<double> parts, angles(1, 0.);
    for (std::size_t i = 0; i < n; ++i)
      parts.push_back(random(0.1, 1));
    const double sum = std::accumulate(parts.begin(), parts.end(), 0.);
    if (*std::max_element(parts.begin(), parts.end()) / sum * turn > widest)
      continue;
    for (std::size_t i = 0; i + 1 < n; ++i)
      angles.push_back(angles.back() + parts[i] / sum * turn);
    return angles;
  }
}

// A polygon whose kernel holds `center`.
std::vector<Point_2> random_star_polygon(std::size_t n, const Point_2& center, Random& random)
{
  std::vector<Point_2> polygon;
  for (const double angle : random_angles(n, 2 * CGAL_PI, 0.9 * CGAL_PI, random))
    polygon.push_back(center + (polar(random(0.2, 1), angle) - CGAL::ORIGIN));
  return polygon;
}

bool is_left_of_all_edges(const Point_2& p, const std::vector<Point_2>& polygon)
{
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (!is_left_turn(polygon[i], polygon[(i + 1) % polygon.size()], p))
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

// The kernel's corners by brute force: those intersections of two edges' lines that lie on no wrong side, by their angle around `inside`.
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

// ---- polygon kernel ----

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
    const Point_2 expected = area_centroid(kernel_corners(polygon, Point_2(0, 0))), found = kernel_of(polygon, polygon[0], 3).centroid();
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
  const std::vector<Point_2> u_shape = { Point_2(0, 0), Point_2(3, 0), Point_2(3, 2), Point_2(2, 2), Point_2(2, 1), Point_2(1, 1), Point_2(1, 2), Point_2(0, 2) };
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

// ---- rest shapes ----

struct Invariants { double frobenius, determinant; };

Invariants invariants(const Rest_corner& c, const Point_2& v, const Point_2& a, const Point_2& b)
{
  const Vector_2 ab = b - a, av = v - a;
  return { c.inverse_area * ((av - c.foot * ab).squared_length() / (2 * c.height) + 0.5 * c.height * ab.squared_length()),
           c.inverse_area * 0.5 * cross(ab, av) };
}

Point_3 random_point_3(Random& random)
{
  const double x = random(-1, 1), y = random(-1, 1);
  return Point_3(x, y, random(-1, 1));
}

Point_2 random_point_2(Random& random)
{
  const double x = random(-1, 1);
  return Point_2(x, random(-1, 1));
}

TEST(Rest_corner, invariants_agree_from_all_corners_and_with_the_singular_values)
{
  Random random(4);
  for (int k = 0; k < 1000; ++k) {
    const std::array<Point_3, 3> p = { random_point_3(random), random_point_3(random), random_point_3(random) };
    const std::array<Point_2, 3> q = { random_point_2(random), random_point_2(random), random_point_2(random) };
    const Singular_values s = singular_values(p[0], p[1], p[2], q[0], q[1], q[2]);
    const double frobenius = s.greatest * s.greatest + s.least * s.least, tolerance = 1e-10 * frobenius;
    const std::array<Rest_corner, 3> corners = rest_corners(p[0], p[1], p[2]);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, l = (i + 2) % 3;
      for (const Rest_corner& c : { corners[i], rest_corner(p[i], p[j], p[l]) }) {
        const Invariants found = invariants(c, q[i], q[j], q[l]);
        EXPECT_NEAR(found.frobenius, frobenius, tolerance);
        EXPECT_NEAR(found.determinant, s.determinant, tolerance);
        EXPECT_NEAR(c.inverse_area * s.area, 1, 1e-10);
      }
    }
  }
}

TEST(Rest_corner, similar_apex_makes_the_map_a_similarity)
{
  Random random(5);
  for (int k = 0; k < 100; ++k) {
    const Point_3 v = random_point_3(random), a = random_point_3(random), b = random_point_3(random);
    const Point_2 image_a = random_point_2(random), image_b = random_point_2(random);
    const Point_2 apex = rest_corner(v, a, b).similar_apex(image_a, image_b);
    EXPECT_NEAR(singular_values(v, a, b, apex, image_a, image_b).mips(), MIPS_energy_2::minimum, 1e-8);
    EXPECT_TRUE(is_left_turn(apex, image_a, image_b));
  }
}

TEST(Rest_corner, degenerate_triangles_have_a_finite_positive_rest_shape)
{
  const Point_3 o(0.25, 0.5, 0.125), x(1.25, 0.5, 0.125), middle(0.75, 0.5, 0.125), beyond(3.25, 0.5, 0.125), near_o(0.25 + 1e-14, 0.5, 0.125);
  const std::vector<std::array<Point_3, 3>> triangles = { { o, x, middle }, { o, middle, x }, { middle, o, x }, { o, x, beyond }, { o, o, x },
                                                          { o, x, o }, { x, o, o }, { o, o, o }, { o, near_o, x }, { o, near_o, near_o } };
  const std::array<Point_2, 3> image = { Point_2(0, 0), Point_2(1, 0.2), Point_2(0.3, 0.8) };
  for (const auto& [p, q, r] : triangles) {
    const std::array<Rest_corner, 3> corners = rest_corners(p, q, r);
    const Invariants first = invariants(corners[0], image[0], image[1], image[2]);
    for (int i = 0; i < 3; ++i) {
      const Rest_corner& c = corners[i];
      EXPECT_TRUE(std::isfinite(c.foot) && std::isfinite(c.height) && std::isfinite(c.inverse_area));
      EXPECT_GT(c.height, 0);
      EXPECT_GT(c.inverse_area, 0);
      const Invariants found = invariants(c, image[i], image[(i + 1) % 3], image[(i + 2) % 3]);
      EXPECT_NEAR(found.frobenius / first.frobenius, 1, 1e-6);
      EXPECT_NEAR(found.determinant / first.determinant, 1, 1e-6);
    }
    const Rest_corner single = rest_corner(p, q, r);
    EXPECT_TRUE(std::isfinite(single.foot) && single.height > 0 && single.inverse_area > 0 && std::isfinite(single.inverse_area));
  }
}

TEST(Map_invariants, agree_with_the_singular_values)
{
  Random random(6);
  for (int k = 0; k < 500; ++k) {
    const std::array<Point_3, 3> p = { random_point_3(random), random_point_3(random), random_point_3(random) };
    std::array<Point_2, 3> q = { random_point_2(random), random_point_2(random), random_point_2(random) };
    if (!is_left_turn(q[0], q[1], q[2]))
      std::swap(q[0], q[1]);
    const Map_invariants map(Mapped_triangle(p, q));
    const Singular_values s = singular_values(p[0], p[1], p[2], q[0], q[1], q[2]);
    EXPECT_NEAR(map.greatest_singular_value() / s.greatest, 1, 1e-8);
    EXPECT_NEAR(map.angle_distortion() / (0.5 * s.mips()), 1, 1e-6);
    EXPECT_NEAR(map.area / s.area, 1, 1e-10);
  }
}

// ---- energies: one check of the concept for all models ----

// A user's own energy, (f / d)^2 + (d - 1/d)^2: it has second derivatives of every kind.
struct Energy_archetype
{
  static constexpr double minimum = 4;
  static constexpr bool is_scale_invariant = false;
  static constexpr bool is_flip_free = true;
  const Energy_archetype& of_area(double) const { return *this; }
  static double value(double f, double d) { return f * f / (d * d) + (d - 1 / d) * (d - 1 / d); }
  static Distortion_derivatives_2 derivatives(double f, double d)
  {
    const double d2 = d * d, d3 = d2 * d, d4 = d2 * d2;
    return { value(f, d), 2 * f / d2, -2 * f * f / d3 + 2 * d - 2 / d3, 2 / d2, -4 * f / d3, 6 * f * f / d4 + 2 + 6 / d4 };
  }
};

template <class Energy>
class DistortionEnergy_2 : public testing::Test { };

typedef testing::Types<MIPS_energy_2, Symmetric_Dirichlet_energy_2, Energy_archetype, Scale_bounded_energy_2<MIPS_energy_2>> Energies;
typedef testing::Types<MIPS_energy_2, Symmetric_Dirichlet_energy_2, Energy_archetype, Scale_bounded_energy_2<MIPS_energy_2>, As_rigid_as_possible_energy_2> All_energies;   // some let triangles flip
TYPED_TEST_SUITE(DistortionEnergy_2, All_energies, );

TYPED_TEST(DistortionEnergy_2, has_its_minimum_at_an_isometry)
{
  EXPECT_DOUBLE_EQ(TypeParam().value(2, 1), TypeParam::minimum);
  Random random(7);
  for (int k = 0; k < 1000; ++k) {
    const double s1 = std::exp(random(-3, 3)), s2 = std::exp(random(-3, 3));
    EXPECT_GE(TypeParam().value(s1 * s1 + s2 * s2, s1 * s2), TypeParam::minimum * (1 - 1e-15));
  }
}

TYPED_TEST(DistortionEnergy_2, derivatives_match_differences)
{
  Random random(8);
  for (int k = 0; k < 200; ++k) {
    const double s1 = std::exp(random(-1, 1)), s2 = std::exp(random(-1, 1)), f = s1 * s1 + s2 * s2, d = s1 * s2, h = 1e-6 * d;
    if (f - 2 * d < 4 * h)    // the differences would leave what is possible
      continue;
    const Distortion_derivatives_2 e = TypeParam().derivatives(f, d);
    EXPECT_NEAR(e.value, TypeParam().value(f, d), 1e-13 * e.value);
    const double tolerance = 1e-6 * e.value * (1 + 1 / (d * d));
    EXPECT_NEAR(e.f, (TypeParam().value(f + h, d) - TypeParam().value(f - h, d)) / (2 * h), tolerance);
    EXPECT_NEAR(e.d, (TypeParam().value(f, d + h) - TypeParam().value(f, d - h)) / (2 * h), tolerance);
    const auto by_f = [&](double t) { return TypeParam().derivatives(t, d); };
    const auto by_d = [&](double t) { return TypeParam().derivatives(f, t); };
    EXPECT_NEAR(e.ff, (by_f(f + h).f - by_f(f - h).f) / (2 * h), tolerance);
    EXPECT_NEAR(e.fd, (by_d(d + h).f - by_d(d - h).f) / (2 * h), tolerance);
    EXPECT_NEAR(e.fd, (by_f(f + h).d - by_f(f - h).d) / (2 * h), tolerance);
    EXPECT_NEAR(e.dd, (by_d(d + h).d - by_d(d - h).d) / (2 * h), tolerance);
  }
}

TYPED_TEST(DistortionEnergy_2, knows_whether_scale_matters)
{
  bool matters = false;
  for (const double scale : { 0.5, 2., 16. })
    matters = matters || TypeParam().value(3 * scale * scale, 1.25 * scale * scale) != TypeParam().value(3, 1.25);
  EXPECT_NE(matters, TypeParam::is_scale_invariant);
}

// ---- one star ----

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
      const double energy = TypeParam().value(values.greatest * values.greatest + values.least * values.least, values.determinant);
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
    const double h = 1e-5 * room, gradient_tolerance = 1e-5 * d.value / room, hessian_tolerance = gradient_tolerance / room;
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
  for (int k = 0; k < 2000; ++k) {
    Random_star s(3, true, random);
    const Vector_2 edge = s.uv[2] - s.uv[1];    // next to the edge, up to rounding errors
    s.uv[0] = s.uv[1] + random(0, 1) * edge + random(-1, 1) * 1e-16 * Vector_2(-edge.y(), edge.x());
    EXPECT_TRUE(!s.star<TypeParam>().filtered_energy(s.uv[0]).is_surely_positive || is_star_positive(s.rings, s.uv, 0));
  }
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

template <class Energy>
class Relax_vertex : public testing::Test { };
TYPED_TEST_SUITE(Relax_vertex, Energies, );

TYPED_TEST(Relax_vertex, never_raises_the_energy_and_keeps_the_star_valid)
{
  Random random(14);
  for (int k = 0; k < 400; ++k) {
    Random_star s(3 + k % 6, k % 2 == 0, random);
    s.uv[0] = s.random_place(random);
    if (turns_too_far(s.rings, Place_of_vertex{ s.uv }, 0))
      continue;
    const Star<TypeParam> star = s.star<TypeParam>();
    for (int i = 0; i < 20; ++i) {
      const double before = star.energy(s.uv[0]), decrease = relax_vertex(star, s.rings, 0, i % 2 == 0 ? 1. : 1.8, s.uv);
      EXPECT_GE(decrease, 0);
      EXPECT_NEAR(star.energy(s.uv[0]), before - decrease, 1e-12 * before);
      EXPECT_TRUE(is_star_valid(s.rings, s.uv, 0));
    }
  }
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

// A border vertex with five angles of 100 degrees in space, that would like to turn by more than a full turn in the plane.
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
          corners.push_back(v == 0 ? rest_corner(hub, first, second) : w == 0 ? rest_corner(second, hub, first) : rest_corner(first, second, hub));
        Star<MIPS_energy_2> star;
        star.gather(rings, uv, v, corners.data(), Triangle_weight::ONE);
        relax_vertex(star, rings, v, 1.8, uv);
        ASSERT_TRUE(is_map_valid(rings, uv));
      }
  }
}

// ---- discrete exponential map, parent triangle ----

double length(const Vector_2& v) { return std::sqrt(v.squared_length()); }

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
      EXPECT_NEAR(turn_between(flat_ring[i], flat_ring[(i + 1) % n]), 2 * CGAL_PI / total * angle_between(ring[i] - v, ring[(i + 1) % n] - v), 1e-7);
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
    for (const std::vector<Point_3>& ring : { std::vector<Point_3>(5, o), std::vector<Point_3>(5, x), std::vector<Point_3>{ x, o, x, o } }) {
      std::vector<Vector_2> flat_ring;
      discrete_exponential_map(o, ring, is_closed, flat_ring);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        EXPECT_TRUE(std::isfinite(flat_ring[i].x()) && std::isfinite(flat_ring[i].y()));
        EXPECT_NEAR(length(flat_ring[i]), std::sqrt(CGAL::squared_distance(o, ring[i])), 1e-15);
      }
    }
}

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
      EXPECT_NEAR(length(rho * flat_ring[w0] + sigma * flat_ring[parent.slots[1]] + tau * flat_ring[parent.slots[2]]), 0, 1e-12);
    }
  }
  EXPECT_GT(tried, 300);
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
      EXPECT_EQ(size == 2, parent.slots[1] == parent.slots[2]);   // an ear: as Collapse_hierarchy_3::parent_triangle() says
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
            flips = flips || !is_left_turn(polygon[w0], polygon[i], polygon[(i + 1) % n]);
        const double worst = worst_quality_after_collapse(flat_ring, w0);
        EXPECT_EQ(worst <= 0, flips);
        for (const double bound : { worst - 0.1, worst, worst + 0.1 })      // a search that may stop early
          EXPECT_EQ(worst_quality_after_collapse(flat_ring, w0, bound) > bound, worst > bound);
      }
  }
}

// ---- validity of a star ----

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
  EXPECT_FALSE(fan_turns_too_far({ Point_2(1, 2), Point_2(-3, 1), Point_2(-1, -2), Point_2(0, -1), Point_2(1, 1.5) }, false));
  EXPECT_TRUE(fan_turns_too_far({ Point_2(1, 2), Point_2(-3, 1), Point_2(-1, -2), Point_2(0, -1), Point_2(0.5, 1) }, false));
}

TEST(Turns_too_far, around_an_interior_vertex_is_one_turn_and_not_two)
{
  const Point_2 east(1, 0), north(0, 1), west(-1, 0), south(0, -1);
  EXPECT_FALSE(fan_turns_too_far({ east, north, west, south }, true));
  EXPECT_FALSE(fan_turns_too_far({ east, Point_2(-1, 1), Point_2(-1, -1) }, true));
  EXPECT_TRUE(fan_turns_too_far({ east, Point_2(-1, 1), Point_2(-1, -1), Point_2(1, 0.1), Point_2(-1, 1.2), Point_2(-1, -1.2) }, true));
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
  std::vector<Point_2> uv = { Point_2(0, 0), Point_2(1, 0), Point_2(0, 1), Point_2(-1, 0), Point_2(0, -1), Point_2(1, -0.25) };
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

// ---- insertion ----

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

// Inserts an interior vertex into the star polygon with the corner W0 at `center`, an angle of `turn` there, and `fan` coarse triangles.
testing::AssertionResult insert_interior_vertex(Index fan, double turn, double least_radius, const Point_2& center, Random& random)
{
  // V is vertex 0, W0 vertex 1, Wi vertex i + 1.
  std::vector<Point_2> uv = { center, center };
  const std::vector<double> angles = random_angles(fan + 1, turn * (fan + 1) / fan, CGAL_PI, random);
  for (const double angle : angles)
    uv.push_back(center + (polar(std::exp(random(std::log(least_radius), 0)), angle * turn / angles.back()) - CGAL::ORIGIN));
  for (Index i = 2; i + 1 < uv.size(); ++i)
    if (!is_left_turn(uv[1], uv[i], uv[i + 1]))
      return testing::AssertionSuccess() << "no coarse map";
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
    return testing::AssertionFailure() << "no place: turn " << turn << ", fan " << fan << ", least radius " << least_radius;
  if (!is_star_positive(rings, uv, 0))
    return testing::AssertionFailure() << "a flip: turn " << turn << ", fan " << fan;
  return testing::AssertionSuccess();
}

TEST(Vertex_inserter, finds_a_place_in_every_star_polygon_with_a_positive_fan)
{
  Random random(20);
  for (int k = 0; k < 2000; ++k)
    EXPECT_TRUE(insert_interior_vertex(1 + k % 9, random(0.2, (std::min)(1.9, 0.9 * (1 + k % 9)) * CGAL_PI), 0.3, random_point_2(random), random));
}

TEST(Vertex_inserter, finds_a_place_beside_a_reflex_corner_and_in_thin_kernels)
{
  Random random(21);
  for (int k = 0; k < 1000; ++k) {
    const Index fan = 3 + k % 7;
    EXPECT_TRUE(insert_interior_vertex(fan, (2 - std::pow(10, random(-4, 0))) * CGAL_PI, 0.3, random_point_2(random), random));
    EXPECT_TRUE(insert_interior_vertex(fan, std::pow(10, random(-4, 0)), 0.3, random_point_2(random), random));
    EXPECT_TRUE(insert_interior_vertex(fan, random(0.5, 1.9) * CGAL_PI, 1e-4, random_point_2(random), random));
  }
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
  const std::vector<Rest_corner> corners(6, rest_corner(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.5, std::sqrt(0.75), 0)));
  std::vector<bool> is_placed(7, true);
  Vertex_inserter inserter(rings, uv, is_placed);
  ASSERT_TRUE(inserter.insert(0, corners.data(), { 1, 3, 4 }, { 0.5, 0, 0.5 }));    // the middle of opposite corners
  EXPECT_NEAR(uv[0].x(), 5, 1e-14);
  EXPECT_NEAR(uv[0].y(), 5, 1e-14);
}

// A border vertex C, number 0, whose coarse fan turns by `turn`, with the neighbors 1, .., n + 1. Its last edge, from n + 1 to 0, and its
// first one, from 0 to 1, lie on the border.
std::vector<Point_2> coarse_border_fan(Index n, double turn, Random& random)
{
  std::vector<Point_2> uv(1, Point_2(0, 0));
  const std::vector<double> angles = random_angles(n + 1, turn * (n + 1) / n, CGAL_PI, random);
  for (const double angle : angles)
    uv.push_back(polar(random(0.5, 1), angle * turn / angles.back()));
  return uv;
}

// Inserts ears on the border edges of C one after the other: `onto_center` says whether they had collapsed onto C.
testing::AssertionResult insert_ears(Index n, double turn, bool onto_center, bool is_second_too, Random& random)
{
  std::vector<Point_2> uv = coarse_border_fan(n, turn, random);
  std::vector<Index_triangle> triangles;
  for (Index i = 0; i < n; ++i)
    triangles.push_back({ 0, 1 + i, 2 + i });
  if (!is_map_valid(One_rings(uv.size(), triangles), uv))
    return testing::AssertionSuccess() << "no coarse map";

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
      return testing::AssertionFailure() << "no place for ear " << v - first_ear << ": turn " << turn << ", onto center " << onto_center;
    is_placed[v] = true;
  }
  return is_map_valid(rings, uv) ? testing::AssertionSuccess() : testing::AssertionFailure() << "an invalid map: turn " << turn;
}

TEST(Vertex_inserter, inserts_ears_beside_border_vertices_of_any_turn)
{
  Random random(22);
  for (int k = 0; k < 300; ++k)
    for (const bool is_second_too : { false, true }) {
      EXPECT_TRUE(insert_ears(3 + k % 5, random(0.5, 1.9) * CGAL_PI, k % 2 == 0, is_second_too, random));
      EXPECT_TRUE(insert_ears(3 + k % 5, (2 - std::pow(10, random(-6, 0))) * CGAL_PI, k % 2 == 0, is_second_too, random));
    }
}

// Inserts a border vertex V between the last neighbor of C and C; it takes the last `taken` triangles from C. V had collapsed onto C
// or, if it takes one triangle only, onto the other end.
testing::AssertionResult insert_border_vertex(Index n, double turn, Index taken, bool onto_center, Random& random)
{
  std::vector<Point_2> uv = coarse_border_fan(n, turn, random);
  std::vector<Index_triangle> triangles;
  for (Index i = 0; i < n; ++i)
    triangles.push_back({ 0, 1 + i, 2 + i });
  if (!is_map_valid(One_rings(uv.size(), triangles), uv))
    return testing::AssertionSuccess() << "no coarse map";

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
  const std::array<double, 3> coordinates = onto_center ? std::array<double, 3>{ 1 - fraction, 0, fraction } : std::array<double, 3>{ 1 - fraction, fraction, 0 };
  if (!inserter.insert(v, random_rest_shapes(taken + 1, random).data(), parent, coordinates))
    return testing::AssertionFailure() << "no place: turn " << turn << ", onto center " << onto_center;
  return is_map_valid(rings, uv) ? testing::AssertionSuccess() : testing::AssertionFailure() << "an invalid map: turn " << turn;
}

TEST(Vertex_inserter, inserts_border_vertices_beside_border_vertices_of_any_turn)
{
  Random random(23);
  for (int k = 0; k < 500; ++k)
    for (const double turn : { random(0.5, 1.9), 2 - std::pow(10, random(-6, 0)) }) {
      const Index n = 3 + k % 5;
      EXPECT_TRUE(insert_border_vertex(n, turn * CGAL_PI, 1 + Index(random.below(n - 1)), true, random));
      EXPECT_TRUE(insert_border_vertex(n, turn * CGAL_PI, 1, false, random));
    }
}

// ---- one-rings ----

std::set<Index_triangle> rotated_to_least(const std::vector<Index_triangle>& triangles)
{
  std::set<Index_triangle> result;
  for (Index_triangle t : triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.insert(t);
  }
  return result;
}

TEST(One_rings, hold_every_triangle_at_each_of_its_corners)
{
  std::vector<std::pair<std::string, Flat_mesh>> meshes = named_meshes();
  meshes.push_back({ "sphere", sphere(5, 8) });
  meshes.push_back({ "large hub on border", open_fan(500) });
  for (const auto& [name, m] : meshes) {
    SCOPED_TRACE(name);
    const One_rings rings(m.points.size(), m.triangles);
    EXPECT_EQ(rings.first_non_manifold_vertex(), no_index);
    std::vector<Index_triangle> triangles;
    for (Index v = 0; v < m.points.size(); ++v) {
      const One_rings::Ring ring = rings[v];
      EXPECT_EQ(rings.number_of_triangles(v), ring.size() - (rings.is_border(v) ? 1 : 0));
      for (std::size_t i = 0; i < rings.number_of_triangles(v); ++i)
        triangles.push_back({ v, ring[i], ring[(i + 1) % ring.size()] });
    }
    EXPECT_EQ(triangles.size(), 3 * m.triangles.size());
    EXPECT_EQ(rotated_to_least(triangles), rotated_to_least(m.triangles));
  }
}

TEST(One_rings, border_vertices_are_the_ends_of_edges_with_one_triangle)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    std::map<std::pair<Index, Index>, int> edges;
    for (const Index_triangle& t : m.triangles)
      for (int i = 0; i < 3; ++i)
        ++edges[std::minmax({ t[i], t[(i + 1) % 3] })];
    std::vector<bool> is_border(m.points.size(), false);
    for (const auto& [edge, count] : edges)
      if (count == 1)
        is_border[edge.first] = is_border[edge.second] = true;
    const One_rings rings(m.points.size(), m.triangles);
    for (Index v = 0; v < m.points.size(); ++v) {
      EXPECT_EQ(rings.is_border(v), is_border[v]);
      if (is_border[v]) {
        EXPECT_EQ((edges[std::minmax({ v, rings[v].front() })]), 1);
        EXPECT_EQ((edges[std::minmax({ v, rings[v].back() })]), 1);
      }
    }
  }
}

TEST(One_rings, count_borders)
{
  const auto count = [](const Flat_mesh& m) { return One_rings(m.points.size(), m.triangles).number_of_borders(); };
  EXPECT_EQ(count(sphere(4, 6)), 0u);
  EXPECT_EQ(count(single_triangle()), 1u);
  EXPECT_EQ(count(fan(500)), 1u);
  EXPECT_EQ(count(disk_with_hole()), 2u);
  EXPECT_EQ(count(annulus(12)), 2u);
  EXPECT_EQ(count(grid_with_holes(20)), 4u);
}

TEST(One_rings, find_vertices_that_are_not_manifold)
{
  const auto first_bad = [](std::size_t n, const std::vector<Index_triangle>& triangles) { return One_rings(n, triangles).first_non_manifold_vertex(); };
  EXPECT_EQ(first_bad(5, two_umbrellas().triangles), 0u);
  EXPECT_EQ(first_bad(4, single_triangle().triangles), 3u);                                        // an isolated vertex
  EXPECT_EQ(first_bad(4, { { 0, 1, 2 }, { 1, 2, 3 } }), 1u);                                       // neighbors with opposite orientations
  EXPECT_EQ(first_bad(5, { { 2, 0, 1 }, { 3, 1, 0 }, { 4, 0, 1 } }), 0u);                          // three triangles at an edge
  EXPECT_EQ(first_bad(7, { { 6, 0, 1 }, { 6, 1, 2 }, { 6, 2, 0 }, { 6, 3, 4 }, { 6, 4, 5 }, { 6, 5, 3 } }), 6u);   // two closed fans
  for (const Index n : { 20u, 200u }) {   // two large fans, closed ones and open ones
    Flat_mesh m = fan(n);
    for (const Index_triangle& t : fan(n).triangles)
      m.triangles.push_back({ 0, t[1] + n, t[2] + n });
    EXPECT_EQ(first_bad(2 * n + 1, m.triangles), 0u);
    m.triangles.pop_back();
    EXPECT_EQ(first_bad(2 * n + 1, m.triangles), 0u);
    m.triangles.erase(m.triangles.begin());
    EXPECT_EQ(first_bad(2 * n + 1, m.triangles), 0u);
  }
}

TEST(One_rings, can_be_built_again)
{
  One_rings rings;
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    rings.build(m.points.size(), m.triangles, Loops());
    const One_rings fresh(m.points.size(), m.triangles);
    ASSERT_EQ(rings.number_of_slots(), fresh.number_of_slots());
    EXPECT_EQ(rings.first_non_manifold_vertex(), no_index);
    for (Index v = 0; v < m.points.size(); ++v)
      EXPECT_TRUE(rings.is_border(v) == fresh.is_border(v) && rings[v] == fresh[v]);
  }
}

} // namespace
