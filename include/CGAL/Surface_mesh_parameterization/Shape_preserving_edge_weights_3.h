// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_SHAPE_PRESERVING_EDGE_WEIGHTS_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_SHAPE_PRESERVING_EDGE_WEIGHTS_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/discrete_exponential_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationEnergies
///
/// The discrete exponential map flattens the one-ring of a vertex. For each neighbor, the vertex then lies in a
/// triangle of this neighbor and two other, consecutive ones. The weights are the means of its barycentric coordinates
/// in these triangles, and sum to 1. A planar mesh whose holes are convex is mapped onto itself if its border is. No
/// weight is negative, so no triangle flips if the border is convex.
///
/// For a vertex on the border of a hole, its two neighbors on that border count as joined by a triangle.
///
/// Source: Floater, *Parametrization and smooth approximation of surface triangulations*, 1997.
///
/// \cgalModels `EdgeWeights_3`
class Shape_preserving_edge_weights_3
{
public:
  static constexpr bool is_symmetric = false;   ///< an edge has different weights at its ends

  /// computes the weights of the edges of one vertex, see `EdgeWeights_3`
  void operator()(const internal::Point_3& v, const std::vector<internal::Point_3>& ring, bool,
                  std::vector<double>& weights)
  {
    // None of the angles exceeds the sum of the others, so that in the plane none exceeds half a turn.
    internal::discrete_exponential_map(v, ring, true, m_flat_ring);
    weights.assign(ring.size(), 0.);
    for (std::size_t i = 0; i < ring.size(); ++i)
      add_coordinates(i, 1 / double(ring.size()), weights);
  }

private:
  //        Wj                 The triangle of Wi that holds V: the ray from Wi through V leaves the ring by the edge
  //       /| \  -             WjWk. So Wj is the last one in counter-clockwise order that is less than half a turn
  //      / V---- Wi           away from Wi.
  //     / -   -
  //    Wk
  void add_coordinates(std::size_t i, double factor, std::vector<double>& weights) const
  {
    const internal::Vector_2& wi = m_flat_ring[i];
    std::size_t j = i, k = next(i);
    while (k != i && internal::cross(wi, m_flat_ring[k]) > 0) {
      j = k;
      k = next(k);
    }
    const internal::Vector_2 &wj = m_flat_ring[j], &wk = m_flat_ring[k];
    const std::array<double, 3> areas = { (std::max)(0., internal::cross(wj, wk)),
                                          (std::max)(0., internal::cross(wk, wi)),
                                          (std::max)(0., internal::cross(wi, wj)) };
    const double area = areas[0] + areas[1] + areas[2];
    if (j != i && k != i && area > 0) {
      weights[i] += factor * areas[0] / area;
      weights[j] += factor * areas[1] / area;
      weights[k] += factor * areas[2] / area;
    } else
      add_coordinates_between(i, k == i ? j : k, factor, weights);
  }

  // Where V lies between Wi and Wk, up to rounding, as in a ring of two.
  void add_coordinates_between(std::size_t i, std::size_t k, double factor, std::vector<double>& weights) const
  {
    const double to_i = std::sqrt(m_flat_ring[i].squared_length()), to_k = std::sqrt(m_flat_ring[k].squared_length());
    const double fraction = to_i > 0 ? to_i / (to_i + to_k) : 0;
    weights[i] += factor * (1 - fraction);
    weights[k] += factor * fraction;
  }

  std::size_t next(std::size_t i) const { return internal::next_in_cycle(i, m_flat_ring.size()); }

  std::vector<internal::Vector_2> m_flat_ring;    // scratch
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SHAPE_PRESERVING_EDGE_WEIGHTS_3_H
