// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_COLLAPSE_GROUP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_COLLAPSE_GROUP_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/prefetch.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Added_edges.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Parent_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Ring_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Unit_edge_metric.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/discrete_exponential_map.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// One collapse group (Hormann, Greiner, Campagna 1999, section 3): unlock all vertices; while one is unlocked, take one
// at random, collapse it, lock its one-ring. No two removed vertices share an edge, so each star is that of the mesh
// before the group. Only the link condition has to know the edges that the group itself adds.
class Collapse_group
{
public:
  struct Collapse
  {
    Index removed_vertex;
    std::array<Index, 3> parent;          // W0, Wi, Wi+1; W0 is the kept vertex
    std::array<double, 2> coordinates;    // of the removed vertex, with respect to Wi and Wi+1
  };

  struct Mesh
  {
    const Ring_mesh& rings;
    const std::vector<Point_3>& points;
    const std::vector<bool>& is_pinned;           // these vertices must stay
    const Unit_edge_metric* metric = nullptr;     // in which triangles are rated; null for that of space
  };

  // Chooses collapses of `mesh`; `random` is used and advanced. At least `fewest_vertices` remain.
  template <class RandomGenerator>
  void choose(const Mesh& mesh, std::size_t fewest_vertices, RandomGenerator& random, const Loops& loops)
  {
    const std::size_t n = mesh.points.size();
    m_is_locked.assign(n, 0);
    m_added.reset(n);
    m_collapses.clear();

    shuffle_vertices(n, random);
    for (const Acceptance acceptance : { Acceptance::ROUND, Acceptance::NEEDLES, Acceptance::BENT_BORDERS }) {
      m_acceptance = acceptance;
      choose_in_order(mesh, fewest_vertices, loops);
      if (double(m_collapses.size()) >= least_part_of_vertices * double(n))
        break;
    }
    sort_collapses();
  }

  // In the order of the removed vertices' indices.
  const std::vector<Collapse>& collapses() const { return m_collapses; }

private:
  // Which triangles a collapse may leave. A surface that consists of needles, or whose border turns with every edge,
  // has no coarser mesh of good triangles: where few vertices can be removed otherwise, bad ones are accepted.
  enum class Acceptance {
    ROUND,
    NEEDLES,          // a little worse than the triangles that it takes
    BENT_BORDERS      // at the border these may overlap in the plane, too
  };

  void choose_in_order(const Mesh& mesh, std::size_t fewest_vertices, const Loops& loops)
  {
    const std::size_t n = mesh.points.size();
    constexpr std::size_t least_batches = 32, least_batch_size = 64, greatest_batch_size = 2048;
    const std::size_t batch_size = (std::min)((std::max)(n / least_batches, least_batch_size), greatest_batch_size);
    for (std::size_t begin = 0; begin < n && m_collapses.size() + fewest_vertices < n; begin += batch_size) {
      const std::size_t end = (std::min)(begin + batch_size, n);
      examine_batch(mesh, Index(begin), Index(end), loops);
      for (std::size_t i = begin; i < end && m_collapses.size() + fewest_vertices < n; ++i)
        if (!m_is_locked[m_order[i]])
          try_collapse(mesh, m_prospects[i - begin]);
    }
  }

  // In random order block by block, so that most of what the vertices of a block need stays in the cache. std::shuffle
  // is not the same everywhere.
  template <class RandomGenerator>
  void shuffle_vertices(std::size_t n, RandomGenerator& random)
  {
    constexpr std::size_t block_size = 65536;
    m_order.resize(n);
    std::iota(m_order.begin(), m_order.end(), Index(0));
    for (std::size_t begin = 0; begin < n; begin += block_size)
      for (std::size_t i = (std::min)(n - begin, block_size); i > 1; --i)
        std::swap(m_order[begin + i - 1], m_order[begin + std::size_t((std::uint64_t(random()) * i) >> 32)]);
  }

  // In random order, nearly everything about a vertex would have to be waited for: that is asked for step by step while
  // the vertices before it are examined.
  BOOST_FORCEINLINE void prefetch_vertices_after(const Mesh& mesh, std::size_t i) const
  {
    constexpr std::size_t vertex_ahead = 12, ring_ahead = 6, ring_points_ahead = 3;
    if (i + vertex_ahead >= m_order.size())
      return;
    const Index vertex = m_order[i + vertex_ahead];
    prefetch(&m_is_locked[vertex]);
    prefetch(&mesh.points[vertex]);
    if (mesh.metric)
      mesh.metric->prefetch_vertex(vertex);
    prefetch(mesh.rings.offsets() + vertex);
    if (const Index v = m_order[i + ring_ahead]; !m_is_locked[v])
      prefetch(mesh.rings[v].begin());
    if (const Index v = m_order[i + ring_points_ahead]; !m_is_locked[v])
      for (Index w : mesh.rings[v]) {
        prefetch(&mesh.points[w]);
        prefetch(mesh.rings.offsets() + w);
      }
  }

  // What the search for the best collapse of a vertex works on.
  struct Scratch
  {
    std::vector<Point_3> ring_points;
    std::vector<Vector_2> flat_ring;
    std::vector<unsigned char> is_forbidden;      // by the link condition, to collapse onto this neighbor
  };

  // Finds the best collapses of the vertices from `begin` to `end` in the random order before it is their turn: that is
  // nearly all there is to compute, and can be done by several threads. Few vertices are examined in vain, because
  // others of their batch lock them.
  void examine_batch(const Mesh& mesh, Index begin, Index end, const Loops& loops)
  {
    m_prospects.resize((std::max)(m_prospects.size(), std::size_t(end - begin)));
    constexpr Index block_size = 256;       // a vertex is much work
    loops.for_each_block_with_scratch(
        begin, end, [] { return Scratch(); },
        [&](Index block_begin, Index block_end, Scratch& scratch) {
          for (Index i = block_begin; i < block_end; ++i) {
            prefetch_vertices_after(mesh, i);
            m_prospects[i - begin] = m_is_locked[m_order[i]] ? no_collapse : best_collapse(mesh, m_order[i], scratch);
          }
        },
        block_size);
  }

  static constexpr Collapse no_collapse = { no_index, {}, {} };

  // The collapse of V, onto the neighbor whose fan has the best worst triangle, that the link condition allows after
  // the collapses so far. Where every fan is too bad, one onto a neighbor at the same place, which changes no triangle.
  Collapse best_collapse(const Mesh& mesh, Index v, Scratch& scratch) const
  {
    // The choice of W0 is quadratic in the valence. A hub can wait until its neighbors have gone: valences sum to less
    // than 6 n, so less than a fifth of the vertices are hubs on any level.
    constexpr Index highest_valence = 32;
    const Ring_mesh::Ring ring = mesh.rings[v];
    if (mesh.is_pinned[v] || ring.size > highest_valence || (ring.size < 3 && ring.is_closed))
      return no_collapse;
    scratch.ring_points.clear();
    for (Index w : ring)
      scratch.ring_points.push_back(mesh.points[w]);
    discrete_exponential_map(mesh.points[v], scratch.ring_points, ring.is_closed, scratch.flat_ring);
    if (mesh.metric)
      mesh.metric->transform(v, mesh.points[v], scratch.ring_points, scratch.flat_ring);
    const double least_quality = least_quality_after_collapse(scratch.flat_ring, ring.is_closed);
    scratch.is_forbidden.assign(ring.size, false);
    for (;;) {
      Index w0 = ring.is_closed || m_acceptance != Acceptance::BENT_BORDERS
                     ? best_neighbor(scratch.flat_ring, ring.is_closed, least_quality, scratch.is_forbidden)
                     : best_neighbor(scratch.ring_points, ring.is_closed, least_quality, scratch.is_forbidden);
      if (w0 == no_index)
        w0 = coincident_neighbor(scratch.flat_ring, ring.is_closed, scratch.is_forbidden);
      if (w0 == no_index)
        return no_collapse;
      if (satisfies_link_condition(mesh, v, w0)) {
        const Parent_triangle parent = ring.is_closed ? find_parent_triangle(scratch.flat_ring, w0)
                                                      : find_parent_border_edge(scratch.flat_ring, w0);
        return { v, { ring[parent.slots[0]], ring[parent.slots[1]], ring[parent.slots[2]] }, parent.coordinates };
      }
      scratch.is_forbidden[w0] = true;
    }
  }

  // Needles are accepted as long as their rest shapes need not be raised.
  double least_quality_after_collapse(const std::vector<Vector_2>& flat_ring, bool is_closed) const
  {
    constexpr double least_quality = 1e-4, least_part = 0.25;
    return m_acceptance == Acceptance::ROUND ? least_quality
                                             : std::clamp(least_part * worst_quality_of_star(flat_ring, is_closed),
                                                          lowest_rest_height, least_quality);
  }

  // The position of the neighbor whose fan has the best worst triangle, `no_index` if every fan is too bad.
  template <class Place>
  static Index best_neighbor(const std::vector<Place>& places, bool is_closed, double least_quality,
                             const std::vector<unsigned char>& is_forbidden)
  {
    Index best = no_index;
    double best_quality = least_quality;
    for (Index w0 = 0; w0 < places.size(); w0 += step_of_candidates(places.size(), is_closed))
      if (!is_forbidden[w0])
        if (const double quality = worst_quality_after_collapse(places, w0, best_quality); quality > best_quality) {
          best = w0;
          best_quality = quality;
        }
    return best;
  }

  // The position of a neighbor that lies where V does, `no_index` if there is none.
  static Index coincident_neighbor(const std::vector<Vector_2>& flat_ring, bool is_closed,
                                   const std::vector<unsigned char>& is_forbidden)
  {
    for (Index w0 = 0; w0 < flat_ring.size(); w0 += step_of_candidates(flat_ring.size(), is_closed))
      if (!is_forbidden[w0] && flat_ring[w0] == Vector_2(0, 0))
        return w0;
    return no_index;
  }

  // A border vertex has two candidates, the ends of its ring.
  static Index step_of_candidates(std::size_t size, bool is_closed) { return is_closed ? 1 : Index(size - 1); }

  // The collapse keeps the mesh a manifold if V and W0 have no common neighbor besides the ones beside W0 in the ring;
  // an ear additionally needs a triangle on the other side of its base.
  bool satisfies_link_condition(const Mesh& mesh, Index v, Index w0_slot) const
  {
    const Ring_mesh::Ring ring = mesh.rings[v], kept_ring = mesh.rings[ring[w0_slot]];
    for (Index i = 0; i < ring.size; ++i)
      if (i != w0_slot && !ring.are_adjacent(i, w0_slot) && kept_ring.contains(ring[i]))
        return false;
    if (m_added.join(ring[w0_slot], ring))
      return false;
    const bool is_ear = !ring.is_closed && ring.size == 2;
    return !is_ear || is_interior_edge(mesh, ring[0], ring[1]);
  }

  // Whether the edge that joins two border vertices has triangles on both sides: they are no border neighbors.
  static bool is_interior_edge(const Mesh& mesh, Index a, Index b)
  {
    const Ring_mesh::Ring ring = mesh.rings[a];
    return ring[0] != b && ring[ring.size - 1] != b;
  }

  // Performs a collapse that was found before others of its batch were performed, or the next best one if these have
  // forbidden it.
  void try_collapse(const Mesh& mesh, Collapse c)
  {
    if (c.removed_vertex == no_index)
      return;
    const Ring_mesh::Ring ring = mesh.rings[c.removed_vertex];
    if (m_added.join(c.parent[0], ring))
      c = best_collapse(mesh, c.removed_vertex, m_scratch);
    if (c.removed_vertex == no_index)
      return;
    m_collapses.push_back(c);
    m_is_locked[c.removed_vertex] = 1;
    const Index w0 = ring.position_of(c.parent[0]);
    for (Index i = 0; i < ring.size; ++i) {
      m_is_locked[ring[i]] = 1;
      if (i != w0 && !ring.are_adjacent(i, w0))
        m_added.add(ring[w0], ring[i]);
    }
  }

  // By removed vertex.
  void sort_collapses()
  {
    m_order.assign(m_order.size(), no_index);
    for (std::size_t i = 0; i < m_collapses.size(); ++i)
      m_order[m_collapses[i].removed_vertex] = Index(i);
    m_sorted.clear();
    for (const Index i : m_order)
      if (i != no_index)
        m_sorted.push_back(m_collapses[i]);
    m_collapses.swap(m_sorted);
  }

  static constexpr double least_part_of_vertices = 1. / 8;      // that a group should remove

  std::vector<Index> m_order;
  std::vector<unsigned char> m_is_locked;
  Acceptance m_acceptance = Acceptance::ROUND;
  Added_edges m_added;
  std::vector<Collapse> m_collapses, m_sorted;
  std::vector<Collapse> m_prospects;              // of a batch of vertices in the order
  Scratch m_scratch;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_COLLAPSE_GROUP_H
