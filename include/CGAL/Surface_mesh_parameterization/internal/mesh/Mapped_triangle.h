// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_MAPPED_TRIANGLE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_MAPPED_TRIANGLE_H

#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>

#include <CGAL/Origin.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal {

// A triangle in space and its image in the plane.
struct Mapped_triangle
{
  std::array<Point_3, 3> points;
  std::array<Point_2, 3> uv;

  Mapped_triangle(const std::array<Point_3, 3>& points, const std::array<Point_2, 3>& uv) : points(points), uv(uv) { }

  template <class Face, class TriangleMesh, class VertexUVMap>
  Mapped_triangle(Face f, const TriangleMesh& mesh, VertexUVMap uvmap)
  {
    const auto point_map = get(CGAL::vertex_point, mesh);
    int i = 0;
    for (const auto v : vertices_around_face(halfedge(f, mesh), mesh)) {
      points[i] = to_point_3(get(point_map, v));
      uv[i++] = to_point_2(get(uvmap, v));
    }
  }

  bool is_finite() const
  {
    return std::all_of(uv.begin(), uv.end(), [](const Point_2& p) { return internal::is_finite(p); });
  }
};

// The powers of two that bring the longest edges of some triangles, and of their images, to about length 1. Measures
// that know no scale do not feel them, and no product of lengths over- or underflows then.
class Unit_scale
{
public:
  void include(const Mapped_triangle& t)
  {
    for (int i = 0; i < 3; ++i) {
      const Vector_3 edge = t.points[(i + 1) % 3] - t.points[i];
      const Vector_2 image = t.uv[(i + 1) % 3] - t.uv[i];
      m_longest = (std::max)({ m_longest, std::abs(edge.x()), std::abs(edge.y()), std::abs(edge.z()) });
      m_longest_image = (std::max)({ m_longest_image, std::abs(image.x()), std::abs(image.y()) });
    }
  }

  // The triangle so scaled, with its first corner at the origin.
  Mapped_triangle operator()(const Mapped_triangle& t) const
  {
    const int k = exponent(m_longest), l = exponent(m_longest_image);
    Mapped_triangle result = t;
    for (int i = 0; i < 3; ++i) {
      result.points[i] = times_power_of_two(CGAL::ORIGIN + (t.points[i] - t.points[0]), k);
      result.uv[i] = times_power_of_two(CGAL::ORIGIN + (t.uv[i] - t.uv[0]), l);
    }
    return result;
  }

private:
  static int exponent(double longest) { return longest > 0 && std::isfinite(longest) ? -std::ilogb(longest) : 0; }

  double m_longest = 0, m_longest_image = 0;
};

// What the singular values s1 >= s2 of the map of a triangle are functions of.
struct Map_invariants
{
  double frobenius;       // s1^2 + s2^2
  double determinant;     // s1 s2
  double area;            // of the triangle in space

  // Triangle and image are scaled by one power of two first, which changes nothing but keeps products of lengths
  // representable.
  explicit Map_invariants(const Mapped_triangle& t)
  {
    const Vector_3 p = t.points[1] - t.points[0], q = t.points[2] - t.points[0];
    double longest = 0;
    for (int i = 0; i < 3; ++i)
      longest = (std::max)({ longest, std::abs(p[i]), std::abs(q[i]) });
    const int exponent = longest > 0 ? std::ilogb(longest) : 0;
    const auto scaled = [&](const auto& vector) { return times_power_of_two(CGAL::ORIGIN + vector, -exponent); };

    const Rest_corner c = rest_corner(Point_3(0, 0, 0), scaled(p), scaled(q));
    const Point_2 a(0, 0), b = scaled(t.uv[2] - t.uv[1]), v = scaled(t.uv[0] - t.uv[1]);
    frobenius = c.squared_frobenius_norm(v, a, b);
    determinant = c.determinant(v, a, b);
    area = std::ldexp(1 / c.inverse_area, 2 * exponent);
  }

  double greatest_singular_value() const
  {
    return std::sqrt(
        0.5 * (frobenius + std::sqrt((std::max)(0., (frobenius - 2 * determinant) * (frobenius + 2 * determinant)))));
  }

  // (s1/s2 + s2/s1) / 2
  double angle_distortion() const { return 0.5 * frobenius / determinant; }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_MAPPED_TRIANGLE_H
