// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_UNIT_EDGE_METRIC_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_UNIT_EDGE_METRIC_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/prefetch.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Ring_mesh.h>

#include <boost/config.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The metric in which the edges of a mesh are as equally long as one metric for each vertex can make them. In it, and
// not in space, the matrix of uniform weights is a Laplacian: sum_j (u_i - u_j)^2 = grad u . D grad u with D = sum_j
// e_ij e_ij^T, and the metric is the inverse of that diffusion tensor D. Coarse triangles that are round in it keep the
// coarse matrices isotropic, as the smoother needs them.
class Unit_edge_metric
{
public:
  Unit_edge_metric(const std::vector<Point_3>& points, const Ring_mesh& mesh)
  {
    m_tensors.resize(points.size());
    for (Index v = 0; v < points.size(); ++v)
      for (const Index w : mesh[v])
        add_edge(m_tensors[v], points[w] - points[v]);
  }

  BOOST_FORCEINLINE void prefetch_vertex(Index v) const { prefetch(&m_tensors[v]); }

  // Turns the ring of V, laid flat around the origin, from the metric of space into this one, up to a scale. A star
  // without width stays as it is.
  void transform(Index v, const Point_3& point, const std::vector<Point_3>& ring_points,
                 std::vector<Vector_2>& flat_ring) const
  {
    // The vectors in space that the axes of the plane stand for, by least squares.
    Vector_3 sum_x(0, 0, 0), sum_y(0, 0, 0);
    double xx = 0, xy = 0, yy = 0;
    for (std::size_t i = 0; i < flat_ring.size(); ++i) {
      const Vector_2& w = flat_ring[i];
      const Vector_3 edge = ring_points[i] - point;
      sum_x += w.x() * edge;
      sum_y += w.y() * edge;
      xx += w.x() * w.x();
      xy += w.x() * w.y();
      yy += w.y() * w.y();
    }
    const Vector_3 axis_x = yy * sum_x - xy * sum_y, axis_y = xx * sum_y - xy * sum_x;

    // The plane's D = ((a, b), (b, c)), whose square root is D + sqrt(det D) I, up to a scale.
    const Vector_3 d_axis_x = times(m_tensors[v], axis_x);
    double a = d_axis_x * axis_x, b = d_axis_x * axis_y, c = times(m_tensors[v], axis_y) * axis_y;
    constexpr double least_squared_width = 1e-6;
    const double determinant = a * c - b * b;
    if (!(determinant > least_squared_width * (a + c) * (a + c)))
      return;
    a += std::sqrt(determinant);
    c += std::sqrt(determinant);
    const double scale = 1 / (a + c);
    for (Vector_2& w : flat_ring)
      w = Vector_2(scale * (c * w.x() - b * w.y()), scale * (a * w.y() - b * w.x()));
  }

  // A vertex keeps its metric on every level.
  void compact(const std::vector<unsigned char>& is_removed)
  {
    std::size_t kept = 0;
    for (std::size_t v = 0; v < m_tensors.size(); ++v)
      if (!is_removed[v])
        m_tensors[kept++] = m_tensors[v];
    m_tensors.resize(kept);
  }

private:
  typedef std::array<float, 6>   Tensor;       // symmetric: xx, xy, xz, yy, yz, zz

  static void add_edge(Tensor& t, const Vector_3& e)
  {
    const float x = float(e.x()), y = float(e.y()), z = float(e.z());
    t[0] += x * x;
    t[1] += x * y;
    t[2] += x * z;
    t[3] += y * y;
    t[4] += y * z;
    t[5] += z * z;
  }

  static Vector_3 times(const Tensor& t, const Vector_3& e)
  {
    return Vector_3(t[0] * e.x() + t[1] * e.y() + t[2] * e.z(), t[1] * e.x() + t[3] * e.y() + t[4] * e.z(),
                    t[2] * e.x() + t[4] * e.y() + t[5] * e.z());
  }

  std::vector<Tensor> m_tensors;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_UNIT_EDGE_METRIC_H
