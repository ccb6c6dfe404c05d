// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The multigrid solver for systems that others assemble, from its matrix up to Multigrid_solver_traits.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Grid_transfer.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Incomplete_LU.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Krylov_methods.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_preconditioner.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/properties.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

using SMP::internal::Grid_transfer;
using SMP::internal::Hierarchy_interpolation;
using SMP::internal::Incomplete_LU;
using SMP::internal::Loops;
using SMP::internal::Mesh_unknown;
using SMP::internal::Multigrid_preconditioner;
using SMP::internal::Pruned_prolongation;
using SMP::internal::Sparse_matrix;
using SMP::internal::Sparse_rows;
using SMP::internal::Value_vector;

typedef CGAL::Simple_cartesian<double>               Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>          Surface_mesh;
typedef boost::graph_traits<Surface_mesh>::halfedge_descriptor   Halfedge;
typedef Multigrid_solver_traits::Vector              Vector;
typedef SMP::internal::Values<double, 1>             Value;
typedef Value_vector<double, 1>                      Values;

// ---- Sparse_matrix ----

Eigen::MatrixXd dense(const Sparse_rows<double>& rows, std::size_t columns)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rows.number_of_rows(), columns);
  for (Index i = 0; i < rows.number_of_rows(); ++i)
    for (Index k = rows.first[i]; k < rows.first[i + 1]; ++k) {
      EXPECT_TRUE(k == rows.first[i] || rows.columns[k - 1] < rows.columns[k]);
      result(i, rows.columns[k]) = rows.values[k];
    }
  return result;
}

TEST(Sparse_matrix, equals_a_dense_one_after_any_sequence_of_changes)
{
  for (const std::size_t n : { 1, 3, 40 })
    for (unsigned int seed = 0; seed < 5; ++seed) {
      const std::size_t m = n + seed;
      Random random(seed);
      Sparse_matrix matrix(n, m);
      Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(n, m);
      Eigen::MatrixXi is_known = Eigen::MatrixXi::Zero(n, m);
      EXPECT_EQ(matrix.row_dimension(), int(n));
      EXPECT_EQ(matrix.column_dimension(), int(m));
      for (int step = 0; step < 20000; ++step) {
        const std::size_t i = random.below(n), j = random.below(m);
        const double value = double(random.below(100)) - 50;      // whole numbers, whose sums are exact
        const double action = random(0, 1);
        if (action < 0.5) {
          matrix.add_coef(i, j, value);
          expected(i, j) += value;
        } else if (action < 0.999) {
          matrix.set_coef(i, j, value, !is_known(i, j) && random(0, 1) < 0.5);
          expected(i, j) = value;
        } else if (action < 0.9995)
          ASSERT_EQ(matrix.get_coef(i, j), expected(i, j)) << "step " << step;
        else
          ASSERT_EQ(dense(*matrix.rows(), m), expected) << "step " << step;
        is_known(i, j) = action < 0.999 || is_known(i, j);
      }
      EXPECT_EQ(dense(*matrix.rows(), m), expected);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < m; ++j)
          EXPECT_EQ(matrix.get_coef(i, j), expected(i, j));
    }
}

TEST(Sparse_matrix, knows_nothing_but_zeros_at_first)
{
  const Sparse_matrix matrix(3);
  EXPECT_EQ(matrix.get_coef(2, 1), 0);
  EXPECT_EQ(matrix.rows()->number_of_rows(), 3u);
  EXPECT_TRUE(matrix.rows()->values.empty());
}

TEST(Sparse_matrix, rows_stay_as_they_are_while_somebody_holds_them)
{
  Sparse_matrix matrix(2);
  matrix.set_coef(0, 0, 1, true);
  matrix.set_coef(1, 0, 2, true);
  const auto change = [&](auto&& f) {
    const auto rows = matrix.rows();
    const Sparse_rows<double> before = *rows;
    EXPECT_EQ(matrix.get_coef(0, 0), before.values.front());
    EXPECT_EQ(matrix.rows(), rows) << "reading changes nothing";
    f();
    EXPECT_NE(matrix.rows(), rows);
    EXPECT_EQ(rows->columns, before.columns);
    EXPECT_EQ(rows->values, before.values);
  };
  change([&] { matrix.set_coef(0, 0, 7); });
  change([&] { matrix.set_coef(0, 1, 7); });
  change([&] { matrix.set_coef(1, 1, 7, true); });
  change([&] { matrix.add_coef(0, 0, 7); });
  change([&] { matrix.add_coef(1, 0, -7); });

  Sparse_matrix copy = matrix;
  EXPECT_EQ(copy.rows(), matrix.rows());
  copy.set_coef(0, 0, -1);
  EXPECT_EQ(matrix.get_coef(0, 0), 14);
  EXPECT_EQ(copy.get_coef(0, 0), -1);
}

// ---- Incomplete_LU ----

Sparse_rows<double> sparse(const Eigen::MatrixXd& matrix)
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
    Values unit(n, Value::Zero());
    unit[j] = 1;
    const Values image = map(unit);
    result.conservativeResize(image.size(), n);
    for (std::size_t i = 0; i < image.size(); ++i)
      result(i, j) = image[i][0];
  }
  return result;
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

// The Laplacian of a grid of unknowns, with random weights.
Eigen::MatrixXd laplacian(Eigen::Index n, bool is_symmetric)
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

constexpr double enlargement = 1.25;

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
    EXPECT_NEAR((inverse_of(Incomplete_LU<double>(sparse(a), enlargement)) * enlarged(a) - Eigen::MatrixXd::Identity(20, 20)).norm(), 0, 1e-12);
  }
}

TEST(Incomplete_LU, keeps_the_matrix_itself)
{
  const Eigen::MatrixXd a = laplacian(5, false);
  const Incomplete_LU<double> factors(sparse(a), enlargement);
  const Values zero(25, Value::Zero());
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

// Which is what makes it incomplete: L U agrees with what is factorized where that has entries.
TEST(Incomplete_LU, factors_agree_with_the_matrix_on_its_pattern)
{
  const Eigen::MatrixXd a = enlarged(laplacian(6, false)), product = inverse_of(Incomplete_LU<double>(sparse(laplacian(6, false)), enlargement)).inverse();
  double fill_in = 0;
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      if (a(i, j) != 0)
        EXPECT_NEAR(product(i, j), a(i, j), 1e-12);
      else
        fill_in = (std::max)(fill_in, std::abs(product(i, j)));
  EXPECT_GT(fill_in, 1e-3);
}

TEST(Incomplete_LU, relaxation_adds_the_solution_for_the_residual)
{
  const Eigen::MatrixXd a = laplacian(6, false);
  const Incomplete_LU<double> factors(sparse(a), enlargement);
  const Eigen::MatrixXd smoother = inverse_of(factors);
  const Values zero(36, Value::Zero());
  const Eigen::MatrixXd iteration = matrix_of(36, [&](const Values& start) {
    Values x = start, scratch(36);
    factors.relax(zero, x, scratch);
    return x;
  });
  EXPECT_NEAR((iteration - (Eigen::MatrixXd::Identity(36, 36) - smoother * a)).norm(), 0, 1e-12);
}

// ---- Hierarchy_interpolation, Grid_transfer, Multigrid_preconditioner ----

Collapse_hierarchy_3 hierarchy_of(const Flat_mesh& m) { return Collapse_hierarchy_3(surface(m), parameters::coarsest_size(20)); }

// Two unknowns at each vertex of a level, but for some whose values are known.
std::vector<Mesh_unknown> some_unknowns(const Collapse_hierarchy_3& hierarchy, std::size_t level)
{
  std::vector<Mesh_unknown> result;
  for (Index v = 0; v < hierarchy.number_of_vertices(level); ++v)
    for (const Index component : { 0, 1 })
      if ((hierarchy.input_vertex(v) + component) % 7 != 0)
        result.push_back({ v, component });
  std::sort(result.begin(), result.end(), [&](const Mesh_unknown& a, const Mesh_unknown& b) {
    return std::make_pair(hierarchy.input_vertex(a.vertex), a.component) < std::make_pair(hierarchy.input_vertex(b.vertex), b.component);
  });
  return result;
}

Eigen::MatrixXd prolongation_of(const Grid_transfer& transfer, std::size_t fine_size)
{
  return matrix_of(transfer.coarse_unknowns().size(), [&](const Values& coarse) {
    Values x(fine_size, Value::Zero());
    transfer.add_prolongation(coarse, x);
    return x;
  });
}

// The solver works with the interpolation alone: it must put every vertex where the hierarchy does, to single precision.
TEST(Hierarchy_interpolation, has_the_levels_and_the_prolongation_of_its_hierarchy)
{
  const Collapse_hierarchy_3 hierarchy = hierarchy_of(delaunay_patch(300, 5, wavy));
  const Hierarchy_interpolation interpolation(hierarchy);
  ASSERT_GT(hierarchy.number_of_levels(), 4u);
  ASSERT_EQ(interpolation.number_of_levels(), hierarchy.number_of_levels());
  for (std::size_t level = 0; level < hierarchy.number_of_levels(); ++level)
    EXPECT_EQ(interpolation.number_of_vertices(level), hierarchy.number_of_vertices(level));
  EXPECT_EQ(interpolation.number_of_vertices(), hierarchy.number_of_vertices());
  for (Index v = 0; v < hierarchy.number_of_vertices(); ++v) {
    EXPECT_EQ(interpolation.input_vertex(v), hierarchy.input_vertex(v));
    if (v < hierarchy.number_of_vertices(0))
      continue;
    EXPECT_EQ(interpolation.parent_triangle(v), hierarchy.parent_triangle(v));
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(interpolation.barycentric_coordinates(v)[k], hierarchy.barycentric_coordinates(v)[k], 1e-6);
      EXPECT_GE(interpolation.barycentric_coordinates(v)[k], 0);
      sum += interpolation.barycentric_coordinates(v)[k];
    }
    EXPECT_NEAR(sum, 1, 1e-6);
  }
}

TEST(Grid_transfer, restriction_is_the_transpose_and_the_Galerkin_product_as_defined)
{
  const Collapse_hierarchy_3 hierarchy = hierarchy_of(delaunay_patch(120, 3, wavy));
  const std::size_t fine = hierarchy.number_of_levels() - 1, coarse = fine - 3;
  const std::vector<Mesh_unknown> unknowns = some_unknowns(hierarchy, fine);
  const std::size_t n = unknowns.size();
  const Grid_transfer transfer(Pruned_prolongation(hierarchy, coarse, fine, Loops()), unknowns);
  const Eigen::MatrixXd p = prolongation_of(transfer, n);
  EXPECT_EQ(transfer.coarse_unknowns().size(), some_unknowns(hierarchy, coarse).size());

  const Eigen::MatrixXd transpose = matrix_of(n, [&](const Values& b) {
    Values result(p.cols());
    transfer.restrict([&](Index i) { return b[i]; }, result);
    return result;
  });
  EXPECT_EQ(transpose, p.transpose());

  Random random(1);
  const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(n, n, [&](Eigen::Index i, Eigen::Index j) { return i == j || random(0, 1) < 0.05 ? random(-1, 1) : 0; });
  const Sparse_rows<double> product = transfer.galerkin_product<double>(Incomplete_LU<double>(sparse(a), enlargement));
  EXPECT_NEAR((dense(product, p.cols()) - p.transpose() * a * p).norm(), 0, 1e-12 * a.norm());
}

TEST(Grid_transfer, prolongs_components_apart_and_keeps_constants)
{
  const Collapse_hierarchy_3 hierarchy = hierarchy_of(disk_with_hole());
  std::vector<Mesh_unknown> unknowns;
  for (Index v = 0; v < hierarchy.number_of_vertices(); ++v)
    for (const Index component : { 0, 1 })
      unknowns.push_back({ v, component });
  const Grid_transfer transfer(Pruned_prolongation(hierarchy, 0, hierarchy.number_of_levels() - 1, Loops()), unknowns);
  Values coarse, x(unknowns.size(), Value::Zero());
  for (const Mesh_unknown& u : transfer.coarse_unknowns())
    coarse.push_back(Value(u.component == 0 ? 3. : -5.));
  transfer.add_prolongation(coarse, x);
  for (std::size_t i = 0; i < x.size(); ++i)
    EXPECT_NEAR(x[i][0], unknowns[i].component == 0 ? 3 : -5, 1e-5);
}

// An edge energy's matrix with an unknown at each vertex in the order of the input; rows of border vertices hold nothing but the diagonal.
template <class EdgeWeights>
Sparse_matrix edge_matrix(const Flat_mesh& m, EdgeWeights edge_weights)
{
  const One_rings rings(m.points.size(), m.triangles);
  Sparse_matrix result(m.points.size());
  std::vector<Point_3> ring;
  std::vector<double> weights;
  for (Index v = 0; v < m.points.size(); ++v) {
    double sum = 0;
    if (!rings.is_border(v)) {
      ring.clear();
      for (const Index w : rings[v])
        ring.push_back(m.points[w]);
      edge_weights(m.points[v], ring, true, weights);
      std::size_t i = 0;
      for (const Index w : rings[v]) {
        result.set_coef(v, w, -weights[i], true);
        sum += weights[i++];
      }
    }
    result.set_coef(v, v, sum == 0 ? 1 : sum, true);
  }
  return result;
}

// The vertices that are not on the border, and the rows and columns of the matrix above that belong to them.
struct Inner_system
{
  std::vector<Mesh_unknown> unknowns;
  Sparse_rows<double> rows;

  Inner_system(const Flat_mesh& m, const Collapse_hierarchy_3& hierarchy)
  {
    const One_rings rings(m.points.size(), m.triangles);
    std::vector<Index> rank_of(m.points.size()), number(m.points.size(), SMP::internal::no_index);
    for (Index rank = 0; rank < m.points.size(); ++rank)
      rank_of[hierarchy.input_vertex(rank)] = rank;
    for (Index v = 0; v < m.points.size(); ++v)
      if (!rings.is_border(v)) {
        number[v] = Index(unknowns.size());
        unknowns.push_back({ rank_of[v], 0 });
      }
    const auto all = edge_matrix(m, Harmonic_edge_weights_3()).rows();
    Sparse_matrix inner(unknowns.size());
    for (Index v = 0; v < m.points.size(); ++v)
      for (Index k = all->first[v]; k < all->first[v + 1]; ++k)
        if (number[v] != SMP::internal::no_index && number[all->columns[k]] != SMP::internal::no_index)
          inner.set_coef(number[v], number[all->columns[k]], all->values[k], true);
    rows = *inner.rows();
  }
};

TEST(Multigrid_preconditioner, cycle_of_a_symmetric_matrix_is_symmetric_and_positive)
{
  const Flat_mesh m = delaunay_patch(3000, 2, wavy);
  const Collapse_hierarchy_3 hierarchy = hierarchy_of(m);
  const Inner_system system(m, hierarchy);
  const std::size_t n = system.unknowns.size();
  ASSERT_GT(n, 4 * Multigrid_preconditioner<double>::coarsest_size);
  const Multigrid_preconditioner<double> multigrid(hierarchy, system.unknowns, system.rows);
  ASSERT_TRUE(multigrid.is_ready());
  Multigrid_preconditioner<double>::Space<1> space(multigrid);
  const auto cycle = [&](const Values& b) {
    space.right_side[0] = b;
    multigrid.cycle(space);
    return space.solution[0];
  };
  Random random(3);
  Values x(n), y(n);
  for (int i = 0; i < 5; ++i) {
    for (Values* vector : { &x, &y })
      for (Value& value : *vector)
        value = random(-1, 1);
    const Values cycle_x = cycle(x), cycle_y = cycle(y);
    const double xy = SMP::internal::dot(Loops(), cycle_x, y)[0], yx = SMP::internal::dot(Loops(), x, cycle_y)[0];
    const double xx = SMP::internal::dot(Loops(), cycle_x, x)[0], yy = SMP::internal::dot(Loops(), cycle_y, y)[0];
    EXPECT_GT(xx, 0);
    EXPECT_NEAR(xy, yx, 1e-12 * std::sqrt(xx * yy));
  }
}

TEST(Multigrid_preconditioner, cycles_reduce_the_error_and_full_cycles_more_so)
{
  const Flat_mesh m = delaunay_patch(3000, 2, wavy);
  const Collapse_hierarchy_3 hierarchy = hierarchy_of(m);
  const Inner_system system(m, hierarchy);
  const Multigrid_preconditioner<double> multigrid(hierarchy, system.unknowns, system.rows);
  Multigrid_preconditioner<double>::Space<1> space(multigrid);

  Values expected, b(system.unknowns.size());
  for (const Mesh_unknown& u : system.unknowns)     // smooth, as a solution for a smooth right side
    expected.push_back(Value(std::sin(3 * hierarchy.point(u.vertex).x()) + hierarchy.point(u.vertex).y()));
  for (Index i = 0; i < b.size(); ++i)
    b[i] = system.rows.row_times(i, expected);
  const auto energy_of_error = [&] {
    Values error = expected;
    for (std::size_t i = 0; i < error.size(); ++i)
      error[i] -= space.solution[0][i];
    double result = 0;
    for (Index i = 0; i < error.size(); ++i)
      result += error[i][0] * system.rows.row_times(i, error)[0];
    return std::sqrt(result);
  };
  space.solution[0].assign(b.size(), Value::Zero());
  const double start = energy_of_error();
  space.right_side[0] = b;
  multigrid.cycle(space);
  const double by_cycle = energy_of_error();
  space.right_side[0] = b;
  multigrid.full_cycle(space);
  const double by_full_cycle = energy_of_error();
  EXPECT_LT(by_cycle, 0.5 * start);
  EXPECT_LT(by_full_cycle, 0.5 * by_cycle);
}

// ---- the Krylov methods ----

// A dense system for two right sides, preconditioned by the diagonal.
struct Dense_system
{
  typedef SMP::internal::Values<double, 2>   Value_2;
  typedef Value_vector<double, 2>            Vector_2;

  Eigen::MatrixXd matrix;
  double target = 1e-12;
  Loops sequential = {};

  Index number_of_rows() const { return Index(matrix.rows()); }
  const Loops& loops() const { return sequential; }

  Value_2 row_times(Index i, const Vector_2& x) const
  {
    Value_2 sum = Value_2::Zero();
    for (Index j = 0; j < x.size(); ++j)
      sum += matrix(i, j) * x[j];
    return sum;
  }

  void precondition(const Vector_2& r, Vector_2& z) const
  {
    for (Index i = 0; i < r.size(); ++i)
      z[i] = r[i] / matrix(i, i);
  }

  bool is_finished(const Vector_2& r) const { return (SMP::internal::dot(sequential, r, r).sqrt() <= target).all(); }

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
  template <class... Arguments>
  std::size_t operator()(Arguments&&... arguments) const { return SMP::internal::conjugate_gradients(arguments...); }
};

struct Stabilized_biconjugate_gradients
{
  static constexpr bool needs_symmetry = false;
  template <class... Arguments>
  std::size_t operator()(Arguments&&... arguments) const { return SMP::internal::stabilized_biconjugate_gradients(arguments...); }
};

template <class Method>
class Krylov_method : public testing::Test { };
typedef testing::Types<Conjugate_gradients, Stabilized_biconjugate_gradients> Krylov_methods;
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
    Dense_system::Vector_2 x(16, Dense_system::Value_2::Zero()), r = system.times(expected);
    const std::size_t iterations = TypeParam()(system, x, r, 100);
    EXPECT_LE(iterations, 16u + 4);      // as many as unknowns, but for rounding
    EXPECT_GE(iterations, 3u);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_TRUE(((x[i] - expected[i]).abs() < 1e-10).all());
    EXPECT_TRUE(system.is_finished(r));
    EXPECT_EQ(TypeParam()(system, x, r, 100), 0u) << "there is nothing left to do";
  }
}

TYPED_TEST(Krylov_method, leaves_a_solved_right_side_as_it_is)
{
  Dense_system system{ laplacian(4, true) };
  Dense_system::Vector_2 solution(16, Dense_system::Value_2(0, 1));
  Dense_system::Vector_2 x(16, Dense_system::Value_2(5, 0)), r = system.times(solution);
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
    Dense_system::Vector_2 x(16, Dense_system::Value_2::Zero()), r(16, Dense_system::Value_2(1, -1));
    r[3] = { 7, 4 };
    EXPECT_EQ(TypeParam()(system, x, r, most), most);
  }

  // What no iteration can reach, it does not fill with numbers that are none.
  system.matrix.setZero();
  system.matrix.diagonal().setConstant(std::numeric_limits<double>::infinity());
  Dense_system::Vector_2 x(16, Dense_system::Value_2::Zero()), r(16, Dense_system::Value_2::Ones());
  EXPECT_LE(TypeParam()(system, x, r, 100), 100u);
}

// ---- Multigrid_solver_traits ----

// A system of which the solution is known.
struct Known_system
{
  Sparse_matrix matrix;
  Vector right_side, expected;

  explicit Known_system(Sparse_matrix m) : matrix(std::move(m)), right_side(matrix.row_dimension()), expected(matrix.row_dimension())
  {
    const auto rows = matrix.rows();
    Random random(11);
    for (int i = 0; i < matrix.row_dimension(); ++i)
      expected[i] = random(-1, 1);
    for (int i = 0; i < matrix.row_dimension(); ++i)
      for (Index k = rows->first[i]; k < rows->first[i + 1]; ++k)
        right_side[i] += rows->values[k] * expected[rows->columns[k]];
  }

  double error(const Vector& x) const { return (x.eigen_object() - expected.eigen_object()).lpNorm<Eigen::Infinity>(); }
};

// A mesh with a solver on it, whose unknowns have the order of the vertices.
struct Solver_on_mesh
{
  Surface_mesh mesh;
  Multigrid_solver_traits solver;

  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Solver_on_mesh(const Flat_mesh& m, const NamedParameters& np = parameters::default_values())
    : mesh(make<Surface_mesh>(m)), solver(mesh, longest_border(mesh), get(CGAL::vertex_index, mesh), np)
  { }
};

TEST(Multigrid_solver_traits, solves_what_sits_on_a_mesh)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    Solver_on_mesh on(m);
    for (const bool is_symmetric : { true, false }) {
      Sparse_matrix matrix = is_symmetric ? edge_matrix(m, Uniform_edge_weights_3()) : edge_matrix(m, Mean_value_edge_weights_3());
      const Known_system system(std::move(matrix));
      Vector x;
      double d = 0;
      EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
      EXPECT_EQ(d, 1);
      EXPECT_LT(system.error(x), 1e-4);       // of degenerate triangles the matrix is nearly singular
    }
    EXPECT_EQ(on.solver.error().code, OK);
    EXPECT_EQ(on.solver.summary().right_sides, 2u);
    EXPECT_EQ(on.solver.summary().setups, 2u);
    EXPECT_EQ(on.solver.summary().direct_solutions, 0u);
    EXPECT_LE(on.solver.summary().residual, 1e-10);
  }
}

// How many iterations it takes to 1e-8.
template <class EdgeWeights>
std::size_t iterations(const Flat_mesh& m, EdgeWeights edge_weights, unsigned int seed = 0, bool unit_edges = false)
{
  Solver_on_mesh on(m, parameters::tolerance(1e-8).unit_edges(unit_edges).random_seed(seed));
  const Sparse_matrix matrix = edge_matrix(m, edge_weights);
  Vector b(matrix.row_dimension()), x;
  const One_rings rings(m.points.size(), m.triangles);
  for (Index v = 0; v < m.points.size(); ++v)
    if (rings.is_border(v))
      b[v] = m.points[v].x();
  double d;
  EXPECT_TRUE(on.solver.linear_solver(matrix, b, x, d));
  EXPECT_EQ(on.solver.summary().direct_solutions, 0u);
  EXPECT_LE(on.solver.summary().residual, 1e-8);
  return on.solver.summary().iterations;
}

// Whose coarse levels have no vertex that is not on the border.
TEST(Multigrid_solver_traits, solves_where_coarse_levels_have_no_unknown)
{
  for (const Flat_mesh& m : { grid(1500, 2, wavy), grid(700, 3, wavy), grid_with_holes(60) }) {
    Solver_on_mesh on(m, parameters::coarsest_size(5));
    const Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
    Vector x;
    double d;
    EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
    EXPECT_LT(system.error(x), 1e-6);
    EXPECT_EQ(on.solver.summary().direct_solutions, 0u);
  }
}

template <class EdgeWeights>
class Iterations : public testing::Test { };
typedef testing::Types<Uniform_edge_weights_3, Harmonic_edge_weights_3, Mean_value_edge_weights_3> Edge_weights;
TYPED_TEST_SUITE(Iterations, Edge_weights, );

// On average over several hierarchies of a mesh: from one to the next the number varies by two.
TYPED_TEST(Iterations, are_few_and_do_not_grow)
{
  const auto mean_iterations = [](const Flat_mesh& m) {
    constexpr unsigned int seeds = 4;
    std::size_t sum = 0;
    for (unsigned int seed = 0; seed < seeds; ++seed) {
      const std::size_t n = iterations(m, TypeParam(), seed);
      EXPECT_LE(n, 12u) << m.points.size() << " vertices, seed " << seed;
      sum += n;
    }
    return double(sum) / seeds;
  };
  const auto check = [&](const auto& mesh_of_size) {
    const double small = mean_iterations(mesh_of_size(2000));
    for (const Index n : { 8000, 32000 })
      EXPECT_LE(mean_iterations(mesh_of_size(n)), small + 4) << n << " vertices";
  };
  check([](Index n) { return delaunay_patch(n, 1, wavy); });
  check([](Index n) { return cap(Index(std::sqrt(n / 4.)), Index(std::sqrt(4. * n)), 0.5 * CGAL_PI); });
}

TYPED_TEST(Iterations, are_few_on_real_meshes)
{
  for (const std::string name : { "face_1042.off", "three_peaks.off", "lion_head.off", "camelhead.off" }) {
    Flat_mesh m;
    if (!read_off(name, m))
      GTEST_SKIP() << "no real meshes at hand";
    EXPECT_LE(iterations(m, TypeParam()), 20u) << name;
  }
}

// Half the edges are opposite to angles of up to 166 degrees: with cotangents so negative, incomplete factors of the matrix as it is make no smoother.
TEST(Multigrid_solver_traits, copes_with_obtuse_triangles)
{
  for (const Index n : { 60, 120 })
    EXPECT_LE(iterations(affine_image(grid(n, n, flat), 1, -4, 0, 1), Harmonic_edge_weights_3()), 12u) << n;
}

// Uniform weights do not feel that a mesh is stretched, and neither does the iteration.
TEST(Multigrid_solver_traits, unit_edges_suit_uniform_weights)
{
  const Flat_mesh m = grid(120, 120, flat), stretched = affine_image(m, 6, 0, 0, 1);
  const std::size_t expected = iterations(m, Uniform_edge_weights_3());
  EXPECT_LE(iterations(stretched, Uniform_edge_weights_3(), 0, true), expected + 1);
  EXPECT_GE(iterations(stretched, Uniform_edge_weights_3(), 0, false), expected + 3);
}

TEST(Multigrid_solver_traits, factor_keeps_the_matrix_for_several_right_sides)
{
  const Flat_mesh m = grid(20, 20, wavy);
  Solver_on_mesh on(m);
  const Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
  Vector never_solved;
  EXPECT_FALSE(on.solver.linear_solver(system.right_side, never_solved)) << "nothing has been factored";
  double d = 0;
  EXPECT_TRUE(on.solver.factor(system.matrix, d));
  EXPECT_EQ(d, 1);
  for (int i = 0; i < 3; ++i) {
    Vector x;
    EXPECT_TRUE(on.solver.linear_solver(system.right_side, x));
    EXPECT_LT(system.error(x), 1e-8);
  }
  Vector x;
  EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
  EXPECT_EQ(on.solver.summary().setups, 1u);
  EXPECT_EQ(on.solver.summary().right_sides, 4u);
}

TEST(Multigrid_solver_traits, notices_that_a_matrix_has_changed_in_its_place)
{
  const Flat_mesh m = grid(20, 20, wavy);
  Solver_on_mesh on(m);
  Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
  Vector x;
  double d;
  EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
  system.matrix.set_coef(200, 200, 100 + system.matrix.get_coef(200, 200));
  const Known_system changed(system.matrix);
  EXPECT_TRUE(on.solver.linear_solver(system.matrix, changed.right_side, x, d));
  EXPECT_LT(changed.error(x), 1e-8);
  EXPECT_EQ(on.solver.summary().setups, 2u);
}

TEST(Multigrid_solver_traits, copies_share_what_was_set_up)
{
  const Flat_mesh m = grid(20, 20, wavy);
  Solver_on_mesh on(m);
  Multigrid_solver_traits copy = on.solver;
  const Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
  Vector x;
  double d;
  EXPECT_TRUE(copy.factor(system.matrix, d));
  EXPECT_TRUE(on.solver.linear_solver(system.right_side, x));
  EXPECT_EQ(copy.summary().right_sides, 1u);
}

TEST(Multigrid_solver_traits, default_constructed_takes_the_solver_of_the_innermost_scope)
{
  const auto solves = [](const Flat_mesh& m) {
    const Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
    Vector x;
    double d = 0;
    const bool result = Multigrid_solver_traits().linear_solver(system.matrix, system.right_side, x, d);
    EXPECT_EQ(Multigrid_solver_traits().factor(system.matrix, d), result);
    return result && system.error(x) < 1e-8;
  };
  const Flat_mesh outer_mesh = grid(9, 9, wavy), inner_mesh = fan(17);
  Solver_on_mesh outer(outer_mesh), inner(inner_mesh);
  EXPECT_FALSE(solves(outer_mesh));
  {
    const Multigrid_solver_traits::Scope outer_scope(outer.solver);
    EXPECT_TRUE(solves(outer_mesh));
    EXPECT_FALSE(solves(inner_mesh));
    {
      const Multigrid_solver_traits::Scope inner_scope(inner.solver);
      EXPECT_FALSE(solves(outer_mesh));
      EXPECT_TRUE(solves(inner_mesh));
    }
    EXPECT_TRUE(solves(outer_mesh));
    const Multigrid_solver_traits::Scope empty_scope{ Multigrid_solver_traits(nullptr) };
    EXPECT_FALSE(solves(outer_mesh));
  }
  EXPECT_FALSE(solves(outer_mesh));
  EXPECT_EQ(Multigrid_solver_traits().summary().setups, 0u);
}

// The solution of a call that fails must be as it was.
template <class Call>
void expect_failure(const Call& call)
{
  Vector x(3);
  for (int i = 0; i < 3; ++i)
    x[i] = i + 0.5;
  EXPECT_FALSE(call(x));
  ASSERT_EQ(x.size(), 3);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(x[i], i + 0.5);
}

TEST(Multigrid_solver_traits, refuses_wrong_sizes)
{
  const Flat_mesh m = grid(5, 5, wavy);
  Solver_on_mesh on(m);
  double d = 0;
  for (const auto& size : { std::make_pair(35, 35), std::make_pair(37, 37), std::make_pair(36, 72) }) {
    const int rows = size.first, columns = size.second;
    Sparse_matrix matrix(rows, columns);
    for (int i = 0; i < (std::min)(rows, columns); ++i)
      matrix.set_coef(i, i, 1, true);
    EXPECT_FALSE(on.solver.factor(matrix, d)) << rows << " x " << columns;
    expect_failure([&](Vector& x) { return on.solver.linear_solver(matrix, Vector(rows), x, d); });
  }
  const Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
  EXPECT_TRUE(on.solver.factor(system.matrix, d));
  for (const int n : { 0, 35, 37 }) {
    expect_failure([&](Vector& x) { return on.solver.linear_solver(Vector(n), x); });
    expect_failure([&](Vector& x) { return on.solver.linear_solver(system.matrix, Vector(n), x, d); });
  }
}

TEST(Multigrid_solver_traits, fails_with_a_singular_matrix_and_leaves_the_solution)
{
  const Flat_mesh m = grid(30, 30, wavy);
  double d = 0;
  const std::size_t n = m.points.size();

  Sparse_matrix zero_row = edge_matrix(m, Uniform_edge_weights_3());
  for (std::size_t j = 0; j < n; ++j)
    if (zero_row.get_coef(480, j) != 0)
      zero_row.set_coef(480, j, 0);

  Sparse_matrix not_finite = edge_matrix(m, Uniform_edge_weights_3());
  not_finite.set_coef(480, 481, std::numeric_limits<double>::quiet_NaN());

  Sparse_matrix empty_row(n), empty_column(n);
  for (std::size_t i = 0; i < n; ++i) {
    empty_row.add_coef(i == 7 ? 8 : i, i, 1);
    empty_column.add_coef(i, i == 7 ? 8 : i, 1);
  }

  for (const Sparse_matrix& matrix : { Sparse_matrix(n), zero_row, empty_row, empty_column, not_finite }) {
    Solver_on_mesh on(m);
    Vector b(n);
    for (std::size_t i = 0; i < n; ++i)
      b[i] = 1 + double(i % 3);
    expect_failure([&](Vector& x) { return on.solver.linear_solver(matrix, b, x, d); });
  }

  Solver_on_mesh on(m);
  Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
  system.right_side[480] = std::numeric_limits<double>::infinity();
  expect_failure([&](Vector& x) { return on.solver.linear_solver(system.matrix, system.right_side, x, d); });
}

TEST(Multigrid_solver_traits, tells_when_the_direct_solver_took_over)
{
  const Flat_mesh m = delaunay_patch(2000, 1, wavy);
  const Known_system system(edge_matrix(m, Mean_value_edge_weights_3()));
  for (const std::size_t most : { 0, 1 }) {
    Solver_on_mesh on(m, parameters::number_of_iterations(most));
    Vector x;
    double d;
    EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
    EXPECT_LT(system.error(x), 1e-8);
    EXPECT_EQ(on.solver.summary().direct_solutions, 1u);
    EXPECT_EQ(on.solver.summary().right_sides, 1u);
    EXPECT_EQ(on.solver.summary().iterations, most);
    EXPECT_LT(on.solver.summary().residual, 1e-10);
  }
}

// The vertices in the system may be some of the mesh's, in any order, with several unknowns each.
TEST(Multigrid_solver_traits, follows_the_vertex_index_map)
{
  const Flat_mesh m = delaunay_patch(6000, 1, wavy);
  const One_rings rings(m.points.size(), m.triangles);
  Surface_mesh mesh = make<Surface_mesh>(m);
  auto index = mesh.add_property_map<Surface_mesh::Vertex_index, int>("v:index", -1).first;
  std::vector<Index> inner;
  for (Index v = 0; v < m.points.size(); ++v)
    if (!rings.is_border(v))
      inner.push_back(v);
  Random random(4);
  for (std::size_t i = inner.size(); i > 1; --i)
    std::swap(inner[i - 1], inner[random.below(i)]);
  for (std::size_t i = 0; i < inner.size(); ++i)
    index[Surface_mesh::Vertex_index(inner[i])] = int(10 * i);     // gaps do not matter

  for (const std::size_t components : { 1, 2 }) {
    Sparse_matrix matrix(components * inner.size());
    for (std::size_t i = 0; i < inner.size(); ++i)
      for (std::size_t c = 0; c < components; ++c)
        for (const Index w : rings[inner[i]]) {
          matrix.add_coef(components * i + c, components * i + c, 1);
          const int j = index[Surface_mesh::Vertex_index(w)];
          if (j >= 0)
            matrix.add_coef(components * i + c, components * (j / 10) + c, -1);
        }
    Multigrid_solver_traits solver(mesh, longest_border(mesh), index);
    const Known_system system(std::move(matrix));
    Vector x;
    double d;
    EXPECT_TRUE(solver.linear_solver(system.matrix, system.right_side, x, d));
    EXPECT_LT(system.error(x), 1e-8);
    EXPECT_EQ(solver.summary().direct_solutions, 0u);
    EXPECT_LE(solver.summary().iterations, 12u);      // which wrong places of the unknowns would not allow
  }
}

TEST(Multigrid_solver_traits, tells_what_is_wrong_with_the_mesh)
{
  Surface_mesh closed = make<Surface_mesh>(sphere(5, 8));
  Multigrid_solver_traits no_border(closed, *halfedges(closed).begin(), get(CGAL::vertex_index, closed));
  EXPECT_EQ(no_border.error().code, ERROR_WRONG_PARAMETER);
  double d = 0;
  EXPECT_FALSE(no_border.factor(Sparse_matrix(42), d));
  EXPECT_EQ(no_border.summary().setups, 0u);

  Flat_mesh m = grid(5, 5, wavy);
  m.points[9] = Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  Solver_on_mesh no_number(m);
  EXPECT_EQ(no_number.solver.error().code, ERROR_WRONG_PARAMETER);
  EXPECT_EQ(no_number.solver.error().place, Parameterization_error::VERTEX);
  EXPECT_EQ(no_number.solver.error().index, 9u);
}

TEST(Multigrid_solver_traits, solves_for_a_parameterizer_of_CGAL)
{
  typedef Square_border_arc_length_parameterizer_3<Surface_mesh>                                          Border;
  typedef Mean_value_coordinates_parameterizer_3<Surface_mesh, Border>                                    Direct;
  typedef Mean_value_coordinates_parameterizer_3<Surface_mesh, Border, Multigrid_solver_traits>           Multigrid;
  const Flat_mesh m = grid(30, 30, wavy);
  Surface_mesh mesh = make<Surface_mesh>(m);
  const Halfedge bhd = longest_border(mesh);
  const auto vimap = get(CGAL::vertex_index, mesh);
  const auto parameterize = [&](auto&& parameterizer) {
    const auto uvmap = get(CGAL::dynamic_vertex_property_t<Kernel::Point_2>(), mesh);
    const auto vpmap = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
    EXPECT_EQ(parameterizer.parameterize(mesh, bhd, uvmap, vimap, vpmap), OK);
    return uvmap;
  };
  Multigrid_solver_traits solver(mesh, bhd, vimap, parameters::tolerance(1e-12));
  const auto expected = parameterize(Direct()), by_object = parameterize(Multigrid(Border(), solver));
  const Multigrid_solver_traits::Scope scope(solver);
  const auto by_scope = parameterize(Multigrid());
  for (const auto v : vertices(mesh)) {
    EXPECT_LT(CGAL::squared_distance(get(expected, v), get(by_object, v)), 1e-18);
    EXPECT_EQ(get(by_object, v), get(by_scope, v));
  }
  EXPECT_EQ(solver.summary().right_sides, 4u);
  EXPECT_EQ(solver.summary().setups, 2u);
}

} // namespace
