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

// Minimum degree of A + A^T, for matrices of meshes: their entries have places that are symmetric, or nearly so. A row
// of a vertex of high valence costs no more than its entries then. Eigen's default for L U, an order for A^T A, fills
// the matrix for such a row, and takes more entries for any other mesh.
template <class Index_type>
struct Minimum_degree_ordering
{
  typedef Eigen::AMDOrdering<Index_type>              Ordering;
  typedef typename Ordering::PermutationType          PermutationType;

  template <class Matrix>
  void operator()(const Matrix& matrix, PermutationType& permutation) const
  {
    PermutationType inverse;      // what Cholesky factorizations take
    Ordering()(matrix, inverse);
    permutation = inverse.inverse();
  }
};

// L U by pivots on the diagonal, which keep that order, but where one is small next to its column.
template <class Real>
class Sparse_LU
  : public Eigen::SparseLU<Eigen_matrix<Real>, Minimum_degree_ordering<std::ptrdiff_t>>
{
public:
  Sparse_LU()
  {
    constexpr double least_pivot = 1e-3;
    this->setPivotThreshold(Real(least_pivot));
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
  return factorize_by_Eigen<Eigen::SimplicialLDLT<Eigen_matrix<Real>>>(n, entries);
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
