// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_STARTING_MAP_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_STARTING_MAP_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/scale_of_area.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/first_maps.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/starting_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool make_starting_map(const Triangulated_surface_3& surface, const Loops& loops, std::vector<Point_2>& uv)
{
  One_rings rings;
  rings.build(uv.size(), surface.triangles, loops);
  rings.release_scratch();
  std::size_t unused = 0;
  if (!has_no_flips(rings, uv, loops) && repair_map(surface, false, loops, uv, unused) != OK)
    return false;
  mirror_back(rings, uv);
  return is_map_valid(rings, uv, loops);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool bring_to_scale(const Level& level, bool borders_must_not_meet, Level::Uv& uv)
{
  constexpr double greatest_factor = 2;
  const double factor = scale_of_area(level, uv);
  if (!(factor > 0))
    return false;
  if (factor > greatest_factor || 1 / factor > greatest_factor)
    scale_to_area(level, borders_must_not_meet, uv);
  return true;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_STARTING_MAP_IMPL_H
