// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_SCALE_TO_AREA_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_SCALE_TO_AREA_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal {

// Scales a map so that it has the area of the surface. Where rounding would spoil it for `is_valid`, the nearest power of two is taken
// instead, which is exact.
template <class Is_valid>
void scale_to_area(const Level& level, Level::Uv& uv, const Is_valid& is_valid)
{
  double area = 0, image_area = 0;
  for (const Level::Triangle& t : level.triangles()) {
    area += std::sqrt(CGAL::cross_product(level.point(t[1]) - level.point(t[0]), level.point(t[2]) - level.point(t[0])).squared_length());
    image_area += cross(uv[t[1]] - uv[t[0]], uv[t[2]] - uv[t[0]]);
  }
  if (!(area > 0))
    return;

  const double scale = std::sqrt(area / image_area);
  Level::Uv scaled = uv;
  for (Point_2& p : scaled)
    p = Point_2(scale * p.x(), scale * p.y());
  if (!is_valid(scaled)) {
    const double power_of_two = std::exp2(std::round(std::log2(scale)));
    for (std::size_t v = 0; v < uv.size(); ++v)
      scaled[v] = Point_2(power_of_two * uv[v].x(), power_of_two * uv[v].y());
  }
  uv.swap(scaled);
}

inline void scale_to_area(const Level& level, Level::Uv& uv)
{
  scale_to_area(level, uv, [&](const Level::Uv& scaled) { return is_map_valid(level.rings(), scaled, level.loops()); });
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_SCALE_TO_AREA_H
