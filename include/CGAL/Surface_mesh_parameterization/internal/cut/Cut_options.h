// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_OPTIONS_H

#include <CGAL/Surface_mesh_parameterization/Option_defaults.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

class Run_watch;

struct Cut_options
{
  double distortion_bound = Option_defaults::distortion_bound;      // of the mean symmetric Dirichlet energy
  double bound_of_disks = 8;                // surfaces that need no cut are cut, too, where they exceed this
  bool measures_all_disks = false;          // else only those with a short border are taken to exceed it
  double least_length_of_border = 0.5;      // of one that is not short, by that of a circle of the surface's area
  bool joins_borders = false;               // whether the result is a disk without holes
  std::size_t most_branches = 50;           // paths to extremities
  double least_gain = 0.01;                 // of a branch, of the distortion above its minimum
  unsigned int most_failures = 8;           // branches that gain less, before a search ends
  std::size_t sample_size = 2000;           // vertices of the coarse level on which extremities are found
  Run_watch* watch = nullptr;               // asks whether the cut may go on; null if nobody does

  bool is_valid() const { return distortion_bound >= Symmetric_Dirichlet_energy_2::minimum; }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_OPTIONS_H
