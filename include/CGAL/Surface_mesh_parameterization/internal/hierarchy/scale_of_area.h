// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_SCALE_OF_AREA_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_SCALE_OF_AREA_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal {

// The factor that brings a map to the area of the level; 0 if doubles have none.
inline double scale_of_area(const Level& level, const Level::Uv& uv)
{
  double area = 0, image_area = 0;
  for (const Level::Triangle& t : level.triangles()) {
    area += doubled_area(level.point(t[0]), level.point(t[1]), level.point(t[2]));
    image_area += doubled_area(uv[t[0]], uv[t[1]], uv[t[2]]);
  }
  const double scale = std::sqrt(area / image_area);
  return std::isfinite(scale) ? scale : 0;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_SCALE_OF_AREA_H
