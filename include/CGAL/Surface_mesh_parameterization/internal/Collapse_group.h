// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_COLLAPSE_GROUP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_COLLAPSE_GROUP_H

#include <CGAL/Surface_mesh_parameterization/internal/Halfedge_collapse.h>
#include <CGAL/Surface_mesh_parameterization/internal/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/discrete_exponential_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/prefetch.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// One collapse group (Hormann, Greiner, Campagna 1999, section 3): unlock all vertices; while one is unlocked, take one at random,
// collapse it, lock its one-ring. No two removed vertices share an edge, so each star is that of the mesh before the group, and every
// triangle holds at most one removed vertex. Only the link condition has to know the edges that the group itself adds.
class Collapse_group
{
public:
  struct Collapse
  {
    Index removed_vertex;
    std::array<Index, 3> parent;          // W0, Wi, Wi+1; W0 is the kept vertex
    std::array<double, 2> coordinates;    // of the removed vertex, with respect to Wi and Wi+1
  };

  // Chooses the collapses. `is_pinned` marks vertices that must stay; `random` is used and advanced. At least `fewest_vertices` remain.
  template <class RandomGenerator>
  void choose(const std::vector<Point_3>& points, const std::vector<Index_triangle>& triangles, const std::vector<bool>& is_pinned,
              std::size_t fewest_vertices, RandomGenerator& random, const Loops& loops)
  {
    const std::size_t n = points.size();
    m_rings.build(n, triangles, loops);
    m_is_locked.assign(n, 0);
    m_is_in_ring.assign(n, 0);
    m_first_added.assign(n, no_index);
    m_added.clear();
    m_collapses.clear();

    shuffle_vertices(n, random);
    constexpr std::size_t least_batches = 32, least_batch_size = 64, greatest_batch_size = 4096;
    const std::size_t batch_size = (std::min)((std::max)(n / least_batches, least_batch_size), greatest_batch_size);
    for (std::size_t begin = 0; begin < n && m_collapses.size() + fewest_vertices < n; begin += batch_size) {
      const std::size_t end = (std::min)(begin + batch_size, n);
      examine_batch(Index(begin), Index(end), is_pinned, points, loops);
      for (std::size_t i = begin; i < end && m_collapses.size() + fewest_vertices < n; ++i)
        if (!m_is_locked[m_order[i]])
          try_collapse(m_order[i], m_prospects[i - begin]);
    }
    std::sort(m_collapses.begin(), m_collapses.end(),
              [](const Collapse& a, const Collapse& b) { return a.removed_vertex < b.removed_vertex; });
  }

  // In the order of the removed vertices' indices.
  const std::vector<Collapse>& collapses() const { return m_collapses; }

private:
  // std::shuffle is not the same everywhere.
  template <class RandomGenerator>
  void shuffle_vertices(std::size_t n, RandomGenerator& random)
  {
    m_order.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      m_order[i] = Index(i);
    for (std::size_t i = n; i > 1; --i)
      std::swap(m_order[i - 1], m_order[std::size_t((std::uint64_t(random()) * i) >> 32)]);
  }

  // In random order, nearly everything about a vertex would have to be waited for: that is asked for step by step while the vertices before it are tried.
  BOOST_FORCEINLINE void prefetch_vertices_after(std::size_t i, const std::vector<Point_3>& points) const
  {
    constexpr std::size_t vertex_ahead = 12, ring_ahead = 6, ring_points_ahead = 3;
    if (i + vertex_ahead >= m_order.size())
      return;
    const Index vertex = m_order[i + vertex_ahead];
    prefetch(&m_is_locked[vertex]);
    prefetch(&points[vertex]);
    prefetch(m_rings.offsets() + vertex);
    if (const Index v = m_order[i + ring_ahead]; !m_is_locked[v])
      prefetch(m_rings[v].begin());
    if (const Index v = m_order[i + ring_points_ahead]; !m_is_locked[v])
      for (Index w : m_rings[v]) {
        prefetch(&points[w]);
        prefetch(m_rings.offsets() + w);
      }
  }

  // What can be said of a vertex before it is its turn, since its star stays as it is: nearly all that is to be computed, and by several threads. Few vertices
  // are examined in vain, because others of their batch lock them.
  struct Prospect
  {
    std::vector<Vector_2> flat_ring;
    std::vector<std::pair<double, Index>> candidates;   // quality, negative, and place in the ring of neighbors to collapse onto, the best first
  };

  // The vertices from `begin` to `end` in the random order.
  void examine_batch(Index begin, Index end, const std::vector<bool>& is_pinned, const std::vector<Point_3>& points, const Loops& loops)
  {
    m_prospects.resize((std::max)(m_prospects.size(), std::size_t(end - begin)));
    loops.for_each_block(begin, end, [] { return std::vector<Point_3>(); }, [&](Index block_begin, Index block_end, std::vector<Point_3>& ring_points) {
      for (Index i = block_begin; i < block_end; ++i) {
        prefetch_vertices_after(i, points);
        examine(m_order[i], is_pinned, points, ring_points, m_prospects[i - begin]);
      }
    });
  }

  void examine(Index v, const std::vector<bool>& is_pinned, const std::vector<Point_3>& points, std::vector<Point_3>& ring_points, Prospect& prospect) const
  {
    // The choice of W0 is quadratic in the valence; a hub becomes cheaper as its neighbors go.
    constexpr std::size_t highest_valence = 32;
    prospect.candidates.clear();
    if (m_is_locked[v] || is_pinned[v])
      return;
    const One_rings::Ring ring = m_rings[v];
    const bool is_closed = !m_rings.is_border(v);
    if (ring.size() > highest_valence || (ring.size() < 3 && is_closed))
      return;
    ring_points.clear();
    for (Index w : ring)
      ring_points.push_back(points[w]);
    discrete_exponential_map(points[v], ring_points, is_closed, prospect.flat_ring);
    rank_candidates(is_closed, prospect);
  }

  // The neighbors whose fan has no flipped triangle, the one with the best worst triangle first.
  static void rank_candidates(bool is_closed, Prospect& prospect)
  {
    constexpr double least_quality = 1e-4;
    const std::size_t ring_size = prospect.flat_ring.size(), step = is_closed ? 1 : ring_size - 1;   // a border vertex has two candidates, the ends of its ring
    for (std::size_t w0 = 0; w0 < ring_size; w0 += step) {
      const double quality = worst_quality_after_collapse(prospect.flat_ring, is_closed, w0);
      if (quality > least_quality)
        prospect.candidates.push_back({ -quality, Index(w0) });
    }
    std::sort(prospect.candidates.begin(), prospect.candidates.end());
  }

  void try_collapse(Index v, const Prospect& prospect)
  {
    if (prospect.candidates.empty())
      return;
    const One_rings::Ring ring = m_rings[v];
    for (Index w : ring)
      m_is_in_ring[w] = 1;
    for (const auto& [quality, w0] : prospect.candidates)
      if (satisfies_link_condition(v, ring, w0)) {
        collapse(v, ring, prospect.flat_ring, w0);
        break;
      }
    for (Index w : ring)
      m_is_in_ring[w] = 0;
  }

  // The collapse keeps the mesh a manifold if V and W0 have no common neighbor besides the ones beside W0 in the ring; an ear
  // additionally needs a triangle on the other side of its base.
  bool satisfies_link_condition(Index v, const One_rings::Ring& ring, Index w0_slot) const
  {
    const Index w0 = ring[w0_slot];
    const bool is_ear = m_rings.is_border(v) && ring.size() == 2;
    std::size_t common = 0;
    for (Index w : m_rings[w0])
      common += m_is_in_ring[w];
    for (Index e = m_first_added[w0]; e != no_index; e = m_added[e].next)
      common += m_is_in_ring[m_added[e].neighbor];

    const std::size_t allowed = m_rings.is_border(v) ? 1 : 2;
    if (common != allowed)
      return false;
    return !is_ear || is_interior_edge(ring[0], ring[1]);
  }

  // Whether the edge that joins two border vertices has triangles on both sides: they are no border neighbors.
  bool is_interior_edge(Index a, Index b) const { return m_rings[a].front() != b && m_rings[a].back() != b; }

  void collapse(Index v, const One_rings::Ring& ring, const std::vector<Vector_2>& flat_ring, Index w0)
  {
    const bool is_closed = !m_rings.is_border(v);
    const Parent_triangle parent = is_closed ? find_parent_triangle(flat_ring, w0) : find_parent_border_edge(flat_ring, w0);
    m_collapses.push_back({ v, { ring[parent.slots[0]], ring[parent.slots[1]], ring[parent.slots[2]] }, parent.coordinates });

    const std::size_t size = ring.size();
    for (std::size_t i = 0; i < size; ++i) {
      m_is_locked[ring[i]] = 1;
      const bool was_adjacent = i == w0 || (is_closed ? i == (w0 + 1) % size || w0 == (i + 1) % size : i == (w0 == 0 ? 1 : size - 2));
      if (!was_adjacent) {
        add_edge(ring[w0], ring[i]);
        add_edge(ring[i], ring[w0]);
      }
    }
    m_is_locked[v] = 1;
  }

  void add_edge(Index from, Index to)
  {
    m_added.push_back({ to, m_first_added[from] });
    m_first_added[from] = Index(m_added.size() - 1);
  }

  struct Added_edge { Index neighbor, next; };

  One_rings m_rings;
  std::vector<Index> m_order;
  std::vector<unsigned char> m_is_locked, m_is_in_ring;
  std::vector<Index> m_first_added;               // per vertex: its list in m_added
  std::vector<Added_edge> m_added;
  std::vector<Collapse> m_collapses;
  std::vector<Prospect> m_prospects;              // of a batch of vertices in the order
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_COLLAPSE_GROUP_H
