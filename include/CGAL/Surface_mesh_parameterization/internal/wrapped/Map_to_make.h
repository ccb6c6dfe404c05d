// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_MAP_TO_MAKE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_MAP_TO_MAKE_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Component_map.h>

#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A component whose vertices have numbers, and arrays in their order for its map.
template <class TriangleMesh, class Point>
struct Map_to_make
{
  typedef boost::graph_traits<TriangleMesh>            Graph_traits;
  typedef typename Graph_traits::vertex_descriptor     vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor   halfedge_descriptor;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<int>>::const_type     Index_map;
  typedef Component_map<Index_map, Point>              Uv_map;
  typedef Component_map<Index_map, char>               Placed_map;

  const TriangleMesh& mesh;
  halfedge_descriptor bhd;
  const std::vector<vertex_descriptor>& vertices;
  Index_map index;
  std::vector<Point> uv;              // not finite where there is no place yet
  std::vector<char> is_placed;

  Index number(vertex_descriptor v) const { return Index(get(index, v)); }

  Uv_map uv_map() { return { index, &uv }; }
  Placed_map placed_map() { return { index, &is_placed }; }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_MAP_TO_MAKE_H
