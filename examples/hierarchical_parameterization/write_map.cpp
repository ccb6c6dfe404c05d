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

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

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

// The map of one chart as PLY, in plain text: a place for every vertex.
void write_PLY(std::ostream& out, const Mesh& mesh, const UV_map& uvmap, const Vertex_flags& is_mapped)
{
  Mesh copy;    // without the properties that are of no use outside
  std::vector<Mesh::Vertex_index> vertices;
  for (const Mesh::Vertex_index v : mesh.vertices())
    vertices.push_back(copy.add_vertex(mesh.point(v)));
  std::vector<Mesh::Vertex_index> corners;
  for (const Mesh::Face_index f : mesh.faces()) {
    corners.clear();
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners.push_back(vertices[v]);
    copy.add_face(corners);
  }
  const auto u = copy.add_property_map<Mesh::Vertex_index, double>("v:u").first,
             v = copy.add_property_map<Mesh::Vertex_index, double>("v:v").first;
  for (const Mesh::Vertex_index w : mesh.vertices()) {
    const Kernel::Point_2& place = is_mapped[w] ? uvmap[w] : nowhere;
    u[vertices[w]] = place.x();
    v[vertices[w]] = place.y();
  }
  CGAL::IO::write_PLY(out, copy, CGAL::parameters::stream_precision(17));
}

// The map of an atlas as PLY, in plain text: a list of coordinates for every face, empty where it has no map. Readers
// know the list `texcoord` of floats; the digits are all there.
void write_PLY(std::ostream& out, const Mesh& mesh, const Corner_map& corner_map)
{
  out.precision(17);
  out << "ply\nformat ascii 1.0\ncomment texcoord has u and v of the corners of a face, in their order\nelement vertex "
      << mesh.number_of_vertices() << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
      << mesh.number_of_faces()
      << "\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n";
  for (const Kernel::Point_3& p : mesh.points())
    out << p << '\n';
  for (const Mesh::Face_index f : mesh.faces()) {
    const auto corners = mesh.halfedges_around_face(mesh.halfedge(f));
    out << '3';
    for (const Mesh::Halfedge_index h : corners)
      out << ' ' << mesh.target(h).idx();
    const bool is_mapped = std::isfinite(corner_map[*corners.begin()].x());
    out << (is_mapped ? " 6" : " 0");
    for (const Mesh::Halfedge_index h : corners)
      if (is_mapped)
        out << ' ' << corner_map[h];
    out << '\n';
  }
}

} // namespace

void write_mesh(Output_files& files, const std::string& name, Input& input)
{
  const Mesh& mesh = input.mesh;
  const bool is_PLY = has_suffix(name, ".ply");
  files.write(name, [&](std::ostream& out) {
    if (has_suffix(name, ".glb"))
      write_GLB(out, mesh, input.is_atlas ? input.corner_map : corner_map_of_chart(input));
    else if (input.is_atlas && is_PLY)
      write_PLY(out, mesh, input.corner_map);
    else if (input.is_atlas)
      SMP::IO::write_OBJ(out, mesh, input.corner_map);
    else if (is_PLY)
      write_PLY(out, mesh, input.uvmap, mapped_vertices(input));
    else
      SMP::IO::write_OBJ(out, mesh, input.uvmap, mapped_vertices(input));
  });
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
