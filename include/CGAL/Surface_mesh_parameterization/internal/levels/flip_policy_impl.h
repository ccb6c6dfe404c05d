// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FLIP_POLICY_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FLIP_POLICY_IMPL_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/vertex_order.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Map_repair.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Patch_repair.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/place_in_the_middle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

inline std::vector<Point_2> mirrored(std::vector<Point_2> uv)
{
  mirror(uv);
  return uv;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool has_no_flips(const One_rings& rings, const std::vector<Point_2>& uv, const Loops& loops)
{
  if (!are_finite(uv))
    return false;
  return is_map_valid(rings, is_mirrored_if_valid(rings, uv) ? mirrored(uv) : uv, loops);
}

// How many triangles are turned to the left, and to the right. The others are degenerate, or have a coordinate that is
// no number.
struct Numbers_of_turns
{
  std::size_t left = 0, right = 0, all = 0;
};

inline Numbers_of_turns count_turns(const One_rings& rings, const std::vector<Point_2>& uv)
{
  Numbers_of_turns result;
  for (Index v = 0; v < uv.size(); ++v)
    rings.for_each_triangle_of_least_vertex(v, [&](Index a, Index b, std::size_t) {
      ++result.all;
      if (!is_finite(uv[v]) || !is_finite(uv[a]) || !is_finite(uv[b]))
        return;
      const Orientation turn = exact_orientation(uv[v], uv[a], uv[b]);
      result.left += turn == LEFT_TURN;
      result.right += turn == RIGHT_TURN;
    });
  return result;
}

// The vertices whose triangles do not wind around them once, in a map whose triangles are turned alike.
inline std::size_t count_windings(const One_rings& rings, const std::vector<Point_2>& uv, bool is_mirrored)
{
  const std::vector<Point_2> map = is_mirrored ? mirrored(uv) : uv;
  std::size_t result = 0;
  for (Index v = 0; v < map.size(); ++v)
    result += !is_fan_valid(rings, map, v);
  return result;
}

// Whether a map is that of a mirrored surface, but for flips. Where no two border edges cross, the border around all
// others tells: no map without flips has it the other way around. Else it is what most triangles are.
inline bool is_mostly_mirrored(const One_rings& rings, const std::vector<Point_2>& uv, const Numbers_of_turns& turns)
{
  double greatest = 0, sum = 0;      // of what borders enclose, negative if they are clockwise; doubled
  for (const std::vector<Index>& border : rings.borders()) {
    std::vector<Point_2> polygon;
    for (const Index v : border)
      polygon.push_back(uv[v]);
    const double area = doubled_area(polygon);
    sum += std::abs(area);
    if (std::abs(area) > std::abs(greatest))
      greatest = area;
  }
  if (greatest != 0 && std::isfinite(sum) && !has_crossings(rings, uv))
    return greatest < 0;
  return turns.right > turns.left;
}

// Puts vertices whose places are not finite in the middle of their neighbors. Returns whether all are finite then: many
// are left to the hierarchy.
inline bool place_missing_vertices(const One_rings& rings, std::vector<Point_2>& uv)
{
  constexpr double greatest_part = 0.1;
  std::vector<Index> missing;
  for (Index v = 0; v < uv.size(); ++v)
    if (!is_finite(uv[v]))
      missing.push_back(v);
  return missing.empty() || (double(missing.size()) <= greatest_part * double(uv.size()) &&
                             place_in_the_middle(rings, missing, positions_in(missing, Index(uv.size())), {}, uv));
}

// Gives new places to vertices near the flips of a map, where that removes flips. Returns at how many vertices the map
// is not valid then.
inline std::size_t repair_patches(const Triangulated_surface_3& surface, const One_rings& rings,
                                  std::vector<Point_2>& uv)
{
  return place_missing_vertices(rings, uv) ? Patch_repair(rings, surface.points, uv).run() : uv.size();
}

// Removes all flips from a map, see Map_repair.
inline Error_code repair_by_hierarchy(const Triangulated_surface_3& surface, const Hierarchy_options& options,
                                      const Loops& loops, std::vector<Point_2>& uv)
{
  const Collapse_hierarchy_3 hierarchy(surface, options, loops);
  std::vector<Point_2> repaired;
  const Error_code status = Map_repair(hierarchy, loops, by_rank(hierarchy, uv)).run(repaired);
  if (status == OK)
    uv = in_input_order(hierarchy, repaired);
  return status;
}

// The same. Where doubles leave no room for a vertex, in another hierarchy they may; at last Tutte's map of the whole
// surface is where the repair starts.
inline Error_code repair_by_hierarchies(const Triangulated_surface_3& surface, const Loops& loops,
                                        std::vector<Point_2>& uv)
{
  constexpr unsigned int most_seeds = 3;
  Hierarchy_options options;
  options.coarsest_size = 4;      // as coarse as possible: there Tutte's map has surely no flip, if a start is needed
  for (; options.random_seed < most_seeds; ++options.random_seed)
    if (repair_by_hierarchy(surface, options, loops, uv) == OK)
      return OK;
  options.coarsest_size = surface.points.size();
  return repair_by_hierarchy(surface, options, loops, uv);
}

// The exponent of the power of two that makes edges of a map about 1 long: the median, which vertices that are far away
// do not change; of one edge of each triangle.
inline int scale_exponent_of_edges(const std::vector<Index_triangle>& triangles, const std::vector<Point_2>& uv)
{
  std::vector<double> lengths;
  for (const Index_triangle& t : triangles) {
    const Vector_2 edge = uv[t[1]] - uv[t[0]];
    const double length = (std::max)(std::abs(edge.x()), std::abs(edge.y()));
    if (std::isfinite(length))
      lengths.push_back(length);
  }
  if (lengths.empty())
    return 0;
  const auto median = lengths.begin() + std::ptrdiff_t(lengths.size() / 2);
  std::nth_element(lengths.begin(), median, lengths.end());
  return *median > 0 ? -std::ilogb(*median) : 0;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code repair_map(const Triangulated_surface_3& surface, bool may_give_up, const Loops& loops,
                      std::vector<Point_2>& uv, std::size_t& moved_vertices)
{
  constexpr double part_given_up = 0.005;       // with so many vertices in large folds, the hierarchy moves nearly all
  const int exponent = scale_exponent_of_edges(surface.triangles, uv);
  std::vector<Point_2> map = uv;
  for (Point_2& p : map)
    p = times_power_of_two(p, exponent);
  One_rings rings;
  rings.build(uv.size(), surface.triangles, loops);
  rings.release_scratch();
  const bool must_mirror = is_mostly_mirrored(rings, map, count_turns(rings, map));
  if (must_mirror)
    mirror(map);
  const std::vector<Point_2> start = map;
  const std::size_t bad_vertices = repair_patches(surface, rings, map);
  rings = One_rings();      // the hierarchy needs the memory
  if (bad_vertices > 0) {
    if (may_give_up && double(bad_vertices) > part_given_up * double(uv.size()))
      return ERROR_NO_1_TO_1_MAPPING;
    if (const Error_code status = repair_by_hierarchies(surface, loops, map); status != OK)
      return status;
  }
  for (Index v = 0; v < uv.size(); ++v)
    if (map[v] != start[v]) {
      ++moved_vertices;
      if (must_mirror)
        mirror(map[v]);
      uv[v] = times_power_of_two(map[v], -exponent);
    }
  return OK;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code settle_flips(const Flip_settlement& settlement, const One_rings& rings,
                        Function_ref<Triangulated_surface_3()> make_surface, std::vector<Point_2>& uv,
                        Parameterization_summary& summary)
{
  if (settlement.policy == Flip_policy::KEEP || has_no_flips(rings, uv, settlement.loops))
    return OK;
  const Numbers_of_turns turns = count_turns(rings, uv);
  const bool is_mirrored = is_mostly_mirrored(rings, uv, turns);
  const std::size_t flips = turns.all - (is_mirrored ? turns.right : turns.left);
  summary.flips = flips > 0 ? flips : count_windings(rings, uv, is_mirrored);
  if (settlement.policy == Flip_policy::FAIL)
    return ERROR_NO_1_TO_1_MAPPING;
  const Error_code status = settlement.repair(make_surface(), settlement.may_give_up, settlement.loops, uv,
                                              summary.moved_vertices);
  return status != OK || has_no_flips(rings, uv, settlement.loops) ? status : ERROR_NO_1_TO_1_MAPPING;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void mirror_back(const One_rings& rings, std::vector<Point_2>& uv)
{
  if (is_mirrored_if_valid(rings, uv))
    mirror(uv);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FLIP_POLICY_IMPL_H
