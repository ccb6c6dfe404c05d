// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_TRIANGLE_WEIGHT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_TRIANGLE_WEIGHT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationEnergies
///
/// The weight of a triangle's energy in the sum over all triangles.
enum class Triangle_weight
{
  ONE,    ///< 1, as in the paper
  AREA    ///< the triangle's area in space
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_TRIANGLE_WEIGHT_H
