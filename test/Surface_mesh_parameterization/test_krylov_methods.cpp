// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The iterations around a preconditioner.

#include "dense_matrices.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Krylov_methods.h>

#include <Eigen/Core>
#include <Eigen/QR>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace test_krylov_methods {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace test_systems;
using internal::Loops;

// A dense system for two right sides, preconditioned by the diagonal.
struct Dense_system
{
  typedef SMP::internal::Values<double, 2>   Value_2;
  typedef Value_vector<double, 2>            Vector_2;

  Eigen::MatrixXd matrix;
  double target = 1e-12;
  Loops sequential = {};
  Vector_2 preconditioned = {};

  Index number_of_rows() const { return Index(matrix.rows()); }
  const Loops& loops() const { return sequential; }

  Value_2 row_times(Index i, const Vector_2& x) const
  {
    Value_2 sum = Value_2::zero();
    for (Index j = 0; j < x.size(); ++j)
      sum += matrix(i, j) * x[j];
    return sum;
  }

  Value_2 multiply(const Vector_2& x, Vector_2& y, const Vector_2& z) const
  {
    return multiply_by_rows(*this, x, y, z);
  }

  Vector_2& precondition(const Vector_2& r)
  {
    preconditioned.resize(r.size());
    for (Index i = 0; i < r.size(); ++i)
      preconditioned[i] = (1 / matrix(i, i)) * r[i];
    return preconditioned;
  }

  Value_2 squared_size(Index, const Value_2& r) const { return r * r; }
  Value_2 direction_factor(const Value_2& a, const Value_2& b) const { return quotient(a, b); }
  bool is_finished(const Value_2& squared_norm) const
  {
    return is_less_or_equal(sqrt(squared_norm), Value_2::all(target));
  }
  bool is_solved(const Vector_2& r) const { return is_finished(SMP::internal::squared_norm(*this, r)); }

  Vector_2 times(const Vector_2& x) const
  {
    Vector_2 result;
    for (Index i = 0; i < x.size(); ++i)
      result.push_back(row_times(i, x));
    return result;
  }
};

struct Conjugate_gradients
{
  static constexpr bool needs_symmetry = true;
  template <class System, class Vector>
  std::size_t operator()(System& system, Vector& x, Vector& r, std::size_t most_iterations) const
  {
    Vector scratch(x.size());
    return SMP::internal::conjugate_gradients(system, x, r, scratch, most_iterations);
  }
};

struct Stabilized_biconjugate_gradients
{
  static constexpr bool needs_symmetry = false;
  template <class System, class Vector>
  std::size_t operator()(System& system, Vector& x, Vector& r, std::size_t most_iterations) const
  {
    return SMP::internal::stabilized_biconjugate_gradients(system, x, r, most_iterations);
  }
};

struct Minimal_residuals
{
  static constexpr bool needs_symmetry = false;
  template <class System, class Vector>
  std::size_t operator()(System& system, Vector& x, Vector& r, std::size_t most_iterations) const
  {
    return SMP::internal::generalized_minimal_residuals(system, x, r, most_iterations);
  }
};

template <class Method>
class Krylov_method : public testing::Test { };
typedef testing::Types<Conjugate_gradients, Stabilized_biconjugate_gradients, Minimal_residuals> Krylov_methods;
TYPED_TEST_SUITE(Krylov_method, Krylov_methods, );

TYPED_TEST(Krylov_method, solves_dense_systems)
{
  for (const bool is_symmetric : { true, false }) {
    if (TypeParam::needs_symmetry && !is_symmetric)
      continue;
    Dense_system system{ laplacian(4, is_symmetric) };
    Random random(2);
    Dense_system::Vector_2 expected(16);
    for (auto& value : expected)
      value = { random(-1, 1), random(-1, 1) };
    Dense_system::Vector_2 x(16, Dense_system::Value_2::zero()), r = system.times(expected);
    const std::size_t iterations = TypeParam()(system, x, r, 100);
    EXPECT_LE(iterations, 16u + 4);      // as many as unknowns, but for rounding
    EXPECT_GE(iterations, 3u);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_TRUE(is_less_or_equal(abs(x[i] - expected[i]), Dense_system::Value_2::all(1e-10)));      // a NaN is not
    EXPECT_TRUE(system.is_solved(r));
    EXPECT_EQ(TypeParam()(system, x, r, 100), 0u) << "there is nothing left to do";
  }
}

TYPED_TEST(Krylov_method, leaves_a_solved_right_side_as_it_is)
{
  Dense_system system{ laplacian(4, true) };
  Dense_system::Vector_2 solution(16, Dense_system::Value_2{ 0, 1 });
  Dense_system::Vector_2 x(16, Dense_system::Value_2{ 5, 0 }), r = system.times(solution);
  TypeParam()(system, x, r, 100);
  for (const auto& value : x) {
    EXPECT_EQ(value[0], 5);
    EXPECT_NEAR(value[1], 1, 1e-10);
  }
}

TYPED_TEST(Krylov_method, stops_in_time)
{
  Dense_system system{ laplacian(4, true) };
  for (const std::size_t most : { 0, 1, 3 }) {
    Dense_system::Vector_2 x(16, Dense_system::Value_2::zero()), r(16, Dense_system::Value_2{ 1, -1 });
    r[3] = { 7, 4 };
    EXPECT_EQ(TypeParam()(system, x, r, most), most);
  }

  // What no iteration can reach, it does not fill with numbers that are none: here A x is the same in all rows.
  system.matrix.setOnes();
  Dense_system::Vector_2 x(16, Dense_system::Value_2::zero()), r(16);
  for (Index i = 0; i < r.size(); ++i)
    r[i] = Dense_system::Value_2::all(i % 2 ? 1 : -1);
  EXPECT_LE(TypeParam()(system, x, r, 100), 100u);
  for (const auto& value : x)
    EXPECT_TRUE(std::isfinite(value[0]) && std::isfinite(value[1])) << value[0] << ' ' << value[1];

  // Nor does it go on for ever where a number is none.
  system.matrix.setConstant(std::numeric_limits<double>::infinity());
  EXPECT_LE(TypeParam()(system, x, r, 100), 100u);
}

// After k iterations the residual is the least one that a combination of M^-1 r, M^-1 A M^-1 r, and so on, leaves; also
// of a matrix with rows far from diagonally dominant.
TEST(Minimal_residuals, are_minimal)
{
  Dense_system system{ laplacian(4, false) };
  system.matrix.row(3) *= -1;
  system.matrix(9, 9) = -0.01;
  const Eigen::VectorXd inverse_diagonal = system.matrix.diagonal().cwiseInverse();
  const Index n = system.number_of_rows();
  Random random(5);
  Dense_system::Vector_2 b(n);
  for (auto& value : b)
    value = { random(-1, 1), random(-1, 1) };
  for (Index k = 1; k <= 8; ++k) {
    Dense_system::Vector_2 x(n, Dense_system::Value_2::zero()), r = b;
    ASSERT_EQ(SMP::internal::generalized_minimal_residuals(system, x, r, k), k);
    const Dense_system::Vector_2 ax = system.times(x);
    for (int c = 0; c < 2; ++c) {
      Eigen::VectorXd right_side(n), residual(n), carried_along(n);
      for (Index i = 0; i < n; ++i) {
        right_side[i] = b[i][c];
        residual[i] = b[i][c] - ax[i][c];
        carried_along[i] = r[i][c];
      }
      Eigen::MatrixXd images(n, k);
      Eigen::VectorXd v = right_side;
      for (Index j = 0; j < k; ++j) {
        v = (system.matrix * inverse_diagonal.cwiseProduct(v)).normalized();
        images.col(j) = v;
      }
      const Eigen::VectorXd least = right_side - images * images.colPivHouseholderQr().solve(right_side);
      EXPECT_NEAR(residual.norm(), least.norm(), 1e-9);
      EXPECT_LE((residual - carried_along).norm(), 1e-12);
    }
  }
}

// The quadratic function x A x / 2 - b x falls by what the method tells, and the iteration ends when that does not pay.
TEST(Conjugate_gradients, tell_what_they_lower)
{
  typedef Dense_system::Value_2    Value_2;
  typedef Dense_system::Vector_2   Vector_2;
  Dense_system system{ laplacian(4, true) };
  Random random(3);
  Vector_2 b(16);
  for (Value_2& value : b)
    value = { random(-1, 1), random(-1, 1) };
  Vector_2 x(16, Value_2::zero()), r = b, scratch(16);
  Value_2 sum = Value_2::zero();
  std::size_t calls = 0;
  const std::size_t iterations = SMP::internal::conjugate_gradients(system, x, r, scratch, 100, [&](const Value_2& d) {
    EXPECT_TRUE(is_less_or_equal(Value_2::zero(), d));
    sum += d;
    return ++calls < 4;
  });
  EXPECT_EQ(iterations, 4u);
  const Vector_2 ax = system.times(x);
  Value_2 value = Value_2::zero();
  for (std::size_t i = 0; i < x.size(); ++i)
    value += x[i] * (0.5 * ax[i] - b[i]);
  EXPECT_TRUE(is_less_or_equal(abs(value + sum), Value_2::all(1e-12)));
}

} // namespace test_krylov_methods
