// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a triangle contributes: its rest shape, the invariants of its map, and the energies of these.

#include "energy_archetype.h"
#include "exact_kernel.h"
#include "measures.h"
#include "random_shapes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Distortion_derivatives_2.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Mapped_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Bounded_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Unfolding_energy_2.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace test_energies {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;

typedef As_rigid_as_possible_energy_2   Energy;

constexpr double infinity = std::numeric_limits<double>::infinity();

// ---- rest shapes ----

struct Invariants { double frobenius, determinant; };

Invariants invariants(const Rest_corner& c, const Point_2& v, const Point_2& a, const Point_2& b)
{
  const Vector_2 ab = b - a, av = v - a;
  return { c.inverse_area *
               ((av - c.foot * ab).squared_length() / (2 * c.height) + 0.5 * c.height * ab.squared_length()),
           c.inverse_area * 0.5 * cross(ab, av) };
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
    EXPECT_TRUE(turns_left(apex, image_a, image_b));
  }
}

TEST(Rest_corner, degenerate_triangles_have_a_finite_positive_rest_shape)
{
  const Point_3 o(0.25, 0.5, 0.125), x(1.25, 0.5, 0.125), middle(0.75, 0.5, 0.125), beyond(3.25, 0.5, 0.125),
      near_o(0.25 + 1e-14, 0.5, 0.125);
  const std::vector<std::array<Point_3, 3>> triangles = { { o, x, middle },     { o, middle, x }, { middle, o, x },
                                                          { o, x, beyond },     { o, o, x },      { o, x, o },
                                                          { x, o, o },          { o, o, o },      { o, near_o, x },
                                                          { o, near_o, near_o } };
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
    EXPECT_TRUE(std::isfinite(single.foot) && single.height > 0 && single.inverse_area > 0 &&
                std::isfinite(single.inverse_area));
  }
}

TEST(Map_invariants, agree_with_the_singular_values)
{
  Random random(6);
  for (int k = 0; k < 500; ++k) {
    const std::array<Point_3, 3> p = { random_point_3(random), random_point_3(random), random_point_3(random) };
    const std::array<Point_2, 3> q = { random_point_2(random), random_point_2(random), random_point_2(random) };
    const Map_invariants map(Mapped_triangle(p, q));
    const Singular_values s = singular_values(p[0], p[1], p[2], q[0], q[1], q[2]);
    const double s1 = s.greatest, s2 = s.least;
    EXPECT_NEAR(map.mips() / s.mips(), 1, 1e-6);
    EXPECT_NEAR(map.greatest_stretch() * s2, 1, 1e-6);
    EXPECT_NEAR(map.area() / s.area, 1, 1e-10);
    EXPECT_NEAR(map.area_of_image() / (s.area * s1 * s2), 1, 1e-6);
    EXPECT_NEAR(map.dirichlet() / (s.area * (s1 * s1 + s2 * s2)), 1, 1e-6);
    EXPECT_NEAR(map.inverse_dirichlet() / (s.area * (1 / (s1 * s1) + 1 / (s2 * s2))), 1, 1e-6);
    EXPECT_NEAR(map.angle() / (0.5 * s.area * s.mips()), 1, 1e-6);
    EXPECT_NEAR(map.inverse_determinant() / (s.area / (s1 * s2)), 1, 1e-6);
  }
}

TEST(Map_invariants, of_a_triangle_of_any_size_are_those_of_one_of_size_1)
{
  const std::array<Point_3, 3> p = { Point_3(0, 0, 0), Point_3(1, 0.25, 0), Point_3(0.5, 1.5, 0.125) };
  const std::array<Point_2, 3> q = { Point_2(0, 0), Point_2(0.5, 0.125), Point_2(1, 1.75) };
  const Map_invariants map(Mapped_triangle(p, q));
  for (const int k : { -1000, -600, -300, 0, 300, 1000 })
    for (const int l : { -1000, -600, -300, 0, 300, 1000 }) {
      std::array<Point_3, 3> points;
      std::array<Point_2, 3> image;
      for (int i = 0; i < 3; ++i) {
        points[i] = times_power_of_two(p[i], k);
        image[i] = times_power_of_two(q[i], l);
      }
      const Map_invariants scaled(Mapped_triangle(points, image));
      EXPECT_EQ(scaled.mips(), map.mips());
      EXPECT_EQ(scaled.greatest_stretch(), std::ldexp(map.greatest_stretch(), k - l));
      EXPECT_EQ(scaled.area(), std::ldexp(map.area(), 2 * k));
      EXPECT_EQ(scaled.area_of_image(), std::ldexp(map.area_of_image(), 2 * l));
      EXPECT_EQ(scaled.dirichlet(), std::ldexp(map.dirichlet(), 2 * l));
      EXPECT_EQ(scaled.inverse_dirichlet(), std::ldexp(map.inverse_dirichlet(), 4 * k - 2 * l));
    }
}

// Compares an energy's derivatives with differences over 2 h. An error of the value, by rounding, is divided by h.
template <class Energy>
void expect_derivatives(const Energy& energy, double f, double d, double h, double error_of_value, double tolerance)
{
  const Distortion_derivatives_2 e = energy.derivatives(f, d);
  EXPECT_NEAR(e.value, energy.value(f, d), error_of_value);
  const double of_value = tolerance + error_of_value / h;
  EXPECT_NEAR(e.f, (energy.value(f + h, d) - energy.value(f - h, d)) / (2 * h), of_value);
  EXPECT_NEAR(e.d, (energy.value(f, d + h) - energy.value(f, d - h)) / (2 * h), of_value);
  const auto by_f = [&](double t) { return energy.derivatives(t, d); };
  const auto by_d = [&](double t) { return energy.derivatives(f, t); };
  EXPECT_NEAR(e.ff, (by_f(f + h).f - by_f(f - h).f) / (2 * h), tolerance);
  EXPECT_NEAR(e.fd, (by_d(d + h).f - by_d(d - h).f) / (2 * h), tolerance);
  EXPECT_NEAR(e.fd, (by_f(f + h).d - by_f(f - h).d) / (2 * h), tolerance);
  EXPECT_NEAR(e.dd, (by_d(d + h).d - by_d(d - h).d) / (2 * h), tolerance);
}

// ---- one check of the concept for all models ----

template <class Energy>
class DistortionEnergy_2 : public testing::Test { };

// Some let triangles flip.
typedef testing::Types<MIPS_energy_2, Symmetric_Dirichlet_energy_2, Energy_archetype,
                       Scale_bounded_energy_2<MIPS_energy_2>, As_rigid_as_possible_energy_2>   All_energies;
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
    const double s1 = std::exp(random(-1, 1)), s2 = std::exp(random(-1, 1)), f = s1 * s1 + s2 * s2, d = s1 * s2,
                 h = 1e-6 * d;
    if (f - 2 * d < 4 * h)    // the differences would leave what is possible
      continue;
    const double value = TypeParam().value(f, d);
    expect_derivatives(TypeParam(), f, d, h, 1e-13 * value, 1e-6 * value * (1 + 1 / (d * d)));
  }
}

TYPED_TEST(DistortionEnergy_2, knows_whether_scale_matters)
{
  bool matters = false;
  for (const double scale : { 0.5, 2., 16. })
    matters = matters || TypeParam().value(3 * scale * scale, 1.25 * scale * scale) != TypeParam().value(3, 1.25);
  EXPECT_NE(matters, TypeParam::is_scale_invariant);
}

// ---- the as-rigid-as-possible energy ----

const std::vector<double> stiffnesses = { 0, 1e-3, 0.3, 0.5, 1, 40, 1e6, 1e18, infinity };

// Singular values, one of which is negative now and then.
struct Random_map
{
  double s1, s2, f, d;

  explicit Random_map(Random& random)
    : s1(std::exp(random(-2, 1.5))), s2(s1 * random(-0.9, 0.95)), f(s1 * s1 + s2 * s2), d(s1 * s2)
  { }
};

TEST(As_rigid_as_possible_energy_2, is_the_least_over_all_scales)
{
  Random random(1);
  for (const double k : stiffnesses)
    for (int i = 0; i < 200; ++i) {
      const Random_map map(random);
      const auto energy = [&](double s) {
        return (map.s1 - s) * (map.s1 - s) + (map.s2 - s) * (map.s2 - s) + k * (s * s - 1) * (s * s - 1);
      };
      const double expected =
          k < 1e10 ? least_value(energy, 0, 10) : (map.s1 - 1) * (map.s1 - 1) + (map.s2 - 1) * (map.s2 - 1);
      EXPECT_NEAR(Energy(2 * k).value(map.f, map.d), expected, 1e-8 * (1 + expected)) << "stiffness " << k;
    }
}

TEST(As_rigid_as_possible_energy_2, depends_on_lambda_by_the_area)
{
  EXPECT_EQ(Energy(3).of_area(0.5).value(3, 0.7), Energy(12, 2).value(3, 0.7));
  EXPECT_EQ(Energy(3, 7).of_area(0.5).value(3, 0.7), Energy(12, 2).value(3, 0.7));
  EXPECT_LT(Energy(3).of_area(0.5).value(3, 0.7), Energy(3).of_area(0.4).value(3, 0.7));
}

TEST(As_rigid_as_possible_energy_2, derivatives_match_differences)
{
  Random random(2);
  for (const double k : stiffnesses)
    for (int i = 0; i < 200; ++i) {
      const Random_map map(random);
      const double f = map.f, d = map.d, q = f + 2 * d, h = 1e-5 * q;
      const Energy energy(2 * k);
      expect_derivatives(energy, f, d, h, 1e-14 * (1 + f), 1e-6 * (1 + 1 / (q * q)));
    }
}

TEST(As_rigid_as_possible_energy_2, is_finite_everywhere)
{
  for (const double k : stiffnesses)
    for (const double d : { -2., 0., 2. })
      for (const double f : { 2 * std::abs(d), 3 * std::abs(d) }) {
        const Distortion_derivatives_2 e = Energy(2 * k).derivatives(f, d);
        for (const double x : { e.value, e.f, e.d, e.ff, e.fd, e.dd })
          EXPECT_TRUE(std::isfinite(x)) << "stiffness " << k << ", f " << f << ", d " << d;
      }
}

// ---- unfolding ----

TEST(Unfolding_energy_2, derivatives_match_differences_on_both_sides_of_zero)
{
  Random random(3);
  for (const double width : { 0.1, 1., 5. })
    for (int i = 0; i < 200; ++i) {
      const double d = random(-2, 2), f = 2 * std::abs(d) + random(0.1, 3), h = 1e-5 * width;
      const Unfolding_energy_2 energy(width);
      const double scale = energy.value(f, d) * (1 + 1 / (width * width));
      expect_derivatives(energy, f, d, h, 1e-14 * energy.value(f, d), 1e-6 * scale);
    }
}

TEST(Unfolding_energy_2, is_that_of_MIPS_where_its_width_is_0_and_grows_where_triangles_are_flipped)
{
  for (const double d : { 1e-3, 1., 20. }) {
    const Distortion_derivatives_2 e = Unfolding_energy_2(0).derivatives(50, d),
                                   mips = MIPS_energy_2::derivatives(50, d);
    for (double Distortion_derivatives_2::*const member :
         { &Distortion_derivatives_2::value, &Distortion_derivatives_2::f, &Distortion_derivatives_2::d,
           &Distortion_derivatives_2::ff, &Distortion_derivatives_2::fd, &Distortion_derivatives_2::dd })
      EXPECT_NEAR(e.*member, mips.*member, 1e-13 * std::abs(mips.*member));
  }
  double last = 0;
  for (double d = 2; d > -1e6; d -= 1 + std::abs(d)) {
    const double value = Unfolding_energy_2(1e-3).value(2e6, d);
    EXPECT_GT(value, last);
    EXPECT_TRUE(std::isfinite(value));
    last = value;
  }
}

} // namespace test_energies
