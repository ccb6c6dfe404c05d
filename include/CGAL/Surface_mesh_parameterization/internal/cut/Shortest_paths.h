// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_SHORTEST_PATHS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_SHORTEST_PATHS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Distance_queue.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The shortest paths along edges from a set of sources, which may grow, in a connected mesh. A border is one place:
// what reaches one of its vertices has reached all of them.
class Shortest_paths
{
public:
  // The mesh is kept by reference; its borders may not change.
  explicit Shortest_paths(const Corner_mesh& mesh);

  // A place is a vertex that is on no border, or a border.
  Index number_of_places() const { return Index(m_is_border.size()); }
  Index place(Index v) const { return m_place[v]; }
  bool is_border(Index place) const { return m_is_border[place]; }

  // Adds places to the sources, and shortens the paths that become shorter.
  void add_sources(const std::vector<Index>& places);

  // From the nearest source, along edges.
  double distance(Index place) const { return m_queue.distance(place); }

  // The halfedge by which the shortest path enters the place; `no_index` at a source.
  Index last_halfedge(Index place) const { return m_last_halfedge[place]; }

  // The halfedges of the shortest path, the last one first.
  std::vector<Index> path_to(Index place) const;

  // The farthest place, the least one of several.
  Index farthest() const { return m_queue.farthest(); }

private:
  const Corner_mesh& m_mesh;
  std::vector<Index> m_place;                       // by vertex
  std::vector<bool> m_is_border;                    // by place
  Compressed_lists<Index> m_leaving;                // the halfedges that leave each place
  Distance_queue m_queue;                           // of places
  std::vector<Index> m_last_halfedge;               // by place
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/cut/Shortest_paths_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_SHORTEST_PATHS_H
