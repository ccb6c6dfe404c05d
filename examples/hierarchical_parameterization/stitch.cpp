// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces whose points are there several times.

#include "stitch.h"

#include "components.h"

#include <CGAL/Polygon_mesh_processing/stitch_borders.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

void stitch(Mesh& mesh)
{
  std::vector<Kernel::Point_3> first_corners;
  for (const Mesh::Face_index f : mesh.faces())
    first_corners.push_back(mesh.point(mesh.target(mesh.halfedge(f))));
  CGAL::Polygon_mesh_processing::stitch_borders(mesh);

  // Not by collect_garbage(), which puts the last vertices into the places of those that are gone.
  Mesh compact;
  std::vector<Mesh::Vertex_index> image(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  for (const Mesh::Vertex_index v : mesh.vertices())
    image[v] = compact.add_vertex(mesh.point(v));
  for (const Mesh::Face_index f : mesh.faces()) {
    std::array<Mesh::Vertex_index, 3> corners;
    std::size_t i = 0, first = 0;
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
      if (mesh.point(v) == first_corners[f])
        first = i;
      corners[i++] = image[v];
    }
    std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(first), corners.end());
    compact.add_face(corners[0], corners[1], corners[2]);
  }
  mesh = compact;
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
