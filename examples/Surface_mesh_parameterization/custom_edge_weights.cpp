// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edge weights of one's own: springs that are the softer the greater the triangles beside them, so that coarse parts
// get more room than with uniform weights. On the built-in face that makes the map better. On most scans it is too
// much: this shows how weights are written, not which to take.

#include "input_surface.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double>          Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>     Mesh;

namespace SMP = CGAL::Surface_mesh_parameterization;

//! [weights]
// 1 over the area of the triangles at the edge. Both ends see the same triangles, so that the weights are symmetric.
struct Area_edge_weights_3
{
  static constexpr bool is_symmetric = true;

  typedef SMP::Level::Point_3   Point_3;

  void operator()(const Point_3& v, const std::vector<Point_3>& ring, bool is_closed,
                  std::vector<double>& weights) const
  {
    constexpr double least_area = 1e-12;        // the surface is scaled to about size 1
    weights.assign(ring.size(), least_area);
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < ring.size(); ++i) {
      const std::size_t j = (i + 1) % ring.size();
      const double area = std::sqrt(CGAL::squared_area(v, ring[i], ring[j]));
      weights[i] += area;
      weights[j] += area;
    }
    for (double& weight : weights)
      weight = 1 / weight;
  }
};

template <class TriangleMesh>
using Area_parameterizer_3 = SMP::Edge_energy_parameterizer_3<TriangleMesh, Area_edge_weights_3>;
//! [weights]

template <class TriangleMesh>
using Uniform_parameterizer_3 = SMP::Edge_energy_parameterizer_3<TriangleMesh, SMP::Uniform_edge_weights_3>;

template <template <class...> class Method>
bool run(const std::string& name, Mesh& mesh)
{
  const auto uvmap = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto result = SMP::hierarchical_parameterization<Method>(mesh, uvmap);
  if (!result.is_ok()) {
    std::cerr << SMP::error_message(result.error) << '\n';
    return false;
  }
  const SMP::Parameterization_quality quality = SMP::parameterization_quality(mesh, uvmap);
  std::cout << name << ": distortion of angles " << quality.angle << ", of areas " << quality.area << ", "
            << result.levels.back().iterations << " iterations on the finest level\n";
  return true;
}

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc > 2) {
    std::cerr << "usage: custom_edge_weights_example [INPUT.off]\n";
    return 1;
  }
  if (!read_surface_with_border(argv[1], mesh))
    return 1;
  return run<Uniform_parameterizer_3>("uniform", mesh) && run<Area_parameterizer_3>("area", mesh) ? 0 : 1;
}
