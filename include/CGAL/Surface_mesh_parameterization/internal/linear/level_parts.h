// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_LEVEL_PARTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_LEVEL_PARTS_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// The share of a level's edges that join two parts, by a sample.
inline double share_of_joints(const Level& level, const Row_parts& parts)
{
  constexpr Index step = 16;
  std::size_t edges = 0, joints = 0;
  for (Index v = 0; v < level.number_of_vertices(); v += step)
    for (const Index w : level.one_ring(v)) {
      ++edges;
      joints += parts.part_of(v) != parts.part_of(w) ? 1 : 0;
    }
  return double(joints) / double(edges);
}

// The vertices of a level in parts; in fewer where these would be no regions, since the order of the input does not
// follow the surface.
inline Row_parts level_parts(const Level& level, const Row_parts_options& options = Row_parts_options())
{
  Index number = number_of_parts(level.number_of_vertices(), options);
  Row_parts result(level.hierarchy(), level.index(), number);
  while (number > 1 && share_of_joints(level, result) > options.most_joints)
    result = Row_parts(level.hierarchy(), level.index(), number /= 2);
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_LEVEL_PARTS_H
