// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERIZATION_PROGRESS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERIZATION_PROGRESS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationRef
///
/// How far a run has come, as it is reported to a `HierarchyVisitor_3`.
struct Parameterization_progress
{
  std::size_t level = 0;              ///< index of the level; 0 is the coarsest
  std::size_t number_of_levels = 0;   ///< number of levels; 0 while the hierarchy is being built
  std::size_t vertices = 0;           ///< number of vertices of the level; of those left while the hierarchy is built
  std::size_t iterations = 0;         ///< iterations on the level so far, as `Level_summary` counts them; of a linear
                                      ///< solver, iterations for the system that is being solved
  double energy = 0;      ///< the energy that is being minimized, as `Level_summary::energy_end`; of a linear solver,
                          ///< the relative residual; 0 while the hierarchy is being built
  /// an estimate of the fraction of the whole run that is done, from 0 to 1. It never falls, and it is 1 only in the
  /// last call, when the map is finished
  double part_done = 0;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERIZATION_PROGRESS_H
