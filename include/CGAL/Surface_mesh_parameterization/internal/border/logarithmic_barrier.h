// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_LOGARITHMIC_BARRIER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_LOGARITHMIC_BARRIER_H

#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal {

// The energy -stiffness log(x / range) (1 - x / range)^2 of a number x > 0, that vanishes from `range` on. A step of
// Newton's method doubles a small x. An energy that grows with a power of 1 / x takes many more steps, and hides the
// energy of the triangles meanwhile.
inline double barrier_energy(double x, double range, double stiffness)
{
  const double part = x / range, rest = 1 - part;
  return part < 1 ? -stiffness * std::log(part) * rest * rest : 0;
}

struct Barrier_derivatives
{
  double first, second;
};

// Precondition: x < range.
inline Barrier_derivatives barrier_derivatives(double x, double range, double stiffness)
{
  const double part = x / range, rest = 1 - part, logarithm = std::log(part);
  return { stiffness * (2 * logarithm * rest / range - rest * rest / x),
           stiffness * (rest * rest / (x * x) + 4 * rest / (x * range) - 2 * logarithm / (range * range)) };
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_LOGARITHMIC_BARRIER_H
