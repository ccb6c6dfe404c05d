// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_CRACKS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_CRACKS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/mesh/cracks.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/fixed_places.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/holes.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The vertices of a surface, of which some become one.
class Merged_vertices
{
public:
  // No two bound vertices become one.
  Merged_vertices(const One_rings& rings, std::vector<bool> is_bound)
    : m_rings(rings), m_first(is_bound.size()), m_is_bound(std::move(is_bound))
  {
    std::iota(m_first.begin(), m_first.end(), Index(0));
    m_next = m_first;
  }

  // The vertex that stands for each one, and those that are one with it.
  const std::vector<Index>& representatives() const { return m_first; }

  // Whether a manifold is left if p and q, on two sides of a hole, become one: they have no edge, and no neighbors in
  // common but the ends of the hole that this closes, one or both.
  bool may_merge(Index p, Index q, std::size_t number_of_ends) const
  {
    if (m_is_bound[p] && m_is_bound[q])
      return false;
    const std::vector<Index> of_p = neighbors(p), of_q = neighbors(q);
    std::vector<Index> common;
    std::set_intersection(of_p.begin(), of_p.end(), of_q.begin(), of_q.end(), std::back_inserter(common));
    return common.size() == number_of_ends && !std::binary_search(of_p.begin(), of_p.end(), q);
  }

  // Makes q one with p, which stands for both.
  void merge(Index p, Index q)
  {
    m_is_bound[p] = m_is_bound[p] || m_is_bound[q];
    Index v = q;
    do {
      m_first[v] = p;
      v = m_next[v];
    } while (v != q);
    std::swap(m_next[p], m_next[q]);
  }

private:
  // Ascending.
  std::vector<Index> neighbors(Index p) const
  {
    std::vector<Index> result;
    Index v = p;
    do {
      for (const Index w : m_rings[v])
        result.push_back(m_first[w]);
      v = m_next[v];
    } while (v != p);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  const One_rings& m_rings;
  std::vector<Index> m_first, m_next;      // of the cycle of vertices that have become one
  std::vector<bool> m_is_bound;
};

// Closes a crack from its tips on, as far as it goes. The border is a cycle.
inline void merge_sides(std::deque<Index> border, const std::vector<Point_3>& points, Merged_vertices& vertices)
{
  constexpr double greatest_opening = 0.1;      // of a tip, relative to the shorter one of its edges
  const auto squared_distance = [&](Index p, Index q) { return (points[p] - points[q]).squared_length(); };
  const auto is_tip = [&](Index p, Index v, Index q) {
    return squared_distance(p, q) <=
           greatest_opening * greatest_opening * (std::min)(squared_distance(p, v), squared_distance(v, q));
  };
  for (std::size_t untried = border.size(); untried > 0 && border.size() >= 4;) {
    const Index p = border.back(), v = border[0], q = border[1];
    const std::size_t ends = border.size() == 4 ? 2 : 1;
    border.pop_front();
    if (is_tip(p, v, q) && vertices.may_merge(p, q, ends)) {
      vertices.merge(p, q);
      border.front() = p;      // the new tip
      border.pop_back();
      ++untried;
    } else {
      border.push_back(v);
      --untried;
    }
  }
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Index> merge_sides(const std::vector<Border>& cracks, const std::vector<Point_3>& points,
                               const One_rings& rings, std::vector<bool> is_bound)
{
  Merged_vertices vertices(rings, std::move(is_bound));
  for (const Border& crack : cracks)
    merge_sides(std::deque<Index>(crack.begin(), crack.end()), points, vertices);
  return vertices.representatives();
}

inline std::vector<bool> are_bound_to_places(const Triangulated_surface_3& surface)
{
  std::vector<bool> result = are_fixed(surface);
  for (const Triangulated_surface_3::Spring& spring : surface.springs)
    result[spring.vertex] = true;
  return result;
}

// Leaves out the vertices that others stand for. Returns the new number of each vertex.
inline std::vector<Index> remove_merged_vertices(const std::vector<Index>& representatives,
                                                 Triangulated_surface_3& surface)
{
  std::vector<Index> result(surface.points.size());
  Index size = 0;
  for (Index v = 0; v < result.size(); ++v)
    if (representatives[v] == v) {
      surface.points[size] = surface.points[v];
      result[v] = size++;
    }
  surface.points.resize(size);
  for (Index v = 0; v < result.size(); ++v)
    result[v] = result[representatives[v]];      // the one that stands for v has its number already
  for (Index_triangle& t : surface.triangles)
    for (Index& v : t)
      v = result[v];
  for (Index& v : surface.outer_border)
    v = result[v];
  for (Triangulated_surface_3::Fixed_vertex& fixed : surface.fixed_vertices)
    fixed.vertex = result[fixed.vertex];
  for (Triangulated_surface_3::Spring& spring : surface.springs)
    spring.vertex = result[spring.vertex];
  return result;
}

inline std::vector<Border> small_cracks(const Triangulated_surface_3& surface, const One_rings& rings,
                                        double greatest_length)
{
  std::vector<Border> result = holes(surface, rings);
  const auto is_other = [&](const Border& hole) {
    const std::vector<Point_3> places = places_of(hole, [&](Index v) { return surface.points[v]; });
    return !(perimeter(places) <= greatest_length && is_crack(places));
  };
  result.erase(std::remove_if(result.begin(), result.end(), is_other), result.end());
  return result;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Closed_surface close_cracks(Triangulated_surface_3 surface, double greatest_length)
{
  const One_rings rings(surface.points.size(), surface.triangles);
  const std::vector<Border> cracks = small_cracks(surface, rings, greatest_length);
  if (cracks.empty())
    return { std::move(surface), {} };
  std::vector<Index> new_vertices =
      remove_merged_vertices(merge_sides(cracks, surface.points, rings, are_bound_to_places(surface)), surface);
  const One_rings new_rings(surface.points.size(), surface.triangles);
  for (const Border& crack : small_cracks(surface, new_rings, greatest_length))
    fill_hole(crack, new_rings, surface);
  return { std::move(surface), std::move(new_vertices) };
}

// Moves a border vertex by a small part of its shortest edge along the bisector of its triangles, while these stay
// positive.
inline void open_along_bisector(const One_rings& rings, Index v, std::vector<Point_2>& uv)
{
  constexpr double part_of_shortest_edge = 0.1;
  constexpr int most_halvings = 30;
  double angle = 0, shortest = (uv[rings[v].back()] - uv[v]).squared_length();
  rings.for_each_triangle(v, [&](Index a, Index b, std::size_t) {
    const Vector_2 to_a = uv[a] - uv[v], to_b = uv[b] - uv[v];
    angle += std::atan2(cross(to_a, to_b), to_a * to_b);
    shortest = (std::min)(shortest, to_a.squared_length());
  });
  const Vector_2 to_first = uv[rings[v].front()] - uv[v];
  const double direction = std::atan2(to_first.y(), to_first.x()) + 0.5 * angle;
  const Point_2 start = uv[v];
  double length = part_of_shortest_edge * std::sqrt(shortest);
  for (int i = 0; i < most_halvings; ++i, length *= 0.5) {
    uv[v] = start + length * Vector_2(std::cos(direction), std::sin(direction));
    if (is_star_positive(rings, uv, v))
      return;
  }
  uv[v] = start;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Point_2> open_cracks(const Triangulated_surface_3& surface, const Closed_surface& closed,
                                 const std::vector<Point_2>& closed_map)
{
  std::vector<Index> number_of_copies(closed_map.size(), 0);
  std::vector<Point_2> uv;
  uv.reserve(closed.vertices.size());
  for (const Index v : closed.vertices) {
    ++number_of_copies[v];
    uv.push_back(closed_map[v]);
  }
  const std::vector<bool> is_fixed = are_fixed(surface);
  const One_rings rings(surface.points.size(), surface.triangles);
  for (Index v = 0; v < uv.size(); ++v)
    if (number_of_copies[closed.vertices[v]] > 1 && !is_fixed[v])
      open_along_bisector(rings, v, uv);
  return is_map_valid(rings, uv) ? uv : std::vector<Point_2>();
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_CRACKS_IMPL_H
