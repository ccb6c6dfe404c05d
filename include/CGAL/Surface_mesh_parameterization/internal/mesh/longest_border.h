// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_LONGEST_BORDER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_LONGEST_BORDER_H

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <unordered_set>

namespace CGAL::Surface_mesh_parameterization::internal {

template <class TriangleMesh>
struct Longest_border
{
  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor   halfedge =
      boost::graph_traits<TriangleMesh>::null_halfedge();
  std::size_t number_of_borders = 0;
};

// The longest of the borders whose halfedges are wanted; a null halfedge if there is none. Unlike that of
// Polygon_mesh_processing, it also finds a border whose squared lengths overflow, or are all zero, and takes none of
// edges without faces. One whose length is no number is the longest, so that its fault is told.
template <class TriangleMesh, class Is_wanted>
Longest_border<TriangleMesh> longest_border(const TriangleMesh& mesh, const Is_wanted& is_wanted)
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor   halfedge_descriptor;
  const auto point_map = get(CGAL::vertex_point, mesh);
  Longest_border<TriangleMesh> longest;
  double greatest_length = -1;
  std::unordered_set<halfedge_descriptor> visited;
  for (const halfedge_descriptor start : halfedges(mesh)) {
    if (!is_border(start, mesh) || visited.count(start) || !is_wanted(start))
      continue;
    double length = 0;
    bool has_face = false;
    for (const halfedge_descriptor h : halfedges_around_face(start, mesh)) {
      visited.insert(h);
      has_face = has_face || !is_border(opposite(h, mesh), mesh);
      const auto& p = get(point_map, source(h, mesh));
      const auto& q = get(point_map, target(h, mesh));
      length +=
          std::hypot(CGAL::to_double(q.x()) - CGAL::to_double(p.x()), CGAL::to_double(q.y()) - CGAL::to_double(p.y()),
                     CGAL::to_double(q.z()) - CGAL::to_double(p.z()));
    }
    if (!has_face)
      continue;
    ++longest.number_of_borders;
    if (!(length <= greatest_length) && !std::isnan(greatest_length)) {
      greatest_length = length;
      longest.halfedge = start;
    }
  }
  return longest;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_LONGEST_BORDER_H
