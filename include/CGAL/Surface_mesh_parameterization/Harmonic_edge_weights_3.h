// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_HARMONIC_EDGE_WEIGHTS_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_HARMONIC_EDGE_WEIGHTS_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/sum_over_corners.h>

#include <array>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationEnergies
///
/// The weight is half the sum of the cotangents of the angles opposite to the edge. The energy is the Dirichlet energy,
/// and the map is discrete harmonic. A planar mesh without holes is mapped onto itself if its border is. Where the two
/// opposite angles sum to more than 180 degrees, the weight is negative, and triangles may flip.
///
/// The border of a hole is free: its edges have one opposite angle. A triangle whose height is less than 1e-6 of its
/// longest edge is treated as if it had that height, an edge without length as 1e-4 of the other two.
///
/// Sources: Pinkall and Polthier, *Computing discrete minimal surfaces and their conjugates*, 1993; Eck et al.,
/// *Multiresolution analysis of arbitrary meshes*, 1995.
///
/// \cgalModels `EdgeWeights_3`
struct Harmonic_edge_weights_3
{
  static constexpr bool is_symmetric = true;    ///< an edge has the same weight at both ends

  /// computes the weights of the edges of one vertex, see `EdgeWeights_3`
  void operator()(const internal::Point_3& v, const std::vector<internal::Point_3>& ring, bool is_closed,
                  std::vector<double>& weights) const
  {
    const auto halves_of_cotangents = [](const internal::Rest_corner& corner) {
      return std::array<double, 2>{ 0.5 * corner.cotangent_at_b(), 0.5 * corner.cotangent_at_a() };
    };
    internal::sum_over_corners(v, ring, is_closed, halves_of_cotangents, weights);
  }
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_HARMONIC_EDGE_WEIGHTS_3_H
