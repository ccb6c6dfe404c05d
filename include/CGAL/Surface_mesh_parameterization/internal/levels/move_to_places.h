// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MOVE_TO_PLACES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MOVE_TO_PLACES_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/vertex_order.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/best_similarity.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Moves a map of the finest level to the places of one vertex of the input or two: by a motion of the plane, or by a
// similarity. The result is rounded if `round` is not null. Far away, where doubles are coarse, vertices may have to go
// to the middle of their stars.
//
// Returns whether the map is still valid, and its borders do not cross if `borders_must_not_meet`, where both was so
// before; if not, it stays where it was.
inline bool move_to_places(const Level& level, const std::vector<Triangulated_surface_3::Fixed_vertex>& fixed_vertices,
                           Round_coordinate round, bool borders_must_not_meet, Level::Uv& uv)
{
  std::vector<std::pair<Index, Point_2>> places;      // by rank
  std::vector<Wanted_move> moves;
  for (const Triangulated_surface_3::Fixed_vertex& fixed : fixed_vertices) {
    places.push_back({ rank_of(level.hierarchy(), fixed.vertex), fixed.place });
    moves.push_back({ uv[places.back().first], fixed.place });
  }
  const Similarity_2 similarity = best_similarity(moves);
  Level::Uv moved(uv.size());
  level.for_each_vertex([&](Index v) { moved[v] = similarity(uv[v]); });
  const auto hold = [&] {
    for (const auto& [v, place] : places)
      moved[v] = place;
  };
  const auto is_valid = [&](const Level::Uv& map) { return is_map_valid(level.rings(), map, level.loops()); };
  const auto crosses_itself = [&](const Level::Uv& map) { return has_crossings(level.rings(), map); };

  hold();
  if (is_valid(uv)) {
    if (round || !is_valid(moved)) {
      const Round_coordinate to_doubles = [](double x, int) { return x; };
      round_map(level.rings(), round ? round : to_doubles, level.scale_exponent(), moved, level.loops());
      hold();
    }
    if (!is_valid(moved) || (borders_must_not_meet && !crosses_itself(uv) && crosses_itself(moved)))
      return false;
  }
  uv.swap(moved);
  return true;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MOVE_TO_PLACES_H
