// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that came apart in places.

#ifndef CRACKED_MESHES_H
#define CRACKED_MESHES_H

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace test_meshes {

using SMP::internal::One_rings;

// Cuts the triangles around a vertex into `parts` parts of about the same size, each with a vertex of its own.
inline void split_vertex(Flat_mesh& m, const One_rings& rings, Index v, std::size_t parts)
{
  const std::size_t n = rings.number_of_triangles(v);
  std::vector<Index> copies{ v };
  for (std::size_t i = 1; i < parts; ++i) {
    copies.push_back(Index(m.points.size()));
    m.points.push_back(Point_3(m.points[v]));
  }
  rings.for_each_triangle(v, [&](Index a, Index b, std::size_t i) {
    for (Index_triangle& t : m.triangles)
      if (contains(t, v) && contains(t, a) && contains(t, b))
        for (Index& w : t)
          if (w == v)
            w = copies[i * parts / n];
  });
}

// Cracks of `branches` branches at every `distance`-th vertex that has no neighbor on a border. Precondition: these are
// no neighbors.
inline Flat_mesh with_cracks(Flat_mesh m, Index distance, std::size_t branches = 2)
{
  const One_rings rings(m.points.size(), m.triangles);
  const auto is_border = [&](Index v) { return rings.is_border(v); };
  for (Index v = distance / 2; v < rings.number_of_vertices(); v += distance)
    if (!is_border(v) && std::none_of(rings[v].begin(), rings[v].end(), is_border))
      split_vertex(m, rings, v, branches);
  return m;
}

// Cracks of `branches` branches at every `distance`-th vertex of the rows and columns of a grid of n times n cells.
inline Flat_mesh grid_with_cracks(Index n, Index distance, std::size_t branches = 2)
{
  Flat_mesh m = grid(n, n, wavy);
  const One_rings rings(m.points.size(), m.triangles);
  for (Index j = distance / 2; j < n; j += distance)
    for (Index i = distance / 2; i < n; i += distance)
      split_vertex(m, rings, j * (n + 1) + i, branches);
  return m;
}

// A crack along a row of the grid.
inline Flat_mesh grid_with_long_crack(Index n, Index row, Index begin, Index end)
{
  Flat_mesh m = grid(n, n, wavy);
  for (Index i = begin + 1; i < end; ++i) {
    const Index v = row * (n + 1) + i, copy = Index(m.points.size());
    m.points.push_back(Point_3(m.points[v]));
    for (std::size_t t = 2 * n * row; t < m.triangles.size(); ++t)
      for (Index& w : m.triangles[t])
        if (w == v)
          w = copy;
  }
  return m;
}

// With a vertex in the middle of an edge, for the triangle on one side alone, of every `distance`-th triangle.
inline Flat_mesh with_T_junctions(Flat_mesh m, std::size_t distance)
{
  const One_rings rings(m.points.size(), m.triangles);
  for (std::size_t i = distance / 2, end = m.triangles.size(); i < end; i += distance) {
    const auto [a, b, c] = m.triangles[i];
    const Index middle = Index(m.points.size());
    if (rings.is_border(a) || rings.is_border(b))
      continue;
    m.points.push_back(CGAL::midpoint(m.points[a], m.points[b]));
    m.triangles[i] = { a, middle, c };
    m.triangles.push_back({ middle, b, c });
  }
  return m;
}

} // namespace test_meshes

#endif // CRACKED_MESHES_H
