// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes maps.

#include "write_map.h"

#include "Output_files.h"
#include "PLY_writer.h"
#include "has_suffix.h"
#include "input.h"
#include "write_GLB.h"

#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_SVG.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace {

const Kernel::Point_2 nowhere(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN());

// The map of one chart as one of corners.
Corner_map corner_map_of_chart(Input& input)
{
  const Corner_map result = input.mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv", nowhere).first;
  for (const Mesh::Face_index f : input.faces)
    for (const Mesh::Halfedge_index h : input.mesh.halfedges_around_face(input.mesh.halfedge(f)))
      result[h] = input.uvmap[input.mesh.target(h)];
  return result;
}

// The start of a PLY file, and its vertices, each with what `write_more` adds.
template <class Function>
void write_vertices(PLY_writer& out, const Mesh& mesh, std::string_view comment, std::string_view vertex_properties,
                    std::string_view face_properties, const Function& write_more)
{
  out.begin_header() << comment << "element vertex " << mesh.number_of_vertices()
                     << "\nproperty double x\nproperty double y\nproperty double z\n" << vertex_properties
                     << "element face " << mesh.number_of_faces() << "\nproperty list uchar int vertex_indices\n"
                     << face_properties << "end_header\n";
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    for (int i = 0; i < 3; ++i)
      out.coordinate(p[i]);
    write_more(v);
    out.end_element();
  }
}

void write_corners(PLY_writer& out, const Mesh& mesh, Mesh::Face_index f)
{
  out.size_of_list(3);
  for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
    out.index(std::int32_t(v.idx()));
}

void write_place(PLY_writer& out, const Kernel::Point_2& place)
{
  out.coordinate(place.x());
  out.coordinate(place.y());
}

// The map of one chart as PLY: a place for every vertex.
void write_PLY(PLY_writer& out, const Mesh& mesh, const UV_map& uvmap, const std::vector<bool>& is_mapped)
{
  write_vertices(out, mesh, "", "property double u\nproperty double v\n", "", [&](Mesh::Vertex_index v) {
    write_place(out, is_mapped[v] ? uvmap[v] : nowhere);
  });
  for (const Mesh::Face_index f : mesh.faces()) {
    write_corners(out, mesh, f);
    out.end_element();
  }
}

// The map of an atlas as PLY: a list of coordinates for every face, empty where it has no map. Of text, readers know
// the list `texcoord` of floats; the digits are all there.
void write_PLY(PLY_writer& out, const Mesh& mesh, const Corner_map& corner_map, bool is_binary)
{
  write_vertices(out, mesh, "comment texcoord has u and v of the corners of a face, in their order\n", "",
                 is_binary ? "property list uchar double texcoord\n" : "property list uchar float texcoord\n",
                 [](Mesh::Vertex_index) {});
  for (const Mesh::Face_index f : mesh.faces()) {
    write_corners(out, mesh, f);
    const bool is_mapped = std::isfinite(corner_map[mesh.halfedge(f)].x());
    out.size_of_list(is_mapped ? 6 : 0);
    if (is_mapped)
      for (const Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
        write_place(out, corner_map[h]);
    out.end_element();
  }
}

void write_PLY(std::ostream& os, const Input& input, bool is_binary)
{
  PLY_writer out(os, is_binary);
  if (input.is_atlas)
    write_PLY(out, input.mesh, input.corner_map, is_binary);
  else
    write_PLY(out, input.mesh, input.uvmap, vertices_of_faces(input));
  out.flush();
}

// The map of one chart as OBJ.
void write_OBJ(std::ostream& os, const Input& input)
{
  const std::vector<bool> flags = vertices_of_faces(input);
  const auto is_mapped = boost::make_function_property_map<Mesh::Vertex_index, bool>(
      [&](Mesh::Vertex_index v) { return bool(flags[v]); });
  SMP::IO::write_OBJ(os, input.mesh, input.uvmap, is_mapped);
}

} // namespace

std::size_t write_mesh(Output_files& files, const std::string& name, bool is_binary, Input& input)
{
  std::size_t spoilt_triangles = 0;
  const Mesh& mesh = input.mesh;
  files.write(name, [&](std::ostream& out) {
    if (has_suffix(name, ".glb"))
      spoilt_triangles = write_GLB(out, mesh, input.is_atlas ? input.corner_map : corner_map_of_chart(input));
    else if (has_suffix(name, ".ply"))
      write_PLY(out, input, is_binary);
    else if (input.is_atlas)
      SMP::IO::write_OBJ(out, mesh, input.corner_map);
    else
      write_OBJ(out, input);
  });
  return spoilt_triangles;
}

void write_picture(Output_files& files, const std::string& name, const Input& input)
{
  files.write(name, [&](std::ostream& out) {
    if (input.is_atlas)
      SMP::IO::write_SVG(out, input.mesh, input.faces, input.corner_map);
    else
      SMP::IO::write_SVG(out, input.mesh, input.faces, input.uvmap);
  });
}
