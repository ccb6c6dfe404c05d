// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAM_INPUT_H
#define PROGRAM_INPUT_H

#include "face_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel   Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                    Mesh;

// A mesh, and the part of it that is parameterized: its largest component.
struct Input
{
  std::string name;
  Mesh mesh;
  std::vector<Mesh::Face_index> faces;     // of the largest component
  Mesh::Halfedge_index border;             // on its longest border
  std::size_t number_of_borders = 0;
  std::size_t number_of_components = 0;
};

// Something that is wrong with the input, to be told to the user.
struct Input_error { std::string message; };

inline bool has_suffix(const std::string& text, const std::string& suffix)
{
  return text.size() >= suffix.size() && std::equal(suffix.rbegin(), suffix.rend(), text.rbegin(),
                                                    [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

// Reads OFF, OBJ, PLY or STL as it is: vertices that coincide stay apart, except in STL, which has no other way to join triangles.
inline Mesh read_mesh(const std::string& file)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!std::ifstream(file))
    throw Input_error{ "cannot be opened" };
  if (!CGAL::IO::read_polygon_soup(file, points, polygons))
    throw Input_error{ "cannot be read as OFF, OBJ, PLY or STL" };

  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (polygons[i].size() != 3)
      throw Input_error{ "face " + std::to_string(i) + " has " + std::to_string(polygons[i].size()) + " corners; only triangles can be parameterized" };
    for (const std::size_t v : polygons[i])
      if (v >= points.size())
        throw Input_error{ "face " + std::to_string(i) + " refers to a vertex that does not exist" };
  }
  if (has_suffix(file, ".stl"))
    PMP::merge_duplicate_points_in_polygon_soup(points, polygons);
  if (!PMP::is_polygon_soup_a_polygon_mesh(polygons))
    throw Input_error{ "is no surface: an edge has more than two triangles or two of opposite orientation, or several fans meet at a vertex" };
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  return mesh;
}

// Finds the component with the most faces and its borders.
inline void choose_component(Input& input)
{
  const Mesh& mesh = input.mesh;
  if (mesh.number_of_faces() == 0)
    throw Input_error{ "has no faces" };
  auto component_of = input.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  input.number_of_components = CGAL::Polygon_mesh_processing::connected_components(mesh, component_of);

  std::vector<std::size_t> sizes(input.number_of_components, 0);
  for (const Mesh::Face_index f : mesh.faces())
    ++sizes[component_of[f]];
  const std::size_t largest = std::size_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  for (const Mesh::Face_index f : mesh.faces())
    if (component_of[f] == largest)
      input.faces.push_back(f);

  double greatest_length = -1;
  std::vector<bool> is_visited(mesh.number_of_halfedges(), false);
  for (const Mesh::Halfedge_index h : mesh.halfedges()) {
    if (!mesh.is_border(h) || is_visited[h] || component_of[mesh.face(mesh.opposite(h))] != largest)
      continue;
    ++input.number_of_borders;
    double length = 0;
    for (const Mesh::Halfedge_index g : CGAL::halfedges_around_face(h, mesh)) {
      is_visited[g] = true;
      length += CGAL::Polygon_mesh_processing::edge_length(g, mesh);
    }
    if (!(length <= greatest_length)) {
      greatest_length = length;
      input.border = h;
    }
  }
  if (input.number_of_borders == 0)
    throw Input_error{ "is closed: a surface needs a border to be laid out; cut it open first" };
}

// The named file, or the built-in face.
inline Input read_input(const std::string& file)
{
  Input input;
  input.name = file.empty() ? "face" : file;
  if (file.empty())
    make_face(input.mesh);
  else
    input.mesh = read_mesh(file);
  choose_component(input);
  return input;
}

#endif // PROGRAM_INPUT_H
