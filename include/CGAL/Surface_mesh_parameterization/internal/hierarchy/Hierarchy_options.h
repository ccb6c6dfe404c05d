// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHY_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHY_OPTIONS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/number_checks.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

class Run_progress;

// The named parameters of Collapse_hierarchy_3.
struct Hierarchy_options
{
  static constexpr std::size_t default_coarsest_size = 100;

  std::size_t coarsest_size = default_coarsest_size;
  unsigned int random_seed = 0;
  bool has_unit_edges = false;                // triangles are rated in the Unit_edge_metric
  std::vector<bool> is_constrained = {};      // the vertices that stay on every level; none of them if it is empty
  Run_progress* progress = nullptr;           // is told of each group, and may end the building; may be null
};

// `defaults` with what named parameters hold, but for the constrained vertices.
template <class NamedParameters>
Hierarchy_options hierarchy_options_of(const NamedParameters& np,
                                       const Hierarchy_options& defaults = Hierarchy_options())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Hierarchy_options options = defaults;
  options.coarsest_size = chosen_count(np, internal_np::coarsest_size, options.coarsest_size);
  options.random_seed = choose_parameter(get_parameter(np, internal_np::random_seed), options.random_seed);
  options.has_unit_edges = choose_parameter(get_parameter(np, internal_np::unit_edges), options.has_unit_edges);
  return options;
}

// The same with the constrained vertices, of a surface with so many.
template <class NamedParameters>
Hierarchy_options hierarchy_options_of(const NamedParameters& np, std::size_t number_of_vertices)
{
  Hierarchy_options options = hierarchy_options_of(np);
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::vertex_is_constrained_t>::value) {
    const auto is_constrained = parameters::get_parameter(np, internal_np::vertex_is_constrained);
    options.is_constrained.resize(number_of_vertices);
    for (std::size_t v = 0; v < number_of_vertices; ++v)
      options.is_constrained[v] = get(is_constrained, v);
  }
  return options;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHY_OPTIONS_H
