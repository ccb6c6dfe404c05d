// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_DIRECT_SOLVER_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_DIRECT_SOLVER_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// By one of Eigen's solvers.
template <class Solver>
class Eigen_direct_solver final
  : public Direct_solver
{
public:
  Eigen_direct_solver(Index n, const std::vector<Matrix_entry>& entries) : m_size(n)
  {
    m_solver.compute(matrix_of(entries));
  }

  bool is_ready() const { return m_solver.info() == Eigen::Success; }

  bool factorize_again(const std::vector<Matrix_entry>& entries) override
  {
    m_solver.factorize(matrix_of(entries));
    return is_ready();
  }

  void solve(const double* b, double* x, int number_of_right_sides) const override
  {
    for (int i = 0; i < number_of_right_sides; ++i) {
      const Eigen::Map<const Eigen::VectorXd> right_side(b + i * m_size, m_size);
      Eigen::Map<Eigen::VectorXd>(x + i * m_size, m_size) = m_solver.solve(right_side);
    }
  }

private:
  typename Solver::MatrixType matrix_of(const std::vector<Matrix_entry>& entries) const
  {
    typename Solver::MatrixType matrix(m_size, m_size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  Solver m_solver;
  Eigen::Index m_size;
};

// The factors of a few million rows have more entries than an `int` can count.
template <class Real>
using Eigen_matrix = Eigen::SparseMatrix<Real, Eigen::ColMajor, std::ptrdiff_t>;

// Whether the unknowns come in pairs, side by side and joined to the same others, as the coordinates of vertices do.
// The columns have both triangles, and their rows in ascending order.
template <class Matrix>
bool comes_in_pairs(const Matrix& matrix)
{
  const auto* const first = matrix.outerIndexPtr();
  const auto* const rows = matrix.innerIndexPtr();
  if (matrix.cols() % 2 != 0)
    return false;
  for (Eigen::Index j = 0; j < matrix.cols(); j += 2) {
    const auto size = first[j + 1] - first[j];
    if (size % 2 != 0 || first[j + 2] - first[j + 1] != size ||
        !std::equal(rows + first[j], rows + first[j + 1], rows + first[j + 1]))
      return false;
    for (auto k = first[j]; k < first[j + 1]; k += 2)
      if (rows[k] % 2 != 0 || rows[k + 1] != rows[k] + 1)
        return false;
  }
  return true;
}

// Minimum degree for a symmetric matrix; of pairs of unknowns where they come so, which is a fourth of the work.
template <class Index_type>
struct Symmetric_ordering
{
  typedef Eigen::AMDOrdering<Index_type>                  Ordering;
  typedef typename Ordering::PermutationType              PermutationType;

  template <class Matrix>
  void operator()(const Matrix& matrix, PermutationType& permutation) const
  {
    if (!comes_in_pairs(matrix)) {
      Ordering()(matrix.template selfadjointView<Eigen::Lower>(), permutation);
      return;
    }
    Matrix joined_pairs(matrix.rows() / 2, matrix.cols() / 2);
    joined_pairs.reserve(matrix.nonZeros() / 4);
    for (Eigen::Index j = 0; j < joined_pairs.cols(); ++j) {
      joined_pairs.startVec(j);
      for (typename Matrix::InnerIterator entry(matrix, 2 * j); entry; ++entry)
        if (entry.row() % 2 == 0)
          joined_pairs.insertBack(entry.row() / 2, j) = 1;
    }
    joined_pairs.finalize();
    PermutationType of_pairs;
    Ordering()(joined_pairs.template selfadjointView<Eigen::Lower>(), of_pairs);
    permutation.resize(matrix.cols());
    for (Eigen::Index i = 0; i < of_pairs.size(); ++i)
      for (Index_type c = 0; c < 2; ++c)
        permutation.indices()[2 * i + c] = 2 * of_pairs.indices()[i] + c;
  }
};

// Whether no diagonal entry is small next to its row, so that all can be pivots without a loss of digits.
template <class Matrix>
bool has_pivots_on_diagonal(const Matrix& matrix)
{
  constexpr double least_part_of_row = 0.5;
  std::vector<double> diagonal(matrix.rows(), 0.), others(matrix.rows(), 0.);
  for (Eigen::Index j = 0; j < matrix.outerSize(); ++j)
    for (typename Matrix::InnerIterator entry(matrix, j); entry; ++entry)
      (entry.row() == entry.col() ? diagonal : others)[entry.row()] += std::abs(entry.value());
  for (std::size_t i = 0; i < diagonal.size(); ++i)
    if (!(diagonal[i] >= least_part_of_row * others[i]))
      return false;
  return true;
}

// Minimum degree of A + A^T where pivots may stay on the diagonal: the entries of a matrix of a mesh have places that
// are symmetric, or nearly so. Else Eigen's default, an order for A^T A, which suits any pivots and takes more entries.
template <class Index_type>
struct Elimination_ordering
{
  typedef typename Eigen::AMDOrdering<Index_type>::PermutationType   PermutationType;

  template <class Matrix>
  void operator()(const Matrix& matrix, PermutationType& permutation) const
  {
    if (!has_pivots_on_diagonal(matrix)) {
      Eigen::COLAMDOrdering<Index_type>()(matrix, permutation);
      return;
    }
    PermutationType inverse;      // what Cholesky factorizations take
    Eigen::AMDOrdering<Index_type>()(matrix, inverse);
    permutation = inverse.inverse();
  }
};

// L U, by pivots on the diagonal where they may stay there: greater ones in a column, as a vertex of high valence and
// given values make them, would fill the matrix.
template <class Real>
class Sparse_LU
  : public Eigen::SparseLU<Eigen_matrix<Real>, Elimination_ordering<std::ptrdiff_t>>
{
  typedef Eigen::SparseLU<Eigen_matrix<Real>, Elimination_ordering<std::ptrdiff_t>>   Base;

public:
  void compute(const Eigen_matrix<Real>& matrix)
  {
    constexpr double least_pivot = 1e-3;      // relative to the greatest one in the column
    this->setPivotThreshold(has_pivots_on_diagonal(matrix) ? Real(least_pivot) : Real(1));
    Base::compute(matrix);
  }
};

template <class Solver>
std::unique_ptr<Direct_solver> factorize_by_Eigen(Index n, const std::vector<Matrix_entry>& entries)
{
  auto solver = std::make_unique<Eigen_direct_solver<Solver>>(n, entries);
  return solver->is_ready() ? std::move(solver) : nullptr;
}

template <class Real>
std::unique_ptr<Direct_solver> factorize_symmetric(Index n, const std::vector<Matrix_entry>& entries)
{
  typedef Symmetric_ordering<std::ptrdiff_t>   Ordering;
  return factorize_by_Eigen<Eigen::SimplicialLDLT<Eigen_matrix<Real>, Eigen::Lower, Ordering>>(n, entries);
}

// The parts of complex numbers lie in memory as the interface has them. The matrix is factorized at a scale at which
// squares of its entries are numbers.
template <class Real>
class Hermitian_solver final
  : public Direct_solver
{
  static_assert(std::is_same<Real, double>::value);
  typedef std::complex<Real>                              Number;
  typedef Eigen::Matrix<Number, Eigen::Dynamic, 1>        Vector;

public:
  explicit Hermitian_solver(const Sparse_rows<Complex<Real>>& a) : m_size(a.number_of_rows())
  {
    Real greatest = 0;
    for (const Complex<Real>& value : a.values)
      greatest = (std::max)(greatest, std::abs(value.re));
    if (greatest > 0)
      m_scale = std::ldexp(Real(1), -(std::max)(std::ilogb(greatest), least_exponent));
    Eigen_matrix<Number> lower(m_size, m_size);       // whose columns are conjugate to the rows of the upper triangle
    lower.reserve((a.values.size() + m_size) / 2);
    for (Index i = 0; i < m_size; ++i) {
      lower.startVec(i);
      a.for_each_entry(i, [&](Index column, const Complex<Real>& value) {
        if (column >= i)
          lower.insertBack(column, i) = m_scale * Number(value.re, -value.im);
      });
    }
    lower.finalize();
    m_solver.compute(lower);
  }

  bool is_ready() const { return m_solver.info() == Eigen::Success; }

  void solve(const double* b, double* x, int number_of_right_sides) const override
  {
    for (int i = 0; i < number_of_right_sides; ++i) {
      const Eigen::Map<const Vector> right_side(reinterpret_cast<const Number*>(b) + i * m_size, m_size);
      Eigen::Map<Vector>(reinterpret_cast<Number*>(x) + i * m_size, m_size) =
          m_solver.solve(m_scale * right_side);
    }
  }

private:
  static constexpr int least_exponent = -1000;

  Eigen::SimplicialLDLT<Eigen_matrix<Number>> m_solver;
  Eigen::Index m_size;
  Real m_scale = 1;
};

template <class Real>
std::unique_ptr<Direct_solver> factorize_hermitian(const Sparse_rows<Complex<Real>>& a)
{
  auto solver = std::make_unique<Hermitian_solver<Real>>(a);
  return solver->is_ready() ? std::move(solver) : nullptr;
}

template <class Real>
std::unique_ptr<Direct_solver> factorize(Index n, const std::vector<Matrix_entry>& entries)
{
  // With an empty row or column, Eigen may not come to an end.
  std::vector<bool> has_row(n, false), has_column(n, false);
  for (const Matrix_entry& entry : entries)
    has_row[entry.i] = has_column[entry.j] = true;
  const auto is_full = [](const std::vector<bool>& has) {
    return std::find(has.begin(), has.end(), false) == has.end();
  };
  if (!is_full(has_row) || !is_full(has_column))
    return nullptr;
  return factorize_by_Eigen<Sparse_LU<Real>>(n, entries);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_DIRECT_SOLVER_IMPL_H
