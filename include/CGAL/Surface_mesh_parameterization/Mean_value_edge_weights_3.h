// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_MEAN_VALUE_EDGE_WEIGHTS_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_MEAN_VALUE_EDGE_WEIGHTS_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/sum_over_corners.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationEnergies
///
/// The weight is the sum of the tangents of half the two angles at the vertex beside the edge, divided by the length of
/// the edge. A planar mesh without holes is mapped onto itself if its border is. All weights are positive, so no
/// triangle flips if the border is convex.
///
/// An edge on the border of a hole has one such angle. A triangle whose height is less than 1e-6 of its longest edge is
/// treated as if it had that height, an edge without length as 1e-4 of the other two.
///
/// Source: Floater, *Mean value coordinates*, 2003.
///
/// \cgalModels `EdgeWeights_3`
struct Mean_value_edge_weights_3
{
  static constexpr bool is_symmetric = false;   ///< an edge has different weights at its ends

  /// computes the weights of the edges of one vertex, see `EdgeWeights_3`
  void operator()(const internal::Point_3& v, const std::vector<internal::Point_3>& ring, bool is_closed,
                  std::vector<double>& weights) const
  {
    const auto tangents_over_lengths = [](const internal::Rest_corner& corner) {
      const double cotangent = corner.cotangent_at_v(), hypotenuse = std::sqrt(1 + cotangent * cotangent);
      const double tangent_of_half = cotangent > 0 ? 1 / (hypotenuse + cotangent) : hypotenuse - cotangent;
      return std::array<double, 2>{ tangent_of_half / corner.length_to_a(), tangent_of_half / corner.length_to_b() };
    };
    internal::sum_over_corners(v, ring, is_closed, tangents_over_lengths, weights);
  }
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_MEAN_VALUE_EDGE_WEIGHTS_3_H
