// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_INSERT_NEW_VERTICES_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_INSERT_NEW_VERTICES_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/levels/insert_new_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Vertex_inserter.h>

#include <algorithm>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Index insert_new_vertices(const Level& level, Level::Uv& uv, const Level::Uv* wanted)
{
  const Collapse_hierarchy_3& hierarchy = level.hierarchy();
  const Index first_new = Index(level.first_new_vertex()), end = Index(level.number_of_vertices());

  uv.resize(end);
  for (Index v = first_new; v < end; ++v)
    uv[v] = uv[hierarchy.kept_vertex(v)];

  // The vertices are independent of each other but on the border, where the angles involve two neighbors: it comes
  // last, one by one.
  std::vector<bool> is_placed(end, true);
  for (Index v = first_new; v < end; ++v)
    is_placed[v] = !level.is_border(v);

  const auto make_inserter = [&] { return Vertex_inserter(level.rings(), uv, is_placed); };
  const auto insert = [&](Index v, Vertex_inserter& inserter) {
    const Point_2* const place = wanted ? &(*wanted)[v] : level.is_fixed(v) ? &level.fixed_place(v) : nullptr;
    return (place && inserter.insert_at(v, *place)) ||
           inserter.insert(v, level.rest_corners(v), hierarchy.parent_triangle(v),
                           hierarchy.barycentric_coordinates(v));
  };
  const Index failed = level.loops().reduce_with_scratch(
      first_new, end, no_index, make_inserter,
      [&](Index block_begin, Index block_end, Vertex_inserter& inserter) {
        for (Index v = block_begin; v < block_end; ++v)
          if (!level.is_border(v) && !insert(v, inserter))
            return v;
        return no_index;
      },
      [](Index& first, Index v) { first = (std::min)(first, v); });
  if (failed != no_index)
    return failed;

  Vertex_inserter inserter = make_inserter();
  for (Index v = first_new; v < end; ++v)
    if (level.is_border(v)) {
      if (!insert(v, inserter))
        return v;
      is_placed[v] = true;
    }
  return no_index;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void insert_at_stored_places(const Level& level, Level::Uv& uv)
{
  const Collapse_hierarchy_3& hierarchy = level.hierarchy();
  uv.resize(level.number_of_vertices());
  level.loops().for_each(Index(level.first_new_vertex()), Index(level.number_of_vertices()), [&](Index v) {
    uv[v] = level.is_fixed(v) ? level.fixed_place(v)
                              : stored_place(uv, hierarchy.parent_triangle(v), hierarchy.barycentric_coordinates(v));
  });
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_INSERT_NEW_VERTICES_IMPL_H
