// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What atlas_parameterization() does with a distortion_bound, by hand: finds seams that make a surface a disk, hands
// them to a seam mesh, which any parameterizer takes, and moves the map into the unit square. Writes OBJ with texture
// coordinates by corner, and the seams as lines. Without INPUT, a sphere with bumps.

#include "example_utilities.h"
#include "write_file.h"

#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/cut_to_disk.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ostream>
#include <string>

namespace {

typedef Mesh::Property_map<Mesh::Edge_index, bool>               Seam_edge_map;
typedef Mesh::Property_map<Mesh::Vertex_index, bool>             Seam_vertex_map;
typedef CGAL::Seam_mesh<Mesh, Seam_edge_map, Seam_vertex_map>    Seam_mesh;
typedef Mesh::Property_map<Mesh::Halfedge_index, Point_2>        Halfedge_uv_map;

const char* const usage = "cut_open_closed_mesh_example [INPUT] [--output OUT.obj] [--distortion-bound B]";

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
  const double bound = arguments.number<double>("distortion-bound", 4.5, 4, 1000);
  const std::string output = output_name(arguments, "cut_open.obj");
  Mesh mesh = arguments.input().empty() ? make_sphere_with_bumps() : read_surface(arguments);

  // The more branches the seams have, the smaller is the distortion.
  const Seam_edge_map is_seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_seam", false).first;
  const SMP::Cut_summary cut = SMP::cut_to_disk(mesh, is_seam, SMP::parameters::distortion_bound(bound));
  throw_if_failed(cut.error);

  // A vertex is there in the seam mesh as often as seams divide the faces around it.
  const Seam_vertex_map is_on_seam = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_on_seam", false).first;
  for (const Mesh::Edge_index e : mesh.edges())
    if (is_seam[e])
      is_on_seam[mesh.vertex(e, 0)] = is_on_seam[mesh.vertex(e, 1)] = true;
  const Seam_mesh seam_mesh(mesh, is_seam, is_on_seam);

  // A vertex of the seam mesh is a halfedge of the mesh.
  const Halfedge_uv_map uvmap = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  throw_if_failed(SMP::hierarchical_parameterization<SMP::Symmetric_Dirichlet_parameterizer_3>(
      seam_mesh, uvmap, SMP::parameters::globally_injective(true)).error);

  const Halfedge_uv_map corners = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:corner_uv").first;
  for (const Mesh::Halfedge_index h : mesh.halfedges())
    if (!mesh.is_border(h))
      corners[h] = uvmap[target(Seam_mesh::halfedge_descriptor(h), seam_mesh)];
  throw_if_failed({ SMP::pack_charts(mesh, corners) });

  std::size_t handles = 0;
  for (const SMP::Cut_summary::Component& component : cut.components)
    handles += component.genus;
  const SMP::Parameterization_quality quality = SMP::parameterization_quality(seam_mesh, uvmap);
  std::printf("%zu handles, %zu seam edges, %zu flips, %zu overlapping pairs, symmetric Dirichlet %.4f\n",
              handles, cut.seam_edges, quality.flips, quality.overlaps, quality.symmetric_dirichlet);
  write_file(output, [&](std::ostream& out) {
    SMP::IO::write_OBJ(out, mesh, corners);
    for (const Mesh::Edge_index e : mesh.edges())
      if (is_seam[e])
        out << "l " << mesh.vertex(e, 0) + 1 << ' ' << mesh.vertex(e, 1) + 1 << '\n';
  });
}

} // namespace

int main(int argc, char** argv)
{
  return run_application(argc, argv, usage, { "output", "distortion-bound" }, run);
}
