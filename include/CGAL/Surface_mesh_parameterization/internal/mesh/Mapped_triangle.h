// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_MAPPED_TRIANGLE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_MAPPED_TRIANGLE_H

#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>

#include <CGAL/Origin.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Surface_mesh_parameterization::internal {

// A triangle in space and its image in the plane.
struct Mapped_triangle
{
  std::array<Point_3, 3> points;
  std::array<Point_2, 3> uv;

  Mapped_triangle(const std::array<Point_3, 3>& points, const std::array<Point_2, 3>& uv) : points(points), uv(uv) { }

  // Face f with its image, by a map from vertices or from halfedges. A face that is no triangle is nowhere.
  template <class Face, class TriangleMesh, class UVMap>
  Mapped_triangle(Face f, const TriangleMesh& mesh, UVMap uvmap)
  {
    const auto point_map = get(CGAL::vertex_point, mesh);
    std::size_t i = 0;
    for (const auto h : halfedges_around_face(halfedge(f, mesh), mesh)) {
      if (i < 3) {
        points[i] = to_point_3(get(point_map, target(h, mesh)));
        if constexpr (Readable_uv_map_check<UVMap, TriangleMesh>::value)
          uv[i] = to_point_2(get(uvmap, target(h, mesh)));
        else
          uv[i] = to_point_2(get(uvmap, h));
      }
      ++i;
    }
    if (i != 3)
      uv.fill(nowhere());
  }

  bool is_finite() const
  {
    return std::all_of(uv.begin(), uv.end(), [](const Point_2& p) { return internal::is_finite(p); });
  }
};

// The exponents of the powers of two that are about the lengths of the longest edges of some triangles, and of their
// images.
class Unit_scale
{
public:
  void include(const Mapped_triangle& t)
  {
    if (!t.is_finite())
      return;
    for (int i = 0; i < 3; ++i) {
      const Vector_3 edge = t.points[(i + 1) % 3] - t.points[i];
      const Vector_2 image = t.uv[(i + 1) % 3] - t.uv[i];
      m_longest = (std::max)({ m_longest, std::abs(edge.x()), std::abs(edge.y()), std::abs(edge.z()) });
      m_longest_image = (std::max)({ m_longest_image, std::abs(image.x()), std::abs(image.y()) });
    }
  }

  int exponent() const { return exponent(m_longest); }
  int exponent_of_image() const { return exponent(m_longest_image); }
  bool is_point() const { return m_longest == 0; }

private:
  static int exponent(double longest) { return longest > 0 && std::isfinite(longest) ? std::ilogb(longest) : 0; }

  double m_longest = 0, m_longest_image = 0;
};

// What the singular values s1 >= s2 of the map of a triangle, or of its mirror image, are functions of. Triangle and
// image are each brought to about length 1, and the powers of two come back last: a measure of any triangle over- or
// underflows only where no double is near its value.
class Map_invariants
{
public:
  // Lengths are in units of a scale, as that of the surface.
  explicit Map_invariants(const Mapped_triangle& t, const Unit_scale& unit = Unit_scale())
  {
    Unit_scale own;
    own.include(t);
    m_size = own.is_point() ? 0 : own.exponent() - unit.exponent();
    m_size_of_image = own.exponent_of_image() - unit.exponent_of_image();
    const auto scaled = [&](const Vector_3& edge) { return times_power_of_two(CGAL::ORIGIN + edge, -own.exponent()); };
    const auto scaled_image = [&](const Vector_2& edge) {
      return times_power_of_two(CGAL::ORIGIN + edge, -own.exponent_of_image());
    };
    const Rest_corner c =
        rest_corner(Point_3(0, 0, 0), scaled(t.points[1] - t.points[0]), scaled(t.points[2] - t.points[0]));
    const Point_2 a(0, 0), b = scaled_image(t.uv[2] - t.uv[1]), v = scaled_image(t.uv[0] - t.uv[1]);
    m_frobenius = c.squared_frobenius_norm(v, a, b);
    m_determinant = 0.5 * c.inverse_area * doubled_area_of_image(t, v, b, own.exponent_of_image());
    m_area = 1 / c.inverse_area;
  }

  double area() const { return std::ldexp(m_area, 2 * m_size); }
  double area_of_image() const { return std::ldexp(m_area * m_determinant, 2 * m_size_of_image); }

  // s1/s2 + s2/s1
  double mips() const
  {
    return m_determinant > 0 ? m_frobenius / m_determinant : (std::numeric_limits<double>::infinity)();
  }

  // 1/s2: Sander's greatest stretch
  double greatest_stretch() const
  {
    const double root = std::sqrt(m_frobenius + 2 * m_determinant) +
                        std::sqrt((std::max)(0., m_frobenius - 2 * m_determinant));       // 2 s1
    return std::ldexp(0.5 * root / m_determinant, m_size - m_size_of_image);
  }

  // Times the area: s1^2 + s2^2, 1/s1^2 + 1/s2^2, (s1/s2 + s2/s1) / 2, and 1/(s1 s2).
  double dirichlet() const { return std::ldexp(m_area * m_frobenius, 2 * m_size_of_image); }
  double inverse_dirichlet() const { return scaled_inverse(m_area / m_determinant * (m_frobenius / m_determinant)); }
  double angle() const { return std::ldexp(m_area * 0.5 * mips(), 2 * m_size); }
  double inverse_determinant() const { return scaled_inverse(m_area / m_determinant); }

private:
  // With the images of two edges from one corner, in units of 2^exponent. Of an image so slender that rounding matters
  // the area is computed exactly.
  static double doubled_area_of_image(const Mapped_triangle& t, const Point_2& v, const Point_2& b, int exponent)
  {
    constexpr double least_part = 1e-6;
    constexpr int greatest_exponent = 1000;
    const double plus = b.x() * v.y(), minus = b.y() * v.x(), area = std::abs(plus - minus);
    const bool is_precise = area > least_part * (std::abs(plus) + std::abs(minus)) ||
                            std::abs(exponent) > greatest_exponent || !t.is_finite();
    return is_precise ? area : std::abs(exact_doubled_area(t.uv[1], t.uv[2], t.uv[0], exponent));
  }

  double scaled_inverse(double value) const { return std::ldexp(value, 4 * m_size - 2 * m_size_of_image); }

  double m_frobenius, m_determinant, m_area;
  int m_size, m_size_of_image;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_MAPPED_TRIANGLE_H
