// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_CROSSINGS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_CROSSINGS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// An edge of a border, with the surface to its left.
struct Border_edge
{
  Index source, target;
};

// One starts at each border vertex, in their order.
std::vector<Border_edge> border_edges(const One_rings& rings);

// Whether two border edges meet in the plane anywhere but in a vertex that they share. Exact.
bool do_cross(const Border_edge& e, const Border_edge& f, const std::vector<Point_2>& uv);

// Calls f(i, j) for any two edges that meet in the plane, but for a vertex that they share. Exact, and near-linear
// where few edges are near each other. Precondition: no coordinate is infinite or no number.
void for_each_crossing(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv,
                       Function_ref<void(std::size_t, std::size_t)> f);

bool has_crossings(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv);

// The same among the pairs that count.
bool has_crossings(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv,
                   Function_ref<bool(std::size_t, std::size_t)> counts);

// The same among all border edges of a mesh.
inline bool has_crossings(const One_rings& rings, const std::vector<Point_2>& uv)
{
  return has_crossings(border_edges(rings), uv);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_CROSSINGS_H
