// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_FLAT_POINTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_FLAT_POINTS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <CGAL/boost/graph/properties.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The points of vertices of a mesh, in doubles.
template <class TriangleMesh, class Vertex>
std::vector<Point_3> flat_points(const TriangleMesh& mesh, const std::vector<Vertex>& vertices)
{
  const auto point_map = get(CGAL::vertex_point, mesh);
  std::vector<Point_3> points;
  points.reserve(vertices.size());
  for (const Vertex& v : vertices)
    points.push_back(to_point_3(get(point_map, v)));
  return points;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_FLAT_POINTS_H
