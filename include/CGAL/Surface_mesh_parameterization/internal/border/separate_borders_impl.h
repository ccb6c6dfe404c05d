// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_SEPARATE_BORDERS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_SEPARATE_BORDERS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/separate_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Vertex_inserter.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <algorithm>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The point of the coarse border edge that a new border vertex goes toward; `uv` is left as it was.
inline Point_2 point_of_coarse_edge(const Level& level, Level::Uv& uv, Index v)
{
  constexpr int most_halvings = 6;
  const Collapse_hierarchy_3& hierarchy = level.hierarchy();
  const Point_2 place = uv[v], kept = uv[hierarchy.kept_vertex(v)];
  const bool is_ear = level.number_of_triangles(v) == 1;
  Point_2 result = stored_place(uv, hierarchy.parent_triangle(v), hierarchy.barycentric_coordinates(v));
  bool is_valid = is_ear;
  for (int i = 0; i < most_halvings && !is_valid; ++i) {
    uv[v] = result;
    is_valid = is_star_valid(level.rings(), uv, v);
    if (!is_valid)
      result = CGAL::midpoint(kept, result);
  }
  uv[v] = place;
  return is_valid ? result : kept;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool separate_borders(const Level& level, Level::Uv& uv)
{
  constexpr int most_rounds = 45;
  constexpr double part_of_way = 0.4;
  const std::vector<Border_edge> edges = border_edges(level.rings());
  const std::size_t first_new = level.index() == 0 ? level.number_of_vertices() : level.first_new_vertex();
  for (int i = 0; i < most_rounds; ++i) {
    bool is_separate = true;
    std::vector<Index> to_move;
    for_each_crossing(edges, uv, [&](std::size_t e, std::size_t f) {
      is_separate = false;
      for (const Index v : { edges[e].source, edges[e].target, edges[f].source, edges[f].target })
        if (v >= first_new)
          to_move.push_back(v);
    });
    if (is_separate)
      return true;
    if (to_move.empty())
      return false;
    std::sort(to_move.begin(), to_move.end());
    to_move.erase(std::unique(to_move.begin(), to_move.end()), to_move.end());
    for (const Index v : to_move) {
      const Point_2 end = point_of_coarse_edge(level, uv, v);
      uv[v] = end + part_of_way * (uv[v] - end);
      if (!is_star_valid(level.rings(), uv, v))
        return false;
    }
  }
  return false;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_SEPARATE_BORDERS_IMPL_H
