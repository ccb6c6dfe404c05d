// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PLANE_PATH_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PLANE_PATH_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Distance_queue.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The border that encloses the greatest area in the plane.
struct Outer_border
{
  std::vector<Index> halfedges;
  double area = 0;
};

inline Outer_border outer_border(const Corner_mesh& mesh, const std::vector<Point_2>& uv)
{
  Outer_border result;
  for (std::vector<Index>& border : borders(mesh)) {
    std::vector<Point_2> polygon;
    for (const Index h : border)
      polygon.push_back(uv[mesh.target(h)]);
    if (const double area = 0.5 * doubled_area(polygon); area > result.area)
      result = { std::move(border), area };
  }
  return result;
}

// Searches the path along edges from one vertex on the outer border to another for which least has to be cut in the
// plane: edges at holes are cut already. Of the edges that lead to other vertices on the outer border, a multiple
// counts. Without holes the search prefers what is near to the goal (A*).
class Plane_path
{
public:
  Plane_path(const Corner_mesh& mesh, const std::vector<Point_2>& uv, Index start, Index goal)
    : m_mesh(mesh), m_uv(uv), m_start(start), m_goal(goal), m_is_on_outer_border(mesh.number_of_vertices(), false),
      m_leaving(mesh.number_of_vertices()), m_queue(mesh.number_of_vertices()),
      m_last_halfedge(mesh.number_of_vertices(), no_index)
  {
    const Outer_border border = outer_border(mesh, uv);
    for (const Index h : border.halfedges)
      m_is_on_outer_border[mesh.target(h)] = true;
    m_has_holes = border.halfedges.size() < find_leaving_halfedges();
    run();
  }

  // Its halfedges, the last one first.
  std::vector<Index> halfedges() const
  {
    std::vector<Index> path;
    for (Index v = m_goal; v != m_start && m_last_halfedge[v] != no_index; v = other_end(path.back(), v))
      path.push_back(m_last_halfedge[v]);
    return path;
  }

private:
  // Returns the number of halfedges on borders.
  std::size_t find_leaving_halfedges()
  {
    std::vector<bool> is_on_border(m_mesh.number_of_vertices(), false);
    std::size_t border_halfedges = 0;
    for (Index h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      border_halfedges += m_mesh.is_border(h);
      if (!is_on_border[m_mesh.source(h)]) {
        m_leaving[m_mesh.source(h)] = h;
        is_on_border[m_mesh.source(h)] = m_mesh.is_border(h);
      }
    }
    return border_halfedges;
  }

  void run()
  {
    m_queue.reach(m_start, 0);
    for (Index v; (v = m_queue.take_nearest()) != no_index && v != m_goal;) {
      // Counter-clockwise around the vertex, from the border if it is on one.
      Index h = m_leaving[v];
      do {
        reach(h, m_mesh.target(h));
        h = Corner_mesh::previous(h);
        if (m_mesh.is_border(h))
          reach(h, m_mesh.source(h));
        h = m_mesh.opposite[h];
      } while (h != no_index && h != m_leaving[v]);
    }
  }

  void reach(Index h, Index w)
  {
    const Index v = other_end(h, w);
    if (m_queue.reach(w, m_queue.distance(v) + cost(h, v, w), m_has_holes ? 0 : distance(w, m_goal)))
      m_last_halfedge[w] = h;
  }

  double cost(Index h, Index v, Index w) const
  {
    constexpr double multiple_at_border = 3;
    if (m_mesh.is_border(h) && !m_is_on_outer_border[v])
      return 0;
    return distance(v, w) * (m_is_on_outer_border[w] && w != m_goal ? multiple_at_border : 1);
  }

  double distance(Index v, Index w) const { return std::sqrt((m_uv[w] - m_uv[v]).squared_length()); }
  Index other_end(Index h, Index v) const { return m_mesh.source(h) == v ? m_mesh.target(h) : m_mesh.source(h); }

  const Corner_mesh& m_mesh;
  const std::vector<Point_2>& m_uv;
  Index m_start, m_goal;
  std::vector<bool> m_is_on_outer_border;
  bool m_has_holes;
  std::vector<Index> m_leaving;             // by vertex: a halfedge; the first one of those on a border
  Distance_queue m_queue;
  std::vector<Index> m_last_halfedge;       // by vertex: of the best path to it
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PLANE_PATH_H
