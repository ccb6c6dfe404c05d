// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_COVERED_TRIANGLES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_COVERED_TRIANGLES_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Calls f(i, j) for any two positive triangles of a map of which the first one has its centroid in the second one. In a
// map that overlaps itself just along a border there are none or few. Precondition: no coordinate is infinite or no
// number.
void for_each_covered_triangle(const std::vector<Index_triangle>& triangles, const std::vector<Point_2>& uv,
                               Function_ref<void(std::size_t, std::size_t)> f);

// The part of the triangles that have their centroid in another one.
double covered_part(const std::vector<Index_triangle>& triangles, const std::vector<Point_2>& uv);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/border/covered_triangles_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_COVERED_TRIANGLES_H
