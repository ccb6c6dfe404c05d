// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Incomplete factors of a matrix, the smoother of the multigrid solver.

#include "dense_matrices.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Elimination_order.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Incomplete_LU.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace test_incomplete_LU {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace test_systems;
using internal::Elimination_order;
using internal::Incomplete_LU;
using internal::Loops;
using internal::Row_parts_options;

// Four parts of 36 rows, whatever joins them; and one.
const Row_parts_options in_parts{ 10, 4, 1 }, in_one;

Incomplete_LU<double> factors_of(const Eigen::MatrixXd& a, double enlargement_of_diagonal,
                                 const Row_parts_options& parts)
{
  return Incomplete_LU<double>(sparse(a), enlargement_of_diagonal, -(std::numeric_limits<double>::infinity)(), Loops(),
                               parts);
}

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
  const Eigen::MatrixXd a = laplacian(6, false);
  for (const Row_parts_options& parts : { in_one, in_parts }) {
    const Incomplete_LU<double> factors = factors_of(a, enlargement, parts);
    const Values zero(36, Value::zero());
    const Eigen::MatrixXd residuals = matrix_of(36, [&](const Values& x) {
      Values r(36);
      for (Index i = 0; i < 36; ++i)
        r[i] = factors.residual(i, zero, x);
      return r;
    });
    EXPECT_NEAR((residuals + a).norm(), 0, 1e-14);
    for (Index i = 0; i < 36; ++i) {
      Eigen::VectorXd row = Eigen::VectorXd::Zero(36);
      row[i] = factors.diagonal(i);
      factors.for_each_entry(i, [&](Index column, double value) { row[column] += value; });
      EXPECT_EQ(row, a.row(i).transpose());
    }
  }
}

TEST(Incomplete_LU, smoother_of_a_symmetric_matrix_is_symmetric)
{
  for (const Row_parts_options& parts : { in_one, in_parts }) {
    const Eigen::MatrixXd smoother = inverse_of(factors_of(laplacian(6, true), enlargement, parts));
    EXPECT_NEAR((smoother - smoother.transpose()).norm(), 0, 1e-12 * smoother.norm());
  }
}

// With an unknown that is joined with most of those from `first` on.
Eigen::MatrixXd with_hub(Eigen::MatrixXd a, Eigen::Index hub, Eigen::Index first)
{
  Random random(3);
  const Eigen::Index n = a.rows();
  for (Eigen::Index i = first; i < n; ++i)
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
  const Row_parts_options in_halves{ 10, 100, 1 };
  for (const Eigen::MatrixXd& matrix : { laplacian(6, false), with_hub(laplacian(15, false), 112, 0),
                                         with_hub(laplacian(16, false), 150, 128) })
    for (const Row_parts_options& parts : { in_one, in_parts, in_halves }) {
      const Eigen::MatrixXd a = enlarged(matrix),
                            product = inverse_of(factors_of(matrix, enlargement, parts)).inverse();
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

// Whatever the order is, rows of two parts do not meet, and of two rows that meet the later one comes later.
TEST(Elimination_order, lets_parts_be_eliminated_side_by_side)
{
  const Eigen::MatrixXd a = laplacian(12, false);
  Eigen::MatrixXd one_way = a;        // an entry need not have one across the diagonal
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      one_way(i, j) = (i + j) % 3 == 0 ? 0 : a(i, j);
  for (const Eigen::MatrixXd& matrix : { a, one_way }) {
    const Elimination_order order(sparse(matrix), Row_parts_options{ 10, 16, 1 });
    ASSERT_EQ(order.number_of_parts(), 4u);
    std::vector<Index> forward, backward;
    order.for_each(Loops(), [&](Index row) { forward.push_back(row); });
    order.for_each_backward(Loops(), [&](Index row) { backward.push_back(row); });
    ASSERT_EQ(forward.size(), 144u);
    const auto is_before = [&](Index i, Index j) { return order.is_before(i, j); };
    EXPECT_TRUE(std::is_sorted(forward.begin(), forward.end(), is_before));
    std::vector<Index> sorted = forward;
    std::sort(sorted.begin(), sorted.end());
    for (Index i = 0; i < 144; ++i)
      EXPECT_EQ(sorted[i], i);

    const auto place_in = [](const std::vector<Index>& rows, Index row) {
      return std::find(rows.begin(), rows.end(), row) - rows.begin();
    };
    for (Index i = 0; i < 144; ++i)
      for (Index j = 0; j < 144; ++j)
        if (i != j && matrix(i, j) != 0) {
          EXPECT_EQ(order.is_before(i, j), place_in(forward, i) < place_in(forward, j));
          EXPECT_EQ(order.is_before(i, j), place_in(backward, i) > place_in(backward, j));
          const bool are_in_one_part = i * 4 / 144 == j * 4 / 144;
          EXPECT_TRUE(are_in_one_part || order.is_separator(i) || order.is_separator(j));
        }
  }
}

// Where too many rows would separate them, there is but one part, and so there is of few rows.
TEST(Elimination_order, has_parts_if_that_pays)
{
  const auto rows = sparse(laplacian(12, false));
  for (const Row_parts_options& options : { Row_parts_options{ 10, 8, 0.05 }, Row_parts_options{ 145, 8, 1 } }) {
    const Elimination_order order(rows, options);
    EXPECT_EQ(order.number_of_parts(), 1u);
    EXPECT_TRUE(order.separators().empty());
    EXPECT_TRUE(order.is_before(3, 4) && !order.is_before(4, 3));
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
  for (const Row_parts_options& parts : { in_one, in_parts }) {
    const Incomplete_LU<double> factors = factors_of(a, enlargement, parts);
    const Eigen::MatrixXd smoother = inverse_of(factors);
    const Values zero(36, Value::zero());
    const Eigen::MatrixXd iteration = matrix_of(36, [&](const Values& start) {
      Values x = start, scratch(36);
      factors.relax(zero, x, scratch);
      return x;
    });
    EXPECT_NEAR((iteration - (Eigen::MatrixXd::Identity(36, 36) - smoother * a)).norm(), 0, 1e-12);
  }
}

} // namespace test_incomplete_LU
