// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes maps.

#include "write_map.h"

#include "Output_files.h"
#include "has_suffix.h"
#include "input.h"
#include "write_GLB.h"

#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_SVG.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Text_writer.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>

namespace {

const Kernel::Point_2 nowhere(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN());

typedef Mesh::Property_map<Mesh::Vertex_index, bool>   Vertex_flags;

// Which vertices have a place by the map of one chart.
Vertex_flags mapped_vertices(Input& input)
{
  auto is_mapped = input.mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_parameterized", false).first;
  for (const Mesh::Face_index f : input.faces)
    for (const Mesh::Vertex_index v : input.mesh.vertices_around_face(input.mesh.halfedge(f)))
      is_mapped[v] = true;
  return is_mapped;
}

// The map of one chart as one of corners.
Corner_map corner_map_of_chart(Input& input)
{
  const Corner_map result = input.mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv", nowhere).first;
  for (const Mesh::Face_index f : input.faces)
    for (const Mesh::Halfedge_index h : input.mesh.halfedges_around_face(input.mesh.halfedge(f)))
      result[h] = input.uvmap[input.mesh.target(h)];
  return result;
}

typedef SMP::internal::Text_writer   Text_writer;

// The start of a PLY file in plain text, and its vertices, each with what `write_place` adds.
template <class Function>
void write_vertices(Text_writer& out, const Mesh& mesh, std::string_view comment, std::string_view vertex_properties,
                    std::string_view face_properties, const Function& write_place)
{
  out << "ply\nformat ascii 1.0\n" << comment << "element vertex " << mesh.number_of_vertices()
      << "\nproperty double x\nproperty double y\nproperty double z\n" << vertex_properties << "element face "
      << mesh.number_of_faces() << "\nproperty list uchar int vertex_indices\n" << face_properties << "end_header\n";
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    out << p.x() << ' ' << p.y() << ' ' << p.z();
    write_place(v);
    out << '\n';
  }
}

void write_corners(Text_writer& out, const Mesh& mesh, Mesh::Face_index f)
{
  out << '3';
  for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
    out << ' ' << v.idx();
}

// The map of one chart as PLY: a place for every vertex.
void write_PLY(std::ostream& os, const Mesh& mesh, const UV_map& uvmap, const Vertex_flags& is_mapped)
{
  Text_writer out(os);
  write_vertices(out, mesh, "", "property double u\nproperty double v\n", "", [&](Mesh::Vertex_index v) {
    const Kernel::Point_2& place = is_mapped[v] ? uvmap[v] : nowhere;
    out << ' ' << place.x() << ' ' << place.y();
  });
  for (const Mesh::Face_index f : mesh.faces()) {
    write_corners(out, mesh, f);
    out << '\n';
  }
  out.flush();
}

// The map of an atlas as PLY: a list of coordinates for every face, empty where it has no map. Readers know the list
// `texcoord` of floats; the digits are all there.
void write_PLY(std::ostream& os, const Mesh& mesh, const Corner_map& corner_map)
{
  Text_writer out(os);
  write_vertices(out, mesh, "comment texcoord has u and v of the corners of a face, in their order\n", "",
                 "property list uchar float texcoord\n", [](Mesh::Vertex_index) {});
  for (const Mesh::Face_index f : mesh.faces()) {
    write_corners(out, mesh, f);
    const bool is_mapped = std::isfinite(corner_map[mesh.halfedge(f)].x());
    out << (is_mapped ? " 6" : " 0");
    if (is_mapped)
      for (const Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
        out << ' ' << corner_map[h].x() << ' ' << corner_map[h].y();
    out << '\n';
  }
  out.flush();
}

} // namespace

std::size_t write_mesh(Output_files& files, const std::string& name, Input& input)
{
  std::size_t spoilt_triangles = 0;
  const Mesh& mesh = input.mesh;
  const bool is_PLY = has_suffix(name, ".ply");
  files.write(name, [&](std::ostream& out) {
    if (has_suffix(name, ".glb"))
      spoilt_triangles = write_GLB(out, mesh, input.is_atlas ? input.corner_map : corner_map_of_chart(input));
    else if (input.is_atlas && is_PLY)
      write_PLY(out, mesh, input.corner_map);
    else if (input.is_atlas)
      SMP::IO::write_OBJ(out, mesh, input.corner_map);
    else if (is_PLY)
      write_PLY(out, mesh, input.uvmap, mapped_vertices(input));
    else
      SMP::IO::write_OBJ(out, mesh, input.uvmap, mapped_vertices(input));
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
