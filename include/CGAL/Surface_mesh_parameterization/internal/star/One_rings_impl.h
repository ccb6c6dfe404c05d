// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_ONE_RINGS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_ONE_RINGS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <algorithm>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
One_rings::One_rings(std::size_t number_of_vertices, const std::vector<Index_triangle>& triangles)
{
  build(number_of_vertices, triangles, Loops());
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void One_rings::build(std::size_t number_of_vertices, const std::vector<Index_triangle>& triangles, const Loops& loops)
{
  collect_opposite_edges(number_of_vertices, triangles, loops);

  m_first.resize(number_of_vertices + 1);
  m_first[0] = 0;
  for (std::size_t v = 0; v < number_of_vertices; ++v)
    m_first[v + 1] = m_first[v] + (edge_end(Index(v)) - edge_begin(Index(v))) + (m_is_border[v] ? 1 : 0);

  m_neighbors.resize(m_first.back());
  m_first_bad_vertex =
      loops.min(0, Index(number_of_vertices), no_index, [&](Index v) { return link_ring(v) ? no_index : v; });
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void One_rings::reserve(std::size_t number_of_vertices, std::size_t number_of_triangles, const Loops& loops)
{
  m_first.reserve(number_of_vertices + 1);
  m_neighbors.reserve(3 * number_of_triangles + number_of_vertices);
  m_is_border.reserve(number_of_vertices);
  m_edges.reserve(3 * number_of_triangles);
  m_next_edge.reserve(loops.number_of_parts() * number_of_vertices);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void One_rings::release_scratch()
{
  std::vector<Directed_edge>().swap(m_edges);
  std::vector<Index>().swap(m_next_edge);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<std::vector<Index>> One_rings::borders() const
{
  std::vector<std::vector<Index>> result;
  std::vector<bool> is_found(number_of_vertices(), false);
  for (Index start = 0; start < number_of_vertices(); ++start)
    if (is_border(start) && !is_found[start]) {
      result.emplace_back();
      for (Index v = start; !is_found[v]; v = (*this)[v].front()) {
        is_found[v] = true;
        result.back().push_back(v);
      }
    }
  return result;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void One_rings::collect_opposite_edges(std::size_t number_of_vertices, const std::vector<Index_triangle>& triangles,
                                       const Loops& loops)
{
  const Index parts = loops.number_of_parts();
  const auto for_each_triangle = [&](const auto& f) {
    loops.for_each_block(0, parts, [&](Index part, Index) {
      const std::size_t n = triangles.size(), end = n * (part + 1) / parts;
      for (std::size_t i = n * part / parts; i < end; ++i)
        f(triangles[i], m_next_edge.data() + part * number_of_vertices);
    }, 1);
  };
  m_next_edge.assign(parts * number_of_vertices, 0);
  for_each_triangle([](const Index_triangle& t, Index* count) {
    for (const Index v : t)
      ++count[v];
  });
  Index sum = 0;
  for (std::size_t v = 0; v < number_of_vertices; ++v)
    for (Index part = 0; part < parts; ++part)
      sum += std::exchange(m_next_edge[part * number_of_vertices + v], sum);
  m_edges.resize(sum);
  for_each_triangle([this](const Index_triangle& t, Index* next) {
    for (int i = 0; i < 3; ++i)
      m_edges[next[t[i]]++] = { t[(i + 1) % 3], t[(i + 2) % 3] };
  });

  // A closed fan leaves every neighbor once and enters it once; so in an open one the neighbors entered and left differ
  // in sum.
  m_is_border.resize(number_of_vertices);
  loops.for_each(0, Index(number_of_vertices), [&](Index v) {
    Index balance = 0;
    for (Index e = edge_begin(v); e < edge_end(v); ++e)
      balance += m_edges[e].first - m_edges[e].second;
    m_is_border[v] = balance != 0;
  });
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool One_rings::link_ring(Index v)
{
  Directed_edge* const begin = m_edges.data() + edge_begin(v);
  Directed_edge* const end = m_edges.data() + edge_end(v);
  Index* out = m_neighbors.data() + m_first[v];
  if (begin == end)
    return false;
  constexpr std::ptrdiff_t most_edges_to_search = 32;       // for each neighbor
  if (end - begin > most_edges_to_search)
    return link_large_ring(v);

  if (is_border(v))
    for (Directed_edge* e = begin; e != end; ++e)
      if (std::none_of(begin, end, [&](const Directed_edge& other) { return other.second == e->first; })) {
        std::swap(*begin, *e);
        break;
      }
  *out++ = begin->first;
  for (Directed_edge* e = begin; e + 1 != end; ++e) {
    Directed_edge* const following =
        std::find_if(e + 1, end, [&](const Directed_edge& other) { return other.first == e->second; });
    if (following == end)
      return fill_bad_ring(v);
    std::swap(e[1], *following);
    *out++ = e[1].first;
  }
  return close_ring(v, out, (end - 1)->second);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool One_rings::link_large_ring(Index v)
{
  const auto begin = m_edges.begin() + edge_begin(v), end = m_edges.begin() + edge_end(v);
  std::sort(begin, end);
  Index start = begin->first;
  if (is_border(v)) {
    std::vector<Index> sorted_ends;
    for (auto e = begin; e != end; ++e)
      sorted_ends.push_back(e->second);
    std::sort(sorted_ends.begin(), sorted_ends.end());
    for (auto e = begin; e != end; ++e)
      if (!std::binary_search(sorted_ends.begin(), sorted_ends.end(), e->first))
        start = e->first;
  }
  Index* out = m_neighbors.data() + m_first[v];
  Index current = start;
  for (auto i = begin; i != end; ++i) {
    const auto e = std::lower_bound(begin, end, Directed_edge(current, 0));
    if (e == end || e->first != current || (i != begin && current == start))
      return fill_bad_ring(v);
    *out++ = current;
    current = e->second;
  }
  return close_ring(v, out, current);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool One_rings::close_ring(Index v, Index* out, Index last)
{
  if (is_border(v))
    *out = last;
  return is_border(v) || last == m_neighbors[m_first[v]] || fill_bad_ring(v);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool One_rings::fill_bad_ring(Index v)
{
  std::fill(m_neighbors.begin() + m_first[v], m_neighbors.begin() + m_first[v + 1], v);
  return false;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_ONE_RINGS_IMPL_H
