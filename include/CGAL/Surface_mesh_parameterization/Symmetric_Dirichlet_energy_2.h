// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_SYMMETRIC_DIRICHLET_ENERGY_2_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_SYMMETRIC_DIRICHLET_ENERGY_2_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Distortion_derivatives_2.h>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationEnergies
///
/// The symmetric Dirichlet energy of a triangle's map,
/// `s1^2 + s2^2 + 1/s1^2 + 1/s2^2 = (s1^2 + s2^2) (1 + 1/(s1 s2)^2)`, with the singular values `s1 >= s2 > 0` of the
/// map. It measures the distance from an isometry and is 4 for an isometry.
///
/// Source: Smith and Schaefer, *Bijective parameterization with free boundaries*, 2015.
///
/// \cgalModels `DistortionEnergy_2`
struct Symmetric_Dirichlet_energy_2
{
  /// the lower bound, which is the energy of an isometry
  static constexpr double minimum = 4;

  /// whether the energy stays the same when the plane is scaled
  static constexpr bool is_scale_invariant = false;

  /// whether the energy keeps triangles positive
  static constexpr bool is_flip_free = true;

  /// the energy of a triangle with any area in space
  const Symmetric_Dirichlet_energy_2& of_area(double) const { return *this; }

  /// the energy of a map with the given squared Frobenius norm `s1^2 + s2^2` and determinant `s1 s2 > 0`
  static double value(double frobenius, double determinant)
  {
    return frobenius * (1 + 1 / (determinant * determinant));
  }

  /// the energy's value and derivatives with respect to both arguments
  static Distortion_derivatives_2 derivatives(double frobenius, double determinant)
  {
    const double inverse = 1 / determinant, inverse2 = inverse * inverse, inverse3 = inverse2 * inverse;
    return { frobenius * (1 + inverse2), 1 + inverse2, -2 * frobenius * inverse3,
             0, -2 * inverse3, 6 * frobenius * inverse3 * inverse };
  }
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SYMMETRIC_DIRICHLET_ENERGY_2_H
