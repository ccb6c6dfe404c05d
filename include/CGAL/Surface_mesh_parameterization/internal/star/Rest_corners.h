// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_REST_CORNERS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_REST_CORNERS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The shapes in space of the triangles around a vertex, seen from it, in the order of its ring. They are computed when
// they are asked for: to store them would take 144 bytes a vertex, to read them almost as long.
class Rest_corners
{
public:
  // The points and the ring are kept by reference.
  Rest_corners(const std::vector<Point_3>& points, const One_rings& rings, Index v)
    : m_points(points.data()), m_ring(rings[v]), m_vertex(v)
  { }

  Rest_corner operator[](std::size_t i) const
  {
    return rest_corner(m_points[m_vertex], m_points[m_ring[i]], m_points[m_ring[next_in_cycle(i, m_ring.size())]]);
  }

private:
  const Point_3* m_points;
  One_rings::Ring m_ring;
  Index m_vertex;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_REST_CORNERS_H
