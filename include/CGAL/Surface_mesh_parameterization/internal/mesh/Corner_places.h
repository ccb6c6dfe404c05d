// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_CORNER_PLACES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_CORNER_PLACES_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The places that a map from halfedges gives the corners of a mesh. Corners at one vertex with the same coordinates
// share a place. A face has none if a coordinate at one of its corners is not finite.
struct Corner_places
{
  struct Place
  {
    Index vertex;       // its position in vertices(mesh)
    Point_2 uv;
  };

  std::vector<Place> places;          // in the order of the vertices
  std::vector<Index> place_of;        // of the corners, face after face; `no_index` if there is none

  template <class TriangleMesh, class HalfedgeUVMap>
  Corner_places(const TriangleMesh& mesh, HalfedgeUVMap uvmap)
  {
    const auto index_of = get(CGAL::dynamic_vertex_property_t<Index>(), mesh);
    Index number_of_vertices = 0;
    for (const auto v : vertices(mesh))
      put(index_of, v, number_of_vertices++);
    std::vector<Place> corners;
    for (const auto f : faces(mesh)) {
      const std::size_t first = corners.size();
      bool has_place = true;
      for (const auto h : halfedges_around_face(halfedge(f, mesh), mesh)) {
        corners.push_back({ get(index_of, target(h, mesh)), to_point_2(get(uvmap, h)) });
        has_place = has_place && is_finite(corners.back().uv);
      }
      for (std::size_t i = first; i < corners.size() && !has_place; ++i)
        corners[i].vertex = no_index;
    }
    number_places(number_of_vertices, corners);
  }

private:
  // Goes through the corners of one vertex after the other.
  void number_places(Index number_of_vertices, const std::vector<Place>& corners)
  {
    const Compressed_lists<Index> by_vertex(number_of_vertices, [&](const auto& add) {
      for (std::size_t i = 0; i < corners.size(); ++i)
        if (corners[i].vertex != no_index)
          add(corners[i].vertex, Index(i));
    });
    place_of.assign(corners.size(), no_index);
    std::size_t first_of_vertex = 0;
    for (const Index i : by_vertex.items()) {
      const Place& c = corners[i];
      if (!places.empty() && places.back().vertex != c.vertex)
        first_of_vertex = places.size();
      const auto found = std::find_if(places.begin() + std::ptrdiff_t(first_of_vertex), places.end(),
                                      [&](const Place& p) { return p.uv == c.uv; });
      place_of[i] = Index(found - places.begin());
      if (found == places.end())
        places.push_back(c);
    }
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_CORNER_PLACES_H
