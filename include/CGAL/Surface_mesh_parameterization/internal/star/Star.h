// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_STAR_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_STAR_H

#include <CGAL/Surface_mesh_parameterization/Distortion_derivatives_2.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The triangles around one vertex V with their opposite edges in the plane, and the sum of their energies as a function
// of the place of V. All is computed from differences to a triangle's own corner, so a small star far from the origin
// loses nothing.
template <class Energy>
class Star
{
public:
  struct Derivatives
  {
    double value, gradient[2], hessian[3];    // hessian: xx, xy, yy
  };

  // Gathers the star of v. `corners` are the rest shapes of its triangles, in the order of its ring; `unit_of_area` is
  // that of the energy, in the unit of theirs.
  template <class Corners>
  void gather(const One_rings& rings, const std::vector<Point_2>& uv, Index v, const Corners& corners,
              Triangle_weight weight, const Energy& energy = Energy(), double unit_of_area = 1)
  {
    const One_rings::Ring ring = rings[v];
    m_triangles.resize(rings.number_of_triangles(v));
    Point_2 a = uv[ring[0]];
    const Point_2 first = a;
    for (std::size_t i = 0; i < m_triangles.size(); ++i) {
      const Point_2 b = i + 1 == ring.size() ? first : uv[ring[i + 1]];
      const Vector_2 ab = b - a;
      const Rest_corner c = corners[i];
      const double determinant_scale = 0.5 * c.inverse_area;
      m_triangles[i] = { energy.of_area(1 / (unit_of_area * c.inverse_area)),
                         a,
                         ab,
                         c.foot * ab,
                         determinant_scale / c.height,
                         determinant_scale * c.height * ab.squared_length(),
                         determinant_scale,
                         weight == Triangle_weight::AREA ? 1 / c.inverse_area : 1. };
      a = b;
    }
  }

  struct Filtered_energy
  {
    double value;                // infinite unless all triangles are positive, if the energy keeps them so
    bool is_surely_positive;     // whether they are so beyond any rounding error
  };

  // The energy with V at p, and a filter that spares the exact predicates, except for stars that are almost flat.
  Filtered_energy filtered_energy(const Point_2& p) const
  {
    // A determinant of rounded differences is off by at most 4 * 2^-53 times the sum of its two products, unless these
    // underflow.
    constexpr double relative_error = 1e-14, least_determinant = 1e-280;
    double sum = 0, least_margin = 1;
    for (const Triangle& t : m_triangles) {
      const Vector_2 x = p - t.a, u = x - t.foot;
      const double plus = t.ab.x() * x.y(), minus = t.ab.y() * x.x(), doubled_area = plus - minus;
      if (Energy::is_flip_free && !(doubled_area > 0))
        return { (std::numeric_limits<double>::infinity)(), false };
      least_margin = (std::min)(least_margin, doubled_area - relative_error * (std::abs(plus) + std::abs(minus)));
      sum += t.weight *
             t.value(t.frobenius_scale * u.squared_length() + t.least_frobenius, t.determinant_scale * doubled_area);
    }
    return { sum, least_margin > least_determinant };
  }

  double energy(const Point_2& p) const { return filtered_energy(p).value; }

  // Value, gradient and Hessian with V at p. Precondition: all triangles are positive, if the energy keeps them so.
  Derivatives derivatives(const Point_2& p) const
  {
    Derivatives sum = { 0, { 0, 0 }, { 0, 0, 0 } };
    for (const Triangle& t : m_triangles) {
      const Vector_2 x = p - t.a, u = x - t.foot;
      const Distortion_derivatives_2 e = t.derivatives(t.frobenius_scale * u.squared_length() + t.least_frobenius,
                                                       t.determinant_scale * cross(t.ab, x));
      // Gradients of the two invariants: f of the squared Frobenius norm, whose Hessian is a multiple of the identity,
      // d of the determinant.
      const double fx = 2 * t.frobenius_scale * u.x(), fy = 2 * t.frobenius_scale * u.y();
      const double dx = -t.determinant_scale * t.ab.y(), dy = t.determinant_scale * t.ab.x();
      sum.value += t.weight * e.value;
      sum.gradient[0] += t.weight * (e.f * fx + e.d * dx);
      sum.gradient[1] += t.weight * (e.f * fy + e.d * dy);
      sum.hessian[0] += t.weight * (e.ff * fx * fx + 2 * e.fd * fx * dx + e.dd * dx * dx + 2 * t.frobenius_scale * e.f);
      sum.hessian[1] += t.weight * (e.ff * fx * fy + e.fd * (fx * dy + fy * dx) + e.dd * dx * dy);
      sum.hessian[2] += t.weight * (e.ff * fy * fy + 2 * e.fd * fy * dy + e.dd * dy * dy + 2 * t.frobenius_scale * e.f);
    }
    return sum;
  }

  // The length of the step from p, in multiples of `direction`, at which the first triangle vanishes; infinite if none
  // does.
  double longest_step(const Point_2& p, const Vector_2& direction) const
  {
    double longest = (std::numeric_limits<double>::infinity)();
    for (const Triangle& t : m_triangles) {
      const double now = cross(t.ab, p - t.a), change = cross(t.ab, direction);
      if (change < 0)
        longest = (std::min)(longest, -now / change);
    }
    return longest;
  }

private:
  struct Triangle : Energy
  {
    Point_2 a;
    Vector_2 ab, foot;              // relative to a
    double frobenius_scale;         // squared Frobenius norm = frobenius_scale |v - a - foot|^2 + least_frobenius
    double least_frobenius;
    double determinant_scale;       // determinant = determinant_scale cross(ab, v - a)
    double weight;
  };

  std::vector<Triangle> m_triangles;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_STAR_H
