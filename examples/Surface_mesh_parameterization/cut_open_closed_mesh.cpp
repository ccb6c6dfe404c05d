// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameterizes a closed mesh: cuts it open along paths of edges, which a seam mesh does without changing the mesh, and
// writes it as OBJ with texture coordinates by corner and the seam as lines. Without INPUT, a sphere with bumps.

#include "chart.h"
#include "example_utilities.h"
#include "write_file.h"

#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <list>
#include <ostream>
#include <vector>

namespace {

const char* const usage = "cut_open_closed_mesh_example [INPUT] [--output OUT.obj] [--paths N]";

Mesh make_sphere_with_bumps()
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point_3>(mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(4));
  mesh.collect_garbage();
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    const Kernel::Vector_3 p = mesh.point(v) - CGAL::ORIGIN, direction = p / std::sqrt(p.squared_length());
    const double bump = std::sin(5 * direction.x()) * std::sin(4 * direction.y() + 1) * std::sin(5 * direction.z() + 2);
    mesh.point(v) = CGAL::ORIGIN + (1 + 0.15 * bump) * direction;
  }
  return mesh;
}

void run(const Arguments& arguments)
{
  const std::size_t number_of_paths = arguments.number<std::size_t>("paths", 1, 1, 1000);
  Mesh mesh = read_mesh_or(arguments, make_sphere_with_bumps);
  if (!CGAL::is_closed(mesh))
    throw Input_error{ "has a border: no cut is needed" };
  const auto component_of = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  if (CGAL::Polygon_mesh_processing::connected_components(mesh, component_of) > 1)
    throw Input_error{ "has several components" };
  CGAL::Polygon_mesh_processing::remove_isolated_vertices(mesh);
  mesh.collect_garbage();

  // Both halfedges of a seam edge are on the border of the seam mesh; a vertex is there as often as seams divide the
  // faces around it.
  std::list<Chart> charts;
  Chart& chart = charts.emplace_back(mesh);
  const std::vector<Mesh::Halfedge_index> seam = Seam_tree(chart.mesh).grow(number_of_paths);
  for (const Mesh::Halfedge_index h : seam)
    chart.seam_mesh.add_seam(chart.mesh.source(h), chart.mesh.target(h));

  throw_if_failed(SMP::hierarchical_parameterization<SMP::Symmetric_Dirichlet_parameterizer_3>(
      chart.seam_mesh, chart.uvmap, CGAL::parameters::globally_injective(true)));
  lay_side_by_side(charts);

  const SMP::Parameterization_quality quality = SMP::parameterization_quality(chart.seam_mesh, chart.uvmap);
  std::printf(
      "%zu vertices, %zu in the plane, %zu seam edges, %zu flips, %zu overlapping pairs, symmetric Dirichlet %.4f\n",
      std::size_t(mesh.number_of_vertices()), std::size_t(num_vertices(chart.seam_mesh)), seam.size(), quality.flips,
      quality.overlaps, quality.symmetric_dirichlet);
  write_file(arguments.text("output", "cut_open.obj"), [&](std::ostream& out) {
    SMP::IO::write_OBJ(out, chart.seam_mesh, chart.uvmap,
                       CGAL::Constant_property_map<Seam_mesh::vertex_descriptor, bool>(true));
    for (const Mesh::Halfedge_index h : seam)
      out << "l " << chart.mesh.source(h) + 1 << ' ' << chart.mesh.target(h) + 1 << '\n';
  });
}

} // namespace

int main(int argc, char** argv)
{
  return run_application(argc, argv, usage, { "output", "paths" }, run);
}
