// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_CONVERSIONS_H
#define MESH_CONVERSIONS_H

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

// The borders of a mesh, and the mesh as others have it: for a hierarchy, and as a FaceGraph.
namespace test_meshes {

using SMP::internal::One_rings;

typedef CGAL::Simple_cartesian<double>         Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>    Surface_mesh;
typedef CGAL::Simple_cartesian<float>::Point_2 Float_point_2;      // of maps that round

// What is in a map before a run.
template <class Point = Kernel::Point_2>
Point untouched()
{
  return Point(-77, 77);
}

template <class TriangleMesh>
using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

// All borders as cycles of vertices.
inline std::vector<std::vector<Index>> borders(const One_rings& rings)
{
  std::vector<std::vector<Index>> result;
  std::set<Index> found;
  for (Index start = 0; start < rings.number_of_vertices(); ++start)
    if (rings.is_border(start) && found.count(start) == 0) {
      result.emplace_back();
      for (Index v = start; found.insert(v).second; v = rings[v].front())
        result.back().push_back(v);
    }
  return result;
}

// With the border that has most vertices as the outer one.
inline SMP::Triangulated_surface_3 surface(const Flat_mesh& m)
{
  SMP::Triangulated_surface_3 s = { m.points, m.triangles, {} };
  for (const std::vector<Index>& border : borders(One_rings(m.points.size(), m.triangles)))
    if (border.size() > s.outer_border.size())
      s.outer_border = border;
  return s;
}

template <class TriangleMesh>
void append(const Flat_mesh& m, TriangleMesh& mesh)
{
  typedef boost::graph_traits<TriangleMesh>   Graph_traits;
  auto point_map = get(CGAL::vertex_point, mesh);
  typedef typename boost::property_traits<decltype(point_map)>::value_type   Point;
  std::vector<typename Graph_traits::vertex_descriptor> vertices;
  for (const Point_3& p : m.points) {
    vertices.push_back(add_vertex(mesh));
    put(point_map, vertices.back(), Point(p.x(), p.y(), p.z()));
  }
  for (const Index_triangle& t : m.triangles)
    CGAL::Euler::add_face(std::array<typename Graph_traits::vertex_descriptor, 3>{ vertices[t[0]], vertices[t[1]],
                                                                                   vertices[t[2]] },
                          mesh);
}

template <class TriangleMesh>
TriangleMesh make(const Flat_mesh& m)
{
  TriangleMesh mesh;
  append(m, mesh);
  return mesh;
}

// A halfedge of the border that has most edges.
template <class TriangleMesh>
typename boost::graph_traits<TriangleMesh>::halfedge_descriptor longest_border(const TriangleMesh& mesh)
{
  auto longest = boost::graph_traits<TriangleMesh>::null_halfedge();
  std::size_t most = 0;
  for (const auto h : halfedges(mesh))
    if (CGAL::is_border(h, mesh)) {
      const std::size_t size = CGAL::halfedges_around_face(h, mesh).size();
      if (size > most) {
        most = size;
        longest = h;
      }
    }
  return longest;
}

// V - E + F
inline long euler_characteristic(std::size_t number_of_vertices, const std::vector<Index_triangle>& triangles)
{
  std::set<std::pair<Index, Index>> edges;
  for (const Index_triangle& t : triangles)
    for (int i = 0; i < 3; ++i)
      edges.insert(std::minmax({ t[i], t[(i + 1) % 3] }));
  return long(number_of_vertices) - long(edges.size()) + long(triangles.size());
}

} // namespace test_meshes

#endif // MESH_CONVERSIONS_H
