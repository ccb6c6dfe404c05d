// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_DIRECT_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_DIRECT_SOLVER_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Complex.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Values.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/complex_rows.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// An entry of a sparse matrix; entries at one place are added up.
struct Matrix_entry
{
  Index i, j;
  double a;

  Index row() const { return i; }
  Index col() const { return j; }
  double value() const { return a; }
};

// Solves linear systems with one sparse matrix, as its factorization does.
class Direct_solver
{
public:
  virtual ~Direct_solver() = default;

  // Takes another matrix with entries at the same places, for which the order of elimination is known already; false if
  // it cannot.
  virtual bool factorize_again(const std::vector<Matrix_entry>& /*entries*/) { return false; }

  // x := A^-1 b, for so many right sides and solutions, one after the other; NaN if that fails.
  virtual void solve(const double* b, double* x, int number_of_right_sides) const = 0;

  // The same for right sides side by side: `b(i)` tells what they have in row i.
  template <class Right_sides, class Real, int columns>
  void solve_side_by_side(const Right_sides& b, Value_vector<Real, columns>& x) const
  {
    const std::size_t n = x.size();
    std::vector<double> right_sides(columns * n), solutions(columns * n);
    for (std::size_t i = 0; i < n; ++i) {
      const Values<double, columns> row = b(Index(i));
      for (int c = 0; c < columns; ++c)
        right_sides[c * n + i] = row[c];
    }
    solve(right_sides.data(), solutions.data(), columns);
    for (std::size_t i = 0; i < n; ++i)
      for (int c = 0; c < columns; ++c)
        x[i][c] = Real(solutions[c * n + i]);
  }

  // The same for a matrix of complex numbers, see factorize_hermitian().
  template <class Right_side, class Real>
  void solve_side_by_side(const Right_side& b, Value_vector<Complex<Real>, 1>& x) const
  {
    std::vector<double> right_side, solution(2 * x.size());
    right_side.reserve(2 * x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Complex<double> value = b(Index(i))[0];
      right_side.insert(right_side.end(), { value.re, value.im });
    }
    solve(right_side.data(), solution.data(), 1);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i][0] = { Real(solution[2 * i]), Real(solution[2 * i + 1]) };
  }
};

// The factorization L D L^T of a symmetric matrix of dimension n, of which the lower triangle is read; null if it
// breaks down.
template <class Real = double>
std::unique_ptr<Direct_solver> factorize_symmetric(Index n, const std::vector<Matrix_entry>& entries);

// The factorization L D L^H of a Hermitian matrix, of which the upper triangle is read; null if it breaks down. Right
// sides and solutions hold the real and the imaginary part of each number in turn.
template <class Real = double>
std::unique_ptr<Direct_solver> factorize_hermitian(const Sparse_rows<Complex<Real>>& a);

// The factorization L U of any regular matrix of dimension n; null if it is singular.
//
// All three are templates for the sake of who uses the package header-only: what is not called is not compiled, and
// this one takes long.
template <class Real = double>
std::unique_ptr<Direct_solver> factorize(Index n, const std::vector<Matrix_entry>& entries);

inline std::vector<Matrix_entry> entries_of(const Sparse_rows<double>& a)
{
  std::vector<Matrix_entry> entries;
  entries.reserve(a.values.size());
  for (Index i = 0; i < a.number_of_rows(); ++i)
    a.for_each_entry(i, [&](Index column, double value) { entries.push_back({ i, column, value }); });
  return entries;
}

// The same of square matrices that are given by their rows.
template <class Real = double>
std::unique_ptr<Direct_solver> factorize_symmetric_rows(const Sparse_rows<double>& a)
{
  return factorize_symmetric<Real>(a.number_of_rows(), entries_of(a));
}

template <class Real = double>
std::unique_ptr<Direct_solver> factorize_rows(const Sparse_rows<double>& a)
{
  return factorize<Real>(a.number_of_rows(), entries_of(a));
}

// The same of a symmetric matrix that should be a complex one, see complex_rows(): as such, it takes a third of the
// memory and of the time.
template <class Real = double>
std::unique_ptr<Direct_solver> factorize_as_complex(const Sparse_rows<Real>& a)
{
  const auto rows = complex_rows(a);
  return rows ? factorize_hermitian<Real>(*rows) : factorize_symmetric_rows<Real>(a);
}

typedef std::unique_ptr<Direct_solver> (*Make_direct_solver)(const Sparse_rows<double>&);

#ifdef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
extern template std::unique_ptr<Direct_solver> factorize_symmetric<double>(Index, const std::vector<Matrix_entry>&);
extern template std::unique_ptr<Direct_solver> factorize_hermitian<double>(const Sparse_rows<Complex<double>>&);
extern template std::unique_ptr<Direct_solver> factorize<double>(Index, const std::vector<Matrix_entry>&);
#endif

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_DIRECT_SOLVER_H
