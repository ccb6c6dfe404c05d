// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_REST_CORNERS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_REST_CORNERS_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/Rest_triangle.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// Writes the rest shapes of the triangles around v, seen from v, in the order of its ring.
template <class OutputIterator>
void rest_corners(const Level& level, Index v, OutputIterator out)
{
  const Level::Ring ring = level.one_ring(v);
  for (std::size_t i = 0; i < level.rings().number_of_triangles(v); ++i)
    *out++ = rest_corner(level.point(v), level.point(ring[i]), level.point(ring[i + 1 == ring.size() ? 0 : i + 1]));
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_REST_CORNERS_H
