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
  for (Index v = first_new; v < end; ++v)
    uv[v] = uv[hierarchy.kept_vertex(v)];

  // The vertices are independent of each other but on the border, where the angles involve two neighbors: it comes last.
  std::vector<bool> is_placed(end, true);
  for (Index v = first_new; v < end; ++v)
    is_placed[v] = !level.is_border(v);
  Vertex_inserter inserter(level.rings(), uv, is_placed);
  std::vector<Rest_corner> corners;
  for (const bool at_border : { false, true })
    for (Index v = first_new; v < end; ++v) {
      if (level.is_border(v) != at_border)
        continue;
      const Level::Ring ring = level.one_ring(v);
      corners.clear();
      for (std::size_t i = 0; i < level.rings().number_of_triangles(v); ++i)
        corners.push_back(rest_corner(level.point(v), level.point(ring[i]), level.point(ring[i + 1 == ring.size() ? 0 : i + 1])));
      if (!inserter.insert(v, corners.data(), hierarchy.parent_triangle(v), hierarchy.barycentric_coordinates(v)))
        return v;
      is_placed[v] = true;
    }
  return no_index;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_INSERT_NEW_VERTICES_H
