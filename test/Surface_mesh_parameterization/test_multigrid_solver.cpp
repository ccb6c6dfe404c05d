// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Multigrid_solver_traits as a user has it.

#include "mesh_conversions.h"
#include "multigrid_systems.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace test_multigrid_solver {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace test_systems;
namespace parameters = CGAL::parameters;

typedef boost::graph_traits<Surface_mesh>::halfedge_descriptor   Halfedge;

// ---- solutions ----

TEST(Multigrid_solver_traits, solves_what_sits_on_a_mesh)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    Solver_on_mesh on(m);
    for (const bool is_symmetric : { true, false }) {
      Sparse_matrix matrix =
          is_symmetric ? edge_matrix(m, Uniform_edge_weights_3()) : edge_matrix(m, Mean_value_edge_weights_3());
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

TEST(Multigrid_solver_traits, solution_may_replace_the_right_side)
{
  const Flat_mesh m = grid(20, 20, wavy);
  const Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
  for (const std::size_t most_iterations : { 300, 0 }) {      // and by the direct solver
    Solver_on_mesh on(m, parameters::number_of_iterations(most_iterations));
    Vector x = system.right_side;
    double d;
    EXPECT_TRUE(on.solver.linear_solver(system.matrix, x, x, d));
    EXPECT_LT(system.error(x), 1e-8);
  }
}

// With one more vertex in the middle of each triangle.
Flat_mesh with_centers(const Flat_mesh& m)
{
  Flat_mesh result{ m.points, {} };
  for (const auto& t : m.triangles) {
    const Index center = Index(result.points.size());
    result.points.push_back(CGAL::centroid(m.points[t[0]], m.points[t[1]], m.points[t[2]]));
    for (int i = 0; i < 3; ++i)
      result.triangles.push_back({ t[i], t[(i + 1) % 3], center });
  }
  return result;
}

// Whose coarse levels, all or the first one, have no vertex that is not on the border.
TEST(Multigrid_solver_traits, solves_where_coarse_levels_have_no_unknown)
{
  for (const Flat_mesh& m :
       { grid(1500, 2, wavy), grid(700, 3, wavy), grid_with_holes(60), with_centers(strip(800)) }) {
    Solver_on_mesh on(m, parameters::coarsest_size(5));
    const Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
    Vector x;
    double d;
    EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
    EXPECT_LT(system.error(x), 1e-6);
    EXPECT_EQ(on.solver.summary().direct_solutions, 0u);
  }
}

// Not even one whose squares a double cannot hold.
TEST(Multigrid_solver_traits, feels_no_scale)
{
  const Flat_mesh m = grid(20, 20, wavy);
  const Sparse_matrix matrix = edge_matrix(m, Mean_value_edge_weights_3());
  const auto rows = matrix.rows();
  for (const auto& [scale_of_matrix, scale_of_solution] :
       { std::make_pair(1., 1e-170), { 1., 1e170 }, { 1e-200, 1. }, { 1e200, 1. }, { 1e200, 1e-200 } }) {
    SCOPED_TRACE(std::to_string(std::log10(scale_of_matrix)) + " " + std::to_string(std::log10(scale_of_solution)));
    Sparse_matrix scaled(matrix.row_dimension());
    for (Index i = 0; i < rows->number_of_rows(); ++i)
      for (Index k = rows->first[i]; k < rows->first[i + 1]; ++k)
        scaled.set_coef(i, rows->columns[k], scale_of_matrix * rows->values[k], true);
    Known_system system(std::move(scaled));
    for (int i = 0; i < matrix.row_dimension(); ++i)
      system.right_side[i] *= scale_of_solution;
    Solver_on_mesh on(m);
    Vector x;
    double d;
    EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] /= scale_of_solution;
    EXPECT_LT(system.error(x), 1e-8);
    EXPECT_EQ(on.solver.summary().direct_solutions, 0u);
  }
}

// The system with its rows negated, but for those that give a value.
Known_system negative(const Known_system& system)
{
  Known_system result = system;
  const auto rows = system.matrix.rows();
  for (Index i = 0; i < rows->number_of_rows(); ++i)
    if (rows->first[i + 1] - rows->first[i] > 1) {
      result.right_side[i] *= -1;
      for (Index k = rows->first[i]; k < rows->first[i + 1]; ++k)
        result.matrix.set_coef(i, rows->columns[k], -rows->values[k]);
    }
  return result;
}

// Which many assemble from a Laplacian matrix.
TEST(Multigrid_solver_traits, solves_the_negative_of_a_system_in_the_same_way)
{
  const Flat_mesh m = grid(30, 30, wavy);
  for (Sparse_matrix matrix :
       { edge_matrix(m, Uniform_edge_weights_3()), edge_matrix(m, Mean_value_edge_weights_3()) }) {
    const Known_system system(std::move(matrix)), negated = negative(system);
    Solver_on_mesh on(m), on_negated(m);
    Vector x, x_of_negated;
    double d;
    EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
    EXPECT_TRUE(on_negated.solver.linear_solver(negated.matrix, negated.right_side, x_of_negated, d));
    EXPECT_EQ(x.values(), x_of_negated.values());
    EXPECT_EQ(on.solver.summary().iterations, on_negated.solver.summary().iterations);
    EXPECT_EQ(on_negated.solver.summary().direct_solutions, 0u);
  }
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

// ---- failures ----

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

// Of which the pivots of a factorization must not be chosen by size.
TEST(Multigrid_solver_traits, solves_rows_of_very_different_size_directly)
{
  const Flat_mesh m = delaunay_patch(2000, 1, wavy);
  const auto rows = edge_matrix(m, Mean_value_edge_weights_3()).rows();
  Sparse_matrix matrix(rows->number_of_rows());
  for (Index i = 0; i < rows->number_of_rows(); ++i)
    for (Index k = rows->first[i]; k < rows->first[i + 1]; ++k)
      matrix.add_coef(i, rows->columns[k], std::pow(10, -double(i % 41)) * rows->values[k]);
  const Known_system system(std::move(matrix));
  Solver_on_mesh on(m, parameters::number_of_iterations(0));
  Vector x;
  double d;
  EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
  EXPECT_LT(system.error(x), 1e-8);
  EXPECT_LT(on.solver.summary().residual, 1e-10);
  EXPECT_EQ(on.solver.summary().failures, 0u);
}

TEST(Multigrid_solver_traits, solves_directly_what_has_0_on_the_diagonal)
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
    const auto solver = internal::make_multigrid_linear_solver<1>(nullptr, a.rows(), {}, {});
    const double b[3] = { x[1], 2 * x[0] + x[1], 3 * x[2] };
    double found[3];
    EXPECT_TRUE(solver->solve({ b }, { found }, internal::Linear_solver_options()).is_solved);
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(found[i], x[i], 1e-14);
  }
}

// Such a diagonal must not scale its row. The third row says that two unknowns are equal.
TEST(Multigrid_solver_traits, solves_directly_what_has_next_to_nothing_on_the_diagonal)
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
      const auto solver = internal::make_multigrid_linear_solver<1>(nullptr, a.rows(), {}, {});
      const double b[3] = { 0.1, 0.3, 0 }, x[3] = { 0.1, 0.1, -0.1 };
      double found[3] = {};
      EXPECT_TRUE(solver->solve({ b }, { found }, internal::Linear_solver_options()).is_solved)
          << nothing << ' ' << scale;
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(found[i], x[i], 1e-10);
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

// The unknowns of which sit elsewhere than the vertex index map says.
TEST(Multigrid_solver_traits, solves_directly_what_does_not_match_the_mesh)
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
  Vector x;
  double d;
  EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
  EXPECT_LT(system.error(x), 1e-8);
  EXPECT_EQ(on.solver.summary().direct_solutions, 1u);
  EXPECT_EQ(on.solver.summary().iterations, 0u);
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

// ---- solutions that are put off ----

using internal::Multigrid_session;

// A session that puts solutions off, and a system on its mesh with two right sides.
struct Deferring
{
  Flat_mesh mesh = grid(30, 30, wavy);
  std::unique_ptr<Multigrid_session> session;
  Known_system system{ edge_matrix(mesh, Uniform_edge_weights_3()) };
  Vector second_right_side, second_expected;

  explicit Deferring(const internal::Linear_solver_options& options = internal::Linear_solver_options())
    : second_right_side(system.right_side), second_expected(system.expected)
  {
    const auto interpolation =
        std::make_shared<const internal::Hierarchy_interpolation>(surface(mesh), internal::Hierarchy_options());
    session = std::make_unique<Multigrid_session>(interpolation, internal::Mesh_unknowns(interpolation->ranks()),
                                                  options, &internal::make_multigrid_linear_solver<2>, true);
    for (std::size_t i = 0; i < second_right_side.size(); ++i) {
      second_right_side[i] *= -3;
      second_expected[i] *= -3;
    }
  }

  bool solve_first(Vector& x) { return session->solve(system.matrix, system.right_side, x); }
  bool solve_second(Vector& x) { return session->solve(system.matrix, second_right_side, x); }

  static bool are_near(const Vector& x, const Vector& expected)
  {
    bool result = x.size() == expected.size();
    for (std::size_t i = 0; i < expected.size() && result; ++i)
      result = std::abs(x[i] - expected[i]) < 1e-7;
    return result;
  }

  bool is_first(const Vector& x) const { return are_near(x, system.expected); }
  bool is_second(const Vector& x) const { return are_near(x, second_expected); }
};

TEST(Deferred_solution, is_found_with_the_second)
{
  Deferring d;
  Vector x, y;
  EXPECT_TRUE(d.solve_first(x));
  EXPECT_EQ(d.session->summary().right_sides, 0u) << "it is put off";
  EXPECT_TRUE(d.solve_second(y));
  EXPECT_EQ(d.session->summary().right_sides, 2u);
  EXPECT_TRUE(d.is_first(x));
  EXPECT_TRUE(d.is_second(y));
  EXPECT_TRUE(d.session->finish());
  EXPECT_EQ(d.session->summary().setups, 1u);
}

TEST(Deferred_solution, that_is_read_before_the_second_right_side_is_right)
{
  Deferring d;
  Vector x, y;
  EXPECT_TRUE(d.solve_first(x));
  EXPECT_TRUE(d.is_first(x));
  EXPECT_EQ(d.session->summary().right_sides, 1u);
  EXPECT_TRUE(d.solve_second(y));
  EXPECT_TRUE(d.is_second(y));
  EXPECT_TRUE(d.is_first(x));
  EXPECT_EQ(d.session->summary().right_sides, 2u);
  EXPECT_TRUE(d.session->finish());
}

TEST(Deferred_solution, has_right_copies)
{
  Deferring d;
  Vector x, assigned, y;
  EXPECT_TRUE(d.solve_first(x));
  const Vector copy = x;
  assigned = x;
  EXPECT_TRUE(d.is_first(copy));
  EXPECT_TRUE(d.is_first(assigned));
  EXPECT_TRUE(d.is_first(x));

  EXPECT_TRUE(d.solve_second(y));
  const Vector moved = std::move(y);
  EXPECT_TRUE(d.is_second(moved));
  EXPECT_TRUE(d.is_first(copy)) << "copies share nothing";
}

TEST(Deferred_solution, has_its_size_at_once)
{
  Deferring d;
  Vector x, longer(5000);
  EXPECT_TRUE(d.solve_first(x));
  EXPECT_EQ(x.size(), d.system.expected.size());
  EXPECT_TRUE(d.session->finish());
  EXPECT_TRUE(d.solve_first(longer));
  EXPECT_EQ(longer.dimension(), d.system.expected.dimension());
}

TEST(Deferred_solution, survives_the_session)
{
  Deferring d;
  Vector x;
  EXPECT_TRUE(d.solve_first(x));
  d.session.reset();
  EXPECT_TRUE(d.is_first(x));
}

TEST(Deferred_solution, may_be_destroyed_before_it_is_found)
{
  Deferring d;
  {
    Vector lost;
    EXPECT_TRUE(d.solve_first(lost));
  }
  Vector y, z;
  EXPECT_TRUE(d.solve_second(y));
  EXPECT_TRUE(d.is_second(y));
  {
    Vector lost;
    EXPECT_TRUE(d.solve_first(lost));
  }
  EXPECT_TRUE(d.session->finish());
  EXPECT_TRUE(d.solve_second(z));
  {
    Vector lost;
    EXPECT_TRUE(d.solve_first(lost));
  }
  EXPECT_TRUE(d.is_second(z));
  {
    Vector lost;
    EXPECT_TRUE(d.solve_first(lost));
  }
  d.session.reset();
}

TEST(Deferred_solution, may_be_written_to)
{
  Deferring d;
  Vector x;
  EXPECT_TRUE(d.solve_first(x));
  x[7] = 1000;
  EXPECT_TRUE(d.session->finish());
  EXPECT_EQ(x[7], 1000);
  x[7] = d.system.expected[7];
  EXPECT_TRUE(d.is_first(x));
}

TEST(Deferred_solution, may_go_where_the_first_one_is)
{
  Deferring d;
  Vector x;
  EXPECT_TRUE(d.solve_first(x));
  EXPECT_TRUE(d.solve_second(x));
  EXPECT_TRUE(d.is_second(x));
}

TEST(Deferred_solution, may_wait_for_another_session)
{
  Deferring d, other;
  Vector x;
  EXPECT_TRUE(d.solve_first(x));
  EXPECT_TRUE(other.solve_second(x));
  EXPECT_TRUE(d.session->finish());
  EXPECT_TRUE(d.is_second(x));
  EXPECT_TRUE(other.session->finish());
}

TEST(Deferred_solution, is_not_spoilt_by_a_right_side_of_wrong_size)
{
  Deferring d;
  Vector x, y(3);
  EXPECT_FALSE(d.session->solve(d.system.matrix, Vector(7), y));
  EXPECT_TRUE(d.solve_first(x));
  EXPECT_FALSE(d.session->solve(d.system.matrix, Vector(7), y));
  EXPECT_EQ(y.size(), 3u);
  EXPECT_TRUE(d.is_first(x));
  EXPECT_TRUE(d.session->finish());
}

// As in an inverse iteration.
TEST(Deferred_solution, may_be_the_next_right_side)
{
  Deferring d;
  Vector x, y;
  EXPECT_TRUE(d.solve_first(x));
  ASSERT_TRUE(d.session->solve(d.system.matrix, x, y));
  const auto rows = d.system.matrix.rows();
  for (Index i = 0; i < rows->number_of_rows(); ++i) {
    double product = 0;
    for (Index k = rows->first[i]; k < rows->first[i + 1]; ++k)
      product += rows->values[k] * y[rows->columns[k]];
    ASSERT_NEAR(product, d.system.expected[i], 1e-7);
  }
}

TEST(Deferred_solution, belongs_to_the_matrix_that_it_was_asked_for)
{
  Deferring d;
  Vector x, y;
  EXPECT_TRUE(d.solve_first(x));
  Sparse_matrix& matrix = d.system.matrix;
  matrix.set_coef(200, 200, 100 + matrix.get_coef(200, 200));
  const Known_system changed(matrix);
  EXPECT_TRUE(d.session->solve(matrix, changed.right_side, y));
  EXPECT_TRUE(d.is_first(x));
  EXPECT_LT(changed.error(y), 1e-7);
  EXPECT_EQ(d.session->summary().setups, 2u);
}

TEST(Deferred_solution, tells_at_the_end_that_it_could_not_be_found)
{
  Deferring d;
  for (const bool is_read : { false, true }) {
    Vector x, y, b = d.system.right_side;
    b[480] = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(d.session->solve(d.system.matrix, b, x));
    if (is_read) {
      EXPECT_FALSE(d.is_first(x));
    } else {
      EXPECT_FALSE(d.solve_second(y));
      EXPECT_FALSE(d.is_first(x));
    }
  }
  EXPECT_FALSE(d.session->finish());
}

// ---- what is not for multigrid ----

TEST(Multigrid_session, finds_the_negative_of_a_matrix_no_wilder)
{
  internal::Linear_solver_options options;
  options.greatest_row_sum = 2;
  Deferring d(options);
  const auto is_solved_directly = [&d](const Known_system& system) {
    const std::size_t before = d.session->summary().direct_solutions;
    Vector x;
    EXPECT_TRUE(d.session->solve(system.matrix, system.right_side, x));
    EXPECT_LT(system.error(x), 1e-7);
    return d.session->summary().direct_solutions > before;
  };
  EXPECT_FALSE(is_solved_directly(d.system));
  EXPECT_FALSE(is_solved_directly(negative(d.system)));

  Sparse_matrix wild = d.system.matrix;       // indefinite
  for (int i = 0; i < wild.row_dimension(); ++i)
    if (i % 2 == 0)
      wild.add_coef(i, i, -0.6 * wild.get_coef(i, i));
  const Known_system wild_system(wild);
  EXPECT_TRUE(is_solved_directly(wild_system));
  EXPECT_TRUE(is_solved_directly(negative(wild_system)));
}

// ---- users ----

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

// As those of smooth surfaces, which couple each vertex with neighbors of its neighbors.
TEST(Multigrid_solver_traits, iterates_with_wide_stencils)
{
  const Flat_mesh m = delaunay_patch(3000, 1, wavy);
  const auto rows = edge_matrix(m, Uniform_edge_weights_3()).rows();
  Sparse_matrix square(rows->number_of_rows());
  for (Index i = 0; i < rows->number_of_rows(); ++i)
    for (Index k = rows->first[i]; k < rows->first[i + 1]; ++k)
      for (Index l = rows->first[rows->columns[k]]; l < rows->first[rows->columns[k] + 1]; ++l)
        square.add_coef(i, rows->columns[l], rows->values[k] * rows->values[l]);
  const Known_system system(std::move(square));
  Solver_on_mesh on(m);
  Vector x;
  double d;
  EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
  EXPECT_LT(system.error(x), 1e-5);
  EXPECT_GT(on.solver.summary().iterations, 0u);
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

} // namespace test_multigrid_solver
