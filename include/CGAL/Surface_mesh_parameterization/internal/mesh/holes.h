// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_HOLES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_HOLES_H

#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

typedef std::vector<Index>   Border;      // a cycle of vertices, with the surface to its left

// All borders but the outer one. `rings` are those of the surface.
std::vector<Border> holes(const Triangulated_surface_3& surface, const One_rings& rings);

// The length of a border whose vertices are at `place(v)`.
template <class Place>
double length_of_border(const Border& border, const Place& place)
{
  double result = 0;
  for (std::size_t i = 0; i < border.size(); ++i)
    result += std::sqrt((place(border[i + 1 == border.size() ? 0 : i + 1]) - place(border[i])).squared_length());
  return result;
}

// Whether two sides of a hole, whose vertices are at `place(v)`, almost lie on each other: its area is next to nothing
// for its length.
template <class Place>
bool is_crack(const Border& hole, const Place& place)
{
  constexpr double greatest_area = 0.01;      // for the length 1; that of a square is 0.06
  Vector_3 doubled_area(0, 0, 0);
  for (std::size_t i = 1; i + 1 < hole.size(); ++i)
    doubled_area += CGAL::cross_product(place(hole[i]) - place(hole[0]), place(hole[i + 1]) - place(hole[0]));
  return 0.5 * std::sqrt(doubled_area.squared_length()) <= greatest_area * CGAL::square(length_of_border(hole, place));
}

// Closes a hole by a virtual vertex in the middle of it, which comes last. In a crack, where its triangles would have
// no area, it is a little above the surface, if that has an area there. `rings` are those of the surface with the hole.
void fill_hole(const Border& hole, const One_rings& rings, Triangulated_surface_3& surface);

// Closes every border but the outer one. The virtual vertices come last.
void fill_holes(Triangulated_surface_3& surface);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/mesh/holes_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_HOLES_H
