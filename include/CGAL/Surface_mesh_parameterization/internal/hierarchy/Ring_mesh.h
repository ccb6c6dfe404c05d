// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_RING_MESH_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_RING_MESH_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A mesh as the one-rings of its vertices. Collapses of vertices that share no edge turn it into the next coarser mesh,
// each ring by itself: no triangle is looked at, and nothing has to be sorted.
class Ring_mesh
{
public:
  // The ring of a vertex, counter-clockwise; that of a border vertex is open.
  struct Ring
  {
    const Index* neighbors;
    Index size;
    bool is_closed;

    const Index* begin() const { return neighbors; }
    const Index* end() const { return neighbors + size; }
    Index operator[](Index i) const { return neighbors[i]; }

    // The position of W, `size` if it is none of the neighbors.
    Index position_of(Index w) const { return Index(std::find(begin(), end(), w) - begin()); }
    bool contains(Index w) const { return position_of(w) != size; }

    Index following(Index i) const { return Index(next_in_cycle(i, size)); }
    bool are_adjacent(Index i, Index j) const
    {
      return i + 1 == j || j + 1 == i || (is_closed && (following(i) == j || following(j) == i));
    }
  };

  // Precondition: every vertex is manifold.
  Ring_mesh(std::size_t number_of_vertices, const std::vector<Index_triangle>& triangles, const Loops& loops)
  {
    One_rings rings;
    rings.build(number_of_vertices, triangles, loops);
    rings.release_scratch();
    m_first.assign(rings.offsets(), rings.offsets() + number_of_vertices + 1);
    m_neighbors.assign(rings.neighbors(), rings.neighbors() + rings.number_of_slots());
    m_is_border.resize(number_of_vertices);
    for (Index v = 0; v < number_of_vertices; ++v)
      m_is_border[v] = rings.is_border(v);
  }

  std::size_t number_of_vertices() const { return m_is_border.size(); }
  Ring operator[](Index v) const
  {
    return { m_neighbors.data() + m_first[v], m_first[v + 1] - m_first[v], !m_is_border[v] };
  }

  // Where the rings begin: what has to be known of a vertex before its ring.
  const Index* offsets() const { return m_first.data(); }

  // Removes vertices that share no edge. `number[v]` is the new number of V, or of the W0 that V collapses onto.
  void collapse(const std::vector<unsigned char>& is_removed, const std::vector<Index>& number, const Loops& loops)
  {
    m_new_rings.resize((std::max)(m_new_rings.size(), number_of_vertices() / Loops::default_block_size + 1));
    m_new_first.assign(std::count(is_removed.begin(), is_removed.end(), 0) + 1, 0);
    loops.for_each_block(0, Index(number_of_vertices()), [&](Index begin, Index end) {
      std::vector<Index>& rings = m_new_rings[begin / Loops::default_block_size];
      rings.clear();
      for (Index w = begin; w < end; ++w)
        if (!is_removed[w]) {
          const std::size_t first = rings.size();
          append_new_ring(w, is_removed, number, rings);
          m_new_first[number[w] + 1] = Index(rings.size() - first);
        }
    });
    std::partial_sum(m_new_first.begin(), m_new_first.end(), m_new_first.begin());
    m_first.swap(m_new_first);

    m_neighbors.clear();
    for (std::size_t begin = 0; begin < number_of_vertices(); begin += Loops::default_block_size) {
      const std::vector<Index>& rings = m_new_rings[begin / Loops::default_block_size];
      m_neighbors.insert(m_neighbors.end(), rings.begin(), rings.end());
    }
    for (Index w = 0; w < number_of_vertices(); ++w)
      if (!is_removed[w])
        m_is_border[number[w]] = m_is_border[w];
    m_is_border.resize(m_first.size() - 1);
  }

private:
  void append_new_ring(Index w, const std::vector<unsigned char>& is_removed, const std::vector<Index>& number,
                       std::vector<Index>& result) const
  {
    const std::size_t first = result.size();
    const Ring ring = (*this)[w];
    // A closed ring may start anywhere, so it does at a neighbor that stays.
    Index i = ring.is_closed && is_removed[ring[0]] ? 1 : 0;
    for (Index k = 0; k < ring.size; ++k, i = ring.following(i))
      if (number[ring[i]] == number[w])
        append_fan(w, ring[i], number, result);
      else if (result.size() == first || result.back() != number[ring[i]])    // V and W0 have become one
        result.push_back(number[ring[i]]);
    if (ring.is_closed && result[first] == result.back())
      result.pop_back();
  }

  // What W0 has instead of V after the collapse: the neighbors of V from W2 on that it has not already.
  void append_fan(Index w0, Index v, const std::vector<Index>& number, std::vector<Index>& result) const
  {
    const Ring ring = (*this)[v];
    Index i = ring.position_of(w0);
    if (ring.is_closed || i == 0)         // W1 stands before V
      i = ring.following(i);
    i = ring.following(i);
    for (Index left = ring.size - (ring.is_closed ? 3 : 2); left > 0; --left, i = ring.following(i))
      result.push_back(number[ring[i]]);
  }

  std::vector<Index> m_first, m_neighbors;
  std::vector<unsigned char> m_is_border;

  // Scratch of collapse(): of the next mesh, and its rings by blocks of vertices of this one.
  std::vector<Index> m_new_first;
  std::vector<std::vector<Index>> m_new_rings;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_RING_MESH_H
