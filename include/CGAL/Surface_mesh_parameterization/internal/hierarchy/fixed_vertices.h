// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_FIXED_VERTICES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_FIXED_VERTICES_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Whether a map of a level is free to move and turn as a whole: whether no place of a vertex is given or wished for.
inline bool is_free(const Level& level)
{
  return level.hierarchy().fixed_places().empty() && level.hierarchy().springs().empty();
}

// The vertices of a level whose places are given, in ascending order.
inline std::vector<Index> fixed_vertices(const Level& level)
{
  std::vector<Index> result;
  for (const auto& [v, place] : level.hierarchy().fixed_places())
    if (v < level.number_of_vertices())
      result.push_back(v);
  return result;
}

// Those of them that are not at their places.
inline std::vector<Index> displaced_vertices(const Level& level, const Level::Uv& uv)
{
  std::vector<Index> result;
  for (const auto& [v, place] : level.hierarchy().fixed_places())
    if (v < level.number_of_vertices() && uv[v] != place)
      result.push_back(v);
  return result;
}

// The springs that pull at vertices of a level.
inline std::vector<Triangulated_surface_3::Spring> springs_of(const Level& level)
{
  const std::vector<Triangulated_surface_3::Spring>& all = level.hierarchy().springs();
  const auto end = std::lower_bound(all.begin(), all.end(), level.number_of_vertices(),
                                    [](const auto& s, std::size_t v) { return s.vertex < v; });
  return { all.begin(), end };
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_FIXED_VERTICES_H
