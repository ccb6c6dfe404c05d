// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hierarchy without any parameterization. A function on the surface, here the third coordinate, is sampled at the
// vertices of each level, and interpolated from there to all vertices of the mesh.

#include "input_surface.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <iostream>
#include <utility>

typedef CGAL::Simple_cartesian<double>          Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>     Mesh;

namespace SMP = CGAL::Surface_mesh_parameterization;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc > 2) {
    std::cerr << "usage: hierarchy_example [INPUT.off]\n";
    return 1;
  }
  if (!read_surface_with_border(argv[1], mesh))
    return 1;

  //! [hierarchy]
  const Mesh::Halfedge_index bhd = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  SMP::Mesh_component<Mesh> component(mesh, bhd);
  if (component.error().code != SMP::OK) {
    std::cerr << SMP::error_message(component.error()) << '\n';
    return 1;
  }
  const SMP::Collapse_hierarchy_3 hierarchy(std::move(component.surface()), SMP::parameters::coarsest_size(50));

  // A function on the mesh, in the order of the hierarchy: the vertices of a level are the first ones.
  Eigen::VectorXd function(hierarchy.number_of_vertices());
  for (SMP::Collapse_hierarchy_3::Index v = 0; v < hierarchy.number_of_vertices(); ++v)
    function[v] = mesh.point(component.vertices_of_component()[hierarchy.input_vertex(v)]).z();

  const std::size_t finest = hierarchy.number_of_levels() - 1;
  for (std::size_t level = 0; level <= finest; ++level) {
    const std::size_t n = hierarchy.number_of_vertices(level);
    const Eigen::VectorXd interpolated = hierarchy.prolongation(level, finest) * function.head(n);
    std::cout << n << " vertices, " << hierarchy.number_of_faces(level) << " faces: mean square error "
              << (interpolated - function).squaredNorm() / double(function.size()) << '\n';
  }
  //! [hierarchy]
  return 0;
}
