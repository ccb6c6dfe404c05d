// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_LINEAR_SOLVER_OPTIONS_OF_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_LINEAR_SOLVER_OPTIONS_OF_H

#include <CGAL/Surface_mesh_parameterization/internal/core/number_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

namespace CGAL::Surface_mesh_parameterization::internal {

// What named parameters hold, else the defaults.
template <class NamedParameters>
Linear_solver_options linear_solver_options_of(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Linear_solver_options options;
  options.tolerance = choose_parameter(get_parameter(np, internal_np::tolerance), options.tolerance);
  options.most_iterations = chosen_count(np, internal_np::number_of_iterations, options.most_iterations);
  return options;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_LINEAR_SOLVER_OPTIONS_OF_H
