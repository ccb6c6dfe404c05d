// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The engine's exact predicates agree with those of CGAL's kernel.

#include "exact_kernel.h"
#include "random_shapes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/intersections.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace test_exact_predicates {

using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
constexpr double greatest = (std::numeric_limits<double>::max)(), least = std::numeric_limits<double>::denorm_min();

// Up to `most` units in the last place away.
double moved_by_ulps(double x, std::size_t most, Random& random)
{
  const double towards = random(0, 1) < 0.5 ? -infinity : infinity;
  for (std::size_t i = random.below(most + 1); i > 0; --i)
    x = std::nextafter(x, towards);
  return x;
}

Point_2 moved_by_ulps(const Point_2& p, std::size_t most, Random& random)
{
  const double x = moved_by_ulps(p.x(), most, random);
  return Point_2(x, moved_by_ulps(p.y(), most, random));
}

// How often the points lie to the left, on a line, and to the right.
struct Counts
{
  std::size_t left = 0, collinear = 0, right = 0;

  // Compares all orders of the points.
  void check(const Point_2& a, const Point_2& b, const Point_2& c)
  {
    const CGAL::Orientation expected = orientation_by_CGAL(a, b, c);
    for (const auto& [p, q, r] : { std::array<Point_2, 3>{ a, b, c }, { b, c, a }, { c, a, b } }) {
      ASSERT_EQ(exact_orientation(p, q, r), expected) << a << ", " << b << ", " << c;
      ASSERT_EQ(exact_orientation(q, p, r), -expected) << a << ", " << b << ", " << c;
      ASSERT_EQ(is_left_turn(p, q, r), expected == CGAL::LEFT_TURN);
      ASSERT_EQ(is_left_turn(q, p, r), expected == CGAL::RIGHT_TURN);
    }
    ASSERT_EQ(unfiltered_orientation(a, b, c), expected) << a << ", " << b << ", " << c;
    ++(expected == CGAL::LEFT_TURN ? left : expected == CGAL::RIGHT_TURN ? right : collinear);
  }

  void expect_all_kinds(std::size_t least) const
  {
    EXPECT_GT(left, least);
    EXPECT_GT(right, least);
    EXPECT_GT(collinear, least);
  }
};

// ---- orientation ----

TEST(Exact_orientation, of_random_points)
{
  Random random(1);
  Counts counts;
  for (int k = 0; k < 10000; ++k) {
    const Point_2 a = random_point_2(random), b = random_point_2(random);
    counts.check(a, b, random_point_2(random));
  }
  EXPECT_GT(counts.left, 4000u);
  EXPECT_GT(counts.right, 4000u);
}

TEST(Exact_orientation, of_points_on_a_line_moved_by_ulps)
{
  Random random(2);
  Counts counts;
  for (int k = 0; k < 8000; ++k) {
    const Point_2 a = random_point_2(random), b = random_point_2(random);
    counts.check(a, b, moved_by_ulps(a + random(-1, 2) * (b - a), 2, random));
  }
  counts.expect_all_kinds(0);
}

// Where the filter alone would be wrong: Kettner, Mehlhorn, Pion, Schirra, Yap, Classroom examples of robustness
// problems in geometric computations, 2008.
TEST(Exact_orientation, of_points_beside_a_diagonal)
{
  Counts counts;
  const Point_2 b(12, 12), c(24, 24);
  double x = 0.5;
  for (int i = 0; i < 64; ++i, x = std::nextafter(x, 1.)) {
    double y = 0.5;
    for (int j = 0; j < 64; ++j, y = std::nextafter(y, 1.)) {
      counts.check(Point_2(x, y), b, c);
      ASSERT_EQ(exact_orientation(Point_2(x, y), b, c), i == j  ? CGAL::COLLINEAR
                                                        : i < j ? CGAL::LEFT_TURN
                                                                : CGAL::RIGHT_TURN);
    }
  }
  counts.expect_all_kinds(63);
}

TEST(Exact_orientation, of_collinear_points)
{
  Random random(3);
  for (int k = 0; k < 5000; ++k) {
    // Whole numbers, whose multiples are exact.
    const auto whole = [&] { return double(random.below(2001)) - 1000; };
    const double x = whole(), y = whole(), dx = whole(), dy = whole(), s = whole(), t = whole();
    const Point_2 a(x, y), b(x + s * dx, y + s * dy), c(x + t * dx, y + t * dy);
    ASSERT_EQ(exact_orientation(a, b, c), CGAL::COLLINEAR);
    ASSERT_EQ(exact_orientation(a, b, b), CGAL::COLLINEAR);
    ASSERT_EQ(exact_orientation(a, b, a), CGAL::COLLINEAR);
    ASSERT_EQ(exact_orientation(a, a, a), CGAL::COLLINEAR);
    Counts().check(a, b, c);
    const double scale = std::ldexp(1., int(random.below(600)) - 300);
    Counts().check(Point_2(scale * a.x(), scale * a.y()), Point_2(scale * b.x(), scale * b.y()),
                   Point_2(scale * c.x(), scale * c.y()));
  }
}

// Also where products overflow or underflow.
TEST(Exact_orientation, of_huge_tiny_and_subnormal_points)
{
  Random random(4);
  for (const int exponent : { 1022, 1000, 600, 512, 511, 300, -300, -480, -500, -511, -537, -540, -600, -1000, -1022,
                              -1040, -1060, -1070 }) {
    Counts counts;
    const auto scaled = [&](const Point_2& p) {
      return Point_2(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent));
    };
    for (int k = 0; k < 100; ++k) {
      const Point_2 a = random_point_2(random), b = random_point_2(random);
      counts.check(scaled(a), scaled(b), scaled(random_point_2(random)));
      counts.check(scaled(a), scaled(b), moved_by_ulps(scaled(a + random(0, 1) * (b - a)), 2, random));
    }
    EXPECT_GT(counts.left, 50u) << exponent;
    EXPECT_GT(counts.right, 50u) << exponent;
  }
  const std::vector<double> numbers = {
    0,     least, -least, 2 * least, 1e-320,    (std::numeric_limits<double>::min)(), 1e-160, -1e-160, 1e-145, 1, -1,
    1e145, 1e160, -1e160, greatest,  -greatest, std::nextafter(greatest, 0.)
  };
  Counts counts;
  for (int k = 0; k < 3000; ++k) {
    const auto number = [&] { return numbers[random.below(numbers.size())]; };
    const double ax = number(), ay = number(), bx = number(), by = number(), cx = number();
    counts.check(Point_2(ax, ay), Point_2(bx, by), Point_2(cx, number()));
  }
  counts.expect_all_kinds(20);
}

TEST(Exact_orientation, of_points_far_from_the_origin)
{
  Random random(5);
  for (const double offset : { 1e3, 1e8, 1e15, 1e16, 1e100 }) {
    Counts counts;
    for (int k = 0; k < 3000; ++k) {
      const auto far = [&](const Point_2& p) { return Point_2(offset + p.x(), p.y() - offset / 3); };
      const Point_2 a = far(random_point_2(random)), b = far(random_point_2(random));
      counts.check(a, b, far(random_point_2(random)));
      counts.check(moved_by_ulps(a, 3, random), moved_by_ulps(a, 3, random), moved_by_ulps(a, 3, random));
    }
    counts.expect_all_kinds(100);
  }
}

TEST(Exact_orientation, of_points_that_are_not_finite_is_collinear)
{
  for (const double bad : { nan, infinity, -infinity })
    for (const Point_2& p : { Point_2(bad, 0), Point_2(0, bad), Point_2(bad, bad), Point_2(bad, -bad) }) {
      const Point_2 a(0, 0), b(1, 0), c(0, 1);
      EXPECT_EQ(exact_orientation(p, b, c), CGAL::COLLINEAR);
      EXPECT_EQ(exact_orientation(a, p, c), CGAL::COLLINEAR);
      EXPECT_EQ(exact_orientation(a, b, p), CGAL::COLLINEAR);
      EXPECT_EQ(exact_orientation(p, p, p), CGAL::COLLINEAR);
      EXPECT_EQ(unfiltered_orientation(a, b, p), CGAL::COLLINEAR);
      EXPECT_FALSE(is_left_turn(a, b, p));
    }
}

// ---- order ----

TEST(Order_xy, is_that_of_CGAL)
{
  Random random(6);
  for (int k = 0; k < 2000; ++k) {
    const auto point = [&] {
      const double x = double(random.below(4));
      return Point_2(x, double(random.below(4)));
    };
    const Point_2 p = point(), q = point(), r = point();
    EXPECT_EQ(is_less_xy(p, q), CGAL::compare_xy(exact(p), exact(q)) == CGAL::SMALLER);
    if (orientation_by_CGAL(p, q, r) == CGAL::COLLINEAR) {
      EXPECT_EQ(are_strictly_ordered_xy(p, q, r),
                CGAL::collinear_are_strictly_ordered_along_line(exact(p), exact(q), exact(r)));
    }
  }
}

// ---- segments ----

// The same in every order of the ends and of the segments.
void check_segments(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& d, bool expected)
{
  for (const bool is_first_turned : { false, true })
    for (const bool is_second_turned : { false, true }) {
      const Point_2 &p = is_first_turned ? b : a, &q = is_first_turned ? a : b, &r = is_second_turned ? d : c,
                    &s = is_second_turned ? c : d;
      ASSERT_EQ(do_segments_meet(p, q, r, s), expected) << a << ", " << b << " and " << c << ", " << d;
      ASSERT_EQ(do_segments_meet(r, s, p, q), expected) << a << ", " << b << " and " << c << ", " << d;
    }
}

// A segment of length zero is a point, with which CGAL does not intersect segments.
bool do_meet_by_CGAL(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& d)
{
  typedef Exact_kernel::Segment_2   Segment;
  if (a == b && c == d)
    return a == c;
  if (a == b)
    return Segment(exact(c), exact(d)).has_on(exact(a));
  if (c == d)
    return Segment(exact(a), exact(b)).has_on(exact(c));
  return CGAL::do_intersect(Segment(exact(a), exact(b)), Segment(exact(c), exact(d)));
}

TEST(Do_segments_meet, of_random_segments_on_a_grid)
{
  Random random(7);
  for (const std::size_t size : { 2, 3, 5, 20 }) {
    std::size_t meeting = 0, degenerate = 0;
    for (int k = 0; k < 6000; ++k) {
      const auto point = [&] {
        const double x = double(random.below(size));
        return Point_2(x, double(random.below(size)));
      };
      const Point_2 a = point(), b = point(), c = point(), d = point();
      const bool expected = do_meet_by_CGAL(a, b, c, d);
      check_segments(a, b, c, d, expected);
      meeting += expected;
      degenerate += a == b || c == d;
    }
    EXPECT_GT(meeting, 600u);
    EXPECT_LT(meeting, 5400u);
    EXPECT_GT(degenerate, 10u);
  }
}

TEST(Do_segments_meet, of_collinear_segments)
{
  Random random(8);
  for (int k = 0; k < 5000; ++k) {
    const Vector_2 direction(double(random.below(7)) - 3, double(random.below(7)) - 3);
    const auto point = [&] { return Point_2(1, 2) + double(random.below(8)) * direction; };
    const Point_2 a = point(), b = point(), c = point(), d = point();
    check_segments(a, b, c, d, do_meet_by_CGAL(a, b, c, d));
  }
}

TEST(Do_segments_meet, of_touching_overlapping_and_disjoint_ones)
{
  const Point_2 o(0, 0), e(4, 0), middle(2, 0), north(2, 3), beyond(6, 0), far(9, 0);
  check_segments(o, e, middle, north, true);              // an end inside the other segment
  check_segments(o, e, e, north, true);                   // a common end
  check_segments(o, e, Point_2(2, -3), north, true);      // across
  check_segments(o, e, Point_2(2, least), north, false);  // just above
  check_segments(o, e, middle, beyond, true);             // collinear: overlapping, inside, touching, apart
  check_segments(o, far, middle, beyond, true);
  check_segments(o, e, e, beyond, true);
  check_segments(o, e, beyond, far, false);
  check_segments(o, e, o, e, true);
  check_segments(middle, middle, o, e, true);             // points
  check_segments(beyond, beyond, o, e, false);
  check_segments(north, north, o, e, false);
  check_segments(o, o, o, o, true);
  check_segments(o, o, e, e, false);
}

TEST(Do_segments_meet, of_ends_next_to_the_other_segment)
{
  Random random(9);
  std::size_t meeting = 0;
  for (int k = 0; k < 10000; ++k) {
    const Point_2 a = random_point_2(random), b = random_point_2(random), d = random_point_2(random);
    const Point_2 c = moved_by_ulps(a + random(-0.2, 1.2) * (b - a), 2, random);
    const bool expected = do_meet_by_CGAL(a, b, c, d);
    check_segments(a, b, c, d, expected);
    meeting += expected;
  }
  EXPECT_GT(meeting, 1000u);
  EXPECT_LT(meeting, 9000u);
}

} // namespace test_exact_predicates
