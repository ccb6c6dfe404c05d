// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An atlas of a mechanical part, cut along its sharp edges, and what became of each chart.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/atlas_quality.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>

#include <iostream>
#include <limits>

typedef CGAL::Simple_cartesian<double>          Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>     Mesh;

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace np = SMP::parameters;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc != 3) {
    std::cerr << "usage: sharp_edges_example INPUT.off OUTPUT.obj\n";
    return 1;
  }
  if (!CGAL::IO::read_OFF(argv[1], mesh)) {
    std::cerr << argv[1] << ": cannot be read as an OFF file of a manifold surface\n";
    return 1;
  }

  //! [atlas]
  // Corners of charts without a map keep what they have.
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  auto uvmap =
      mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv", Kernel::Point_2(nowhere, nowhere)).first;

  auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 40, seams);      // degrees

  // A given bound opens rings, too, as the side of a cylinder is one.
  const SMP::Atlas_summary atlas = SMP::atlas_parameterization<SMP::Symmetric_Dirichlet_parameterizer_3>(
      mesh, uvmap, np::edge_is_constrained_map(seams).distortion_bound(4.5));
  for (const SMP::Atlas_summary::Chart& chart : atlas.charts)
    if (!chart.summary.is_ok())
      std::cerr << "a chart of " << chart.faces << " faces: " << SMP::error_message(chart.summary.error) << '\n';
  //! [atlas]
  if (!atlas.is_ok() && atlas.charts.empty()) {
    std::cerr << SMP::error_message(atlas.error) << '\n';
    return 1;
  }
  const SMP::Parameterization_quality quality = SMP::atlas_quality(mesh, uvmap);
  std::cout << "charts: " << atlas.charts.size() << ", symmetric Dirichlet energy: " << quality.symmetric_dirichlet
            << ", part of the square used: " << atlas.used_part << '\n';

  if (!SMP::IO::write_OBJ(argv[2], mesh, uvmap)) {
    std::cerr << argv[2] << ": cannot be written\n";
    return 1;
  }
  return atlas.is_ok() ? 0 : 1;
}
