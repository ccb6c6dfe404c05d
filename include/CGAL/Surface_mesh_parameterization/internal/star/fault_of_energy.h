// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_FAULT_OF_ENERGY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_FAULT_OF_ENERGY_H

#include <CGAL/Surface_mesh_parameterization/Distortion_derivatives_2.h>

#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal {

// Where the values of an energy tell that they or one of its other members are wrong, which; else null. A minimization
// with a wrong derivative ends anywhere, and says that it converged.
template <class Energy>
const char* fault_of_energy(const Energy& energy_of_any_area)
{
  const Energy energy = energy_of_any_area.of_area(1);
  constexpr double singular_values[][2] = { { 1.3, 0.9 }, { 2.7, 0.4 }, { 0.6, 0.35 } };
  constexpr double difference = 1e-6, greatest_error = 1e-3, rounding = 1e-12, scale = 2;
  for (const auto& s : singular_values) {
    const double f = s[0] * s[0] + s[1] * s[1], d = s[0] * s[1], value = energy.value(f, d);
    if (std::isnan(value))
      return "value() of the energy is no number for a map without flips";
    if (std::isinf(value))
      continue;
    const Distortion_derivatives_2 derivatives = energy.derivatives(f, d);
    const double hf = difference * f, hd = difference * d;
    const auto is_near = [&](double a, double b, double unit) {
      return std::abs(a - b) <= greatest_error * std::abs(b) + rounding * std::abs(value) / unit;
    };
    if (!is_near(derivatives.value, value, 1))
      return "derivatives() of the energy has another value than value()";
    if (!is_near(derivatives.f, (energy.value(f + hf, d) - energy.value(f - hf, d)) / (2 * hf), hf))
      return "derivatives() of the energy has a derivative by f that is not that of value()";
    if (!is_near(derivatives.d, (energy.value(f, d + hd) - energy.value(f, d - hd)) / (2 * hd), hd))
      return "derivatives() of the energy has a derivative by d that is not that of value()";
    if (Energy::is_scale_invariant && !is_near(energy.value(scale * scale * f, scale * scale * d), value, 1))
      return "is_scale_invariant of the energy is true, but value() depends on the scale";
  }
  return nullptr;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_FAULT_OF_ENERGY_H
