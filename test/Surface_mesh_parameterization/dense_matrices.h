// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DENSE_MATRICES_H
#define DENSE_MATRICES_H

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Values.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <cstddef>

// Matrices, dense ones and sparse ones, and a family of systems to solve.
namespace test_systems {

namespace SMP = CGAL::Surface_mesh_parameterization;
using SMP::internal::Block;
using SMP::internal::Index;
using SMP::internal::Sparse_matrix;
using SMP::internal::Sparse_rows;
using SMP::internal::Value_vector;
using test_meshes::Random;

typedef SMP::internal::Values<double, 1>   Value;
typedef Value_vector<double, 1>            Values;

inline Eigen::Matrix2d dense_of(const Block& b)
{
  Eigen::Matrix2d result;
  result << b.xx(), b.xy(), b.yx(), b.yy();
  return result;
}

inline Eigen::MatrixXd dense(const Sparse_rows<double>& rows, std::size_t columns)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rows.number_of_rows(), columns);
  for (Index i = 0; i < rows.number_of_rows(); ++i)
    for (Index k = rows.first[i]; k < rows.first[i + 1]; ++k) {
      EXPECT_TRUE(k == rows.first[i] || rows.columns[k - 1] < rows.columns[k]);
      result(i, rows.columns[k]) = rows.values[k];
    }
  return result;
}

inline Sparse_rows<double> sparse(const Eigen::MatrixXd& matrix)
{
  Sparse_matrix result(matrix.rows(), matrix.cols());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      if (matrix(i, j) != 0)
        result.set_coef(i, j, matrix(i, j), true);
  return *result.rows();
}

// The matrix of a linear map from n values to others.
template <class Map>
Eigen::MatrixXd matrix_of(std::size_t n, const Map& map)
{
  Eigen::MatrixXd result;
  for (std::size_t j = 0; j < n; ++j) {
    Values unit(n, Value::zero());
    unit[j] = Value::all(1);
    const Values image = map(unit);
    result.conservativeResize(image.size(), n);
    for (std::size_t i = 0; i < image.size(); ++i)
      result(i, j) = image[i][0];
  }
  return result;
}

// The Laplacian of a grid of unknowns, with random weights.
inline Eigen::MatrixXd laplacian(Eigen::Index n, bool is_symmetric)
{
  Random random(5);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n * n, n * n);
  const auto connect = [&](Eigen::Index i, Eigen::Index j) {
    const double weight = random(0.1, 1);
    result(i, j) -= weight;
    result(i, i) += weight;
  };
  for (Eigen::Index i = 0; i < n * n; ++i) {
    result(i, i) += 0.1;
    if (i % n + 1 < n) {
      connect(i, i + 1);
      connect(i + 1, i);
    }
    if (i + n < n * n) {
      connect(i, i + n);
      connect(i + n, i);
    }
  }
  if (is_symmetric)
    result = (result + result.transpose()).eval();
  return result;
}

// By this the diagonal of a matrix is multiplied before it is factorized.
constexpr double enlargement = 1.25;

} // namespace test_systems

#endif // DENSE_MATRICES_H
