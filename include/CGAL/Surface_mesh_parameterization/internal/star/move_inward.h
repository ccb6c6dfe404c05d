// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_MOVE_INWARD_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_MOVE_INWARD_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Moves a border vertex this part of the way to the middle of its neighbors, rounded, if its star is valid there.
inline void move_inward(const One_rings& rings, Index v, double part_of_way, std::vector<Point_2>& uv,
                        const Rounding& round = Rounding())
{
  const Point_2 start = uv[v];
  Vector_2 sum(0, 0);
  for (const Index w : rings[v])
    sum = sum + (uv[w] - start);
  const Point_2 end = start + part_of_way / double(rings[v].size()) * sum;
  uv[v] = round(end);
  if (!is_star_valid(rings, uv, v))
    uv[v] = start;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_MOVE_INWARD_H
