// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_CHORDAL_EDGE_WEIGHTS_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_CHORDAL_EDGE_WEIGHTS_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationEnergies
///
/// The weight of an edge of length `l` is `1 / l^r`: a longer edge is a softer spring. With `r = 0` the weights are
/// uniform.
///
/// An edge that is shorter than 1e-9 of the size of the surface is treated as if it had that length.
///
/// Source: Greiner and Hormann, *Interpolating and approximating scattered 3D-data with hierarchical tensor product
/// B-splines*, 1997.
///
/// \cgalModels `EdgeWeights_3`
class Chordal_edge_weights_3
{
public:
  static constexpr bool is_symmetric = true;    ///< an edge has the same weight at both ends

  /// \param exponent `r`
  explicit Chordal_edge_weights_3(double exponent = 1) : m_exponent(exponent) { }

  /// computes the weights of the edges of one vertex, see `EdgeWeights_3`
  void operator()(const internal::Point_3& v, const std::vector<internal::Point_3>& ring, bool,
                  std::vector<double>& weights) const
  {
    constexpr double shortest = 1e-9;
    weights.resize(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i)
      weights[i] = std::pow((std::max)(shortest, std::sqrt(CGAL::squared_distance(v, ring[i]))), -m_exponent);
  }

private:
  double m_exponent;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_CHORDAL_EDGE_WEIGHTS_3_H
