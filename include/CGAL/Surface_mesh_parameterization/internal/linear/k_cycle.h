// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_K_CYCLE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_K_CYCLE_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Values.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

namespace CGAL::Surface_mesh_parameterization::internal {

// Makes `x`, the solution of a cycle for A x = r on a coarse grid, that of two steps of conjugate gradients, each with
// a cycle, as in the K-cycle of Notay and Vassilevski (2008). Changes r.
//
// This is for energies that conformal motions hardly change: coarse grids resist such motions more than the finest one,
// and with one cycle the error of a grid would add to those of all coarser ones.
//
// `multiply(x, ax)` makes A x, `energy_of_row(i, x)` is what row i contributes to x A x, `product(a, b)` the inner
// product of rows as a double, and `cycle(r, z)` makes a cycle from 0. `z` and `ax` are scratch; `Real` is the type of
// the vectors' numbers.
template <class Real, class Vector, class Multiply, class Energy_of_row, class Product, class Cycle>
void take_second_step(const Loops& loops, const Multiply& multiply, const Energy_of_row& energy_of_row,
                      const Product& product, const Cycle& cycle, Vector& x, Vector& r, Vector& z, Vector& ax)
{
  const Index n = Index(x.size());
  z.resize(n);
  ax.resize(n);
  multiply(x, ax);
  typedef Values<double, 2>   Products;     // r x, x A x
  const Products first = loops.sum(0, n, Products::zero(), [&](Index i) {
    return Products{ { product(r[i], x[i]), product(x[i], ax[i]) } };
  });
  if (!(first[1] > 0))
    return;
  const double length = first[0] / first[1];
  loops.for_each(0, n, [&](Index i) { r[i] -= Real(length) * ax[i]; });
  cycle(r, z);

  typedef Values<double, 4>   More_products;      // x A z, r z, r x, z A z
  const More_products second = loops.sum(0, n, More_products::zero(), [&](Index i) {
    return More_products{ { product(ax[i], z[i]), product(r[i], z[i]), product(r[i], x[i]),
                            energy_of_row(i, z) } };
  });
  // The direction z - factor x is conjugate to x.
  const double factor = second[0] / first[1], curvature = second[3] - factor * second[0];
  const double second_length = curvature > 0 ? (second[1] - factor * second[2]) / curvature : 0;
  loops.for_each(0, n, [&](Index i) {
    x[i] = Real(length - second_length * factor) * x[i] + Real(second_length) * z[i];
  });
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_K_CYCLE_H
