// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hierarchy serves other functions of CGAL, too: makes a mesh as smooth as its border allows with the multigrid
// solver, and again with the solver that CGAL takes unless told otherwise. Continuity 0, the default of this
// program, is a system of second order, which the grids are made for. With continuity 1, CGAL's default, of fourth
// order, the iteration does not arrive, and the direct solver that stands by gives the result: later, but the same.

#include "input_surface.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>

#include <CGAL/Polygon_mesh_processing/fair.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Real_timer.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

typedef CGAL::Simple_cartesian<double>          Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>     Mesh;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

// The vertices that are neither on the border nor next to it: the rows of the system for continuity 1 reach two edges
// far.
std::vector<Mesh::Vertex_index> vertices_to_fair(const Mesh& mesh)
{
  std::vector<Mesh::Vertex_index> result;
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    const auto neighbors = mesh.vertices_around_target(mesh.halfedge(v));
    if (!mesh.is_border(v) &&
        std::none_of(neighbors.begin(), neighbors.end(), [&](Mesh::Vertex_index n) { return mesh.is_border(n); }))
      result.push_back(v);
  }
  return result;
}

int main(int argc, char** argv)
{
  Mesh mesh;
  const int continuity = argc > 2 ? std::atoi(argv[2]) : 0;
  if (argc > 3 || continuity < 0 || continuity > 1) {
    std::cerr << "usage: fair_with_multigrid_example [INPUT.off [CONTINUITY]], which is 0 or 1\n";
    return 1;
  }
  if (!read_surface_with_border(argv[1], mesh))
    return 1;
  if (argc == 1) {
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(3));
    mesh.collect_garbage();
  }
  Mesh other = mesh;
  const std::vector<Mesh::Vertex_index> region = vertices_to_fair(mesh);
  CGAL::Real_timer timer;

  // fair() numbers the vertices that it is given in ascending order; a vertex with a negative index is not in the
  // system.
  timer.start();
  auto index = mesh.add_property_map<Mesh::Vertex_index, int>("v:index_in_system", -1).first;
  for (std::size_t i = 0; i < region.size(); ++i)
    index[region[i]] = int(i);
  const SMP::Multigrid_solver_traits solver(mesh, PMP::longest_border(mesh).first, index);
  if (solver.error().code != SMP::OK) {
    std::cerr << "the mesh must be one surface with border and without handles\n";
    return 1;
  }
  if (!PMP::fair(mesh, region,
                 CGAL::parameters::sparse_linear_solver(solver).fairing_continuity(unsigned(continuity)))) {
    std::cerr << "the multigrid solver failed\n";
    return 1;
  }
  const double seconds = timer.time();

  timer.reset();
  if (!PMP::fair(other, region, CGAL::parameters::fairing_continuity(unsigned(continuity)))) {
    std::cerr << "the default solver failed\n";
    return 1;
  }
  double squared_distance = 0;
  for (const Mesh::Vertex_index v : region)
    squared_distance = (std::max)(squared_distance, CGAL::squared_distance(mesh.point(v), other.point(v)));

  const SMP::Linear_solver_summary summary = solver.summary();
  std::cout << region.size() << " vertices: multigrid " << seconds << " s (" << summary.iterations << " iterations, "
            << summary.direct_solutions << " of 3 coordinates solved directly), default solver " << timer.time()
            << " s, greatest distance " << std::sqrt(squared_distance) << '\n';
  return 0;
}
