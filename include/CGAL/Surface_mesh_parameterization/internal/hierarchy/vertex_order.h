// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_VERTEX_ORDER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_VERTEX_ORDER_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A map by rank, from one in the order of the hierarchy's input.
inline std::vector<Point_2> by_rank(const Collapse_hierarchy_3& hierarchy, const std::vector<Point_2>& uv)
{
  std::vector<Point_2> result;
  result.reserve(uv.size());
  for (Index rank = 0; rank < uv.size(); ++rank)
    result.push_back(uv[hierarchy.input_vertex(rank)]);
  return result;
}

// The rank of a vertex of the input.
inline Index rank_of(const Collapse_hierarchy_3& hierarchy, Index input_vertex)
{
  Index rank = 0;
  while (hierarchy.input_vertex(rank) != input_vertex)
    ++rank;
  return rank;
}

// Those by rank in the order of the input.
inline std::vector<Point_2> in_input_order(const Collapse_hierarchy_3& hierarchy, const std::vector<Point_2>& uv)
{
  std::vector<Point_2> result(uv.size());
  for (Index rank = 0; rank < uv.size(); ++rank)
    result[hierarchy.input_vertex(rank)] = uv[rank];
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_VERTEX_ORDER_H
