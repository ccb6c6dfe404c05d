// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What Multigrid_solver_traits finds out about matrices and meshes: what is wrong with them, and what has no solution.

#include "mesh_conversions.h"
#include "multigrid_systems.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_system.h>

#include <CGAL/boost/graph/properties.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

namespace test_multigrid_solver_input {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace test_systems;

// The solution of a call that fails must be as it was.
template <class Call>
void expect_failure(const Call& call)
{
  Vector x(3);
  for (int i = 0; i < 3; ++i)
    x[i] = i + 0.5;
  EXPECT_FALSE(call(x));
  ASSERT_EQ(x.size(), 3u);
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
    EXPECT_EQ(on.solver.summary().failures, 1u);
    EXPECT_EQ(on.solver.summary().residual, 0);
  }

  Solver_on_mesh on(m);
  Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
  system.right_side[480] = std::numeric_limits<double>::infinity();
  expect_failure([&](Vector& x) { return on.solver.linear_solver(system.matrix, system.right_side, x, d); });
}

// Of a Laplacian matrix whose values are given nowhere, a right side must have the sum 0.
TEST(Multigrid_solver_traits, fails_where_there_is_no_solution)
{
  for (const Flat_mesh& m : { grid(3, 3, wavy), grid(30, 30, wavy), delaunay_patch(2000, 1, wavy) }) {
    const std::size_t n = m.points.size();
    Sparse_matrix laplacian(n);
    for (const auto& t : m.triangles)
      for (int i = 0; i < 3; ++i) {
        laplacian.add_coef(t[i], t[i], 2);
        laplacian.add_coef(t[i], t[(i + 1) % 3], -1);
        laplacian.add_coef(t[(i + 1) % 3], t[i], -1);
      }
    Vector b(n);
    Random random(5);
    for (std::size_t i = 0; i < n; ++i)
      b[i] = random(-1, 2);
    Solver_on_mesh on(m);
    double d;
    expect_failure([&](Vector& x) { return on.solver.linear_solver(laplacian, b, x, d); });
    EXPECT_EQ(on.solver.summary().failures, 1u);
  }
}

// A matrix that lacks one entry of a symmetric one, above the diagonal or below, or has another value there.
TEST(Mesh_system, tells_symmetric_matrices_from_others)
{
  const auto is_symmetric = [](Index row, Index column, double change) {
    auto rows = std::make_shared<internal::Sparse_rows<double>>();
    for (Index i = 0; i < 4; ++i) {
      internal::Sparse_row entries;
      for (Index j = 0; j < 4; ++j)
        if (const double value = (i == j ? 4 : -1) + (i == row && j == column ? change : 0); value != 0)
          entries.push_back({ j, value });
      rows->append(entries);
    }
    return internal::Mesh_system(nullptr, rows, {}).is_symmetric();
  };
  EXPECT_TRUE(is_symmetric(0, 0, 1));
  for (const double change : { 1., 0.5 })
    for (Index i = 0; i < 4; ++i)
      for (Index j = 0; j < 4; ++j)
        if (i != j) {
          EXPECT_FALSE(is_symmetric(i, j, change)) << i << ' ' << j;
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

} // namespace test_multigrid_solver_input
