// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_FILL_SMALL_HOLES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_FILL_SMALL_HOLES_H

#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Of a component.
struct Filled_holes
{
  std::size_t borders = 0;      // before
  std::size_t faces = 0;        // virtual ones
};

// Closes small holes: borders whose halfedges are all among the given ones, and that are no longer than `hole_bound`
// times the square root of the component's area. The longest border of a component is none. The sides of cracks are
// joined, see merge_sides(); round holes, and what is open of cracks then, get virtual faces around a virtual vertex in
// the middle of each, which come last. Returns what was done with each component, in the order of
// connected_components().
std::vector<Filled_holes> fill_small_holes(Corner_mesh& mesh, const std::vector<bool>& is_at_hole, double hole_bound);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/cut/fill_small_holes_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_FILL_SMALL_HOLES_H
