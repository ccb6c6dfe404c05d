// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_FLAT_CHART_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_FLAT_CHART_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A chart of an atlas as triangles in the plane.
struct Flat_chart
{
  std::vector<Point_2> points;
  std::vector<Index_triangle> triangles;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_FLAT_CHART_H
