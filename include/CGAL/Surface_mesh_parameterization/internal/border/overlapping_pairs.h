// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_OVERLAPPING_PAIRS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_OVERLAPPING_PAIRS_H

#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

typedef std::array<Point_2, 3>   Triangle_2;

// The number of pairs of triangles whose interiors meet. Triangles that lie on a line have no interior; flipped ones
// count like others. After `most_tests` pairs that are near each other counting ends. Precondition: no coordinate is
// infinite or no number.
std::size_t number_of_overlapping_pairs(const std::vector<Triangle_2>& triangles, std::size_t most_tests = 100'000'000);

// Whether there is such a pair; however many are near each other.
bool has_overlapping_pairs(const std::vector<Triangle_2>& triangles);

// Whether the borders of a map of positive triangles show that it is one-to-one: no two edges cross, and of the closed
// curves just one turns left. Then it winds at most once around a point of the plane, and as often as it winds around
// it, so many triangles lie over it.
bool are_borders_one_to_one(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv);

// The same of several charts, each connected, that share no vertex: also that no two overlap. `chart_of` are the charts
// of the edges, from 0.
bool are_charts_one_to_one(const std::vector<Border_edge>& edges, const std::vector<Index>& chart_of,
                           const std::vector<Point_2>& uv);

// Whether no two charts overlap, each of which may overlap itself.
bool are_charts_apart(const std::vector<Border_edge>& edges, const std::vector<Index>& chart_of,
                      const std::vector<Point_2>& uv);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_OVERLAPPING_PAIRS_H
