// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_REST_TRIANGLE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_REST_TRIANGLE_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal {

// The rest shape of a triangle (its shape in space, before it is mapped), seen from its corner V over the opposite edge
// AB:
//
//              V
//             /|\           foot    where the height from V meets AB, in lengths of AB: 0 at A, 1 at B
//            / | \          height  the length of that height, in lengths of AB
//           /  |  \         inverse_area  1 / area, of the triangle in space
//          A---+---B
//
// With a, b, v the images in the plane, the squared Frobenius norm of the map is quadratic and its determinant linear
// in v:
//
//     area (s1^2 + s2^2) = |v - (a + foot ab)|^2 / (2 height) + height |ab|^2 / 2,   area s1 s2 = cross(ab, v - a) / 2.
struct Rest_corner
{
  double foot, height, inverse_area;

  // The place of V that makes the image similar to the rest shape.
  Point_2 similar_apex(const Point_2& a, const Point_2& b) const
  {
    const Vector_2 ab = b - a;
    return a + Vector_2(foot * ab.x() - height * ab.y(), foot * ab.y() + height * ab.x());
  }

  // Of the map, s1^2 + s2^2 and s1 s2.
  double squared_frobenius_norm(const Point_2& v, const Point_2& a, const Point_2& b) const
  {
    const Vector_2 ab = b - a, from_foot = (v - a) - foot * ab;
    return 0.5 * inverse_area * (from_foot.squared_length() / height + height * ab.squared_length());
  }
  double determinant(const Point_2& v, const Point_2& a, const Point_2& b) const
  {
    return 0.5 * inverse_area * cross(b - a, v - a);
  }

  double cotangent_at_a() const { return foot / height; }
  double cotangent_at_b() const { return (1 - foot) / height; }
  double cotangent_at_v() const { return (height * height - foot * (1 - foot)) / height; }

  // The length of AB in space, and of the edges from V.
  double base() const { return std::sqrt(2 / (inverse_area * height)); }
  double length_to_a() const { return base() * std::sqrt(foot * foot + height * height); }
  double length_to_b() const { return base() * std::sqrt((1 - foot) * (1 - foot) + height * height); }
};

// The lowest height of a rest shape, in lengths of its longest edge: a triangle that is lower is raised to it. One with
// two corners at one place gets a short edge there, and one whose corners all coincide is taken for a small equilateral
// one. So distortion is always measured against a shape that exists, also where a part of the surface is a point.
constexpr double lowest_rest_height = 1e-6;

// The corners of the rest shape of any triangle pqr; entry i looks from corner i over the edge from corner i+1 to i+2.
// Precondition: the mesh was scaled to about size 1.
inline std::array<Rest_corner, 3> rest_corners(const Point_3& p, const Point_3& q, const Point_3& r)
{
  constexpr double least_squared_length = 1e-60, squared_length_at_a_point = 1e-8,
                   short_edge = 1e-4;         // in lengths of the longest one

  const std::array<const Point_3*, 3> corner = { &p, &q, &r };
  std::array<double, 3> squared_length;   // of the edge opposite to each corner
  for (int i = 0; i < 3; ++i)
    squared_length[i] = CGAL::squared_distance(*corner[(i + 1) % 3], *corner[(i + 2) % 3]);

  const int top = int(std::max_element(squared_length.begin(), squared_length.end()) - squared_length.begin());
  const double base2 = squared_length[top];
  double foot = 0.5, height = std::sqrt(0.75);
  if (base2 > least_squared_length) {
    const Vector_3 base = *corner[(top + 2) % 3] - *corner[(top + 1) % 3];
    const Vector_3 side = *corner[top] - *corner[(top + 1) % 3];
    foot = (base * side) / base2;
    height = (std::max)(std::sqrt(CGAL::cross_product(base, side).squared_length()) / base2, lowest_rest_height);
    if (*std::min_element(squared_length.begin(), squared_length.end()) <= least_squared_length) {
      // With two long edges of one length, whichever of them is the base.
      foot = foot < 0.5 ? 0.5 * short_edge * short_edge : 1 - 0.5 * short_edge * short_edge;
      height = short_edge;
    }
  }
  const double inverse_area = 2 / (height * (base2 > least_squared_length ? base2 : squared_length_at_a_point));

  // In lengths of the longest edge AB: A = (0,0), B = (1,0), V = (foot, height).
  const double left2 = foot * foot + height * height, right2 = (1 - foot) * (1 - foot) + height * height;
  std::array<Rest_corner, 3> result;
  result[top] = { foot, height, inverse_area };
  result[(top + 1) % 3] = { (1 - foot) / right2, height / right2, inverse_area };
  result[(top + 2) % 3] = { (height * height - foot * (1 - foot)) / left2, height / left2, inverse_area };
  return result;
}

// Whether a triangle, with the square of its longest edge, is so flat that its height is raised.
inline bool is_height_raised(double doubled_area, double longest2)
{
  return !(doubled_area > lowest_rest_height * longest2);
}

// The corner of one vertex v of the triangle vab; faster where no height has to be raised.
inline Rest_corner rest_corner(const Point_3& v, const Point_3& a, const Point_3& b)
{
  const Vector_3 base = b - a, side = v - a;
  const double base2 = base.squared_length(), side2 = side.squared_length(), along = base * side;
  const double doubled_area = std::sqrt(CGAL::cross_product(base, side).squared_length());
  const double longest2 = (std::max)({ base2, side2, base2 + side2 - 2 * along });
  if (is_height_raised(doubled_area, longest2))
    return rest_corners(v, a, b)[0];
  const double inverse = 1 / base2;
  return { along * inverse, doubled_area * inverse, 2 / doubled_area };
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_REST_TRIANGLE_H
