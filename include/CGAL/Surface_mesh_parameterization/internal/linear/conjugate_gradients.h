// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONJUGATE_GRADIENTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONJUGATE_GRADIENTS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>

#include <cstddef>
#include <cstddef>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

inline double dot(const Loops& loops, const Pair_vector& x, const Pair_vector& y)
{
  return loops.sum(0, Index(x.size()), 0., [&](Index i) { return x[i].dot(y[i]); });
}

// The vectors that conjugate_gradients() works on, brought by the caller. The right side is given in `residual`, the result is `solution`.
struct Conjugate_gradients_space
{
  Pair_vector solution, residual, direction, image;
};

// Solves A x = b by preconditioned conjugate gradients from x = 0, until the residual has fallen by the factor `tolerance`, or after `most_iterations`,
// or where rounding makes the curvature vanish. `preconditioner(r)` returns a reference to a vector. Returns the number of its applications.
template <class Preconditioner>
std::size_t conjugate_gradients(const Loops& loops, const Block_matrix& a, Preconditioner& preconditioner, double tolerance, std::size_t most_iterations,
                                Conjugate_gradients_space& space)
{
  Pair_vector &x = space.solution, &r = space.residual, &p = space.direction, &ap = space.image;
  const Index n = Index(r.size());
  x.resize(n);
  p.resize(n);
  ap.resize(n);
  loops.for_each(0, n, [&](Index i) { x[i] = p[i] = Pair(0, 0); });
  double rr = dot(loops, r, r), rz = 0;
  const double target = tolerance * tolerance * rr;
  std::size_t iterations = 0;
  while (iterations < most_iterations && rr > target) {
    const Pair_vector& z = preconditioner(r);
    ++iterations;
    const double rz_before = std::exchange(rz, dot(loops, r, z)), beta = rz_before > 0 ? rz / rz_before : 0;
    loops.for_each(0, n, [&](Index i) { p[i] = z[i] + beta * p[i]; });
    const double curvature = loops.sum(0, n, 0., [&](Index i) {
      ap[i] = a.row_times(i, p);
      return p[i].dot(ap[i]);
    });
    if (!(curvature > 0))
      break;
    const double alpha = rz / curvature;
    rr = loops.sum(0, n, 0., [&](Index i) {
      x[i] += alpha * p[i];
      r[i] -= alpha * ap[i];
      return r[i].squaredNorm();
    });
  }
  return iterations;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONJUGATE_GRADIENTS_H
