// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_ONE_RINGS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_ONE_RINGS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/prefetch.h>

#include <boost/config.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The neighbors of every vertex, counter-clockwise, in one flat array.
//
// An interior vertex has as many triangles as neighbors: (v, ring[i], ring[i+1]), cyclically. A border vertex has one
// triangle less: its ring starts and ends at its two border neighbors.
class One_rings
{
  typedef std::pair<Index, Index>   Directed_edge;   // opposite to v in a triangle (v, first, second)

public:
  typedef boost::iterator_range<const Index*>   Ring;

  One_rings() = default;
  One_rings(std::size_t number_of_vertices, const std::vector<Index_triangle>& triangles);

  // Reuses the arrays of an earlier build; release_scratch() gives back the half of them that only building needs.
  void build(std::size_t number_of_vertices, const std::vector<Index_triangle>& triangles, const Loops& loops);

  // Makes room for a mesh of that size, so that no later build() has to move the arrays.
  void reserve(std::size_t number_of_vertices, std::size_t number_of_triangles, const Loops& loops);

  void release_scratch();

  std::size_t number_of_vertices() const { return m_is_border.size(); }
  bool is_border(Index v) const { return m_is_border[v] != 0; }

  Ring operator[](Index v) const { return { m_neighbors.data() + m_first[v], m_neighbors.data() + m_first[v + 1] }; }
  std::size_t number_of_triangles(Index v) const { return m_first[v + 1] - m_first[v] - (is_border(v) ? 1 : 0); }

  // Calls f(a, b, i) for the triangles vab around v, the i-th ones.
  template <class Function>
  void for_each_triangle(Index v, const Function& f) const
  {
    const Ring ring = (*this)[v];
    for (std::size_t i = 0; i < number_of_triangles(v); ++i)
      f(ring[i], ring[next_in_cycle(i, ring.size())], i);
  }

  // The same for those of which v is the least vertex: so a loop over the vertices meets every triangle once.
  template <class Function>
  void for_each_triangle_of_least_vertex(Index v, const Function& f) const
  {
    for_each_triangle(v, [&](Index a, Index b, std::size_t i) {
      if (v < a && v < b)
        f(a, b, i);
    });
  }

  // In a loop over vertices, at v: asks for the elements of an array that the neighbors of the next vertices have.
  template <class Array>
  BOOST_FORCEINLINE void prefetch_neighbors_after(Index v, const Array& array) const
  {
    for (Index slot = m_first[v]; slot < m_first[v + 1]; ++slot)
      prefetch_element_after(slot, neighbors(), number_of_slots(), array);
  }

  // Where the ring of v starts in arrays that are parallel to all rings.
  std::size_t first_slot(Index v) const { return m_first[v]; }
  std::size_t number_of_slots() const { return m_neighbors.size(); }

  // All rings one after the other, and where each begins: the pattern of a sparse matrix.
  const Index* offsets() const { return m_first.data(); }
  const Index* neighbors() const { return m_neighbors.data(); }

  // The first vertex whose triangles are not one fan with one orientation, `no_index` if there is none.
  Index first_non_manifold_vertex() const { return m_first_bad_vertex; }

  // Every border as a cycle of vertices, with the surface to its left.
  // Precondition: every vertex is manifold.
  std::vector<std::vector<Index>> borders() const;

private:
  Index edge_begin(Index v) const { return v == 0 ? 0 : edge_end(v - 1); }
  Index edge_end(Index v) const { return m_next_edge[m_next_edge.size() - number_of_vertices() + v]; }

  // Counting sort by vertex, of several parts of the triangles side by side.
  void collect_opposite_edges(std::size_t number_of_vertices, const std::vector<Index_triangle>& triangles,
                              const Loops& loops);

  // Sorts the edges opposite to v, so that each starts where the one before ends. Quadratic in the valence, but in
  // two cache lines; a vertex of high valence sorts them by their start first.
  bool link_ring(Index v);

  bool link_large_ring(Index v);

  // An open fan ends at one more neighbor, a closed one where it began.
  bool close_ring(Index v, Index* out, Index last);

  bool fill_bad_ring(Index v);

  std::vector<Index> m_first, m_neighbors;
  std::vector<unsigned char> m_is_border;
  Index m_first_bad_vertex = no_index;

  std::vector<Directed_edge> m_edges;       // scratch of build()
  // In every part of the triangles, of every vertex; at the end those of the last part end its edges.
  std::vector<Index> m_next_edge;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_ONE_RINGS_H
