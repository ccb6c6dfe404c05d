// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_ADDED_EDGES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_ADDED_EDGES_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Ring_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The edges that the collapses of a group add to the mesh before it: a list for each vertex.
class Added_edges
{
public:
  void reset(std::size_t number_of_vertices)
  {
    m_first.assign(number_of_vertices, no_index);
    m_edges.clear();
  }

  void add(Index v, Index w)
  {
    append(v, w);
    append(w, v);
  }

  // Whether one joins the vertex to the ring.
  bool join(Index v, const Ring_mesh::Ring& ring) const
  {
    for (Index e = m_first[v]; e != no_index; e = m_edges[e].next)
      if (ring.contains(m_edges[e].neighbor))
        return true;
    return false;
  }

private:
  struct Edge { Index neighbor, next; };

  void append(Index from, Index to)
  {
    m_edges.push_back({ to, m_first[from] });
    m_first[from] = Index(m_edges.size() - 1);
  }

  std::vector<Index> m_first;       // of each vertex
  std::vector<Edge> m_edges;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_ADDED_EDGES_H
