// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_K_CYCLE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_K_CYCLE_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Values.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/v_cycle.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// Makes solution(g), that of a cycle for right_side(g), that of two steps of conjugate gradients, each with a cycle, as
// in the K-cycle of Notay and Vassilevski (2008). Changes right_side(g).
//
// This is for energies that conformal motions hardly change: coarse grids resist such motions more than the finest one,
// and with one cycle the error of a grid would add to those of all coarser ones.
//
// Beside what v_cycle() needs, the method has
//   Scalar                               the type of the vectors' numbers
//   loops()
//   multiply(g, x, ax)                   makes A x
//   energy_of_row(g, i, x)               what row i contributes to x A x
//   product(a, b)                        the inner product of two rows as a double
//   second_solution(g), image(g)         scratch
template <class Multigrid>
void take_second_step(Multigrid& multigrid, std::size_t g)
{
  typedef typename Multigrid::Scalar   Scalar;
  auto &x = multigrid.solution(g), &r = multigrid.right_side(g), &z = multigrid.second_solution(g),
       &ax = multigrid.image(g);
  const Loops& loops = multigrid.loops();
  const auto product = [&](const auto& a, const auto& b) { return multigrid.product(a, b); };
  const Index n = Index(x.size());
  z.resize(n);
  ax.resize(n);
  multigrid.multiply(g, x, ax);
  typedef Values<double, 2>   Products;     // r x, x A x
  const Products first = loops.sum(0, n, Products::zero(), [&](Index i) {
    return Products{ { product(r[i], x[i]), product(x[i], ax[i]) } };
  });
  if (!(first[1] > 0))
    return;
  const double length = first[0] / first[1];
  loops.for_each(0, n, [&](Index i) { r[i] -= Scalar(length) * ax[i]; });
  v_cycle(multigrid, g, r, z);

  typedef Values<double, 4>   More_products;      // x A z, r z, r x, z A z
  const More_products second = loops.sum(0, n, More_products::zero(), [&](Index i) {
    return More_products{ { product(ax[i], z[i]), product(r[i], z[i]), product(r[i], x[i]),
                            multigrid.energy_of_row(g, i, z) } };
  });
  // The direction z - factor x is conjugate to x.
  const double factor = second[0] / first[1], curvature = second[3] - factor * second[0];
  const double second_length = curvature > 0 ? (second[1] - factor * second[2]) / curvature : 0;
  loops.for_each(0, n, [&](Index i) {
    x[i] = Scalar(length - second_length * factor) * x[i] + Scalar(second_length) * z[i];
  });
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_K_CYCLE_H
