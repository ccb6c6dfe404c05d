// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_STAR_VALIDITY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_STAR_VALIDITY_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The invariant of every level, by exact predicates: all triangles are positive, the angles around an interior vertex
// sum to one turn, and those at a border vertex to less than one turn. While triangles stay positive and vertices move
// on straight lines, the turn around an interior vertex cannot change; the turn at a border vertex changes only when it
// or a border neighbor of it moves.

// Whether all triangles at v are positive.
inline bool is_star_positive(const One_rings& rings, const std::vector<Point_2>& uv, Index v)
{
  const One_rings::Ring ring = rings[v];
  const std::size_t triangles = rings.number_of_triangles(v), size = ring.size();
  for (std::size_t i = 0; i < triangles; ++i)
    if (!is_left_turn(uv[v], uv[ring[i]], uv[ring[next_in_cycle(i, size)]]))
      return false;
  return true;
}

// Where a vertex w lies, seen from its neighbor v.
struct Place_of_vertex
{
  const std::vector<Point_2>& uv;
  const Point_2& operator()(Index w, Index /*v*/) const { return uv[w]; }
};

// Whether the angles around an interior vertex sum to more than one turn. On each turn to the left the direction to the
// neighbors passes once from below to above, by less than half a turn, so that comparing coordinates is exact.
// Precondition: the star of v is positive.
template <class Place>
bool turns_more_than_once(const One_rings::Ring& ring, const Place& place, Index v)
{
  const auto is_below = [center_y = place(v, v).y(), &place, v](Index w) { return place(w, v).y() < center_y; };
  int turns = 0;
  bool was_below = is_below(ring.back());
  for (const Index w : ring) {
    const bool is_below_now = is_below(w);
    turns += was_below && !is_below_now;
    was_below = is_below_now;
  }
  return turns > 1;
}

// Whether the angles at a border vertex sum to at least one turn: whether the directions from v to its neighbors, that
// turn left by less than half a turn each, come back to the first one before the last one.
// Precondition: the star of v is positive.
template <class Place>
bool turns_back_to_start(const One_rings::Ring& ring, const Place& place, Index v)
{
  const Point_2 &center = place(v, v), &first = place(ring.front(), v);
  bool is_past_half_turn = false;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    if (!is_past_half_turn && i + 1 == ring.size())
      return false;     // the border may be straight here, so that the predicate would need exact numbers
    const bool is_ahead = exact_orientation(center, first, place(ring[i], v)) != RIGHT_TURN;
    if (is_ahead && is_past_half_turn)
      return true;
    is_past_half_turn = is_past_half_turn || !is_ahead;
  }
  return false;
}

// Whether the angles at a vertex break the invariant.
// Precondition: the star of v is positive.
template <class Place>
bool turns_too_far(const One_rings& rings, const Place& place, Index v)
{
  return rings.is_border(v) ? turns_back_to_start(rings[v], place, v) : turns_more_than_once(rings[v], place, v);
}

// What the angles at a border vertex leave of a full turn, at least. An energy can drive them further; but then a finer
// level has no room for another vertex.
constexpr double least_gap = 1e-3;

// Whether they leave less. To be asked of vertices that do not turn too far; in doubles, for it is only about good
// sense.
inline bool leaves_no_room(const One_rings& rings, const std::vector<Point_2>& uv, Index v)
{
  const Vector_2 first = uv[rings[v].front()] - uv[v], last = uv[rings[v].back()] - uv[v];
  const double sine = cross(last, first), cosine = last * first;
  if (!(cosine > 0 && std::abs(sine) < least_gap * cosine))
    return false;
  double turn = 0;    // close to 0 or to a full one
  for (std::size_t i = 0; i + 1 < rings[v].size(); ++i) {
    const Vector_2 a = uv[rings[v][i]] - uv[v], b = uv[rings[v][i + 1]] - uv[v];
    turn += std::atan2(cross(a, b), a * b);
  }
  return turn > CGAL_PI;
}

// Whether the invariant holds at v and, if v lies on the border, at its two border neighbors.
template <class Place>
bool is_star_valid(const One_rings& rings, const std::vector<Point_2>& uv, const Place& place, Index v)
{
  if (!is_star_positive(rings, uv, v))
    return false;
  if (!rings.is_border(v))
    return true;
  return !turns_too_far(rings, place, v) && !turns_too_far(rings, place, rings[v].front()) &&
         !turns_too_far(rings, place, rings[v].back());
}

inline bool is_star_valid(const One_rings& rings, const std::vector<Point_2>& uv, Index v)
{
  return is_star_valid(rings, uv, Place_of_vertex{ uv }, v);
}

// The same without the turns around the neighbors of v. A map is valid if this holds for all vertices.
inline bool is_fan_valid(const One_rings& rings, const std::vector<Point_2>& uv, Index v)
{
  return is_star_positive(rings, uv, v) && !turns_too_far(rings, Place_of_vertex{ uv }, v);
}

// Whether it is the mirror image of a map that is valid; of a map that is not valid in either way this tells nothing.
inline bool is_mirrored_if_valid(const One_rings& rings, const std::vector<Point_2>& uv)
{
  return !uv.empty() && !is_star_positive(rings, uv, 0);
}

// Whether the invariant holds everywhere.
inline bool is_map_valid(const One_rings& rings, const std::vector<Point_2>& uv, const Loops& loops = Loops())
{
  const auto has_positive_triangles = [&](Index v) {    // those of which v is the least vertex
    bool are_positive = true;
    rings.prefetch_neighbors_after(v, uv);
    rings.for_each_triangle_of_least_vertex(v, [&](Index a, Index b, std::size_t) {
      are_positive = are_positive && is_left_turn(uv[v], uv[a], uv[b]);
    });
    return are_positive;
  };
  const auto turns_right = [&](Index v) {
    rings.prefetch_neighbors_after(v, uv);
    return !turns_too_far(rings, Place_of_vertex{ uv }, v);
  };
  const Index n = Index(rings.number_of_vertices());
  return loops.min(0, n, true, has_positive_triangles) && loops.min(0, n, true, turns_right);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_STAR_VALIDITY_H
