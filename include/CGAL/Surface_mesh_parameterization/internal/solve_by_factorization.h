// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_SOLVE_BY_FACTORIZATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_SOLVE_BY_FACTORIZATION_H

#include <CGAL/Surface_mesh_parameterization/internal/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/flat_types.h>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <algorithm>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Solves A x = b by a sparse LU factorization. Returns whether there was one.
template <int columns>
bool solve_by_factorization(const Sparse_rows<double>& a, const Value_vector<double, columns>& b, Value_vector<double, columns>& x)
{
  typedef Eigen::Matrix<double, Eigen::Dynamic, columns>   Dense;
  const Index n = a.number_of_rows();
  Eigen::SparseMatrix<double> matrix(n, n);     // by columns, as the solver wants it
  std::vector<int> sizes(n, 0);
  for (const Index column : a.columns)
    ++sizes[column];
  // Eigen may not come to an end with these.
  const bool has_empty_row = std::adjacent_find(a.first.begin(), a.first.end()) != a.first.end();
  if (has_empty_row || std::find(sizes.begin(), sizes.end(), 0) != sizes.end())
    return false;
  matrix.reserve(sizes);
  for (Index i = 0; i < n; ++i)
    for (Index k = a.first[i]; k < a.first[i + 1]; ++k)
      matrix.insert(i, a.columns[k]) = a.values[k];
  matrix.makeCompressed();

  const Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
  if (solver.info() != Eigen::Success)
    return false;
  Dense right_side(n, columns);
  for (Index i = 0; i < n; ++i)
    right_side.row(i) = b[i].matrix().transpose();
  const Dense solution = solver.solve(right_side);
  for (Index i = 0; i < n; ++i)
    x[i] = solution.row(i).transpose().array();
  return true;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_SOLVE_BY_FACTORIZATION_H
