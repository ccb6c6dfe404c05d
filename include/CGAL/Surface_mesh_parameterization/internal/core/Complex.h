// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_COMPLEX_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_COMPLEX_H

#include <algorithm>
#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal {

// A complex number as an entry of matrices and vectors. The products of std::complex look after infinite factors, which
// costs time.
template <class Real>
struct Complex
{
  Real re, im;

  Complex(Real re = 0, Real im = 0) : re(re), im(im) { }

  template <class Other>
  explicit Complex(const Complex<Other>& other) : re(Real(other.re)), im(Real(other.im)) { }

  Complex& operator+=(const Complex& other)
  {
    re += other.re;
    im += other.im;
    return *this;
  }

  Complex& operator-=(const Complex& other)
  {
    re -= other.re;
    im -= other.im;
    return *this;
  }

  Complex& operator*=(const Complex& other) { return *this = *this * other; }

  friend Complex operator*(const Complex& a, const Complex& b)
  {
    return { a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re };
  }

  friend Complex operator/(const Complex& a, const Complex& b)
  {
    const Real scale = (std::max)(std::abs(b.re), std::abs(b.im));      // its square may be 0 or infinite
    const Real re = b.re / scale, im = b.im / scale, size = re * re + im * im;
    return { (a.re * re + a.im * im) / size / scale, (a.im * re - a.re * im) / size / scale };
  }

  // That of the plane.
  friend double inner_product(const Complex& a, const Complex& b) { return double(a.re) * b.re + double(a.im) * b.im; }
};

inline double inner_product(float a, float b) { return double(a) * b; }
inline double inner_product(double a, double b) { return a * b; }

inline double real_part(double a) { return a; }

template <class Real>
double real_part(const Complex<Real>& a)
{
  return a.re;
}

// The number of the same kind in double precision.
inline double in_double_precision(double a) { return a; }

template <class Real>
Complex<double> in_double_precision(const Complex<Real>& a)
{
  return Complex<double>(a);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_COMPLEX_H
