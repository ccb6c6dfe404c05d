// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_KRYLOV_METHODS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_KRYLOV_METHODS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Values.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Preconditioned Krylov methods, for unknowns that are blocks, or the values of several right sides side by side. The
// system has
//   number_of_rows(), loops(),
//   multiply(x, y, z)           y := A x; returns the inner product of z and y
//   precondition(r)             M^-1 r, in a vector that is valid until the next call
//   squared_size(i, r)          what the residual r of row i contributes to the squared norm
//   direction_factor(a, b)      for conjugate gradients: how much of the last direction the next one keeps, a / b where
//                               M is definite, 0 where b is; b is the product of the last residual and its M^-1, 0 at
//                               the start, and a that of M^-1 residual and the residual's change
//   is_finished(squared_norm)   whether to stop: the residual is small enough for each right side, or there is no
//                               progress any more
// Products are numbers, or one number for each right side. The methods start from `x` and its residual `r`, change
// both, and stop where is_finished(), after `most_iterations`, or where a right side breaks down; they return the
// number of iterations.

inline double quotient(double a, double b) { return b != 0 ? a / b : 0; }
inline bool is_less_or_equal(double a, double b) { return a <= b; }
inline bool is_finite(double a) { return std::isfinite(a); }

template <class Vector>
using Product_of = decltype(inner_product(std::declval<const typename Vector::value_type&>(),
                                          std::declval<const typename Vector::value_type&>()));

template <class Product>
Product zero_product()
{
  if constexpr (std::is_same<Product, double>::value)
    return 0;
  else
    return Product::zero();
}

template <class Vector>
Product_of<Vector> inner_product(const Loops& loops, const Vector& x, const Vector& y)
{
  typedef Product_of<Vector>   Product;
  return loops.sum(0, Index(x.size()), zero_product<Product>(), [&](Index i) { return inner_product(x[i], y[i]); });
}

template <class System, class Vector>
Product_of<Vector> squared_norm(const System& system, const Vector& r)
{
  typedef Product_of<Vector>   Product;
  return system.loops().sum(0, Index(r.size()), zero_product<Product>(),
                            [&](Index i) { return system.squared_size(i, r[i]); });
}

// multiply() of a system that has row_times(i, x), which is row i of A x.
template <class System, class Vector>
Product_of<Vector> multiply_by_rows(const System& system, const Vector& x, Vector& y, const Vector& z)
{
  typedef Product_of<Vector>   Product;
  return system.loops().sum(0, system.number_of_rows(), zero_product<Product>(), [&](Index i) {
    y[i] = system.row_times(i, x);
    return inner_product(z[i], y[i]);
  });
}

// x := x + alpha p, r := r - alpha q; returns the squared norm of r.
template <class System, class Vector>
Product_of<Vector> go_along(const System& system, const Product_of<Vector>& alpha, const Vector& p, const Vector& q,
                            Vector& x, Vector& r)
{
  typedef Product_of<Vector>   Product;
  return system.loops().sum(0, system.number_of_rows(), zero_product<Product>(), [&](Index i) {
    x[i] += alpha * p[i];
    r[i] -= alpha * q[i];
    return system.squared_size(i, r[i]);
  });
}

struct Always
{
  template <class T>
  bool operator()(const T&) const { return true; }
};

// Conjugate gradients; A and M must be symmetric and positive definite. M may change a little from one iteration to the
// next, as a K-cycle does: then the next direction is still conjugate to the last one. `p` is scratch of the size of x.
// The iteration goes on while pays(d) for what the last step lowered x A x / 2 - b x by.
template <class System, class Vector, class Pays = Always>
std::size_t conjugate_gradients(System& system, Vector& x, Vector& r, Vector& p, std::size_t most_iterations,
                                Pays pays = Pays())
{
  typedef Product_of<Vector>   Product;
  const Product zero = zero_product<Product>();
  const Loops& loops = system.loops();
  loops.for_each(0, system.number_of_rows(), [&](Index i) { p[i] = Vector::value_type::zero(); });
  Product norm2 = squared_norm(system, r), rz = zero, alpha = zero;
  Vector q(p.size(), Vector::value_type::zero());     // A p
  std::size_t iterations = 0;
  while (iterations < most_iterations && !system.is_finished(norm2)) {
    const Vector& z = system.precondition(r);
    ++iterations;
    const Product rz_before = std::exchange(rz, inner_product(loops, r, z)),
                  beta = system.direction_factor(zero - alpha * inner_product(loops, q, z), rz_before);
    loops.for_each(0, system.number_of_rows(), [&](Index i) { p[i] = z[i] + beta * p[i]; });
    const Product curvature = system.multiply(p, q, p);
    alpha = quotient(rz, curvature);
    if (!is_less_or_equal(zero, curvature) || !is_finite(alpha))
      break;
    norm2 = go_along(system, alpha, p, q, x, r);
    if (!pays(0.5 * alpha * rz))
      break;
  }
  return iterations;
}

// The stabilized bi-conjugate gradients of van der Vorst (1992), preconditioned from the right: an iteration takes M
// and A twice.
template <class System, class Vector>
std::size_t stabilized_biconjugate_gradients(System& system, Vector& x, Vector& r, std::size_t most_iterations)
{
  typedef typename Vector::value_type   Value;
  typedef Product_of<Vector>            Product;
  const Index n = system.number_of_rows();
  const Loops& loops = system.loops();
  const Vector shadow = r;
  Vector p(n, Value::zero()), v(n, Value::zero()), t(n);
  Product norm2 = squared_norm(system, r), rho = Product::all(1), alpha = rho, omega = rho;
  std::size_t iterations = 0;
  while (iterations < most_iterations && !system.is_finished(norm2)) {
    ++iterations;
    const Product rho_before = std::exchange(rho, inner_product(loops, shadow, r)),
                  beta = quotient(rho, rho_before) * quotient(alpha, omega);
    loops.for_each(0, n, [&](Index i) { p[i] = r[i] + beta * (p[i] - omega * v[i]); });
    const Vector& mp = system.precondition(p);
    alpha = quotient(rho, system.multiply(mp, v, shadow));
    norm2 = go_along(system, alpha, mp, v, x, r);
    if (system.is_finished(norm2))
      break;

    const Vector& mr = system.precondition(r);
    const Product tr = system.multiply(mr, t, r);
    omega = quotient(tr, inner_product(loops, t, t));
    if (!is_finite(alpha) || !is_finite(omega))
      break;
    norm2 = go_along(system, omega, mr, t, x, r);
  }
  return iterations;
}

// The least squares problem of generalized minimal residuals: with the basis so far, A M^-1 V = V' H, and the
// combination y of the basis makes |e - H y| least, where e has the first residual's norm on top. Rotations bring H to
// triangular shape as it grows.
template <class Product>
class Projected_residual
{
public:
  explicit Projected_residual(const Product& norm) : m_right_side(1, norm) { }

  std::size_t size() const { return m_columns.size(); }

  // The norm of the least residual.
  Product norm() const { return abs(m_right_side.back()); }

  // Adds a column of H, which has two entries more than there are columns.
  void add(std::vector<Product> column)
  {
    for (std::size_t i = 0; i < m_rotations.size(); ++i)
      m_rotations[i].turn(column[i], column[i + 1]);
    Product &a = column[size()], &b = column[size() + 1];
    const Product radius = sqrt(a * a + b * b);
    m_rotations.push_back({ quotient(a, radius), quotient(b, radius) });
    m_rotations.back().turn(a, b);
    m_right_side.push_back(zero_product<Product>());
    m_rotations.back().turn(m_right_side[size()], m_right_side[size() + 1]);
    column.pop_back();
    m_columns.push_back(std::move(column));
  }

  std::vector<Product> solution() const
  {
    std::vector<Product> y(m_right_side.begin(), m_right_side.end() - 1);
    for (std::size_t k = size(); k-- > 0;) {
      y[k] = quotient(y[k], m_columns[k][k]);
      for (std::size_t i = 0; i < k; ++i)
        y[i] -= y[k] * m_columns[k][i];
    }
    return y;
  }

private:
  struct Rotation
  {
    Product cosine, sine;

    void turn(Product& a, Product& b) const
    {
      const Product old_a = a;
      a = cosine * old_a + sine * b;
      b = cosine * b - sine * old_a;
    }
  };

  std::vector<Rotation> m_rotations;
  std::vector<std::vector<Product>> m_columns;
  std::vector<Product> m_right_side;
};

// The flexible generalized minimal residuals of Saad (1993), preconditioned from the right: M may change from one
// iteration to the next, and have rounding errors. Keeps two vectors for each iteration.
template <class System, class Vector>
std::size_t generalized_minimal_residuals(System& system, Vector& x, Vector& r, std::size_t most_iterations)
{
  typedef Product_of<Vector>   Product;
  const Index n = system.number_of_rows();
  const Loops& loops = system.loops();
  const auto normalize = [&](Vector& v) {
    const Product norm = sqrt(inner_product(loops, v, v)), inverse = quotient(Product::all(1), norm);
    loops.for_each(0, n, [&](Index i) { v[i] = inverse * v[i]; });
    return norm;
  };
  std::vector<Vector> basis(1, r), directions;
  Projected_residual<Product> projected(normalize(basis.front()));
  while (projected.size() < most_iterations && !system.is_finished(projected.norm() * projected.norm())) {
    Vector next(n);
    directions.push_back(system.precondition(basis.back()));
    system.multiply(directions.back(), next, basis.back());
    std::vector<Product> column;
    for (const Vector& v : basis) {
      const Product part = column.emplace_back(inner_product(loops, next, v));
      loops.for_each(0, n, [&](Index i) { next[i] -= part * v[i]; });
    }
    column.push_back(normalize(next));
    projected.add(std::move(column));
    basis.push_back(std::move(next));
  }

  const std::vector<Product> y = projected.solution();
  Vector step(n, Vector::value_type::zero()), product(n);
  loops.for_each(0, n, [&](Index i) {
    for (std::size_t k = 0; k < y.size(); ++k)
      step[i] += y[k] * directions[k][i];
  });
  system.multiply(step, product, step);
  go_along(system, Product::all(1), step, product, x, r);
  return projected.size();
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_KRYLOV_METHODS_H
