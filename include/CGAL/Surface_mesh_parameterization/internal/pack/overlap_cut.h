// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_OVERLAP_CUT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_OVERLAP_CUT_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Chart_part.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Where to cut a connected chart whose map lies over itself: the halfedges of short cuts, on one side of which
// triangles lie over others only in small pieces. None if the part of the triangles that do so is not greater than the
// bound, or a triangle is not positive.
std::vector<Index> overlap_cut(const Corner_mesh& chart, const std::vector<Point_2>& uv, double overlap_bound);

// The parts into which such cuts divide a chart, and divide the parts again, as long as more of them lies over itself
// than another bound. None if the chart is not divided.
std::vector<Chart_part> divided_at_overlaps(const Chart_part& chart, double overlap_bound, double bound_of_parts);

// Whether the map of a chart whose triangles are positive does not lie over itself.
bool is_one_to_one(const Corner_mesh& chart, const std::vector<Point_2>& uv);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/pack/overlap_cut_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_OVERLAP_CUT_H
