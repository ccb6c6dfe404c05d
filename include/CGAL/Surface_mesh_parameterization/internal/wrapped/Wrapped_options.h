// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_OPTIONS_H

#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/number_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/linear_solver_options_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/build_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <memory>

namespace CGAL::Surface_mesh_parameterization::internal {

// What a run of a wrapped parameterizer takes besides the mesh and the parameterizer.
struct Wrapped_options
{
  Hierarchy_options hierarchy;
  Linear_solver_options solver;
  bool fills_holes = false;
  Flip_settlement flips;
  decltype(&build_interpolation) build = &build_interpolation;
  std::shared_ptr<Any_hierarchy_visitor> visitor;       // may be null
  Parameterization_summary* summary = nullptr;          // may be null
  const char* fault = nullptr;                          // what is wrong with the named parameters; null if nothing is

  const Loops& loops() const { return solver.loops; }
  void set_loops(const Loops& loops) { solver.loops = flips.loops = loops; }
};

// The names that all of them take.
typedef Names<internal_np::coarsest_size_t, internal_np::random_seed_t, internal_np::unit_edges_t,
              internal_np::tolerance_t, internal_np::number_of_iterations_t, internal_np::visitor_t,
              internal_np::summary_t>   Wrapped_option_names;

template <bool may_have_flips, class NamedParameters>
Wrapped_options wrapped_options_of(const NamedParameters& np, const Hierarchy_options& hierarchy_defaults)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Wrapped_options options;
  options.hierarchy = hierarchy_options_of(np, hierarchy_defaults);
  options.solver = linear_solver_options_of(np);
  options.fills_holes = choose_parameter(get_parameter(np, internal_np::fill_holes), options.fills_holes);
  options.flips = flip_settlement_of<may_have_flips>(np);
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::visitor_t>::value) {
    options.visitor = hierarchy_visitor_of(np);
    options.build = &build_visited_interpolation;
  }
  options.summary = summary_of(np);
  options.fault = fault_of_numbers(np);
  return options;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_OPTIONS_H
