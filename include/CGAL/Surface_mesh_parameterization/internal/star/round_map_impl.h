// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_ROUND_MAP_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_ROUND_MAP_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/star/Polygon_kernel_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

namespace CGAL::Surface_mesh_parameterization::internal {

inline bool round_positive_map(const One_rings& rings, Round_coordinate round, int exponent, std::vector<Point_2>& uv,
                               const Loops& loops)
{
  constexpr int most_passes = 10;
  const auto rounded = [=](const Point_2& p) { return Point_2(round(p.x(), exponent), round(p.y(), exponent)); };
  for (Point_2& p : uv)
    p = rounded(p);
  Polygon_kernel_2 kernel;
  for (int i = 0; i < most_passes && !is_map_valid(rings, uv, loops); ++i)
    for (Index v = 0; v < uv.size(); ++v)
      if (!is_star_valid(rings, uv, v))
        uv[v] = rounded(kernel_centroid(rings, uv, v, kernel));
  return is_map_valid(rings, uv, loops);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool round_map(const One_rings& rings, Round_coordinate round, int exponent, std::vector<Point_2>& uv,
               const Loops& loops)
{
  if (!round)
    return true;
  const bool must_mirror = is_mirrored_if_valid(rings, uv);
  if (must_mirror)
    mirror(uv);
  const bool is_valid = round_positive_map(rings, round, exponent, uv, loops);
  if (must_mirror)
    mirror(uv);
  return is_valid;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_ROUND_MAP_IMPL_H
