// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_OPTION_DEFAULTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_OPTION_DEFAULTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// Default values of named parameters, for applications that have options of their own for them. Those of methods that
/// minimize the distortion of triangles are the members of `Refinement_options`, and that of `coarsest_size` is
/// `Collapse_hierarchy_3::default_coarsest_size`.
struct Option_defaults
{
  /// \name Methods that solve linear systems
  /// @{
  static constexpr double tolerance_of_edge_energies = 1e-8;        ///< `tolerance` of `Edge_energy_parameterizer_3`
  static constexpr double tolerance_of_linear_solver = 1e-10;       ///< `tolerance` of `Multigrid_solver_traits` and of
                                                                    ///< CGAL's methods in the adaptor
  static constexpr std::size_t iterations_of_linear_solver = 300;   ///< `number_of_iterations` of all these
  /// @}

  /// \name Atlases
  /// @{
  static constexpr double distortion_bound = 4.5;   ///< of surfaces that have to be cut; disks are left up to 8
  static constexpr double least_used_part = 0.25;   ///< fraction of the square that charts cover
  static constexpr double overlap_bound = 0.2;      ///< fraction of a chart's triangles that others may cover
  static constexpr double hole_bound = 0.1;         ///< length of a hole's border, by the root of the area
  /// @}
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_OPTION_DEFAULTS_H
