// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lays any surface in the unit square, also a closed one or one of several components, and writes it as OBJ with
// texture coordinates.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>

#include <iostream>

typedef CGAL::Simple_cartesian<double>          Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>     Mesh;

namespace SMP = CGAL::Surface_mesh_parameterization;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc != 3) {
    std::cerr << "usage: atlas_example INPUT.off OUTPUT.obj\n";
    return 1;
  }
  if (!CGAL::IO::read_OFF(argv[1], mesh)) {
    std::cerr << argv[1] << ": cannot be read as an OFF file of a manifold surface\n";
    return 1;
  }

  // The place of a corner belongs to the halfedge that leads to it in its face.
  auto uvmap = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const SMP::Atlas_summary atlas = SMP::atlas_parameterization(mesh, uvmap);
  if (!atlas.is_ok()) {
    std::cerr << "could not be parameterized: " << SMP::error_message(atlas.error) << '\n';
    return 1;
  }
  std::cout << "charts: " << atlas.charts.size() << ", edges of seams: " << atlas.cut.seam_edges
            << ", part of the square used: " << atlas.used_part << '\n';

  if (!SMP::IO::write_OBJ(argv[2], mesh, uvmap)) {
    std::cerr << argv[2] << ": cannot be written\n";
    return 1;
  }
  return 0;
}
