// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LONGEST_STEP_OF_TRIANGLES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LONGEST_STEP_OF_TRIANGLES_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Surface_mesh_parameterization::internal {

// The least t > 0 at which a triangle of the map uv + t direction vanishes; infinite if there is none. The triangles of
// `uv` are positive.
inline double longest_step_of_triangles(const Level& level, const Level::Uv& uv, const Block_vectors& direction)
{
  constexpr double infinity = (std::numeric_limits<double>::infinity)();
  return level.loops().min(0, Index(uv.size()), infinity, [&](Index v) {
    level.rings().prefetch_neighbors_after(v, uv);
    double least = infinity;
    level.rings().for_each_triangle_of_least_vertex(v, [&](Index a, Index b, std::size_t) {
      const Vector_2 p = uv[a] - uv[v], q = uv[b] - uv[v];
      const Block_vector d = direction[a] - direction[v], e = direction[b] - direction[v];
      const Vector_2 dp(d.x, d.y), dq(e.x, e.y);
      const double c0 = cross(p, q), c1 = cross(p, dq) + cross(dp, q), c2 = cross(dp, dq);
      // The least positive root of c0 + c1 t + c2 t^2, c0 > 0, in the form whose terms do not cancel.
      const double discriminant = c1 * c1 - 4 * c0 * c2;
      if (discriminant < 0 || (c1 >= 0 && c2 >= 0))
        return;
      const double s = std::sqrt(discriminant), root = c1 > 0 ? (s + c1) / (-2 * c2) : 2 * c0 / (s - c1);
      if (root > 0)
        least = (std::min)(least, root);
    });
    return least;
  });
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LONGEST_STEP_OF_TRIANGLES_H
