// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Systems that multigrid does not solve, or not alone.

#include "generated_meshes.h"
#include "hostile_meshes.h"
#include "mesh_conversions.h"
#include "multigrid_systems.h"
#include "test_meshes.h"
#include "wrapped_maps.h"

#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

namespace test_direct_solutions {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace test_systems;
using namespace wrapped_maps;
namespace parameters = CGAL::parameters;

TEST(Multigrid_solver_traits_of_hard_systems, tells_when_the_direct_solver_took_over)
{
  const Flat_mesh m = delaunay_patch(2000, 1, wavy);
  const Known_system system(edge_matrix(m, Mean_value_edge_weights_3()));
  for (const std::size_t most : { 0, 1 }) {
    Solver_on_mesh on(m, parameters::number_of_iterations(most));
    expect_solved(on.solver, system);
    EXPECT_EQ(on.solver.summary().direct_solutions, 1u);
    EXPECT_EQ(on.solver.summary().right_sides, 1u);
    EXPECT_EQ(on.solver.summary().iterations, most);
    EXPECT_LT(on.solver.summary().residual, 1e-10);
  }
}

// Of which the pivots of a factorization must not be chosen by size.
TEST(Multigrid_solver_traits_of_hard_systems, solves_rows_of_very_different_size_directly)
{
  const Flat_mesh m = delaunay_patch(2000, 1, wavy);
  const auto rows = edge_matrix(m, Mean_value_edge_weights_3()).rows();
  Sparse_matrix matrix(rows->number_of_rows());
  for (Index i = 0; i < rows->number_of_rows(); ++i)
    for (Index k = rows->first[i]; k < rows->first[i + 1]; ++k)
      matrix.add_coef(i, rows->columns[k], std::pow(10, -double(i % 41)) * rows->values[k]);
  const Known_system system(std::move(matrix));
  Solver_on_mesh on(m, parameters::number_of_iterations(0));
  expect_solved(on.solver, system);
  EXPECT_LT(on.solver.summary().residual, 1e-10);
  EXPECT_EQ(on.solver.summary().failures, 0u);
}

TEST(Multigrid_solver_traits_of_hard_systems, solves_directly_what_has_0_on_the_diagonal)
{
  const double x[3] = { 1, -2, 3 };
  for (const bool is_stored : { false, true }) {
    internal::Sparse_matrix a(3);
    if (is_stored)
      a.set_coef(0, 0, 0, true);
    a.set_coef(0, 1, 1, true);
    a.set_coef(1, 0, 2, true);
    a.set_coef(1, 1, 1, true);
    a.set_coef(2, 2, 3, true);
    const auto solver = internal::make_multigrid_linear_solver<1>(nullptr, a.rows(), {}, {}, internal::Loops());
    const double b[3] = { x[1], 2 * x[0] + x[1], 3 * x[2] };
    double found[3];
    EXPECT_TRUE(solver->solve({ b }, { found }, internal::Linear_solver_options()).is_solved);
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(found[i], x[i], 1e-14);
  }
}

// Such a diagonal must not scale its row. The third row says that two unknowns are equal.
TEST(Multigrid_solver_traits_of_hard_systems, solves_directly_what_has_next_to_nothing_on_the_diagonal)
{
  for (const double nothing : { 0., 1e-12, -1e-18, 1e-100 })
    for (const double scale : { 1., 1e-150, 1e150 }) {
      internal::Sparse_matrix a(3);
      a.set_coef(0, 0, 2, true);
      a.set_coef(0, 2, 1, true);
      a.set_coef(1, 1, 2, true);
      a.set_coef(1, 2, -1, true);
      a.set_coef(2, 0, scale, true);
      a.set_coef(2, 1, -scale, true);
      a.set_coef(2, 2, nothing * scale, true);
      const auto solver = internal::make_multigrid_linear_solver<1>(nullptr, a.rows(), {}, {}, internal::Loops());
      const double b[3] = { 0.1, 0.3, 0 }, x[3] = { 0.1, 0.1, -0.1 };
      double found[3] = {};
      EXPECT_TRUE(solver->solve({ b }, { found }, internal::Linear_solver_options()).is_solved)
          << nothing << ' ' << scale;
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(found[i], x[i], 1e-10);
    }
}

// The unknowns of which sit elsewhere than the vertex index map says.
TEST(Multigrid_solver_traits_of_hard_systems, solves_directly_what_does_not_match_the_mesh)
{
  const Flat_mesh m = delaunay_patch(2000, 1, wavy);
  const Sparse_matrix matrix = edge_matrix(m, Uniform_edge_weights_3());
  const auto rows = matrix.rows();
  const Index n = rows->number_of_rows();
  Sparse_matrix moved(n);
  for (Index i = 0; i < n; ++i)
    for (Index k = rows->first[i]; k < rows->first[i + 1]; ++k)
      moved.add_coef((i + n / 2) % n, (rows->columns[k] + n / 2) % n, rows->values[k]);
  const Known_system system(std::move(moved));
  Solver_on_mesh on(m);
  expect_solved(on.solver, system);
  EXPECT_EQ(on.solver.summary().direct_solutions, 1u);
  EXPECT_EQ(on.solver.summary().iterations, 0u);
}

// Were these diagonal entries pivots, most digits would be lost.
TEST(Direct_solver, is_exact_where_the_diagonal_is_small)
{
  constexpr Index n = 60;
  Random random(3);
  for (int trial = 0; trial < 10; ++trial) {
    Sparse_matrix matrix(n * n);
    for (Index i = 0; i < n * n; ++i) {
      matrix.add_coef(i, i, trial % 5 == 0 ? 0 : 2e-3);
      for (const Index j : { i + 1, i + n })
        if (j < n * n && (j % n > 0 || j == i + n)) {
          matrix.add_coef(i, j, random(-1, 1));
          matrix.add_coef(j, i, random(-1, 1));
        }
    }
    const Known_system system(std::move(matrix));
    const auto solver =
        internal::make_multigrid_linear_solver<1>(nullptr, system.matrix.rows(), {}, {}, internal::Loops());
    Vector x(n * n);
    const internal::Linear_solver_result result = solver->solve(
        { system.right_side.values().data() }, { x.values().data() }, internal::Linear_solver_options());
    EXPECT_TRUE(result.is_solved);
    EXPECT_LT(result.residual, 1e-13);
  }
}

// One value that is given is so large that next to it all others are nothing. They are found all the same.
TEST(Multigrid_solver_traits_of_hard_systems, given_values_do_not_hide_what_is_not_solved_yet)
{
  const Flat_mesh m = delaunay_patch(2000, 1, wavy);
  const auto rows = edge_matrix(m, Mean_value_edge_weights_3()).rows();
  const Index n = rows->number_of_rows();
  Index given = 0;
  while (rows->first[given + 1] - rows->first[given] > 1)
    ++given;
  Sparse_matrix matrix(n);
  for (Index i = 0; i < n; ++i)
    for (Index k = rows->first[i]; k < rows->first[i + 1]; ++k)
      if (i == given || rows->columns[k] != given)
        matrix.add_coef(i, rows->columns[k], rows->values[k]);
  Known_system system(std::move(matrix));
  constexpr double large = 1e13;
  system.right_side[given] *= large / system.expected[given];
  system.expected[given] = large;
  Solver_on_mesh on(m, parameters::number_of_iterations(1));
  Vector x;
  double d;
  EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
  x[given] = large;
  EXPECT_LT(system.error(x), 1e-8);
}

// ---- vertices of high valence ----

// Two unknowns at each vertex of a grid: all of them, without an entry between two vertices, and with an unknown before
// the others, which are not numbered in pairs then, or behind them.
TEST(Direct_solver, takes_unknowns_in_pairs_and_others)
{
  constexpr Index n = 12;
  enum Kind { ALL, WITHOUT_ONE_ENTRY, ONE_BEFORE, ONE_BEHIND };
  for (const Kind kind : { ALL, WITHOUT_ONE_ENTRY, ONE_BEFORE, ONE_BEHIND }) {
    const Index first = kind == ONE_BEFORE, size = 2 * n * n + (kind == ONE_BEFORE || kind == ONE_BEHIND);
    Random random(kind);
    Sparse_matrix matrix(size);
    for (Index i = 0; i < size; ++i)
      matrix.add_coef(i, i, 20);
    const auto add = [&](Index i, Index j) {
      const double a = random(-1, 1);
      matrix.add_coef(i, j, a);
      matrix.add_coef(j, i, a);
    };
    for (Index v = 0; v < n * n; ++v) {
      add(first + 2 * v, first + 2 * v + 1);
      for (const Index w : { v + 1, v + n })
        if (w < n * n)
          for (Index c = 0; c < 4; ++c)
            if (!(kind == WITHOUT_ONE_ENTRY && v == n && c == 1))
              add(first + 2 * v + c / 2, first + 2 * w + c % 2);
    }
    const Known_system system(std::move(matrix));
    const auto solver = internal::factorize_symmetric_rows(*system.matrix.rows());
    ASSERT_TRUE(solver);
    Vector x(size);
    solver->solve(system.right_side.values().data(), x.values().data(), 1);
    EXPECT_LT(system.error(x), 1e-13) << kind;
  }
}

// Rings around a hub, whose edges weigh much more than those between the rings; values are given on the outer one. In
// its column they exceed the diagonal, but as pivots they would fill the matrix, which would take tens of gigabytes.
TEST(Direct_solver, fills_nothing_around_a_hub)
{
  constexpr Index n = 40000, rings = 4, size = 1 + n * rings;
  constexpr double weight = 3000, radial_weight = 1e-4;
  Sparse_matrix matrix(size);
  const auto add_edge = [&](Index i, Index j, double w) {
    for (const auto& [k, l] : { std::make_pair(i, j), std::make_pair(j, i) })
      if (k < size - n) {
        matrix.add_coef(k, k, w);
        matrix.add_coef(k, l, -w);
      }
  };
  for (Index i = 0; i < n; ++i)
    for (Index r = 0; r < rings; ++r) {
      const Index v = 1 + r * n + i;
      add_edge(v, 1 + r * n + (i + 1) % n, weight);
      add_edge(v, r == 0 ? 0 : v - n, radial_weight);
    }
  for (Index v = size - n; v < size; ++v)
    matrix.add_coef(v, v, 1);
  const Known_system system(std::move(matrix));
  const auto solver = internal::factorize_rows(*system.matrix.rows());
  ASSERT_TRUE(solver);
  Vector x(size);
  solver->solve(system.right_side.values().data(), x.values().data(), 1);
  EXPECT_LT(system.error(x), 1e-4);
}

// The weights of its edges are so different that no residual is below the tolerance: rounding alone makes one. The
// iteration is at the end of doubles all the same.
TEST(Discrete_conformal_map, around_a_hub_is_found_without_a_factorization)
{
  typedef Discrete_conformal_map_parameterizer_3<Surface_mesh>   Conformal;
  Surface_mesh mesh = make<Surface_mesh>(flat_mesh(hostile_meshes::wheel(15000, 2, 0.3)));
  Parameterization_summary summary;
  Wrapped_map<Surface_mesh> expected(mesh), found(mesh);
  EXPECT_EQ(expected.parameterize(Conformal(), longest_border(mesh)), OK);
  EXPECT_EQ(found.parameterize(Hierarchical_parameterizer_3<Conformal>(parameters::summary(std::ref(summary))),
                               longest_border(mesh)),
            OK);
  found.expect_equal(expected, 1e-8);
  EXPECT_GT(summary.linear_solver.residual, 1e-10);
  EXPECT_EQ(summary.linear_solver.direct_solutions, 0u);
}

} // namespace test_direct_solutions
