// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace SMP = CGAL::Surface_mesh_parameterization;
namespace PMP = CGAL::Polygon_mesh_processing;

// A saddle over the unit square, n vertices along each side.
Mesh saddle(int n)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> grid;
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i)
    {
      const double x = double(i) / (n - 1), y = double(j) / (n - 1);
      grid.push_back(mesh.add_vertex(Kernel::Point_3(x, y, x * x - y * y)));
    }
  for(int j = 0; j + 1 < n; ++j)
    for(int i = 0; i + 1 < n; ++i)
    {
      const int corner = j * n + i;
      mesh.add_face(grid[corner], grid[corner + 1], grid[corner + n + 1]);
      mesh.add_face(grid[corner], grid[corner + n + 1], grid[corner + n]);
    }
  return mesh;
}

int main()
{
  Mesh mesh = saddle(10);
  const auto uvmap = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto bhd = PMP::longest_border(mesh).first;

  SMP::Hierarchical_parameterizer_3<SMP::MIPS_parameterizer_3<Mesh>> mips;
  const SMP::Error_code status = SMP::parameterize(mesh, mips, bhd, uvmap);
  if(status != SMP::OK)
  {
    std::cerr << "parameterize() returned error " << status << '\n';
    return 1;
  }

  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    if(CGAL::orientation(uvmap[mesh.source(h)], uvmap[mesh.target(h)], uvmap[mesh.target(mesh.next(h))])
       != CGAL::LEFT_TURN)
    {
      std::cerr << "face " << f << " is not positive in the plane\n";
      return 1;
    }
  }
  return 0;
}
