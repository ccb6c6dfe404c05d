// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_SETTLE_FLIPS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_SETTLE_FLIPS_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Map_repair.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Whether a map has no flips, or its mirror image has none.
inline bool has_no_flips(const One_rings& rings, const std::vector<Point_2>& uv, const Loops& loops = Loops())
{
  if (!std::all_of(uv.begin(), uv.end(), is_finite))
    return false;
  if (is_map_valid(rings, uv, loops))
    return true;
  std::vector<Point_2> mirrored;
  for (const Point_2& p : uv)
    mirrored.emplace_back(-p.x(), p.y());
  return is_map_valid(rings, mirrored, loops);
}

// The triangles that are turned the other way than most, are degenerate, or have a coordinate that is no number.
inline std::size_t number_of_flips(const std::vector<Index_triangle>& triangles, const std::vector<Point_2>& uv)
{
  std::size_t left = 0, right = 0;
  for (const Index_triangle& t : triangles) {
    if (!is_finite(uv[t[0]]) || !is_finite(uv[t[1]]) || !is_finite(uv[t[2]]))
      continue;
    const Orientation turn = orientation(uv[t[0]], uv[t[1]], uv[t[2]]);
    left += turn == LEFT_TURN;
    right += turn == RIGHT_TURN;
  }
  return triangles.size() - (std::max)(left, right);
}

// Makes a map with flips, given by the surface's points, free of them, and counts the vertices that were moved.
inline Error_code repair_map(const Triangulated_surface_3& surface, std::vector<Point_2>& uv, std::size_t& moved_vertices, unsigned int seed = 0)
{
  // As coarse as possible: there Tutte's map has surely no flip, if a start is needed.
  constexpr std::size_t coarsest_size = 4;
  constexpr unsigned int most_seeds = 3;
  const Collapse_hierarchy_3 hierarchy(surface, parameters::coarsest_size(coarsest_size).random_seed(seed));
  std::vector<Point_2> map(uv.size()), repaired;
  for (Index rank = 0; rank < map.size(); ++rank)
    map[rank] = uv[hierarchy.input_vertex(rank)];
  const Error_code status = Map_repair(hierarchy, map).run(repaired);
  if (status != OK)   // doubles left no room for a vertex; in another hierarchy they may
    return ++seed < most_seeds ? repair_map(surface, uv, moved_vertices, seed) : status;
  moved_vertices = 0;
  for (Index rank = 0; rank < map.size(); ++rank)
    if (repaired[rank] != map[rank]) {
      uv[hierarchy.input_vertex(rank)] = repaired[rank];
      ++moved_vertices;
    }
  return OK;
}

// Does with the flips of a map what the policy says. `triangles` and `rings` are those of the surface that `make_surface()` makes, if it is needed.
template <class Make_surface>
Error_code settle_flips(const std::vector<Index_triangle>& triangles, const One_rings& rings, const Make_surface& make_surface, Flip_policy policy,
                        std::vector<Point_2>& uv, Parameterization_summary& summary)
{
  if (policy == Flip_policy::KEEP || has_no_flips(rings, uv))
    return OK;
  summary.flips = number_of_flips(triangles, uv);
  if (policy == Flip_policy::FAIL)
    return ERROR_NO_1_TO_1_MAPPING;
  const Error_code status = repair_map(make_surface(), uv, summary.moved_vertices);
  return status != OK || has_no_flips(rings, uv) ? status : ERROR_NO_1_TO_1_MAPPING;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_SETTLE_FLIPS_H
