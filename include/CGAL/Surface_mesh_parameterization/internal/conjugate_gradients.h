// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CONJUGATE_GRADIENTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CONJUGATE_GRADIENTS_H

#include <CGAL/Surface_mesh_parameterization/internal/Block_matrix.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

inline double dot(const Pair_vector& x, const Pair_vector& y)
{
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += x[i][0] * y[i][0] + x[i][1] * y[i][1];
  return sum;
}

// The vectors that conjugate_gradients() works on, brought by the caller. The right side is given in `residual`, the result is `solution`.
struct Conjugate_gradients_space
{
  Pair_vector solution, residual, direction, image;
};

// Solves A x = b by preconditioned conjugate gradients from x = 0, until the residual has fallen by the factor `tolerance`, or after `most_iterations`,
// or where rounding makes the curvature vanish. `preconditioner(r)` returns a reference to a vector. Returns the number of its applications.
template <class Preconditioner>
std::size_t conjugate_gradients(const Block_matrix& a, Preconditioner& preconditioner, double tolerance, std::size_t most_iterations,
                                Conjugate_gradients_space& space)
{
  auto& [x, r, p, ap] = space;
  const std::size_t n = r.size();
  x.assign(n, { 0, 0 });
  p.assign(n, { 0, 0 });
  ap.resize(n);
  const double target = tolerance * tolerance * dot(r, r);
  double rz = 0;
  std::size_t iterations = 0;
  while (iterations < most_iterations && dot(r, r) > target) {
    const Pair_vector& z = preconditioner(r);
    ++iterations;
    const double rz_new = dot(r, z), beta = rz > 0 ? rz_new / rz : 0;
    rz = rz_new;
    for (std::size_t i = 0; i < n; ++i)
      p[i] = { z[i][0] + beta * p[i][0], z[i][1] + beta * p[i][1] };
    for (std::size_t i = 0; i < n; ++i)
      ap[i] = a.row_times(Index(i), p);
    const double curvature = dot(p, ap);
    if (!(curvature > 0))
      break;
    const double alpha = rz / curvature;
    for (std::size_t i = 0; i < n; ++i)
      for (int e = 0; e < 2; ++e) {
        x[i][e] += alpha * p[i][e];
        r[i][e] -= alpha * ap[i][e];
      }
  }
  return iterations;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CONJUGATE_GRADIENTS_H
