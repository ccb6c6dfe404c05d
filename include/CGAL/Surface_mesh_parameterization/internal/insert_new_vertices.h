// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_INSERT_NEW_VERTICES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_INSERT_NEW_VERTICES_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/Vertex_inserter.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Inserts the new vertices of a level (Hormann, Greiner, Campagna 1999, step 2b) into a flip-free map of the next coarser level and keeps
// it flip-free. Returns the first vertex for which no place was found, `no_index` if there is none.
inline Index insert_new_vertices(const Level& level, Level::Uv& uv)
{
  const Collapse_hierarchy_3& hierarchy = level.hierarchy();
  const Index first_new = Index(level.first_new_vertex()), end = Index(level.number_of_vertices());

  uv.resize(end);
  for (Index v = first_new; v < end; ++v) {
    const Index_triangle& parent = hierarchy.parent_triangle(v);
    const std::array<double, 3> c = hierarchy.barycentric_coordinates(v);
    uv[v] = uv[parent[0]] + c[1] * (uv[parent[1]] - uv[parent[0]]) + c[2] * (uv[parent[2]] - uv[parent[0]]);
  }

  // The new vertices are independent, but the angles at a border vertex involve both of its border neighbors: these still stand on
  // their coarse border edges, where they leave the angles as they were, until all others have their places.
  Vertex_inserter inserter;
  std::vector<Rest_corner> corners;
  for (const bool at_border : { false, true })
    for (Index v = first_new; v < end; ++v) {
      if (level.is_border(v) != at_border)
        continue;
      const Level::Ring ring = level.one_ring(v);
      corners.clear();
      for (std::size_t i = 0; i < level.rings().number_of_triangles(v); ++i)
        corners.push_back(rest_corner(level.point(v), level.point(ring[i]), level.point(ring[i + 1 == ring.size() ? 0 : i + 1])));
      if (!inserter.insert(level.rings(), v, corners.data(), hierarchy.parent_triangle(v), uv))
        return v;
    }
  return no_index;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_INSERT_NEW_VERTICES_H
