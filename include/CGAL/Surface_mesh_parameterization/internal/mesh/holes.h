// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_HOLES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_HOLES_H

#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <array>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

typedef std::vector<Index>   Border;      // a cycle of vertices, with the surface to its left

// All borders but the outer one. `rings` are those of the surface.
std::vector<Border> holes(const Triangulated_surface_3& surface, const One_rings& rings);

// Where the vertices of a border are: a closed polygon.
template <class Place>
std::vector<Point_3> places_of(const Border& border, const Place& place)
{
  std::vector<Point_3> result;
  for (const Index v : border)
    result.push_back(place(v));
  return result;
}

double perimeter(const std::vector<Point_3>& polygon);

// Whether two sides of a hole almost lie on each other: its area is next to nothing for its length.
bool is_crack(const std::vector<Point_3>& hole);

// A hole as a closed polygon, and the triangles of the surface along it.
struct Hole_3
{
  std::vector<Point_3> places;
  std::vector<std::array<Point_3, 3>> triangles;
};

// The place of a virtual vertex in the middle of a hole: the mean of the hole's. In a crack, where its triangles would
// have no area, it is a little above the surface, along the sum of the normals there, if that is not 0.
Point_3 middle_of_hole(const Hole_3& hole);

// Closes a hole by a virtual vertex in the middle of it, which comes last. `rings` are those of the surface with the
// hole.
void fill_hole(const Border& hole, const One_rings& rings, Triangulated_surface_3& surface);

// Closes every border but the outer one. The virtual vertices come last.
void fill_holes(Triangulated_surface_3& surface);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/mesh/holes_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_HOLES_H
