// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_FLAT_CHART_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_FLAT_CHART_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>

#include <CGAL/Bbox_2.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A chart of an atlas as triangles in the plane.
struct Flat_chart
{
  std::vector<Point_2> points;
  std::vector<Index_triangle> triangles;
};

// Scales points by a power of two, to about size 1. Returns its exponent.
inline int normalize(std::vector<Point_2>& points)
{
  CGAL::Bbox_2 box;
  for (const Point_2& p : points)
    box += p.bbox();
  const int exponent = scale_exponent_of(box);
  for (Point_2& p : points)
    p = times_power_of_two(p, exponent);
  return exponent;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_FLAT_CHART_H
