// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_DIRECT_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_DIRECT_SOLVER_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A sparse LU factorization of a matrix.
class Direct_solver
{
public:
  explicit Direct_solver(const Sparse_rows<double>& a)
  {
    const Index n = a.number_of_rows();
    std::vector<int> sizes(n, 0);
    for (const Index column : a.columns)
      ++sizes[column];
    // Eigen may not come to an end with these.
    const bool has_empty_row = std::adjacent_find(a.first.begin(), a.first.end()) != a.first.end();
    if (has_empty_row || std::find(sizes.begin(), sizes.end(), 0) != sizes.end())
      return;

    Eigen::SparseMatrix<double> matrix(n, n);     // by columns, as the solver wants it
    matrix.reserve(sizes);
    for (Index i = 0; i < n; ++i)
      for (Index k = a.first[i]; k < a.first[i + 1]; ++k)
        matrix.insert(i, a.columns[k]) = a.values[k];
    matrix.makeCompressed();
    m_solver.compute(matrix);
    m_is_ready = m_solver.info() == Eigen::Success;
  }

  // Whether the matrix has a factorization.
  bool is_ready() const { return m_is_ready; }

  // `b[i]` tells what the right sides have in row i; x has the size of the system.
  template <class Right_sides, int columns>
  void solve(const Right_sides& b, Value_vector<double, columns>& x) const
  {
    typedef Eigen::Matrix<double, Eigen::Dynamic, columns>   Dense;
    Dense right_side(x.size(), columns);
    for (std::size_t i = 0; i < x.size(); ++i)
      right_side.row(i) = b[i].matrix().transpose();
    const Dense solution = m_solver.solve(right_side);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = solution.row(i).transpose().array();
  }

private:
  Eigen::SparseLU<Eigen::SparseMatrix<double>> m_solver;
  bool m_is_ready = false;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_DIRECT_SOLVER_H
