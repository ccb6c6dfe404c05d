// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONSTRAINT_ELIMINATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONSTRAINT_ELIMINATION_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Takes the constraints out of a system as Orbifold_Tutte_parameterizer_3 assembles it,
//
//     ( L  A' ) ( x )   ( c )
//     ( A  0  ) ( l ) = ( d )
//
// where x holds two coordinates of each point of the plane and -L is a Laplacian matrix. Each two rows of A give the
// value of one linear combination of points with complex coefficients: a point has its place, or a point of the seam is
// another one turned about a third. Solved for one point each, the constraints say x = Z y + x_0, where y holds the
// points that stay free, and what is left of the system is
//
//     -Z' L Z y = Z' (L x_0 - c),
//
// which is symmetric and positive definite if -L is symmetric and positive semidefinite.
class Constraint_elimination
{
public:
  typedef Sparse_rows<double>   Rows;
  typedef std::vector<double>   Vector;

  // `rows` and `right_side` must live as long as this object; there are as many points as `ranks`. Of two points that
  // are tied to each other the one of lower rank stays free.
  Constraint_elimination(const Rows& rows, const Vector& right_side, const std::vector<Index>& ranks)
    : m_rows(rows), m_right_side(right_side), m_ranks(ranks), m_coordinates(Index(2 * ranks.size()))
  {
    for (Index point = 0; point < ranks.size(); ++point)
      m_ties.push_back({ point, 1, 0 });
    // The points that have their places come first: others are turned about them.
    for (const bool places_point : { true, false })
      for (Index row = m_coordinates; row < rows.number_of_rows(); row += 2)
        if ((rows.first[row + 1] - rows.first[row] == 1) == places_point)
          m_is_complete = eliminate(row) && m_is_complete;
    number_free_points();
  }

  Index number_of_unknowns() const { return m_unknowns; }

  // Whether every constraint could be solved for a point.
  bool is_complete() const { return m_is_complete; }

  bool is_free(Index point) const { return m_ties[point].to == point; }

  // Whether a point is given by a free one.
  bool is_tied(Index point) const { return !is_free(point) && m_ties[point].to != no_index; }

  // -Z' L Z. The unknowns of the i-th free point are 2 i and 2 i + 1.
  Sparse_matrix reduced_matrix() const
  {
    Sparse_matrix result(m_unknowns);
    for (Index i = 0; i < m_coordinates; ++i)
      for_each_in_row(i, [&](Index unknown, double weight) {
        m_rows.for_each_entry(i, [&](Index j, double value) {
          if (j < m_coordinates)
            for_each_in_row(j, [&](Index other, double other_weight) {
              result.add_coef(unknown, other, -weight * value * other_weight);
            });
        });
      });
    return result;
  }

  // Z' (L x_0 - c)
  Vector reduced_right_side() const
  {
    Vector result(m_unknowns, 0.);
    for (Index i = 0; i < m_coordinates; ++i) {
      double value = -m_right_side[i];
      m_rows.for_each_entry(i, [&](Index j, double entry) {
        if (j < m_coordinates)
          value += entry * offset(j);
      });
      for_each_in_row(i, [&](Index unknown, double weight) { result[unknown] += weight * value; });
    }
    return result;
  }

  // Z y + x_0
  Vector expand(const Vector& y) const
  {
    Vector x(m_coordinates);
    for (Index i = 0; i < m_coordinates; ++i) {
      x[i] = offset(i);
      for_each_in_row(i, [&](Index unknown, double weight) { x[i] += weight * y[unknown]; });
    }
    return x;
  }

private:
  typedef std::complex<double>   Complex;

  static constexpr double negligible = 1e-12;       // next to coefficients of a rotation

  // A point is `factor` times the point `to`, plus `offset`. A free point is tied to itself, and one whose place is
  // known to none.
  struct Tie
  {
    Index to;
    Complex factor, offset;
  };

  // The tie of a point to a free one.
  Tie tie(Index point) const
  {
    Tie result = m_ties[point];
    while (result.to != no_index && !is_free(result.to)) {
      const Tie& next = m_ties[result.to];
      result = { next.to, result.factor * next.factor, result.factor * next.offset + result.offset };
    }
    return result;
  }

  // Solves the constraint in two rows for one point. Returns false if it has none, or more than two, that are still
  // free.
  bool eliminate(Index row)
  {
    std::vector<std::pair<Index, Complex>> terms;
    Complex value(m_right_side[row], m_right_side[row + 1]);
    m_rows.for_each_entry(row, [&](Index column, double entry) {
      // The first row is the real part: a + i b times u + i v has the real part a u - b v.
      const bool is_second = column % 2 == 1;
      const Complex coefficient = is_second ? Complex(0, -entry) : Complex(entry, 0);
      const Tie t = tie(column / 2);
      value -= coefficient * t.offset;
      const auto term =
          std::find_if(terms.begin(), terms.end(), [&t](const auto& other) { return other.first == t.to; });
      if (term != terms.end())
        term->second += coefficient * t.factor;
      else if (t.to != no_index)
        terms.push_back({ t.to, coefficient * t.factor });
    });
    terms.erase(std::remove_if(terms.begin(), terms.end(),
                               [](const auto& term) { return std::abs(term.second) <= negligible; }),
                terms.end());
    if (terms.empty() || terms.size() > 2)
      return false;
    if (terms.size() == 1)
      terms.push_back({ no_index, 0 });
    else if (m_ranks[terms[0].first] < m_ranks[terms[1].first])
      std::swap(terms[0], terms[1]);
    const auto [point, coefficient] = terms[0];
    m_ties[point] = { terms[1].first, -terms[1].second / coefficient, value / coefficient };
    return true;
  }

  void number_free_points()
  {
    std::vector<Tie> ties;
    for (Index point = 0; point < m_ties.size(); ++point) {
      ties.push_back(tie(point));
      m_first_unknown.push_back(m_unknowns);
      m_unknowns += is_free(point) ? 2 : 0;
    }
    m_ties = std::move(ties);
  }

  // Row i of Z: calls f(unknown, weight) for what is not 0.
  template <class Function>
  void for_each_in_row(Index i, const Function& f) const
  {
    const Tie& t = m_ties[i / 2];
    if (t.to == no_index)
      return;
    const bool is_second = i % 2 == 1;
    const double weights[2] = { is_second ? t.factor.imag() : t.factor.real(),
                                is_second ? t.factor.real() : -t.factor.imag() };
    for (int k = 0; k < 2; ++k)
      if (weights[k] != 0)
        f(m_first_unknown[t.to] + k, weights[k]);
  }

  // Coordinate i of x_0
  double offset(Index i) const
  {
    const Complex& place = m_ties[i / 2].offset;
    return i % 2 == 1 ? place.imag() : place.real();
  }

  const Rows& m_rows;
  const Vector& m_right_side;
  const std::vector<Index>& m_ranks;
  Index m_coordinates;
  std::vector<Tie> m_ties;
  std::vector<Index> m_first_unknown;      // of each free point
  Index m_unknowns = 0;
  bool m_is_complete = true;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONSTRAINT_ELIMINATION_H
