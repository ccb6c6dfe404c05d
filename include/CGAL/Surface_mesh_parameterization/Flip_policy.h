// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_FLIP_POLICY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_FLIP_POLICY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// The treatment of flips in a map that a method made. A flip is a triangle that is not positive by exact predicates,
/// or a vertex around which its triangles wind more than once. A map that is mirrored as a whole has no flips: if its
/// outermost border runs clockwise and no two border edges cross, or if there are crossings and more triangles are
/// negative than positive, flips are triangles that are not negative, and a repair makes all of them negative.
enum class Flip_policy
{
  FAIL,     ///< flips are an error, `ERROR_NO_1_TO_1_MAPPING`
  KEEP,     ///< the map is returned as it is
  REPAIR    ///< flips are removed; vertices near them move, and others only where that is not enough; the
            ///< default of most methods and of charts in an atlas, but `FAIL` is that of single maps by barycentric and
            ///< mean value coordinates on a circle
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FLIP_POLICY_H
