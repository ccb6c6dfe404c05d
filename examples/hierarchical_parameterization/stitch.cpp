// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces whose points are there several times.

#include "stitch.h"

#include "Polygon_soup.h"
#include "components.h"

#include <CGAL/Polygon_mesh_processing/stitch_borders.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace {

// The corners of a face as they are before borders are joined.
struct Face_corners
{
  std::array<Mesh::Halfedge_index, 3> halfedges;
  std::array<Mesh::Vertex_index, 3> vertices;
};

std::vector<Face_corners> corners_of_faces(const Mesh& mesh)
{
  std::vector<Face_corners> result;
  for (const Mesh::Face_index f : mesh.faces()) {
    Mesh::Halfedge_index h = mesh.halfedge(f);
    result.emplace_back();
    for (std::size_t i = 0; i < 3; ++i, h = mesh.next(h)) {
      result.back().halfedges[i] = h;
      result.back().vertices[i] = mesh.target(h);
    }
  }
  return result;
}

// The halfedge to the first of these corners after borders were joined. Of a face that has lost all of its halfedges,
// points tell it.
Mesh::Halfedge_index halfedge_to_first(const Mesh& mesh, Mesh::Face_index f, const Face_corners& corners)
{
  for (std::size_t i = 0; i < 3; ++i)
    if (const Mesh::Halfedge_index h = corners.halfedges[i]; !mesh.is_removed(h) && mesh.face(h) == f)
      return i == 0 ? h : i == 1 ? mesh.prev(h) : mesh.next(h);
  Mesh::Halfedge_index h = mesh.halfedge(f);
  for (int turns = 0; turns < 2 && (mesh.point(mesh.target(h)) != mesh.point(corners.vertices[0]) ||
                                    mesh.point(mesh.target(mesh.next(h))) != mesh.point(corners.vertices[1]));
       ++turns)
    h = mesh.next(h);
  return h;
}

} // namespace

void stitch(Mesh& mesh)
{
  const std::vector<Face_corners> corners = corners_of_faces(mesh);
  const std::size_t n = mesh.number_of_vertices();
  CGAL::Polygon_mesh_processing::stitch_borders(mesh);

  // Not by collect_garbage(), which puts the last vertices into the places of those that are gone.
  std::vector<Mesh::Vertex_index> joined;                       // what became of each vertex
  for (std::size_t v = 0; v < n; ++v)
    joined.emplace_back(Mesh::size_type(v));
  for (const Mesh::Face_index f : mesh.faces()) {
    Mesh::Halfedge_index h = halfedge_to_first(mesh, f, corners[f]);
    for (std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
      joined[corners[f].vertices[i]] = mesh.target(h);
  }
  Polygon_soup compact;
  constexpr std::size_t none = std::size_t(-1);
  std::vector<std::size_t> image(n, none);      // in the new mesh, of what vertices became
  for (std::size_t v = 0; v < n; ++v)
    if (image[joined[v]] == none) {
      image[joined[v]] = compact.points.size();
      compact.points.push_back(coordinates(mesh.point(Mesh::Vertex_index(Mesh::size_type(v)))));
    }
  for (const Face_corners& c : corners)
    compact.polygons.push_back({ image[joined[c.vertices[0]]], image[joined[c.vertices[1]]],
                                 image[joined[c.vertices[2]]] });
  mesh = manifold_mesh(compact);
}

std::size_t number_of_separate_pieces(const Mesh& mesh)
{
  struct Border_edge
  {
    std::array<Kernel::Point_3, 2> ends;      // in order
    std::size_t component;
    bool operator<(const Border_edge& other) const { return ends < other.ends; }
  };
  const std::vector<std::size_t> component_of = number_components(mesh);
  std::vector<Border_edge> edges;
  for (const Mesh::Halfedge_index h : mesh.halfedges())
    if (mesh.is_border(h)) {
      Border_edge e = { { mesh.point(mesh.source(h)), mesh.point(mesh.target(h)) },
                        component_of[mesh.face(mesh.opposite(h))] };
      if (e.ends[1] < e.ends[0])
        std::swap(e.ends[0], e.ends[1]);
      edges.push_back(e);
    }
  std::sort(edges.begin(), edges.end());

  std::vector<bool> is_separate(mesh.number_of_faces(), false);
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].ends == edges[i - 1].ends && edges[i].component != edges[i - 1].component)
      is_separate[edges[i].component] = is_separate[edges[i - 1].component] = true;
  return std::size_t(std::count(is_separate.begin(), is_separate.end(), true));
}
