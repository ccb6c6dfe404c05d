// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgHierarchicalParameterizationConcepts
/// \cgalConcept
///
/// The energy of a triangle's linear map from space to the plane, a function of its singular values `s1 >= s2 > 0` that is symmetric in them and
/// twice differentiable. It is given through two invariants that are polynomials in the coordinates: the squared Frobenius norm
/// `f = s1^2 + s2^2` and the determinant `d = s1 s2 > 0`. It grows beyond all bounds as `d` goes to 0 with `f` fixed: that keeps triangles positive.
///
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::MIPS_energy_2`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Symmetric_Dirichlet_energy_2`
class DistortionEnergy_2
{
public:
  /// the least value, that of an isometry
  static constexpr double minimum;

  /// whether `value(c * c * f, c * c * d)` equals `value(f, d)` for every `c > 0`
  static constexpr bool is_scale_invariant;

  /// the energy
  static double value(double f, double d);

  /// the energy with its first and second derivatives by `f` and `d`
  static CGAL::Surface_mesh_parameterization::Distortion_derivatives_2 derivatives(double f, double d);
};
