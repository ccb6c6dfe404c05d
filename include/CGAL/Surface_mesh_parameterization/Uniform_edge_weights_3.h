// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_UNIFORM_EDGE_WEIGHTS_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_UNIFORM_EDGE_WEIGHTS_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationEnergies
///
/// All weights are 1, so every vertex goes to the mean of its neighbors. The shape of the surface has no influence.
///
/// Source: Tutte, *How to draw a graph*, 1963.
///
/// \cgalModels `EdgeWeights_3`
struct Uniform_edge_weights_3
{
  static constexpr bool is_symmetric = true;    ///< an edge has the same weight at both ends

  /// computes the weights of the edges of one vertex, see `EdgeWeights_3`
  void operator()(const internal::Point_3&, const std::vector<internal::Point_3>& ring, bool,
                  std::vector<double>& weights) const
  {
    weights.assign(ring.size(), 1.);
  }
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_UNIFORM_EDGE_WEIGHTS_3_H
