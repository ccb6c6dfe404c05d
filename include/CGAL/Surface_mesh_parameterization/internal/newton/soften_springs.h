// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SOFTEN_SPRINGS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SOFTEN_SPRINGS_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/scale_of_area.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>

#include <CGAL/Kernel/global_functions.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The weight of the triangles at a vertex by the mean square of the lengths of its edges in the plane, whose sum is
// given: the stiffness that they have, more or less, while they are hardly distorted.
inline double stiffness_of_triangles(const Level_energy& energy, Index v, double sum_of_squares)
{
  const Level& level = energy.level();
  double weights = 0;
  const Rest_corners corners = level.rest_corners(v);
  for (std::size_t i = 0; i < level.number_of_triangles(v); ++i)
    weights += energy.weight(corners[i]);
  return weights * double(level.one_ring(v).size()) / sum_of_squares;
}

// Makes no spring stiffer than `bound` times the triangles at its vertex are in a map without distortion: of the area
// of `uv`, if the energy has no scale of its own. Returns whether some were.
inline bool soften_springs(const Level_energy& energy, double bound, const Level::Uv& uv,
                           std::vector<Triangulated_surface_3::Spring>& springs)
{
  const Level& level = energy.level();
  const double scale = energy.is_scale_invariant() ? scale_of_area(level, uv) : 1;
  bool result = false;
  for (Triangulated_surface_3::Spring& s : springs) {
    double squares = 0;
    for (const Index w : level.one_ring(s.vertex))
      squares += CGAL::squared_distance(level.point(w), level.point(s.vertex));
    const double greatest = bound * stiffness_of_triangles(energy, s.vertex, squares / (scale * scale));
    if (s.stiffness > greatest) {
      s.stiffness = greatest;
      result = true;
    }
  }
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SOFTEN_SPRINGS_H
