// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The elimination of the constraints that an orbifold's seam puts on its points.

#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Constraint_elimination.h>

#include <CGAL/number_utils.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace test_constraint_elimination {

using namespace CGAL::Surface_mesh_parameterization;
using internal::Constraint_elimination;
using internal::Index;
using internal::Sparse_matrix;

typedef std::complex<double>   Complex;

// A system of points with constraints: the matrix, symmetric beside L, and the right side.
struct Constrained_system
{
  Constrained_system(std::size_t points, std::size_t constraints)
    : next_row(2 * points), matrix(2 * (points + constraints)), right_side(2 * (points + constraints), 0.)
  {
    for (std::size_t i = 0; i < next_row; ++i) {
      matrix.set_coef(i, i, -4. - double(i / 2));
      matrix.set_coef(i, (i + 2) % next_row, 1.5);
      matrix.set_coef(i, (i + next_row - 2) % next_row, 0.5);      // not symmetric
    }
  }

  // The sum of the coefficients times their points is `value`.
  void constrain(const std::vector<std::pair<Index, Complex>>& terms, Complex value)
  {
    for (const auto& [point, c] : terms) {
      const double block[2][2] = { { c.real(), -c.imag() }, { c.imag(), c.real() } };
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          if (block[i][j] != 0) {
            matrix.set_coef(next_row + i, 2 * point + j, block[i][j]);
            matrix.set_coef(2 * point + j, next_row + i, block[i][j]);
          }
    }
    right_side[next_row] = value.real();
    right_side[next_row + 1] = value.imag();
    next_row += 2;
  }

  Eigen::MatrixXd dense() const { return dense(matrix); }

  static Eigen::MatrixXd dense(const Sparse_matrix& m)
  {
    Eigen::MatrixXd result(m.row_dimension(), m.column_dimension());
    for (Eigen::Index i = 0; i < result.rows(); ++i)
      for (Eigen::Index j = 0; j < result.cols(); ++j)
        result(i, j) = m.get_coef(i, j);
    return result;
  }

  std::size_t next_row;
  Sparse_matrix matrix;
  Constraint_elimination::Vector right_side;
};

Eigen::VectorXd as_Eigen(const Constraint_elimination::Vector& x)
{
  return Eigen::Map<const Eigen::VectorXd>(x.data(), x.size());
}

// Points 0 and 4 have places; 1 and 2 are turned into each other about 0, and 3 and 5 about 4, whose place is told
// after that.
Constrained_system two_rotations()
{
  const Complex third = std::polar(1., 2 * CGAL_PI / 3), sixth = std::polar(1., CGAL_PI / 3);
  Constrained_system system(7, 4);
  system.constrain({ { 0, 1 } }, Complex(-1, 2));
  system.constrain({ { 1, third }, { 2, -1 }, { 0, 1. - third } }, 0);
  system.constrain({ { 3, sixth }, { 5, -1 }, { 4, 1. - sixth } }, 0);
  system.constrain({ { 4, 1 } }, Complex(3, 0.5));
  return system;
}

TEST(Constraint_elimination, gives_the_solution_of_the_whole_system)
{
  Constrained_system system = two_rotations();
  for (int i = 0; i < 14; ++i)
    system.right_side[i] = std::sin(i);
  const std::vector<Index> ranks{ 0, 5, 2, 1, 3, 4, 6 };
  const auto rows = system.matrix.rows();
  const Constraint_elimination elimination(*rows, system.right_side, ranks);
  ASSERT_TRUE(elimination.is_complete());
  ASSERT_EQ(elimination.number_of_unknowns(), 6u);
  const Eigen::VectorXd y = Constrained_system::dense(elimination.reduced_matrix())
                                .partialPivLu()
                                .solve(as_Eigen(elimination.reduced_right_side()));
  const Eigen::VectorXd x = system.dense().fullPivLu().solve(as_Eigen(system.right_side)).head(14);
  EXPECT_LT((as_Eigen(elimination.expand({ y.begin(), y.end() })) - x).norm(), 1e-12 * x.norm());
}

TEST(Constraint_elimination, keeps_the_point_of_lower_rank)
{
  const Constrained_system system = two_rotations();
  const std::vector<Index> ranks{ 0, 5, 2, 1, 3, 4, 6 };
  const auto rows = system.matrix.rows();
  const Constraint_elimination elimination(*rows, system.right_side, ranks);
  for (const Index point : { 2, 3, 6 })
    EXPECT_TRUE(elimination.is_free(point)) << point;
  for (const Index point : { 1, 5 })
    EXPECT_TRUE(elimination.is_tied(point) && !elimination.is_free(point)) << point;
  for (const Index point : { 0, 4 })
    EXPECT_TRUE(!elimination.is_tied(point) && !elimination.is_free(point)) << point;
}

TEST(Constraint_elimination, satisfies_the_constraints_whatever_the_free_points)
{
  const Constrained_system system = two_rotations();
  const std::vector<Index> ranks{ 0, 1, 2, 3, 4, 5, 6 };
  const auto rows = system.matrix.rows();
  const Constraint_elimination elimination(*rows, system.right_side, ranks);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(22);
  x.head(14) = as_Eigen(elimination.expand({ 1, -2, 3, 0.25, -5, 6 }));
  EXPECT_LT((system.dense() * x - as_Eigen(system.right_side)).tail(8).norm(), 1e-13);
}

TEST(Constraint_elimination, of_a_symmetric_matrix_is_symmetric_and_of_a_negative_one_positive)
{
  Constrained_system system = two_rotations();
  for (std::size_t i = 0; i < 14; ++i) {
    system.matrix.set_coef(i, (i + 2) % 14, 1);
    system.matrix.set_coef(i, (i + 12) % 14, 1);
  }
  const std::vector<Index> ranks{ 0, 1, 2, 3, 4, 5, 6 };
  const auto rows = system.matrix.rows();
  const Eigen::MatrixXd reduced =
      Constrained_system::dense(Constraint_elimination(*rows, system.right_side, ranks).reduced_matrix());
  EXPECT_LT((reduced - reduced.transpose()).norm(), 1e-13);
  EXPECT_EQ(reduced.llt().info(), Eigen::Success);
}

TEST(Constraint_elimination, tells_when_a_constraint_cannot_be_solved_for_a_point)
{
  const std::vector<Index> ranks{ 0, 1, 2, 3 };
  Constrained_system redundant(4, 2), wide(4, 1);
  redundant.constrain({ { 0, 1 } }, 1);
  redundant.constrain({ { 0, 1 } }, 2);
  wide.constrain({ { 0, 1 }, { 1, 1 }, { 2, 1 } }, 0);
  for (const Constrained_system& system : { redundant, wide }) {
    const auto rows = system.matrix.rows();
    EXPECT_FALSE(Constraint_elimination(*rows, system.right_side, ranks).is_complete());
  }
}

} // namespace test_constraint_elimination
