// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgHierarchicalParameterizationConcepts
/// \cgalConcept
///
/// The energy of a triangle's linear map from space to the plane: a symmetric, twice differentiable function of the
/// singular values `s1 >= s2 > 0` of the map. Its arguments are two invariants that are polynomials in the coordinates:
/// the squared Frobenius norm `f = s1^2 + s2^2` and the determinant `d = s1 s2`. There are two kinds of energies. One
/// kind is defined for positive `d` and goes to infinity as `d` goes to 0 with `f` fixed: it keeps triangles positive.
/// The other kind is defined for every `d`, and maps may have flips: `Distortion_parameterizer_3` does not take it, and
/// `As_rigid_as_possible_parameterizer_3` has one of its own.
///
/// Models are classes, not `final`, that are `DefaultConstructible`, `CopyConstructible` and `Assignable`. An energy
/// that has parameters is passed to the constructor of `Distortion_parameterizer_3` as an object; the functions
/// of one without may be `static`. Several threads may call the functions of one object or of its copies at the same
/// time.
///
/// For a triangle of area 1, a run compares the first derivatives at a few points with differences of values, and a
/// scale-invariant energy at two scales. Where they are not the same it ends with `ERROR_WRONG_PARAMETER`, and the
/// error says which is wrong. Second derivatives are not checked: wrong ones make a run slow.
///
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::As_rigid_as_possible_energy_2`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::MIPS_energy_2`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Symmetric_Dirichlet_energy_2`
class DistortionEnergy_2
{
public:
  /// the lower bound, which is the energy of an isometry
  static constexpr double minimum;

  /// whether `value(c * c * f, c * c * d)` equals `value(f, d)` for every `c > 0`
  static constexpr bool is_scale_invariant;

  /// whether the energy keeps triangles positive
  static constexpr bool is_flip_free;

  /// the energy of a triangle with the given area in space, in the square of the mesh's units: 0 or infinite if squares
  /// of lengths under- or overflow; returns itself if the energy does not depend on the area. The functions below are
  /// called for what it returns
  DistortionEnergy_2 of_area(double area) const;

  /// the energy. Its square, and those of the derivatives, should not overflow: above about 1e150 a run ends early
  double value(double f, double d) const;

  /// the energy with its first and second derivatives by `f` and `d`
  CGAL::Surface_mesh_parameterization::Distortion_derivatives_2 derivatives(double f, double d) const;
};
