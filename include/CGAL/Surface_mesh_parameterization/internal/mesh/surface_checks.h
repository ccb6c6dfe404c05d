// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_SURFACE_CHECKS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_SURFACE_CHECKS_H

#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Whether a connected surface is a disk with holes, and if not, the first vertex where several fans meet or that two
// edges join with the same neighbor, `no_index` if there is none.
struct Disk_check
{
  bool is_disk_with_holes;
  Index bad_vertex;
};

// `border_vertices` are those on borders of the mesh: two edges with the same ends look like one if the triangles
// beside them fit together.
Disk_check check_disk_with_holes(const Triangulated_surface_3& surface, const std::vector<Index>& border_vertices,
                                 const Loops& loops);

// The number of sides of the points' box that have a length.
int dimension_of_box(const std::vector<Point_3>& points);

// Scales the points by a power of two, to about size 1, and moves them to the center of their box.
void normalize(Triangulated_surface_3& surface);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/mesh/surface_checks_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_SURFACE_CHECKS_H
