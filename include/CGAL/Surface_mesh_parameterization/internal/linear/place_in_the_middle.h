// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_PLACE_IN_THE_MIDDLE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_PLACE_IN_THE_MIDDLE_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Tutte's system, the graph Laplacian: each of some `vertices` is placed in the middle of its neighbors, while all
// others stay. `unknown` is the position of each vertex among them, `no_index` of one that stays. For every cycle of
// them in `holes` there is one more vertex, joined with these. Returns false if no vertex stays, or where doubles end.
inline bool place_in_the_middle(const One_rings& rings, const std::vector<Index>& vertices,
                                const std::vector<Index>& unknown, const std::vector<std::vector<Index>>& holes,
                                std::vector<Point_2>& uv)
{
  const std::size_t n = vertices.size() + holes.size();
  std::vector<Matrix_entry> entries;
  std::vector<double> right_sides(2 * n, 0.), solutions(2 * n);
  bool does_any_stay = false;
  for (Index u = 0; u < vertices.size(); ++u) {
    const One_rings::Ring ring = rings[vertices[u]];
    entries.push_back({ u, u, double(ring.size()) });
    for (const Index w : ring)
      if (unknown[w] != no_index)
        entries.push_back({ u, unknown[w], -1 });
      else {
        does_any_stay = true;
        right_sides[u] += uv[w].x();
        right_sides[n + u] += uv[w].y();
      }
  }
  for (std::size_t h = 0; h < holes.size(); ++h)
    for (const Index v : holes[h]) {
      const Index u = unknown[v], middle = Index(vertices.size() + h);
      entries.insert(entries.end(), { { u, u, 1 }, { u, middle, -1 }, { middle, u, -1 }, { middle, middle, 1 } });
    }

  const std::unique_ptr<Direct_solver> solver = does_any_stay ? factorize_symmetric(Index(n), entries) : nullptr;
  if (!solver)
    return false;
  solver->solve(right_sides.data(), solutions.data(), 2);
  for (Index u = 0; u < vertices.size(); ++u)
    uv[vertices[u]] = Point_2(solutions[u], solutions[n + u]);
  return std::all_of(solutions.begin(), solutions.end(), [](double x) { return std::isfinite(x); });
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_PLACE_IN_THE_MIDDLE_H
