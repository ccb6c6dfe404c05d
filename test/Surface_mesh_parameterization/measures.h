// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MEASURES_H
#define MEASURES_H

#include "test_meshes.h"

#include <CGAL/Kernel/global_functions.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>

// What tests measure maps and functions with.
namespace test_meshes {

struct Singular_values
{
  double greatest, least, determinant, area;   // the area is that of the triangle in space

  double mips() const { return greatest / least + least / greatest; }
};

inline Singular_values singular_values(const Point_3& p, const Point_3& q, const Point_3& r, const Point_2& a,
                                       const Point_2& b, const Point_2& c)
{
  const Vector_3 pq = q - p, pr = r - p;
  const double length = std::sqrt(pq.squared_length()),
               doubled_area = std::sqrt(CGAL::cross_product(pq, pr).squared_length());
  Eigen::Matrix2d rest, image;
  rest << length, pq * pr / length, 0, doubled_area / length;
  image << b.x() - a.x(), c.x() - a.x(), b.y() - a.y(), c.y() - a.y();
  const Eigen::Matrix2d jacobian = image * rest.inverse();
  const Eigen::Vector2d s = Eigen::JacobiSVD<Eigen::Matrix2d>(jacobian).singularValues();
  return { s[0], s[1], jacobian.determinant(), 0.5 * doubled_area };
}

// The least value of a function that falls and then rises.
template <class Function>
double least_value(const Function& f, double from, double to)
{
  for (int i = 0; i < 100; ++i) {     // to rounding
    const double left = from + (to - from) / 3, right = to - (to - from) / 3;
    if (f(left) < f(right))
      to = right;
    else
      from = left;
  }
  return f(0.5 * (from + to));
}

} // namespace test_meshes

#endif // MEASURES_H
