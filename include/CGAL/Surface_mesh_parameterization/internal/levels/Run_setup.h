// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_RUN_SETUP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_RUN_SETUP_H

#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/detection.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Place_constraints.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// What a parameterizer is told of its runs, besides the options of the method.
template <class TriangleMesh>
struct Run_setup
{
  Nested_iteration_options options;
  Place_constraints<TriangleMesh> constraints;
  Parameterization_summary* summary = nullptr;      // null: nobody wants it
};

template <class Method, class TriangleMesh, class NamedParameters>
Run_setup<TriangleMesh> run_setup_of(const NamedParameters& np)
{
  return { nested_iteration_options_of<Method>(np), place_constraints_of<TriangleMesh>(np), summary_of(np) };
}

template <class Method>
using Flat_run_setup = decltype(std::declval<const Method&>().flat_run_setup());

// What `np` does not say is what the method was told of its flat runs, if it keeps that and a run coarse to fine takes
// it.
template <class Method, class NamedParameters>
Run_setup<typename Method::Triangle_mesh> run_setup_of(const NamedParameters& np, [[maybe_unused]] const Method& method)
{
  auto result = run_setup_of<Method, typename Method::Triangle_mesh>(np);
  if constexpr (is_detected<Flat_run_setup, Method>) {
    const auto& given = method.flat_run_setup();
    const auto take = [&](auto tag, auto& value, const auto& given_value) {
      if constexpr (parameters::is_default_parameter<NamedParameters, decltype(tag)>::value)
        value = given_value;
    };
    take(internal_np::fill_holes_t(), result.options.fills_holes, given.options.fills_holes);
    take(internal_np::overlap_bound_t(), result.options.overlap_bound, given.options.overlap_bound);
    take(internal_np::flip_policy_t(), result.options.flips, given.options.flips);
    take(internal_np::summary_t(), result.summary, given.summary);
    if constexpr (Method::is_flip_free)
      take(internal_np::initial_map_t(), result.options.make_starting_map, given.options.make_starting_map);
    if constexpr (holds_vertices<Method>) {
      take(internal_np::vertex_is_constrained_t(), result.constraints.is_constrained, given.constraints.is_constrained);
      take(internal_np::position_weight_t(), result.constraints.weight, given.constraints.weight);
    }
  }
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_RUN_SETUP_H
