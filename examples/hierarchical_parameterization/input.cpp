// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is parameterized.

// Polygons are triangulated without CGAL's Delaunay triangulations, which take long to compile.
#define CGAL_HOLE_FILLING_DO_NOT_USE_DT3
#define CGAL_HOLE_FILLING_DO_NOT_USE_CDT2

#include "input.h"

#include "../Surface_mesh_parameterization/face_mesh.h"
#include "Polygon_soup.h"
#include "File_scanner.h"
#include "OFF_reader.h"
#include "components.h"
#include "has_suffix.h"
#include "stitch.h"

#include <CGAL/Surface_mesh_parameterization/internal/mesh/longest_border.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>
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

Kernel::Point_3 point_of(const Polygon_soup& soup, std::size_t v)
{
  return Kernel::Point_3(soup.points[v][0], soup.points[v][1], soup.points[v][2]);
}

// Whether the triangles have all edges of a polygon of n corners, and other edges in pairs.
bool is_triangulation(const std::vector<CGAL::Triple<int, int, int>>& triangles, int n)
{
  std::vector<std::pair<int, int>> edges;
  for (const CGAL::Triple<int, int, int>& t : triangles)
    edges.insert(edges.end(), { { t.first, t.second }, { t.second, t.third }, { t.third, t.first } });
  for (int i = 0; i < n; ++i)
    edges.emplace_back((i + 1) % n, i);              // the other side of the polygon's
  std::sort(edges.begin(), edges.end());
  return triangles.size() == std::size_t(n - 2) && std::adjacent_find(edges.begin(), edges.end()) == edges.end()
         && std::all_of(edges.begin(), edges.end(), [&](const std::pair<int, int>& e) {
              return std::binary_search(edges.begin(), edges.end(), std::make_pair(e.second, e.first));
            });
}

// Puts triangles in the places of polygons. Not by CGAL's triangulate_faces(), which writes out of bounds where a
// corner of a face lies on another edge or corner of it.
void triangulate(Polygon_soup& soup)
{
  std::vector<Polygon_soup::Polygon> result;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    const Polygon_soup::Polygon& polygon = soup.polygons[f];
    if (polygon.size() == 3) {
      result.push_back(polygon);
      continue;
    }
    if (polygon.size() > most_corners_to_triangulate)
      throw Input_error{ face_text(f) + " has more than " + std::to_string(most_corners_to_triangulate) + " corners",
                         SMP::ERROR_NON_TRIANGULAR_MESH };
    std::vector<Kernel::Point_3> corners;
    for (const std::size_t v : polygon)
      corners.push_back(point_of(soup, v));
    std::vector<CGAL::Triple<int, int, int>> triangles;
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
        corners, std::back_inserter(triangles),
        CGAL::parameters::use_delaunay_triangulation(false).use_2d_constrained_delaunay_triangulation(false));
    if (!is_triangulation(triangles, int(polygon.size()))) {      // it has no area, or points that coincide
      triangles.clear();
      for (int i = 1; i + 1 < int(polygon.size()); ++i)
        triangles.emplace_back(0, i, i + 1);
    }
    for (const CGAL::Triple<int, int, int>& t : triangles) {
      result.emplace_back();
      for (const int corner : { t.first, t.second, t.third })
        result.back().push_back(polygon[std::size_t(corner)]);
    }
  }
  soup.polygons = std::move(result);
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
    triangulate(soup);         // two polygons may get the same diagonal
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
