// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_VALUES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_VALUES_H

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The numbers of several right sides or solutions at one unknown. Systems with one matrix are solved side by side: its
// entries are fetched once for all. Arithmetic is element by element.
template <class Real_, int columns>
struct Values
{
  typedef Real_   Real;
  static constexpr int size = columns;

  Real value[columns];

  static Values all(Real x)
  {
    Values result;
    for (Real& y : result.value)
      y = x;
    return result;
  }

  static Values zero() { return all(0); }

  Real& operator[](int i) { return value[i]; }
  Real operator[](int i) const { return value[i]; }

  Values& operator+=(const Values& other)
  {
    for (int i = 0; i < columns; ++i)
      value[i] += other.value[i];
    return *this;
  }

  Values& operator-=(const Values& other)
  {
    for (int i = 0; i < columns; ++i)
      value[i] -= other.value[i];
    return *this;
  }

  Values& operator*=(Real factor)
  {
    for (Real& x : value)
      x *= factor;
    return *this;
  }

  friend Values operator+(Values a, const Values& b) { return a += b; }
  friend Values operator-(Values a, const Values& b) { return a -= b; }
  friend Values operator*(Real factor, Values a) { return a *= factor; }
  friend Values operator*(const Values& a, const Values& b) { return map(a, b, [](Real x, Real y) { return x * y; }); }
  friend Values abs(const Values& a) { return map(a, a, [](Real x, Real) { return std::abs(x); }); }
  friend Values sqrt(const Values& a) { return map(a, a, [](Real x, Real) { return std::sqrt(x); }); }
  friend Values max(const Values& a, const Values& b)
  {
    return map(a, b, [](Real x, Real y) { return (std::max)(x, y); });
  }

  // As many of them as there are right sides: nothing is summed.
  friend Values inner_product(const Values& a, const Values& b) { return a * b; }

  // 0 where the divisor is.
  friend Values quotient(const Values& a, const Values& b)
  {
    return map(a, b, [](Real x, Real y) { return y != 0 ? x / y : Real(0); });
  }

  // For all elements; a NaN is neither.
  friend bool is_less_or_equal(const Values& a, const Values& b)
  {
    return all_of(a, b, [](Real x, Real y) { return x <= y; });
  }
  friend bool is_finite(const Values& a) { return all_of(a, a, [](Real x, Real) { return std::isfinite(x); }); }

  friend Real sum(const Values& a)
  {
    Real result = 0;
    for (const Real x : a.value)
      result += x;
    return result;
  }

  friend Real greatest(const Values& a) { return *std::max_element(a.value, a.value + columns); }

  template <class Other>
  Values<Other, columns> cast() const
  {
    Values<Other, columns> result;
    for (int i = 0; i < columns; ++i)
      result[i] = Other(value[i]);
    return result;
  }

private:
  template <class Function>
  static Values map(const Values& a, const Values& b, const Function& f)
  {
    Values result;
    for (int i = 0; i < columns; ++i)
      result[i] = f(a[i], b[i]);
    return result;
  }

  template <class Predicate>
  static bool all_of(const Values& a, const Values& b, const Predicate& is_true)
  {
    for (int i = 0; i < columns; ++i)
      if (!is_true(a[i], b[i]))
        return false;
    return true;
  }
};

template <class Real, int columns>
using Value_vector = std::vector<Values<Real, columns>>;

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_VALUES_H
