// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is parameterized.

#include "input.h"

#include "../Surface_mesh_parameterization/face_mesh.h"
#include "Polygon_soup.h"
#include "File_scanner.h"
#include "OFF_reader.h"
#include "components.h"
#include "has_suffix.h"
#include "stitch.h"
#include "triangulate_polygons.h"

#include <CGAL/Surface_mesh_parameterization/internal/mesh/longest_border.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <string>
#include <system_error>
#include <vector>

namespace {

// Everything that a stream holds, which may be about so many bytes.
std::string read_content(std::istream& in, bool may_be_empty, std::size_t expected_size)
{
  std::string content;
  content.reserve(expected_size);
  char block[1 << 16];
  while (in.read(block, sizeof block), in.gcount() > 0)
    content.append(block, std::size_t(in.gcount()));
  if (in.bad() || (&in == &std::cin && std::ferror(stdin)))
    throw Input_error{ "cannot be read" };
  if (content.empty() && !may_be_empty)
    throw Input_error{ "is empty", SMP::ERROR_EMPTY_MESH };
  constexpr char byte_order_mark[] = "\xef\xbb\xbf";
  if (content.compare(0, 3, byte_order_mark) == 0)
    content.erase(0, 3);
  return content;
}

} // namespace

std::string read_content(const std::string& file, bool may_be_empty)
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
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);      // a pipe has none
  return read_content(in, may_be_empty, error ? 0 : std::size_t(size));
}

namespace {

// The ending that a file with that content would have.
std::string guess_suffix(const std::string& content)
{
  File_scanner scanner(content);
  scanner.skip_comments();
  const std::string first_word(scanner.word());
  if (first_word == "ply")
    return ".ply";
  if (OFF_keyword(first_word).length > 0)
    return ".off";
  const bool is_text = content.find('\0') == std::string::npos;
  const bool is_solid = first_word.size() == 5 && has_suffix(first_word, "solid");      // in capitals, too
  return is_solid || !is_text ? ".stl" : ".obj";
}

} // namespace

Mesh make_mesh(Polygon_soup soup, const Soup_options& options, std::size_t* left_out)
{
  if (soup.polygons.empty())
    throw Input_error{ "has no faces", SMP::ERROR_EMPTY_MESH };
  check_indices(soup);
  check_coordinates(soup);
  if (options.is_oriented) {
    if (options.is_stitched)
      merge_points(soup);      // neighbors that run against each other would stay apart
    remove_repeated_corners(soup);
  }
  check_corners(soup, options.is_triangulated, options.is_oriented);
  if (options.is_oriented) {
    const std::size_t number = remove_collapsed_faces(soup);
    if (soup.polygons.empty())
      throw Input_error{ "has no faces of three vertices", SMP::ERROR_EMPTY_MESH };
    if (left_out)
      *left_out += number;
  } else if (options.is_triangulated)
    check_manifold(soup);      // names the faces of the file
  if (options.is_triangulated)
    triangulate_polygons(soup);      // two polygons may get the same diagonal
  if (options.is_oriented)
    CGAL::Polygon_mesh_processing::orient_polygon_soup(soup.points, soup.polygons);
  return manifold_mesh(soup);
}

namespace {

Polygon_soup read_polygons(const std::string& file)
{
  const bool is_standard_input = file == "-";
  if (!is_standard_input && std::filesystem::path(file).has_extension())
    return read_soup(file, ::read_content(file));
  const std::string content = is_standard_input ? read_content(std::cin, false, 0) : ::read_content(file);
  const std::string suffix = guess_suffix(content);
  Polygon_soup soup = read_soup(suffix, content);
  if (suffix == ".obj" && soup.points.empty())      // any text may be that
    throw Input_error{ "is not OFF, OBJ, PLY or STL" };
  return soup;
}

} // namespace

Mesh read_mesh(const std::string& file, const Soup_options& options, std::size_t* left_out)
{
  return make_mesh(read_polygons(file), options, left_out);      // the file's content is gone by then
}

Mesh built_in_face()
{
  Mesh mesh;
  make_face(mesh);
  return mesh;
}

namespace {

const Component& largest(const std::vector<Component>& components)
{
  return *std::max_element(components.begin(), components.end(), [](const Component& a, const Component& b) {
    return a.faces.size() < b.faces.size();
  });
}

void take_as_chart(const Component& component, Input& input)
{
  if (component.needs_cut()) {
    const bool is_closed = component.number_of_borders == 0;
    throw Input_error{ std::string(input.number_of_components > 1 ? "its largest component " : "") +
                           (is_closed ? "is closed: a chart needs a border; --cut auto makes one"
                                      : "has a handle: a chart has none; --cut auto cuts it") +
                           ", but not for --flat, --levels, --start and --hold; or cut it open first, by " +
                           (is_closed ? "leaving out a face or by doubling the vertices along a path of edges"
                                      : "doubling the vertices along two loops of edges"),
                       SMP::ERROR_NO_TOPOLOGICAL_DISC };
  }
  input.faces = component.faces;
  input.number_of_borders = component.number_of_borders;
  std::vector<bool> is_inside(input.mesh.number_of_faces(), false);
  for (const Mesh::Face_index f : component.faces)
    is_inside[f] = true;
  input.border = SMP::internal::longest_border(input.mesh, [&](Mesh::Halfedge_index h) {
    return is_inside[input.mesh.face(input.mesh.opposite(h))];
  }).halfedge;
}

void take_as_atlas(const std::vector<Component>& components, bool cuts, Input& input)
{
  input.is_atlas = true;
  for (const Component& c : components)
    if (c.needs_cut() && !cuts)
      input.left_out.push_back(c.faces.front());
    else {
      input.faces.insert(input.faces.end(), c.faces.begin(), c.faces.end());
      input.number_of_borders += c.number_of_borders;
    }
  if (input.faces.empty())
    throw Input_error{ "every component is closed or has handles; --cut auto cuts them",
                       SMP::ERROR_NO_TOPOLOGICAL_DISC };
  std::sort(input.faces.begin(), input.faces.end());
}

} // namespace

std::vector<bool> vertices_of_faces(const Input& input)
{
  std::vector<bool> result(input.mesh.number_of_vertices(), false);
  for (const Mesh::Face_index f : input.faces)
    for (const Mesh::Vertex_index v : input.mesh.vertices_around_face(input.mesh.halfedge(f)))
      result[v] = true;
  return result;
}

void choose_component(Input& input)
{
  const std::vector<Component> components = find_components(input.mesh);
  input.number_of_components = components.size();
  take_as_chart(largest(components), input);
}

void read_input(const std::string& file, const Input_options& options, Input& input)
{
  if (file.empty())
    input.mesh = built_in_face();
  else
    input.mesh = read_mesh(file, options, &input.collapsed_faces);
  if (options.is_stitched)
    stitch(input.mesh);
  std::vector<Component> components = find_components(input.mesh);
  input.number_of_components = components.size();
  if (components.size() > 1)
    input.number_of_pieces = number_of_separate_pieces(input.mesh);
  if (!options.takes_all_components)
    components = { largest(components) };
  if (components.size() == 1 && !(components[0].needs_cut() && options.cuts) && !options.makes_atlas)
    take_as_chart(components[0], input);
  else
    take_as_atlas(components, options.cuts, input);
}

void read_start(const std::string& file, Input& input)
try {
  const Polygon_soup soup = read_soup(file, read_content(file), true);
  if (soup.uv.empty())
    throw Input_error{ "has no map with uv coordinates for each vertex, nor has an atlas: PLY with the vertex "
                       "properties u and v, or OBJ with texture coordinates expected" };
  if (soup.uv.size() != input.mesh.number_of_vertices())
    throw Input_error{ "has " + std::to_string(soup.uv.size()) + " vertices instead of " +
                       std::to_string(input.mesh.number_of_vertices()) };
  for (const Mesh::Vertex_index v : input.mesh.vertices())
    input.uvmap[v] = Kernel::Point_2(soup.uv[v][0], soup.uv[v][1]);
} catch (const Input_error& error) {
  throw Input_error{ "--start: '" + file + "' " + error.message, SMP::ERROR_WRONG_PARAMETER };
}
