// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_CRACKS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_CRACKS_H

#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The length of a polygon whose vertices are at the given points.
template <class Place>
double length_of_cycle(const std::vector<Index>& cycle, const Place& place)
{
  double result = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i)
    result += std::sqrt((place(cycle[i + 1 == cycle.size() ? 0 : i + 1]) - place(cycle[i])).squared_length());
  return result;
}

// Closes what holes of no more than a given length are cracks: from where a hole ends in a tip, vertices that lie on
// each other, or almost so, become one, as long as the surface stays a manifold. Returns for each vertex the one that
// it has become.
// Precondition: every vertex is manifold.
std::vector<Index> close_cracks(Triangulated_surface_3& surface, double greatest_length);

// A map of a surface from that of the surface without cracks: vertices that were one part, each into its own triangles,
// so that a gap opens. `closed_vertices` is what close_cracks() returned.
std::vector<Point_2> open_cracks(const Triangulated_surface_3& surface, const std::vector<Index>& closed_vertices,
                                 const std::vector<Point_2>& closed_map);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/mesh/cracks_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_CRACKS_H
