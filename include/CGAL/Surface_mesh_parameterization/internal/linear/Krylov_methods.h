// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_KRYLOV_METHODS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_KRYLOV_METHODS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <cstddef>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// Preconditioned Krylov methods for several right sides side by side. The system has
//   number_of_rows(), loops(),
//   row_times(i, x)          row i of A x
//   precondition(r, z)       z := M^-1 r
//   is_finished(r)           whether to stop: the residual is small enough for each right side, or there is no progress any more
// The methods start from `x` and its residual `r`, change both, and stop where is_finished(r), after `most_iterations`, or where a right side breaks
// down; they return the number of iterations.

template <class Value>
Value quotient(const Value& a, const Value& b) { return (b != 0).select(a / b, Value::Zero()); }

template <class Vector>
typename Vector::value_type dot(const Loops& loops, const Vector& x, const Vector& y)
{
  typedef typename Vector::value_type   Value;
  return loops.sum(0, Index(x.size()), Value(Value::Zero()), [&](Index i) -> Value { return x[i] * y[i]; });
}

// Conjugate gradients; A and M must be symmetric and positive definite.
template <class System, class Vector>
std::size_t conjugate_gradients(System& system, Vector& x, Vector& r, std::size_t most_iterations)
{
  typedef typename Vector::value_type   Value;
  const Index n = system.number_of_rows();
  const Loops& loops = system.loops();
  Vector z(n), p(n, Value::Zero());
  Value rz = Value::Zero();
  std::size_t iterations = 0;
  for (; iterations < most_iterations && !system.is_finished(r); ++iterations) {
    system.precondition(r, z);
    const Value rz_before = std::exchange(rz, dot(loops, r, z)), beta = quotient(rz, rz_before);
    loops.for_each(0, n, [&](Index i) { p[i] = z[i] + beta * p[i]; });
    const Value curvature = loops.sum(0, n, Value(Value::Zero()), [&](Index i) -> Value {
      z[i] = system.row_times(i, p);
      return p[i] * z[i];
    });
    const Value alpha = quotient(rz, curvature);
    if (!(curvature >= 0).all() || !alpha.isFinite().all())
      break;
    loops.for_each(0, n, [&](Index i) {
      x[i] += alpha * p[i];
      r[i] -= alpha * z[i];
    });
  }
  return iterations;
}

// The stabilized bi-conjugate gradients of van der Vorst (1992), preconditioned from the right: an iteration takes M and A twice.
template <class System, class Vector>
std::size_t stabilized_biconjugate_gradients(System& system, Vector& x, Vector& r, std::size_t most_iterations)
{
  typedef typename Vector::value_type   Value;
  const Index n = system.number_of_rows();
  const Loops& loops = system.loops();
  const Vector shadow = r;
  Vector p(n, Value::Zero()), v(n, Value::Zero()), y(n), t(n);
  Value rho = Value::Ones(), alpha = Value::Ones(), omega = Value::Ones();
  std::size_t iterations = 0;
  for (; iterations < most_iterations && !system.is_finished(r); ++iterations) {
    const Value rho_before = std::exchange(rho, dot(loops, shadow, r)), beta = quotient(rho, rho_before) * quotient(alpha, omega);
    loops.for_each(0, n, [&](Index i) { p[i] = r[i] + beta * (p[i] - omega * v[i]); });
    system.precondition(p, y);
    alpha = quotient(rho, loops.sum(0, n, Value(Value::Zero()), [&](Index i) -> Value {
      v[i] = system.row_times(i, y);
      return shadow[i] * v[i];
    }));
    loops.for_each(0, n, [&](Index i) {
      x[i] += alpha * y[i];
      r[i] -= alpha * v[i];
    });
    if (system.is_finished(r))
      return ++iterations;

    system.precondition(r, y);
    const Value tr = loops.sum(0, n, Value(Value::Zero()), [&](Index i) -> Value {
      t[i] = system.row_times(i, y);
      return t[i] * r[i];
    });
    omega = quotient(tr, dot(loops, t, t));
    if (!alpha.isFinite().all() || !omega.isFinite().all())
      break;
    loops.for_each(0, n, [&](Index i) {
      x[i] += omega * y[i];
      r[i] -= omega * t[i];
    });
  }
  return iterations;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_KRYLOV_METHODS_H
