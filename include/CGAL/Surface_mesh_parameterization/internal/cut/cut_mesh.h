// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_MESH_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_MESH_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Cut_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/cut_component.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

typedef Names<internal_np::distortion_bound_t, internal_np::join_borders_t, internal_np::visitor_t>   Cut_names;

// The named parameters of cut_to_disk().
template <class NamedParameters>
Cut_options cut_options_of(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Cut_options options;
  const std::optional<double> bound =
      choose_parameter(get_parameter(np, internal_np::distortion_bound), std::optional<double>());
  options.measures_all_disks = bound.has_value();
  if (bound)
    options.distortion_bound = options.bound_of_disks = *bound;
  options.joins_borders = choose_parameter(get_parameter(np, internal_np::join_borders), options.joins_borders);
  return options;
}

// Severs a mesh, so that every component becomes a disk, possibly with holes, and splits its vertices. Returns what was
// done with each, in the order of connected_components(). Several components are cut side by side if the loops do so.
// Once the options' watch stops that, the rest is not cut.
std::vector<Component_cut> cut_mesh(Corner_mesh& mesh, const Cut_options& options, const Loops& loops);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/cut/cut_mesh_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_MESH_H
