// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_PROGRESS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_PROGRESS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationAtlas
///
/// How far an atlas has come, as it is reported to an `AtlasVisitor`.
struct Atlas_progress
{
  /// the steps of an atlas, in their order
  enum Step
  {
    CUT,            ///< the surface is cut into charts
    PARAMETERIZE,   ///< the charts are parameterized, and divided where they overlap themselves
    PACK            ///< the charts are packed, and divided where they would leave too much of the square empty
  };

  Step step = CUT;        ///< what is done at this time
  /// an estimate of the fraction of the step that is done, from 0 to 1, by numbers of triangles. It never falls. That
  /// of the packing cannot be told, and stays 0
  double part_done = 0;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_PROGRESS_H
