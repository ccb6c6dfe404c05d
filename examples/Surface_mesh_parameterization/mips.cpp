// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameterizes a mesh with border by MIPS, coarse to fine, and writes it as OBJ with texture coordinates. Of several
// components, the one with the longest border.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <array>
#include <iostream>

typedef CGAL::Simple_cartesian<double>          Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>     Mesh;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc != 3) {
    std::cerr << "usage: mips_example INPUT.off OUTPUT.obj\n";
    return 1;
  }
  if (!CGAL::IO::read_OFF(argv[1], mesh)) {
    std::cerr << argv[1] << ": cannot be read as an OFF file of a manifold surface\n";
    return 1;
  }
  const Mesh::Halfedge_index border = PMP::longest_border(mesh).first;
  if (border == Mesh::null_halfedge()) {
    std::cerr << argv[1] << ": the surface has no border\n";
    return 1;
  }
  PMP::keep_connected_components(mesh, std::array{ mesh.face(mesh.opposite(border)) });
  auto uvmap = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;

  SMP::Hierarchical_parameterizer_3<SMP::MIPS_parameterizer_3<Mesh>> mips;
  const SMP::Error_code status = SMP::parameterize(mesh, mips, border, uvmap);
  if (status != SMP::OK) {
    std::cerr << "could not be parameterized: " << SMP::error_message(status) << '\n';
    return 1;
  }

  const SMP::Parameterization_quality quality = SMP::parameterization_quality(mesh, uvmap);
  std::cout << quality.flips << " flips, mean angle distortion " << quality.angle << '\n';

  if (!SMP::IO::write_OBJ(argv[2], mesh, uvmap)) {
    std::cerr << argv[2] << ": cannot be written\n";
    return 1;
  }
  return 0;
}
