// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads meshes.

#include "read_mesh.h"

#include "Polygon_soup.h"
#include "has_suffix.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <string>
#include <system_error>

namespace {

// Everything that a stream holds.
std::string read_content(std::istream& in)
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

std::string read_content(const std::string& file)
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
std::string guess_suffix(const std::string& content)
{
  const std::string first_word = content.substr(0, content.find_first_of(" \t\r\n"));
  if (first_word == "ply")
    return ".ply";
  if (has_suffix(first_word, "off"))      // COFF, NOFF, ...
    return ".off";
  const bool is_text = content.find('\0') == std::string::npos;
  return first_word == "solid" || !is_text ? ".stl" : ".obj";
}

} // namespace

Mesh make_mesh(Polygon_soup soup, bool is_triangulated)
{
  if (soup.polygons.empty())
    throw Input_error{ "has no faces", SMP::ERROR_EMPTY_MESH };
  check_indices(soup);
  check_coordinates(soup);
  check_corners(soup, is_triangulated);
  check_manifold(soup);
  if (is_triangulated) {
    triangulate(soup);
    check_manifold(soup);                 // two polygons may have got the same diagonal
  }
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  return mesh;
}

Mesh read_mesh(const std::string& file, bool is_triangulated)
{
  if (file == "-") {
    const std::string content = read_content(std::cin);
    return make_mesh(read_soup(guess_suffix(content), content), is_triangulated);
  }
  return make_mesh(read_soup(file, read_content(file)), is_triangulated);
}
