// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PATH_IN_PLANE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PATH_IN_PLANE_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Distance_queue.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The halfedges of the border that encloses the greatest area in the plane.
inline std::vector<Index> outer_border(const Corner_mesh& mesh, const std::vector<Point_2>& uv)
{
  std::vector<Index> result;
  double greatest_area = 0;
  for (std::vector<Index>& border : borders(mesh)) {
    double area = 0;
    for (const Index h : border)
      area += 0.5 * cross(uv[mesh.source(h)] - uv[mesh.source(border[0])],
                          uv[mesh.target(h)] - uv[mesh.source(border[0])]);
    if (area > greatest_area) {
      greatest_area = area;
      result = std::move(border);
    }
  }
  return result;
}

// The halfedges of the path along edges from one vertex on the outer border to another for which least has to be cut in
// the plane: edges at holes are cut already. Of the edges that lead to other vertices on the outer border, a multiple
// counts. Without holes the search prefers what is near to the goal (A*).
inline std::vector<Index> path_in_plane(const Corner_mesh& mesh, const std::vector<Point_2>& uv,
                                        const std::vector<Index>& outer_border, Index start, Index goal)
{
  constexpr double multiple_at_border = 3;
  const auto distance = [&](Index v, Index w) { return std::sqrt((uv[w] - uv[v]).squared_length()); };
  std::vector<bool> is_on_border(mesh.number_of_vertices(), false), is_on_outer_border = is_on_border;
  std::vector<Index> leaving(mesh.number_of_vertices());          // a halfedge; the first one of those on a border
  std::size_t border_edges = 0;
  for (Index h = 0; h < mesh.number_of_halfedges(); ++h) {
    border_edges += mesh.is_border(h);
    if (!is_on_border[mesh.source(h)]) {
      leaving[mesh.source(h)] = h;
      is_on_border[mesh.source(h)] = mesh.is_border(h);
    }
  }
  for (const Index h : outer_border)
    is_on_outer_border[mesh.target(h)] = true;
  const bool has_holes = outer_border.size() < border_edges;
  const auto cost = [&](Index h, Index v, Index w) {
    if (mesh.is_border(h) && !is_on_outer_border[v])
      return 0.;
    return distance(v, w) * (is_on_outer_border[w] && w != goal ? multiple_at_border : 1);
  };

  Distance_queue queue(mesh.number_of_vertices());
  std::vector<Index> last_halfedge(mesh.number_of_vertices(), no_index);
  const auto reach = [&](Index h, Index w) {
    const Index v = mesh.source(h) == w ? mesh.target(h) : mesh.source(h);
    if (queue.reach(w, queue.distance(v) + cost(h, v, w), has_holes ? 0 : distance(w, goal)))
      last_halfedge[w] = h;
  };
  queue.reach(start, 0);
  for (Index v; (v = queue.take_nearest()) != no_index && v != goal;) {
    // Counter-clockwise around the vertex, from the border if it is on one.
    Index h = leaving[v];
    do {
      reach(h, mesh.target(h));
      h = Corner_mesh::previous(h);
      if (mesh.is_border(h))
        reach(h, mesh.source(h));
      h = mesh.opposite[h];
    } while (h != no_index && h != leaving[v]);
  }
  std::vector<Index> path;
  for (Index v = goal; v != start && last_halfedge[v] != no_index;) {
    const Index h = last_halfedge[v];
    path.push_back(h);
    v = mesh.source(h) == v ? mesh.target(h) : mesh.source(h);
  }
  return path;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PATH_IN_PLANE_H
