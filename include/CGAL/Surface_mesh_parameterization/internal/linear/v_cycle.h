// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_V_CYCLE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_V_CYCLE_H

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// One cycle of a multigrid method for A x = b on grid g, from x = 0. The method has, with grid 0 as the finest,
//   is_coarsest(g)
//   solve(b, x)                       on the coarsest grid
//   smooth_from_zero(g, b, x), smooth(g, b, x)
//   restrict_residual(g, b, x)        to right_side(g + 1)
//   solve_coarse(g + 1)               from right_side(g + 1) to solution(g + 1), by cycles on this grid: one in a
//                                     V-cycle
//   add_correction(g, x)              from solution(g + 1)
template <class Multigrid, class Vector>
void v_cycle(Multigrid& multigrid, std::size_t g, const Vector& b, Vector& x)
{
  if (multigrid.is_coarsest(g)) {
    multigrid.solve(b, x);
    return;
  }
  multigrid.smooth_from_zero(g, b, x);
  multigrid.restrict_residual(g, b, x);
  multigrid.solve_coarse(g + 1);
  multigrid.add_correction(g, x);
  multigrid.smooth(g, b, x);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_V_CYCLE_H
