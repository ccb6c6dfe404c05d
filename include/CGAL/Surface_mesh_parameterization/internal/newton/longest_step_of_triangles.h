// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LONGEST_STEP_OF_TRIANGLES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LONGEST_STEP_OF_TRIANGLES_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/time_on_one_line.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>

#include <algorithm>
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
      for (const double t : times_on_one_line(p, Vector_2(d.x, d.y), q, Vector_2(e.x, e.y)))
        if (t > 0)
          least = (std::min)(least, t);
    });
    return least;
  });
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LONGEST_STEP_OF_TRIANGLES_H
