// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_OPTIONS_H

#include <CGAL/Surface_mesh_parameterization/Option_defaults.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Cut_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/cut_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <optional>

namespace CGAL::Surface_mesh_parameterization::internal {

typedef Joined_names<Cut_names, Pack_names,
                     Names<internal_np::edge_is_constrained_t, internal_np::least_used_part_t,
                           internal_np::overlap_bound_t, internal_np::hole_bound_t>>   Atlas_names;

// Checks that no named parameter for the runs of an atlas is one that these cannot have.
template <class Chart_parameters>
void assert_names_of_charts()
{
  using parameters::is_default_parameter;
  static_assert(is_default_parameter<Chart_parameters, internal_np::summary_t>::value,
                "the named parameter 'summary' has no effect on charts: what is returned has the summary of each");
  static_assert(is_default_parameter<Chart_parameters, internal_np::overlap_bound_t>::value,
                "the named parameter 'overlap_bound' is one of the atlas, not of charts");
  static_assert(is_default_parameter<Chart_parameters, internal_np::vertex_is_constrained_t>::value &&
                    is_default_parameter<Chart_parameters, internal_np::position_weight_t>::value,
                "the vertices of charts are not those of the mesh: none can be constrained or pulled by a spring");
  static_assert(is_default_parameter<Chart_parameters, internal_np::initial_map_t>::value,
                "the named parameter 'initial_map' has no effect on charts: no map is known before the surface is cut");
}

struct Atlas_options
{
  Cut_options cut;
  Pack_options pack;
  double least_used_part = Option_defaults::least_used_part;      // 0: charts are not divided for it
  double overlap_bound = Option_defaults::overlap_bound;          // above it a chart is divided
  double hole_bound = Option_defaults::hole_bound;                // above it a hole stays open

  // What is out of its bounds; null if nothing is. The options of the cut are checked where it is made.
  const char* fault() const
  {
    const auto is_part = [](double x) { return x >= 0 && x <= 1; };
    return !pack.is_valid()             ? "the margin is not from 0 to 0.1"
           : !is_part(least_used_part) ? "least_used_part is not from 0 to 1"
           : !is_part(overlap_bound)   ? "overlap_bound is not from 0 to 1"
           : !is_part(hole_bound)      ? "hole_bound is not from 0 to 1"
                                       : nullptr;
  }
};

template <class NamedParameters>
Atlas_options atlas_options_of(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef std::optional<double>   Bound;
  Atlas_options options;
  options.cut = cut_options_of(np);
  options.pack = pack_options_of(np);
  const Bound least_used_part = choose_parameter(get_parameter(np, internal_np::least_used_part), Bound()),
              overlap_bound = choose_parameter(get_parameter(np, internal_np::overlap_bound), Bound()),
              hole_bound = choose_parameter(get_parameter(np, internal_np::hole_bound), Bound());
  options.least_used_part = least_used_part.value_or(options.least_used_part);
  options.overlap_bound = overlap_bound.value_or(options.overlap_bound);
  options.hole_bound = hole_bound.value_or(options.hole_bound);
  return options;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_OPTIONS_H
