// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_FIXED_VERTICES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_FIXED_VERTICES_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Whether a map of a level is free until it is done, because a motion of the plane can bring it to the places that are
// given; or a similarity where scales do not matter. So it is if no place of a vertex is wished for, and one at most is
// given, or two.
inline bool is_free(const Level& level, bool is_scale_invariant)
{
  const auto& places = level.hierarchy().fixed_places();
  const bool has_scale = places.size() == 2 && places[0].second != places[1].second;
  return level.hierarchy().springs().empty() && (places.size() <= 1 || (is_scale_invariant && has_scale));
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

// Those of them that have to be held while a map is refined.
inline std::vector<Index> held_vertices(const Level& level, bool is_scale_invariant)
{
  return is_free(level, is_scale_invariant) ? std::vector<Index>() : fixed_vertices(level);
}

// The vertices with given places that are not there.
inline std::vector<Index> displaced_vertices(const Level& level, const Level::Uv& uv)
{
  std::vector<Index> result;
  for (const auto& [v, place] : level.hierarchy().fixed_places())
    if (v < level.number_of_vertices() && uv[v] != place)
      result.push_back(v);
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_FIXED_VERTICES_H
