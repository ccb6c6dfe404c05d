// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One of CGAL's parameterizers in the adaptor: mean value coordinates on a square, with all threads that there are. The
// symmetric Dirichlet energy is minimized from that map on, with a free border.

#include "input_surface.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/tags.h>

#include <functional>
#include <iostream>

typedef CGAL::Simple_cartesian<double>          Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>     Mesh;

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace np = SMP::parameters;

//! [adaptor]
typedef SMP::Square_border_arc_length_parameterizer_3<Mesh>             Border;
typedef SMP::Mean_value_coordinates_parameterizer_3<Mesh, Border>       Mean_value;
typedef SMP::Hierarchical_parameterizer_3<Mean_value, CGAL::Parallel_if_available_tag>   Adaptor;
//! [adaptor]

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc > 2) {
    std::cerr << "usage: square_border_example [INPUT.off]\n";
    return 1;
  }
  if (!read_surface_with_border(argv[1], mesh))
    return 1;
  auto uvmap = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;

  //! [run]
  const Mesh::Halfedge_index bhd = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  SMP::Parameterization_summary summary;
  Adaptor adaptor(np::flip_policy(SMP::Flip_policy::REPAIR).summary(std::ref(summary)));
  if (SMP::parameterize(mesh, adaptor, bhd, uvmap) != SMP::OK) {
    std::cerr << SMP::error_message(summary.error) << '\n';
    return 1;
  }
  std::cout << "mean value coordinates: " << summary.flips << " flips repaired, "
            << summary.linear_solver.iterations << " iterations\n";

  const auto result = SMP::hierarchical_parameterization<SMP::Symmetric_Dirichlet_parameterizer_3>(
      mesh, uvmap, np::initial_map(true));
  //! [run]
  if (!result.is_ok()) {
    std::cerr << SMP::error_message(result.error) << '\n';
    return 1;
  }
  std::cout << "symmetric Dirichlet: " << result.levels.back().energy_start << " -> " << result.energy << ", "
            << result.levels.back().iterations << " Newton steps\n";
  return 0;
}
