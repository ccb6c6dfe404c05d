// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes maps.

#include "write_map.h"

#include "Output_files.h"
#include "has_suffix.h"
#include "input.h"

#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_SVG.h>

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <ostream>
#include <string>
#include <vector>

namespace {

// The mesh with its map as PLY, in plain text. Vertices of other components get no place, so that of the origin.
void write_PLY(std::ostream& out, const Mesh& mesh, const UV_map& uvmap)
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
    u[vertices[w]] = uvmap[w].x();
    v[vertices[w]] = uvmap[w].y();
  }
  CGAL::IO::write_PLY(out, copy, CGAL::parameters::stream_precision(17));
}

} // namespace

void write_mesh(Output_files& files, const std::string& name, Input& input)
{
  auto is_parameterized = input.mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_parameterized", false).first;
  for (const Mesh::Face_index f : input.faces)
    for (const Mesh::Vertex_index v : input.mesh.vertices_around_face(input.mesh.halfedge(f)))
      is_parameterized[v] = true;
  files.write(name, [&](std::ostream& out) {
    if (has_suffix(name, ".ply"))
      write_PLY(out, input.mesh, input.uvmap);
    else
      SMP::IO::write_OBJ(out, input.mesh, input.uvmap, is_parameterized);
  });
}

void write_picture(Output_files& files, const std::string& name, const Input& input)
{
  files.write(name, [&](std::ostream& out) { SMP::IO::write_SVG(out, input.mesh, input.faces, input.uvmap); });
}
