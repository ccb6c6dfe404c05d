// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The solutions of a session, which may be put off.

#include "multigrid_systems.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace test_multigrid_session {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace test_systems;

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
  options.most_vain_matrices = 2;
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
  EXPECT_FALSE(is_solved_directly(d.system)) << "multigrid has not been tried in vain";
}

// Finds nothing, and counts how often it is made.
struct Vain_solver : internal::Direct_solver
{
  static inline int made = 0;

  void solve(const double*, double* x, int) const override { *x = std::numeric_limits<double>::quiet_NaN(); }

  static std::unique_ptr<internal::Direct_solver> make(const internal::Sparse_rows<double>&)
  {
    ++made;
    return std::make_unique<Vain_solver>();
  }
};

TEST(Multigrid_session, remembers_what_was_in_vain)
{
  static int made_with_grids;       // so that a function without captures sees it
  made_with_grids = Vain_solver::made = 0;
  internal::Linear_solver_options options;
  options.most_iterations = 0;
  options.make_direct_solver = &Vain_solver::make;
  options.most_vain_matrices = 2;
  const Flat_mesh mesh = grid(30, 30, wavy);
  const auto interpolation =
      std::make_shared<const internal::Hierarchy_interpolation>(surface(mesh), internal::Hierarchy_options());
  Multigrid_session session(interpolation, internal::Mesh_unknowns(interpolation->ranks()), options,
                            [](const internal::Hierarchy_interpolation* hierarchy,
                               std::shared_ptr<const internal::Sparse_rows<double>> rows,
                               std::vector<internal::Mesh_unknown> unknowns, const std::vector<Index>& tied_vertices,
                               const internal::Loops& loops) {
                              made_with_grids += !unknowns.empty();
                              return internal::make_multigrid_linear_solver<1>(
                                  hierarchy, std::move(rows), std::move(unknowns), tied_vertices, loops);
                            });
  for (int i = 1; i <= 4; ++i) {
    const Known_system system(edge_matrix(mesh, Uniform_edge_weights_3()));
    for (int k = 0; k < 3; ++k) {
      Vector x;
      EXPECT_TRUE(session.solve(system.matrix, system.right_side, x));
      EXPECT_LT(system.error(x), 1e-10);
    }
    EXPECT_EQ(session.summary().setups, std::size_t(i));
  }
  EXPECT_EQ(Vain_solver::made, 1);
  EXPECT_EQ(made_with_grids, 2);
}

} // namespace test_multigrid_session
