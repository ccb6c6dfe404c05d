// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_UNFOLDING_ENERGY_2_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_UNFOLDING_ENERGY_2_H

#include <CGAL/Surface_mesh_parameterization/Distortion_derivatives_2.h>

#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal {

// The MIPS energy with a positive function of the determinant d in the place of d,
//
//   c(d) = (d + sqrt(d^2 + width^2)) / 2,
//
// so that flipped triangles have a finite energy, too, the greater the more negative their area is. With the width 0 it
// is the MIPS energy.
//
// Source: Garanzha, Kaporin, Kudryavtseva, Protais, Ray, Sokolov, *Foldover-free maps in 50 lines of code*, 2021.
class Unfolding_energy_2
{
public:
  static constexpr bool is_scale_invariant = false;     // and so its Hessian is made positive semidefinite

  explicit Unfolding_energy_2(double width) : m_squared_width(width * width) { }

  double value(double frobenius, double determinant) const
  {
    return frobenius / positive(determinant, root(determinant));
  }

  Distortion_derivatives_2 derivatives(double frobenius, double determinant) const
  {
    const double r = root(determinant), c = positive(determinant, r), c_d = c / r,
                 c_dd = 0.5 * m_squared_width / (r * r * r), value = frobenius / c;
    return { value, 1 / c, -value * c_d / c, 0, -c_d / (c * c), value * (2 * c_d * c_d / c - c_dd) / c };
  }

private:
  double root(double determinant) const { return std::sqrt(determinant * determinant + m_squared_width); }

  // c(d), in a form that does not cancel.
  double positive(double determinant, double root) const
  {
    return determinant > 0 ? 0.5 * (determinant + root) : 0.5 * m_squared_width / (root - determinant);
  }

  double m_squared_width;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_UNFOLDING_ENERGY_2_H
