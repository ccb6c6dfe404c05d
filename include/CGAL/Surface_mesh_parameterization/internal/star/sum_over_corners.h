// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_SUM_OVER_CORNERS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_SUM_OVER_CORNERS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The weights of the edges from a vertex to its ring, as sums over the triangles between them: `weights_of(corner)` are
// those that a triangle adds, of its edges to a and to b, see Rest_corner.
template <class Function>
void sum_over_corners(const Point_3& v, const std::vector<Point_3>& ring, bool is_closed, const Function& weights_of,
                      std::vector<double>& weights)
{
  weights.assign(ring.size(), 0.);
  for (std::size_t i = 0; i + (is_closed ? 0 : 1) < ring.size(); ++i) {
    const std::size_t j = next_in_cycle(i, ring.size());
    const std::array<double, 2> added = weights_of(rest_corner(v, ring[i], ring[j]));
    weights[i] += added[0];
    weights[j] += added[1];
  }
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_SUM_OVER_CORNERS_H
