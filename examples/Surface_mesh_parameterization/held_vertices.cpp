// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameterizes a mesh by MIPS with its border on a circle and one of its vertices held in the middle, without a flip.

#include "input_surface.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <iostream>

typedef CGAL::Simple_cartesian<double>          Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>     Mesh;

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace np = SMP::parameters;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc > 3) {
    std::cerr << "usage: held_vertices_example [INPUT.off [OUTPUT.obj]]\n";
    return 1;
  }
  if (!read_surface_with_border(argv[1], mesh))
    return 1;

  // The circle in the unit square.
  const Mesh::Halfedge_index bhd = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  auto uvmap = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  auto is_held = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_held", false).first;
  auto index = mesh.add_property_map<Mesh::Vertex_index, int>("v:index").first;
  SMP::Circular_border_arc_length_parameterizer_3<Mesh> circle;
  if (circle.parameterize(mesh, bhd, uvmap, index, is_held) != SMP::OK) {
    std::cerr << "the border could not be placed on a circle\n";
    return 1;
  }

  // The highest vertex inside, the tip of the nose of the built-in face, in its middle.
  Mesh::Vertex_index tip = Mesh::null_vertex();
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (!mesh.is_border(v) && (tip == Mesh::null_vertex() || mesh.point(v).z() > mesh.point(tip).z()))
      tip = v;
  if (tip == Mesh::null_vertex()) {
    std::cerr << "all vertices are on borders\n";
    return 1;
  }
  is_held[tip] = true;
  uvmap[tip] = Kernel::Point_2(0.5, 0.5);

  const auto result = SMP::hierarchical_parameterization(mesh, uvmap, np::vertex_is_constrained_map(is_held));
  if (!result.is_ok()) {
    std::cerr << SMP::error_message(result.error) << '\n';
    return 1;
  }
  std::cout << "energy " << result.energy << ", vertex " << tip << " at " << uvmap[tip] << '\n';
  if (argc < 3)
    return 0;
  if (!SMP::IO::write_OBJ(argv[2], mesh, uvmap)) {
    std::cerr << argv[2] << ": cannot be written\n";
    return 1;
  }
  return 0;
}
