// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_H

#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Cut_options.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// Severs edges that have the same ends as others, or one vertex for both: what knows triangles by their vertices cannot
// tell them apart. A border of two edges may be left.
void sever_double_edges(Corner_mesh& mesh);

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

// Cuts a mesh of disk type that is a part of a surface that was cut, if it exceeds the bound for such surfaces. Returns
// whether it does not, then.
bool cut_distorted(Corner_mesh& mesh, const Cut_options& options);

// Makes a cut component's borders what the options ask for, and such that triangles can be told by their vertices.
void settle_borders(Corner_mesh& mesh, const Cut_options& options);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/cut/cut_component_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_H
