// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An energy of one's own: the distortion of angles plus that of areas, minimized coarse to fine without a flip, and
// compared with MIPS, which minds angles only.

#include "face_mesh.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <CGAL/Surface_mesh_parameterization/Distortion_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double>          Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>     Mesh;

namespace SMP = CGAL::Surface_mesh_parameterization;

//! [energy]
// s1/s2 + s2/s1 + d + 1/d with the singular values s1, s2 of a triangle's map and d = s1 s2. As f = s1^2 + s2^2 it is
// f/d + d + 1/d.
struct Angles_and_areas_energy_2
{
  static constexpr double minimum = 4;                    // of an isometry: f = 2, d = 1
  static constexpr bool is_scale_invariant = false;
  static constexpr bool is_flip_free = true;              // grows beyond all bounds as d goes to 0

  const Angles_and_areas_energy_2& of_area(double) const { return *this; }

  static double value(double f, double d) { return f / d + d + 1 / d; }

  static SMP::Distortion_derivatives_2 derivatives(double f, double d)
  {
    const double d2 = d * d, d3 = d2 * d;
    return { value(f, d), 1 / d, 1 - (f + 1) / d2,        // the value, its derivatives by f and by d,
             0, -1 / d2, 2 * (f + 1) / d3 };              // and the second ones: ff, fd, dd
  }
};

template <class TriangleMesh>
using Angles_and_areas_parameterizer_3 = SMP::Distortion_parameterizer_3<TriangleMesh, Angles_and_areas_energy_2>;
//! [energy]

template <template <class...> class Method>
bool run(const std::string& name, Mesh& mesh)
{
  const auto uvmap = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto result =
      SMP::hierarchical_parameterization<Method>(mesh, uvmap,
                                                 CGAL::parameters::triangle_weight(SMP::Triangle_weight::AREA));
  if (!result.is_ok()) {
    std::cerr << SMP::error_message(result.error) << '\n';
    return false;
  }
  const SMP::Parameterization_quality quality = SMP::parameterization_quality(mesh, uvmap);
  std::cout << name << ": " << quality.flips << " flips, distortion of angles " << quality.angle << ", of areas "
            << quality.area << '\n';
  return true;
}

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc > 2 || (argc == 2 && !CGAL::IO::read_OFF(argv[1], mesh))) {
    std::cerr << "usage: custom_energy_example [INPUT.off]\n";
    return 1;
  }
  if (argc == 1)
    make_face(mesh);
  return run<SMP::MIPS_parameterizer_3>("angles", mesh) &&
                 run<Angles_and_areas_parameterizer_3>("angles and areas", mesh)
             ? 0
             : 1;
}
