// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

struct Cut_options
{
  double distortion_bound = 4.5;            // of the mean symmetric Dirichlet energy
  bool bounds_disks = false;                // whether surfaces that need no cut are cut, too, where they exceed it
  bool joins_borders = false;               // whether the result is a disk without holes
  std::size_t most_branches = 50;           // paths to extremities
  std::size_t most_failures = 8;            // branches that gain too little, before all are taken
  std::size_t sample_size = 2000;           // vertices of the coarse level on which extremities are found
};

// What was done with a component.
struct Component_cut
{
  std::size_t faces = 0;
  std::size_t genus = 0, borders = 0;       // before the cut
  std::size_t branches = 0;                 // to extremities
  double distortion = 0;                    // 0 if it was not measured
};

// Severs a connected mesh along edges, so that it becomes a disk, with holes where it had more than one border, and
// splits its vertices.
Component_cut cut_component(Corner_mesh& mesh, const Cut_options& options);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/cut/cut_component_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_H
