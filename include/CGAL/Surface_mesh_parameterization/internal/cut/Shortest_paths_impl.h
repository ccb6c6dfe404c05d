// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_SHORTEST_PATHS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_SHORTEST_PATHS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/cut/Shortest_paths.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Shortest_paths::Shortest_paths(const Corner_mesh& mesh)
  : m_mesh(mesh), m_place(mesh.number_of_vertices(), no_index)
{
  for (const std::vector<Index>& border : borders(mesh)) {
    for (const Index h : border)
      m_place[mesh.target(h)] = Index(m_is_border.size());
    m_is_border.push_back(true);
  }
  for (Index& place : m_place)
    if (place == no_index) {
      place = Index(m_is_border.size());
      m_is_border.push_back(false);
    }

  m_leaving = Compressed_lists<Index>(m_is_border.size(), [this](const auto& add) {
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h)
      add(m_place[m_mesh.source(h)], h);
  });
  m_queue = Distance_queue(m_is_border.size());
  m_last_halfedge.assign(m_is_border.size(), no_index);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Shortest_paths::add_sources(const std::vector<Index>& places)
{
  for (const Index place : places) {
    m_queue.reach(place, 0);
    m_last_halfedge[place] = no_index;
  }
  for (Index place; (place = m_queue.take_nearest()) != no_index;)
    for (const Index h : m_leaving[place]) {
      const Index neighbor = m_place[m_mesh.target(h)];
      if (m_queue.reach(neighbor, m_queue.distance(place) + length(m_mesh, h)))
        m_last_halfedge[neighbor] = h;
    }
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Index> Shortest_paths::path_to(Index place) const
{
  std::vector<Index> path;
  for (Index h = m_last_halfedge[place]; h != no_index; h = m_last_halfedge[m_place[m_mesh.source(h)]])
    path.push_back(h);
  return path;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_SHORTEST_PATHS_IMPL_H
