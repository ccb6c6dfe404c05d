// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_FILLED_MESH_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_FILLED_MESH_H

#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/detection.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/holes.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

template <class TriangleMesh>
using Face_added = decltype(add_vertex(std::declval<TriangleMesh&>()), add_face(std::declval<TriangleMesh&>()));

// Whether faces can be added to a copy of a mesh.
template <class TriangleMesh>
constexpr bool is_fillable = std::is_copy_constructible<TriangleMesh>::value && is_detected<Face_added, TriangleMesh>;

// A copy of a mesh in which every border of the component of `bhd`, but the outer one, is closed by a vertex in the
// middle of it.
template <class TriangleMesh>
class Filled_mesh
{
  typedef boost::graph_traits<TriangleMesh>                                           Graph_traits;
  typedef typename Graph_traits::vertex_descriptor                                    vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor                                  halfedge_descriptor;
  typedef CGAL::dynamic_vertex_property_t<vertex_descriptor>                          Vertex_property;
  typedef typename boost::property_map<TriangleMesh, Vertex_property>::const_type     Original_map;

public:
  // A mesh that would be rejected is copied as it is.
  Filled_mesh(const TriangleMesh& mesh, halfedge_descriptor bhd) : m_mesh(mesh), m_border(bhd)
  {
    // Halfedges of a copy come in the same order, vertices not always: those of a linear cell complex do not.
    std::vector<std::pair<vertex_descriptor, vertex_descriptor>> copies;         // and originals
    auto copy = halfedges(m_mesh).begin();
    for (const halfedge_descriptor h : halfedges(mesh)) {
      if (h == bhd)
        m_border = *copy;
      if (h == halfedge(target(h, mesh), mesh))
        copies.emplace_back(target(*copy, m_mesh), target(h, mesh));
      ++copy;
    }
    m_has_same_descriptors =
        std::all_of(copies.begin(), copies.end(), [](const auto& pair) { return pair.first == pair.second; });
    const Mesh_component<TriangleMesh> component(m_mesh, m_border);
    if (component.error().code == OK)
      fill_holes(component);

    m_original = get(Vertex_property(), std::as_const(m_mesh));
    for (const vertex_descriptor v : vertices(m_mesh))
      put(m_original, v, Graph_traits::null_vertex());
    for (const auto& [v, original_vertex] : copies)
      put(m_original, v, original_vertex);
  }

  Filled_mesh(const Filled_mesh&) = delete;
  Filled_mesh& operator=(const Filled_mesh&) = delete;

  TriangleMesh& mesh() { return m_mesh; }
  halfedge_descriptor border() const { return m_border; }

  // Whether a vertex of the original, where the user named one, is the same one in the copy.
  bool has_same_descriptors() const { return m_has_same_descriptors; }

  // The vertex of the original that a vertex is a copy of, null_vertex() for those in the middle of holes.
  vertex_descriptor original(vertex_descriptor v) const { return get(m_original, v); }

private:
  void fill_holes(const Mesh_component<TriangleMesh>& component)
  {
    const auto is_outer = get(CGAL::dynamic_halfedge_property_t<bool>(), std::as_const(m_mesh));
    for (const halfedge_descriptor h : halfedges(m_mesh))
      put(is_outer, h, false);
    for (const halfedge_descriptor h : halfedges_around_face(m_border, m_mesh))
      put(is_outer, h, true);
    for (const auto f : component.faces_of_component())
      for (const halfedge_descriptor g : halfedges_around_face(halfedge(f, m_mesh), m_mesh))
        if (const halfedge_descriptor h = opposite(g, m_mesh); is_border(h, m_mesh) && !get(is_outer, h))
          fill_hole(h);
  }

  void fill_hole(halfedge_descriptor h)
  {
    const auto point_map = get(CGAL::vertex_point, m_mesh);
    typedef typename boost::property_traits<decltype(point_map)>::value_type   User_point_3;
    const auto place = [&](vertex_descriptor v) { return to_point_3(get(point_map, v)); };
    Hole_3 hole;
    for (const halfedge_descriptor g : halfedges_around_face(h, m_mesh)) {
      const halfedge_descriptor o = opposite(g, m_mesh), n = next(o, m_mesh);
      hole.places.push_back(place(target(g, m_mesh)));
      hole.triangles.push_back({ hole.places.back(), place(target(o, m_mesh)), place(target(n, m_mesh)) });
    }
    const Point_3 middle = middle_of_hole(hole);
    Euler::fill_hole(h, m_mesh);
    put(point_map, target(Euler::add_center_vertex(h, m_mesh), m_mesh),
        User_point_3(middle.x(), middle.y(), middle.z()));
  }

  TriangleMesh m_mesh;
  halfedge_descriptor m_border;
  Original_map m_original;
  bool m_has_same_descriptors;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_FILLED_MESH_H
