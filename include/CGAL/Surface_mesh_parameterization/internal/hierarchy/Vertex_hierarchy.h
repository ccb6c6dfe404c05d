// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_VERTEX_HIERARCHY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_VERTEX_HIERARCHY_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// What brings a removed vertex back, in ranks.
struct Vertex_split
{
  Index_triangle parent;                 // W0, Wi, Wi+1
  std::array<double, 2> coordinates;     // with respect to Wi and Wi+1
};

// The vertices of a hierarchy: what there is to know of it, since the triangles of its levels follow from those of the
// input.
struct Vertex_hierarchy
{
  std::vector<std::size_t> level_vertices;    // the levels' numbers of vertices, coarsest first
  std::vector<Index> input_vertex;            // by rank
  std::vector<Vertex_split> splits;           // of the vertices that are not on level 0

  const Vertex_split& split(Index v) const { return splits[v - level_vertices.front()]; }

  // The ranks of the vertices, in the order of the input.
  std::vector<Index> ranks() const { return positions_in(input_vertex, input_vertex.size()); }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_VERTEX_HIERARCHY_H
