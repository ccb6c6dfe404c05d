// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An energy of one's own with a parameter: distortion of angles and of areas, each with a weight, minimized coarse to
// fine without a flip.

#include "input_surface.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Surface_mesh_parameterization/Distortion_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <iostream>

typedef CGAL::Simple_cartesian<double>          Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>     Mesh;

namespace SMP = CGAL::Surface_mesh_parameterization;

//! [energy]
// (1 - w) (s1/s2 + s2/s1) + w (d + 1/d) with the singular values s1, s2 of a triangle's map and d = s1 s2. As
// f = s1^2 + s2^2, the first part is f/d.
struct Angles_and_areas_energy_2
{
  double weight_of_areas = 0.5;

  static constexpr double minimum = 2;                    // of an isometry: f = 2, d = 1
  static constexpr bool is_scale_invariant = false;
  static constexpr bool is_flip_free = true;              // grows beyond all bounds as d goes to 0

  const Angles_and_areas_energy_2& of_area(double) const { return *this; }

  double value(double f, double d) const { return (1 - weight_of_areas) * f / d + weight_of_areas * (d + 1 / d); }

  SMP::Distortion_derivatives_2 derivatives(double f, double d) const
  {
    const double w = weight_of_areas, d2 = d * d, d3 = d2 * d;
    return { value(f, d), (1 - w) / d, w - ((1 - w) * f + w) / d2,      // the value, its derivatives by f and by d,
             0, -(1 - w) / d2, 2 * ((1 - w) * f + w) / d3 };            // and the second ones: ff, fd, dd
  }
};

typedef SMP::Distortion_parameterizer_3<Mesh, Angles_and_areas_energy_2>      Method;
//! [energy]

bool run(const Angles_and_areas_energy_2& energy, Mesh& mesh)
{
  const auto uvmap = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  //! [run]
  const Method method(energy, SMP::parameters::triangle_weight(SMP::Triangle_weight::AREA));
  SMP::Hierarchical_parameterizer_3<Method> parameterizer(method);
  const SMP::Error_code status = parameterizer.parameterize(mesh, uvmap);
  //! [run]
  if (status != SMP::OK) {
    std::cerr << SMP::error_message(status) << '\n';
    return false;
  }
  const SMP::Parameterization_quality quality = SMP::parameterization_quality(mesh, uvmap);
  std::cout << "weight of areas " << energy.weight_of_areas << ": " << quality.flips << " flips, distortion of angles "
            << quality.angle << ", of areas " << quality.area << '\n';
  return true;
}

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc > 2) {
    std::cerr << "usage: custom_energy_example [INPUT.off]\n";
    return 1;
  }
  if (!read_surface_with_border(argv[1], mesh))
    return 1;
  for (const double weight : { 0.1, 0.5, 0.9 })
    if (!run({ weight }, mesh))
      return 1;
  return 0;
}
