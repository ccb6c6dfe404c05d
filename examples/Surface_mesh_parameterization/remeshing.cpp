// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Remeshing with subdivision connectivity: triangulates the vertices of the coarsest level of the hierarchy in the map,
// divides each triangle there into four over and over, and pulls the result back to the surface. Vertices on the border
// stay there: an edge of the border is halved along it. Writes the new mesh as OBJ, the edges of the coarse mesh also
// as lines. Without INPUT, a face.

#include "example_utilities.h"
#include "remesher.h"
#include "write_file.h"

#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>

#include <CGAL/Polygon_mesh_processing/distance.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <ostream>
#include <set>
#include <string>
#include <utility>

namespace {

const char* const usage = "remeshing_example [INPUT] [--output OUT.obj] [--coarsest VERTICES] [--subdivisions K]";

// Writes the edges of the coarse mesh as lines of OBJ.
void write_coarse_edges(std::ostream& out, const Subdivided_mesh& subdivided)
{
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const Subdivided_mesh::Triangle& t : subdivided.triangles)
    for (int i = 0; i < 3; ++i)
      if (t.is_coarse[i])
        edges.insert(std::minmax(t.corners[i], t.corners[(i + 1) % 3]));
  for (const auto& [v, w] : edges)
    out << "l " << v + 1 << ' ' << w + 1 << '\n';
}

void run(const Arguments& arguments)
{
  const std::size_t subdivisions = arguments.number<std::size_t>("subdivisions", 3, 0, 8),
                    coarsest = arguments.number<std::size_t>("coarsest", 100, 4, 1000000);
  const std::string output = output_name(arguments, "remeshing.obj");
  Mesh mesh = read_surface(arguments);
  const Vertex_uv_map uvmap = mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
  throw_if_failed(SMP::hierarchical_parameterization<SMP::Symmetric_Dirichlet_parameterizer_3>(
      mesh, uvmap, SMP::parameters::globally_injective(true)).error);

  const Remesher remesher(mesh, uvmap);
  const Subdivided_mesh subdivided = remesher.remesh(coarsest, subdivisions);
  Mesh result = remesher.pull_back(subdivided);
  const Vertex_uv_map new_uvmap = result.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
  for (const Mesh::Vertex_index v : result.vertices())
    new_uvmap[v] = subdivided.vertices[v].uv;

  const double distance = PMP::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(mesh.points(), result);
  std::printf("%zu coarse triangles, subdivided %zu times: %zu triangles; greatest distance of a vertex of the input "
              "from them, in diagonals of its box: %.3g\n",
              std::size_t(result.number_of_faces()) >> 2 * subdivisions, subdivisions,
              std::size_t(result.number_of_faces()), distance / box_diagonal(mesh));
  write_file(output, [&](std::ostream& out) {
    SMP::IO::write_OBJ(out, result, new_uvmap);
    write_coarse_edges(out, subdivided);
  });
}

} // namespace

int main(int argc, char** argv)
{
  return run_application(argc, argv, usage, { "output", "coarsest", "subdivisions" }, run);
}
