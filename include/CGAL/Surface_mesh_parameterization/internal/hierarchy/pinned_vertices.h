// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_PINNED_VERTICES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_PINNED_VERTICES_H

#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/fixed_places.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Pins the vertices of given places that no coarse level can do without. One that lies on the border between two others
// may go: what is left of the border still lies in its place.
inline void pin_fixed_vertices(const Triangulated_surface_3& surface, std::vector<bool>& is_pinned)
{
  const std::vector<bool> is_fixed = are_fixed(surface);
  std::vector<std::pair<Index, Index>> edges;     // directed, between fixed vertices
  for (const Index_triangle& t : surface.triangles)
    for (int i = 0; i < 3; ++i)
      if (is_fixed[t[i]] && is_fixed[t[(i + 1) % 3]])
        edges.push_back({ t[i], t[(i + 1) % 3] });
  std::sort(edges.begin(), edges.end());

  std::vector<unsigned char> fixed_border_neighbors(surface.points.size(), 0);
  for (const auto& [source, target] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), std::make_pair(target, source))) {
      ++fixed_border_neighbors[source];
      ++fixed_border_neighbors[target];
    }
  for (const Triangulated_surface_3::Fixed_vertex& fixed : surface.fixed_vertices)
    if (fixed_border_neighbors[fixed.vertex] < 2)
      is_pinned[fixed.vertex] = true;
}

// The vertices that stay on every level: those that are constrained to, and of the given places those that are needed.
inline std::vector<bool> pinned_vertices(const Triangulated_surface_3& surface, const std::vector<bool>& is_constrained)
{
  std::vector<bool> is_pinned = is_constrained;
  is_pinned.resize(surface.points.size(), false);
  if (!surface.fixed_vertices.empty())
    pin_fixed_vertices(surface, is_pinned);
  return is_pinned;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_PINNED_VERTICES_H
