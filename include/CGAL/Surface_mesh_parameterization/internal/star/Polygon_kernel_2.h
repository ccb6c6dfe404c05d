// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_POLYGON_KERNEL_2_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_POLYGON_KERNEL_2_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The kernel of a chain of edges, the set of the points that lie to the left of all of them, as a convex polygon.
// It starts as a box and is clipped by one half-plane at a time (Sutherland and Hodgman), in doubles and relative to
// `origin`: whoever uses a point of it decides by exact predicates whether that point is good.
class Polygon_kernel_2
{
public:
  // Starts from the square around `origin` whose sides are `half_width` away.
  void reset(const Point_2& origin, double half_width)
  {
    m_origin = origin;
    m_polygon.assign({ { -half_width, -half_width },
                       { half_width, -half_width },
                       { half_width, half_width },
                       { -half_width, half_width } });
  }

  // Keeps what lies to the left of the line from a to b.
  void clip(const Point_2& a, const Point_2& b)
  {
    const Vector_2 from = a - m_origin, direction = b - a;
    const auto side = [&](const Vector_2& p) { return cross(direction, p - from); };

    m_clipped.clear();
    for (std::size_t i = 0; i < m_polygon.size(); ++i) {
      const Vector_2& p = m_polygon[i];
      const Vector_2& q = m_polygon[next_in_cycle(i, m_polygon.size())];
      const double side_p = side(p), side_q = side(q);
      if (side_p >= 0)
        m_clipped.push_back(p);
      if ((side_p > 0 && side_q < 0) || (side_p < 0 && side_q > 0))
        m_clipped.push_back(p + (side_p / (side_p - side_q)) * (q - p));
    }
    std::swap(m_polygon, m_clipped);
  }

  bool is_empty() const { return m_polygon.size() < 3; }

  // The centroid of the kernel's area, or of its corners where the area vanishes. Precondition: not empty.
  Point_2 centroid() const
  {
    double doubled_area = 0;
    Vector_2 moment(0, 0), sum(0, 0);
    const Vector_2& base = m_polygon.front();
    for (std::size_t i = 1; i + 1 < m_polygon.size(); ++i) {
      const Vector_2 p = m_polygon[i] - base, q = m_polygon[i + 1] - base;
      const double piece = cross(p, q);
      doubled_area += piece;
      moment = moment + (piece / 3) * (p + q);
    }
    const Vector_2 by_area = base + moment / doubled_area;
    if (doubled_area > 0 && std::isfinite(by_area.x()) && std::isfinite(by_area.y()))
      return m_origin + by_area;

    for (const Vector_2& p : m_polygon)
      sum = sum + p;
    return m_origin + sum / double(m_polygon.size());
  }

private:
  Point_2 m_origin;
  std::vector<Vector_2> m_polygon, m_clipped;   // corners relative to m_origin, counter-clockwise
};

// The centroid of the kernel of v's star. That of a border vertex is unbounded: it is clipped to the box that bounds
// the ring. `kernel` is scratch.
inline Point_2 kernel_centroid(const One_rings& rings, const std::vector<Point_2>& uv, Index v,
                               Polygon_kernel_2& kernel)
{
  const One_rings::Ring ring = rings[v];
  const Point_2& origin = uv[ring.front()];
  double half_width = 0;
  for (Index w : ring)
    half_width = (std::max)({ half_width, std::abs(uv[w].x() - origin.x()), std::abs(uv[w].y() - origin.y()) });
  kernel.reset(origin, half_width);
  for (std::size_t i = 0; i < rings.number_of_triangles(v); ++i)
    kernel.clip(uv[ring[i]], uv[ring[next_in_cycle(i, ring.size())]]);
  return kernel.is_empty() ? origin : kernel.centroid();
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_POLYGON_KERNEL_2_H
