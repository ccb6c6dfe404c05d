// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_LEVEL_TRIANGLES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_LEVEL_TRIANGLES_H

#include <CGAL/Surface_mesh_parameterization/Level.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// Calls f(a, b, i) for the triangles vab around v, the i-th ones, of which v is the least vertex: so a loop over the
// vertices meets every triangle once.
template <class Function>
void for_each_triangle_of_least_vertex(const Level& level, Index v, const Function& f)
{
  const Level::Ring ring = level.one_ring(v);
  for (std::size_t i = 0; i < level.rings().number_of_triangles(v); ++i) {
    const Index a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (v < a && v < b)
      f(a, b, i);
  }
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_LEVEL_TRIANGLES_H
