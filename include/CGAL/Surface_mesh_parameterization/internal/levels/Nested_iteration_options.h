// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_OPTIONS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/concept_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/detection.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/number_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/starting_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

struct Nested_iteration_options
{
  Hierarchy_options hierarchy;                      // a flat run: `coarsest_size` is at least the number of vertices
  bool fills_holes = false;
  bool must_hold_places = false;                    // a result whose fixed vertices are not at their places is none
  bool may_mirror_places = false;                   // if a map tells that they are those of its mirror image
  std::vector<Triangulated_surface_3::Fixed_vertex> places_at_end;      // to which a free map moves when it is done
  double overlap_bound = 1;         // the part of the triangles of a map that may lie over others before it is left so
  Make_starting_map make_starting_map = nullptr;      // of the user's map; null if the run starts on the coarsest level
  Flip_settlement flips;            // for what methods leave that do not keep triangles positive
  Round_coordinate round = nullptr;       // to the number type of the result; null if that holds doubles

  const char* fault_of_hierarchy = nullptr;       // what is wrong with its named parameters; null if nothing is

  // What is wrong with the options; null if nothing is.
  const char* fault() const
  {
    const bool is_part = overlap_bound >= 0 && overlap_bound <= 1;
    return first_fault({ fault_of_hierarchy, is_part ? nullptr : "overlap_bound is not from 0 to 1" });
  }
};

// Whether a method declares that its results have no flips either: is_flip_free only speaks of the levels below the
// finest.
template <class Method>
constexpr bool is_result_flip_free = is_detected_true<concept_checks::Is_result_flip_free, Method>;

// Whether a method declares that it holds vertices whose places are given, and lets springs pull others.
template <class Method>
constexpr bool holds_vertices = is_detected_true<concept_checks::Holds_vertices, Method>;

template <class Method>
using Borders_kept_apart = decltype(std::declval<Method&>().keep_borders_apart(true));

// Whether a method has that optional member of the concept.
template <class Method>
constexpr bool keeps_borders_apart = is_detected<Borders_kept_apart, Method>;

template <class Method, class NamedParameters>
Nested_iteration_options nested_iteration_options_of(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Nested_iteration_options options;
  options.hierarchy = hierarchy_options_of(np);
  options.fault_of_hierarchy = fault_of_hierarchy(np);
  options.fills_holes = choose_parameter(get_parameter(np, internal_np::fill_holes), options.fills_holes);
  options.overlap_bound = choose_parameter(get_parameter(np, internal_np::overlap_bound), options.overlap_bound);
  options.make_starting_map = make_starting_map_of(np);
  options.flips = flip_settlement_of<!is_result_flip_free<Method>>(np);
  return options;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_OPTIONS_H
