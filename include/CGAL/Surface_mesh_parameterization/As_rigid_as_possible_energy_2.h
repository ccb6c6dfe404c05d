// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_AS_RIGID_AS_POSSIBLE_ENERGY_2_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_AS_RIGID_AS_POSSIBLE_ENERGY_2_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Distortion_derivatives_2.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationEnergies
///
/// The squared distance of a triangle's map from the nearest similarity, plus a penalty for that similarity's scale
/// `s`: the minimum, over `s >= 0`, of `(s1 - s)^2 + (s2 - s)^2 + k (s^2 - 1)^2` with the singular values `s1 >= |s2|`
/// of the map, of which the second is negative if the triangle is flipped. It is 0 for an isometry, and has no unit.
/// The stiffness `k` is \f$ \lambda / (2A) \f$ for a triangle of area `A`; \f$ \lambda \f$ and `A` are in squared units
/// of the mesh.
///
/// Weighted by the areas, the sum over the triangles, in squared units of the mesh, is the energy that
/// `CGAL::Surface_mesh_parameterization::ARAP_parameterizer_3` minimizes, half of
/// \f[ \sum_t \Bigl( \sum_{i} \cot\theta_i \, | u_{i+1} - u_{i+2} - L_t ( x_{i+1} - x_{i+2} ) |^2
///     + \lambda ( a_t^2 + b_t^2 - 1 )^2 \Bigr), \qquad
///     L_t = \begin{pmatrix} a_t & b_t \\ -b_t & a_t \end{pmatrix}, \f]
/// minimized over all \f$ L_t \f$. The cotangents may be negative: they only express the Dirichlet integral of a
/// triangle.
///
/// Source: Liu, Zhang, Xu, Gotsman, Gortler, *A local/global approach to mesh parameterization*, 2008.
///
/// \cgalModels `DistortionEnergy_2`
class As_rigid_as_possible_energy_2
{
public:
  /// the lower bound, which is the energy of an isometry
  static constexpr double minimum = 0;

  /// whether the energy stays the same when the plane is scaled
  static constexpr bool is_scale_invariant = false;

  /// whether the energy keeps triangles positive
  static constexpr bool is_flip_free = false;

  /// \param lambda the cost of a change of scale, in squared units of the mesh; if it is infinite, the scale is 1
  /// \param area the area of the triangle in space, in the same units
  /// \pre `lambda >= 0`
  explicit As_rigid_as_possible_energy_2(double lambda = (std::numeric_limits<double>::infinity)(), double area = 1)
    : m_lambda(lambda), m_stiffness(lambda / (2 * area)) { }

  /// the energy, for the same lambda, of a triangle with the given area in space
  As_rigid_as_possible_energy_2 of_area(double area) const { return As_rigid_as_possible_energy_2(m_lambda, area); }

  /// the energy of a map with the given squared Frobenius norm `s1^2 + s2^2` and determinant `s1 s2` of either sign
  double value(double frobenius, double determinant) const
  {
    const double r = mean_singular_value(frobenius, determinant);
    return anisotropy(frobenius, determinant) + scale_penalty(r, excess_scale(r));
  }

  /// the energy's value and derivatives with respect to both arguments. They do not exist where `s1 + s2 = 0`; the
  /// values returned there are finite.
  ///
  /// With `r = (s1 + s2) / 2` the energy is `(s1 - s2)^2 / 2 + h(r)` where `h(r) = min 2 (r - s)^2 + k (s^2 - 1)^2`. By
  /// the envelope theorem `h' = 4 (r - s)` at the best `s`, and with the implicit derivative of `s`,
  /// `h'' = 4 (1 - 1 / (1 + k (3 s^2 - 1)))`.
  Distortion_derivatives_2 derivatives(double frobenius, double determinant) const
  {
    constexpr double least_r = 1e-12, least_slope = 1e-12;
    const double r = (std::max)(mean_singular_value(frobenius, determinant), least_r), t = excess_scale(r), s = 1 + t;
    const double slope =
        (std::max)(1 + m_stiffness * (3 * s * s - 1), least_slope);      // of the left side of the equation for s

    // h as a function of r^2 = (f + 2d) / 4
    const double h1 = 2 * (r - 1 - t) / r, h2 = (4 - 4 / slope - 2 * h1) / (4 * r * r);
    return { anisotropy(frobenius, determinant) + scale_penalty(r, t),
             0.5 + 0.25 * h1,
             0.5 * h1 - 1,
             0.0625 * h2,
             0.125 * h2,
             0.25 * h2 };
  }

private:
  // (s1 - s2)^2 / 2, not negative by rounding
  static double anisotropy(double frobenius, double determinant)
  {
    return (std::max)(0.5 * frobenius - determinant, 0.);
  }

  static double mean_singular_value(double frobenius, double determinant)
  {
    return 0.5 * std::sqrt((std::max)(frobenius + 2 * determinant, 0.));
  }

  // From here on the scale of a triangle is its own.
  static constexpr double infinite_stiffness = 1e15;

  // The best scale, less 1. It is the positive root of k s (s^2 - 1) + s - r, which is convex there and negative at 0:
  // Newton's method comes down to it from the end of a first step that starts at s = 1. With s - 1 as the unknown
  // nothing is lost for great k, where it is of the order 1/k.
  double excess_scale(double r) const
  {
    if (m_stiffness > infinite_stiffness)
      return 0;
    constexpr int most_steps = 60;
    const double k = m_stiffness;
    double t = (r - 1) / (1 + 2 * k);
    for (int i = 0; i < most_steps; ++i) {
      const double next = t - (k * t * (1 + t) * (2 + t) + 1 + t - r) / (1 + k * (3 * (1 + t) * (1 + t) - 1));
      if (!(next < t))
        break;
      t = next;
    }
    return t;
  }

  double scale_penalty(double r, double t) const
  {
    const double difference = r - 1 - t,
                 penalty = m_stiffness > infinite_stiffness ? 0 : m_stiffness * t * t * (2 + t) * (2 + t);
    return 2 * difference * difference + penalty;
  }

  double m_lambda, m_stiffness;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_AS_RIGID_AS_POSSIBLE_ENERGY_2_H
