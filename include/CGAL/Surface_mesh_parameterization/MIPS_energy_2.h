// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_MIPS_ENERGY_2_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_MIPS_ENERGY_2_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Distortion_derivatives_2.h>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationEnergies
///
/// The MIPS energy of a triangle's map, `s1/s2 + s2/s1 = (s1^2 + s2^2) / (s1 s2)`, with the singular values
/// `s1 >= s2 > 0` of the map. It measures the distortion of angles, does not depend on scale, and is 2 for a
/// similarity.
///
/// Source: Hormann and Greiner, *MIPS: An efficient global parametrization method*, 1999.
///
/// \cgalModels `DistortionEnergy_2`
struct MIPS_energy_2
{
  /// the lower bound, which is the energy of a similarity
  static constexpr double minimum = 2;

  /// whether the energy stays the same when the plane is scaled
  static constexpr bool is_scale_invariant = true;

  /// whether the energy keeps triangles positive
  static constexpr bool is_flip_free = true;

  /// the energy of a triangle with any area in space
  const MIPS_energy_2& of_area(double) const { return *this; }

  /// the energy of a map with the given squared Frobenius norm `s1^2 + s2^2` and determinant `s1 s2 > 0`
  static double value(double frobenius, double determinant) { return frobenius / determinant; }

  /// the energy's value and derivatives with respect to both arguments
  static Distortion_derivatives_2 derivatives(double frobenius, double determinant)
  {
    const double inverse = 1 / determinant, value = frobenius * inverse;
    return { value, inverse, -value * inverse, 0, -inverse * inverse, 2 * value * inverse * inverse };
  }
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_MIPS_ENERGY_2_H
