// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_READ_CORNER_MESH_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_READ_CORNER_MESH_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Calls f(h, i) for the halfedges of all faces of a triangulated mesh, with their numbers in its Corner_mesh.
template <class TriangleMesh, class Function>
void for_each_corner(const TriangleMesh& mesh, const Function& f)
{
  Index i = 0;
  for (const auto face : faces(mesh))
    for (const auto h : halfedges_around_face(halfedge(face, mesh), mesh))
      f(h, i++);
}

// Which halfedges of the Corner_mesh lie on a border of the mesh, rather than at a seam.
template <class TriangleMesh>
std::vector<bool> is_at_hole(const TriangleMesh& mesh)
{
  std::vector<bool> result;
  for_each_corner(mesh, [&](auto h, Index) { result.push_back(CGAL::is_border(opposite(h, mesh), mesh)); });
  return result;
}

// Reads a mesh, cut open along the edges for which the map is true. Faces keep their order. Returns what is wrong:
// `ERROR_EMPTY_MESH`, `ERROR_NON_TRIANGULAR_MESH`, or `ERROR_WRONG_PARAMETER` if a coordinate is not finite or the mesh
// too large.
template <class TriangleMesh, class EdgeSeamMap>
Parameterization_error read_corner_mesh(const TriangleMesh& mesh, EdgeSeamMap is_seam, Corner_mesh& corners)
{
  if (faces(mesh).first == faces(mesh).second)
    return { ERROR_EMPTY_MESH, Parameterization_error::NOWHERE, 0 };
  std::size_t position = 0;
  for (const auto f : faces(mesh)) {
    if (!is_triangle(halfedge(f, mesh), mesh))
      return { ERROR_NON_TRIANGULAR_MESH, Parameterization_error::FACE, position };
    ++position;
  }
  if (position > most_triangles)
    return { ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0, cause_of_size };

  const auto point_map = get(CGAL::vertex_point, mesh);
  const auto index_of = get(CGAL::dynamic_vertex_property_t<Index>(), mesh);
  for (const auto v : vertices(mesh)) {
    corners.points.push_back(to_point_3(get(point_map, v)));
    put(index_of, v, Index(corners.points.size() - 1));
  }

  const auto halfedge_index_of = get(CGAL::dynamic_halfedge_property_t<Index>(), mesh);
  for_each_corner(mesh, [&](auto h, Index i) {
    corners.vertex.push_back(get(index_of, target(h, mesh)));
    put(halfedge_index_of, h, i);
  });
  for (const Index v : corners.vertex)
    if (!is_finite(corners.points[v]))
      return { ERROR_WRONG_PARAMETER, Parameterization_error::VERTEX, v, "a coordinate is not a finite number" };
  for_each_corner(mesh, [&](auto h, Index) {
    const auto o = opposite(h, mesh);
    const bool is_open = CGAL::is_border(o, mesh) || get(is_seam, edge(h, mesh)) || get(is_seam, edge(o, mesh));
    corners.opposite.push_back(is_open ? no_index : get(halfedge_index_of, o));
  });
  split_vertices(corners);
  return {};
}

// The same of a mesh that is not cut.
template <class TriangleMesh>
Parameterization_error read_corner_mesh(const TriangleMesh& mesh, Corner_mesh& corners)
{
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor   edge_descriptor;
  return read_corner_mesh(mesh, CGAL::Constant_property_map<edge_descriptor, bool>(false), corners);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_READ_CORNER_MESH_H
