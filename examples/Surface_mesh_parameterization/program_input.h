// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAM_INPUT_H
#define PROGRAM_INPUT_H

#include "face_mesh.h"
#include "program_OBJ.h"
#include "program_OFF.h"
#include "program_PLY.h"
#include "program_STL.h"
#include "program_scanner.h"
#include "program_soup.h"
#include "program_triangulate.h"

#include <CGAL/Surface_mesh_parameterization/internal/mesh/longest_border.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <string>
#include <system_error>
#include <vector>

typedef CGAL::Surface_mesh<Kernel::Point_3>   Mesh;

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

inline bool has_suffix(const std::string& text, const std::string& suffix)
{
  return text.size() >= suffix.size() && std::equal(suffix.rbegin(), suffix.rend(), text.rbegin(),
                                                    [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

// Everything that a stream holds.
inline std::string read_content(std::istream& in)
{
  std::string content;
  char block[1 << 16];
  while (in.read(block, sizeof block), in.gcount() > 0)
    content.append(block, std::size_t(in.gcount()));
  if (in.bad())
    throw Input_error{ "cannot be read" };
  if (content.empty())
    throw Input_error{ "is empty", SMP::ERROR_EMPTY_MESH };
  return content;
}

inline std::string read_content(const std::string& file)
{
  namespace fs = std::filesystem;
  std::error_code unused_error;
  const fs::file_type type = fs::status(file, unused_error).type();
  if (type == fs::file_type::not_found)
    throw Input_error{ "does not exist" };
  if (type != fs::file_type::regular && type != fs::file_type::fifo)
    throw Input_error{ "is no file that can be read" };
  std::ifstream in(file, std::ios::binary);
  if (!in.is_open())
    throw Input_error{ "cannot be opened" };
  return read_content(in);
}

// The ending that a file with that content would have.
inline std::string guess_suffix(const std::string& content)
{
  const std::string first_word = content.substr(0, content.find_first_of(" \t\r\n"));
  if (first_word == "ply")
    return ".ply";
  if (has_suffix(first_word, "off"))      // COFF, NOFF, ...
    return ".off";
  const bool is_text = content.find('\0') == std::string::npos;
  return first_word == "solid" || !is_text ? ".stl" : ".obj";
}

// Reads what a file of that name holds. Not by CGAL::IO::read_polygon_soup(): its readers believe the counts and types that a file states, which costs all
// memory or a crash, and cannot tell which face or vertex is wrong.
inline Polygon_soup read_soup(const std::string& name, const std::string& content)
{
  File_scanner scanner(content);
  if (has_suffix(name, ".off"))
    return OFF_reader(scanner).read();
  if (has_suffix(name, ".obj"))
    return read_OBJ(scanner);
  if (has_suffix(name, ".ply"))
    return PLY_reader(scanner).read();
  if (has_suffix(name, ".stl"))
    return STL_reader(scanner).read();
  throw Input_error{ "is not named .off, .obj, .ply or .stl" };
}

// Makes the mesh as it is: vertices that coincide stay apart, but in STL. With `is_triangulated`, polygons are cut into triangles.
inline Mesh make_mesh(Polygon_soup soup, bool is_triangulated)
{
  if (soup.polygons.empty())
    throw Input_error{ "has no faces", SMP::ERROR_EMPTY_MESH };
  check_indices(soup);
  check_coordinates(soup);
  check_corners(soup, is_triangulated);
  Manifold_check{ soup };
  if (is_triangulated) {
    triangulate(soup);
    Manifold_check{ soup };                // two polygons may have got the same diagonal
  }
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  return mesh;
}

// Finds the component with the most faces and its borders.
inline void choose_component(Input& input)
{
  const Mesh& mesh = input.mesh;
  auto component_of = input.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  input.number_of_components = CGAL::Polygon_mesh_processing::connected_components(mesh, component_of);

  std::vector<std::size_t> sizes(input.number_of_components, 0);
  for (const Mesh::Face_index f : mesh.faces())
    ++sizes[component_of[f]];
  const std::size_t largest = std::size_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  for (const Mesh::Face_index f : mesh.faces())
    if (component_of[f] == largest)
      input.faces.push_back(f);

  const auto longest = SMP::internal::longest_border(mesh, [&](Mesh::Halfedge_index h) { return component_of[mesh.face(mesh.opposite(h))] == largest; });
  input.border = longest.halfedge;
  input.number_of_borders = longest.number_of_borders;
  if (input.number_of_borders == 0)
    throw Input_error{ "is closed: a surface needs a border to be laid out; cut it open first, by leaving out a face or by doubling the vertices along a path of edges",
                       SMP::ERROR_NO_TOPOLOGICAL_DISC };
}

// The mesh of the named file, or of the standard input for "-". Throws an Input_error.
inline Mesh read_mesh(const std::string& file, bool is_triangulated)
{
  if (file == "-") {
    const std::string content = read_content(std::cin);
    return make_mesh(read_soup(guess_suffix(content), content), is_triangulated);
  }
  return make_mesh(read_soup(file, read_content(file)), is_triangulated);
}

// The named file, the standard input, or the built-in face if there is no name. Throws an Input_error.
inline void read_input(const std::string& file, bool is_triangulated, Input& input)
{
  if (file.empty())
    make_face(input.mesh);
  else
    input.mesh = read_mesh(file, is_triangulated);
  choose_component(input);
}

#endif // PROGRAM_INPUT_H
