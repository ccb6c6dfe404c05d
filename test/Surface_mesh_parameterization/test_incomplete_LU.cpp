// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Incomplete factors of a matrix, the smoother of the multigrid solver.

#include "dense_matrices.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/linear/Incomplete_LU.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace test_incomplete_LU {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace test_systems;
using internal::Incomplete_LU;

Eigen::MatrixXd inverse_of(const Incomplete_LU<double>& factors)
{
  return matrix_of(factors.size(), [&](const Values& b) {
    Values x(b.size());
    factors.solve(b, x);
    return x;
  });
}

Eigen::MatrixXd tridiagonal(Eigen::Index n, bool is_symmetric)
{
  Random random(7);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    result(i, i) = random(2.5, 3);
    if (i + 1 < n) {
      result(i, i + 1) = random(-1, -0.1);
      result(i + 1, i) = is_symmetric ? result(i, i + 1) : random(-1, -0.1);
    }
  }
  return result;
}

// What is factorized.
Eigen::MatrixXd enlarged(Eigen::MatrixXd a)
{
  a.diagonal() *= enlargement;
  return a;
}

TEST(Incomplete_LU, is_exact_without_fill_in)
{
  for (const bool is_symmetric : { true, false }) {
    const Eigen::MatrixXd a = tridiagonal(20, is_symmetric);
    EXPECT_NEAR((inverse_of(Incomplete_LU<double>(sparse(a), enlargement)) * enlarged(a) -
                 Eigen::MatrixXd::Identity(20, 20))
                    .norm(),
                0, 1e-12);
  }
}

TEST(Incomplete_LU, keeps_the_matrix_itself)
{
  const Eigen::MatrixXd a = laplacian(5, false);
  const Incomplete_LU<double> factors(sparse(a), enlargement);
  const Values zero(25, Value::zero());
  const Eigen::MatrixXd residuals = matrix_of(25, [&](const Values& x) {
    Values r(25);
    for (Index i = 0; i < 25; ++i)
      r[i] = factors.residual(i, zero, x);
    return r;
  });
  EXPECT_NEAR((residuals + a).norm(), 0, 1e-14);
  for (Index i = 0; i < 25; ++i) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(25);
    row[i] = factors.diagonal(i);
    factors.for_each_entry(i, [&](Index column, double value) { row[column] += value; });
    EXPECT_EQ(row, a.row(i).transpose());
  }
}

TEST(Incomplete_LU, smoother_of_a_symmetric_matrix_is_symmetric)
{
  const Eigen::MatrixXd smoother = inverse_of(Incomplete_LU<double>(sparse(laplacian(6, true)), enlargement));
  EXPECT_NEAR((smoother - smoother.transpose()).norm(), 0, 1e-12 * smoother.norm());
}

// With an unknown in the middle that is joined with all others.
Eigen::MatrixXd with_hub(Eigen::MatrixXd a)
{
  Random random(3);
  const Eigen::Index n = a.rows(), hub = n / 2;
  for (Eigen::Index i = 0; i < n; ++i)
    if (i != hub && i % 5 != 0) {
      a(hub, i) = random(-0.1, -0.05);
      a(i, hub) = random(-0.1, -0.05);
    }
  a(hub, hub) = double(n);
  return a;
}

// Which is what makes it incomplete: L U agrees with what is factorized where that has entries.
TEST(Incomplete_LU, factors_agree_with_the_matrix_on_its_pattern)
{
  for (const Eigen::MatrixXd& matrix : { laplacian(6, false), with_hub(laplacian(15, false)) }) {
    const Eigen::MatrixXd a = enlarged(matrix),
                          product = inverse_of(Incomplete_LU<double>(sparse(matrix), enlargement)).inverse();
    double fill_in = 0;
    for (Eigen::Index i = 0; i < a.rows(); ++i)
      for (Eigen::Index j = 0; j < a.cols(); ++j)
        if (a(i, j) != 0)
          EXPECT_NEAR(product(i, j), a(i, j), 1e-12 * a.diagonal().maxCoeff());
        else
          fill_in = (std::max)(fill_in, std::abs(product(i, j)));
    EXPECT_GT(fill_in, 1e-3);
  }
}

double least_eigenvalue(const Eigen::MatrixXd& symmetric)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric).eigenvalues().minCoeff();
}

// The positive definite matrix of Kershaw (1978), whose incomplete factors are indefinite.
TEST(Incomplete_LU, is_positive_definite_if_pivots_must_not_be_small)
{
  constexpr double little_enlargement = 1.02;
  Eigen::MatrixXd a(4, 4);
  a << 3, -2, 0, 2, -2, 3, -2, 0, 0, -2, 3, -2, 2, 0, -2, 3;
  ASSERT_GT(least_eigenvalue(a), 0.1);
  EXPECT_LT(least_eigenvalue(inverse_of(Incomplete_LU<double>(sparse(a), little_enlargement))), 0);
  EXPECT_GT(least_eigenvalue(inverse_of(Incomplete_LU<double>(sparse(a), little_enlargement, 0.1))), 0);
}

TEST(Incomplete_LU, relaxation_adds_the_solution_for_the_residual)
{
  const Eigen::MatrixXd a = laplacian(6, false);
  const Incomplete_LU<double> factors(sparse(a), enlargement);
  const Eigen::MatrixXd smoother = inverse_of(factors);
  const Values zero(36, Value::zero());
  const Eigen::MatrixXd iteration = matrix_of(36, [&](const Values& start) {
    Values x = start, scratch(36);
    factors.relax(zero, x, scratch);
    return x;
  });
  EXPECT_NEAR((iteration - (Eigen::MatrixXd::Identity(36, 36) - smoother * a)).norm(), 0, 1e-12);
}

} // namespace test_incomplete_LU
