// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_FLIP_POLICY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_FLIP_POLICY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// What becomes of a map that a method made with flips: triangles that are not positive, by exact predicates, or vertices that are surrounded more than once. A
/// map that is mirrored as a whole has none.
enum class Flip_policy
{
  FAIL,     ///< it is an error, `ERROR_NO_1_TO_1_MAPPING`; the default
  KEEP,     ///< the map is returned as it is
  REPAIR    ///< the map is made free of flips, and stays the same but for vertices that cannot be where the method put them
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FLIP_POLICY_H
