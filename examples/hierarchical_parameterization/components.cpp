// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The connected components of a surface.

#include "components.h"

#include "Polygon_soup.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

std::vector<std::size_t> number_components(const Mesh& mesh)
{
  // Sets of faces as trees, the first face of each its root.
  std::vector<std::size_t> parent(mesh.number_of_faces());
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  const auto root = [&](std::size_t f) {
    for (; parent[f] != f; f = parent[f])
      parent[f] = parent[parent[f]];
    return f;
  };
  for (const Mesh::Edge_index e : mesh.edges()) {
    const Mesh::Face_index f = mesh.face(mesh.halfedge(e, 0)), g = mesh.face(mesh.halfedge(e, 1));
    if (f != Mesh::null_face() && g != Mesh::null_face()) {
      const auto [first, second] = std::minmax({ root(f), root(g) });
      parent[second] = first;
    }
  }
  std::size_t number_of_components = 0;
  for (std::size_t f = 0; f < parent.size(); ++f)      // from here on, of the faces before, their numbers
    parent[f] = parent[f] == f ? number_of_components++ : parent[parent[f]];
  return parent;
}

std::vector<Component> find_components(const Mesh& mesh)
{
  const std::vector<std::size_t> number = number_components(mesh);
  std::vector<Component> components;
  for (const Mesh::Face_index f : mesh.faces()) {
    if (number[f] == components.size())
      components.emplace_back();
    components[number[f]].faces.push_back(f);
  }

  const auto number_at = [&](Mesh::Halfedge_index h) {
    return number[mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h)];
  };
  std::vector<std::size_t> border_sizes(components.size(), 0);
  std::vector<bool> is_visited(mesh.number_of_halfedges(), false);
  for (const Mesh::Halfedge_index start : mesh.halfedges()) {
    if (!mesh.is_border(start) || is_visited[start])
      continue;
    const std::size_t i = number_at(start);
    ++components[i].number_of_borders;
    for (const Mesh::Halfedge_index h : mesh.halfedges_around_face(start)) {
      is_visited[h] = true;
      ++border_sizes[i];
    }
  }

  // 2 V - 2 E + 2 F: a triangle has three halfedges of 2 E, and the border the others.
  std::vector<std::ptrdiff_t> doubled_characteristic;
  for (std::size_t i = 0; i < components.size(); ++i)
    doubled_characteristic.push_back(-std::ptrdiff_t(components[i].faces.size() + border_sizes[i]));
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (!mesh.is_isolated(v))
      doubled_characteristic[number_at(mesh.halfedge(v))] += 2;
  for (std::size_t i = 0; i < components.size(); ++i)
    components[i].number_of_handles =
        std::size_t(2 - doubled_characteristic[i] / 2 - std::ptrdiff_t(components[i].number_of_borders)) / 2;
  return components;
}

Mesh mesh_of(const Mesh& mesh, const std::vector<Mesh::Face_index>& faces)
{
  Polygon_soup result;
  constexpr std::size_t none = std::size_t(-1);
  std::vector<std::size_t> image(mesh.number_of_vertices(), none);
  for (const Mesh::Face_index f : faces) {
    result.polygons.emplace_back();
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
      if (image[v] == none) {
        image[v] = result.points.size();
        result.points.push_back(coordinates(mesh.point(v)));
      }
      result.polygons.back().push_back(image[v]);
    }
  }
  return manifold_mesh(result);
}
