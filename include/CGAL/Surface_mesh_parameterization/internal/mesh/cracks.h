// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_CRACKS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_CRACKS_H

#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/holes.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Closes cracks from where they end in tips on: vertices that lie on each other, or almost so, become one, as long as
// the surface stays a manifold, and no two bound ones do. `cracks` are borders, `rings` those of the surface. Returns
// the vertex that stands for each one.
std::vector<Index> merge_sides(const std::vector<Border>& cracks, const std::vector<Point_3>& points,
                               const One_rings& rings, std::vector<bool> is_bound);

// A surface without the small cracks of another one.
struct Closed_surface
{
  Triangulated_surface_3 surface;
  std::vector<Index> vertices;      // what the vertices of the other surface have become; empty if it had no cracks
};

// Closes what holes of no more than a given length are cracks, see merge_sides(). What is open then, because the
// vertices of one side do not meet those of the other, is filled.
// Precondition: every vertex is manifold.
Closed_surface close_cracks(Triangulated_surface_3 surface, double greatest_length);

// A map of the surface that was closed, from one of the closed surface: vertices that were made one part, each into its
// own triangles, so that a gap opens. Empty if that leads to no valid map.
std::vector<Point_2> open_cracks(const Triangulated_surface_3& surface, const Closed_surface& closed,
                                 const std::vector<Point_2>& closed_map);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/mesh/cracks_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_CRACKS_H
