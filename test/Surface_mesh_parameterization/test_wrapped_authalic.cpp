// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's authalic methods in Hierarchical_parameterizer_3: some of their systems are not for multigrid.

#include "mesh_conversions.h"
#include "test_meshes.h"
#include "wrapped_maps.h"

#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>

namespace test_wrapped_authalic {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace wrapped_maps;
namespace parameters = CGAL::parameters;

// ---- systems that are not for multigrid ----

int solutions = 0;

typedef CGAL::Eigen_solver_traits<
    Eigen::BiCGSTAB<CGAL::Eigen_sparse_matrix<double>::EigenType, Eigen::IncompleteLUT<double>>>
    Default_solver;

// CGAL's default solver; counts what it solves.
struct Counting_solver : Default_solver
{
  bool linear_solver(const Matrix& a, const Vector& b, Vector& x, NT& d)
  {
    ++solutions;
    return Default_solver::linear_solver(a, b, x, d);
  }
};

TEST(Wrapped_authalic, takes_its_own_solver_where_weights_are_wild)
{
  typedef Discrete_authalic_parameterizer_3<Surface_mesh, CGAL::Default, Counting_solver> Parameterizer;
  const auto own_solutions = [](const Flat_mesh& m) {
    Surface_mesh mesh = make<Surface_mesh>(m);
    Parameterization_summary summary;
    Wrapped_map<Surface_mesh> expected(mesh), found(mesh);
    EXPECT_EQ(expected.parameterize(Parameterizer(), longest_border(mesh)), OK);
    solutions = 0;
    EXPECT_EQ(found.parameterize(Hierarchical_parameterizer_3<Parameterizer>(
                                     parameters::flip_policy(Flip_policy::KEEP).summary(std::ref(summary))),
                                 longest_border(mesh)),
              OK);
    found.expect_equal(expected, tolerance);
    EXPECT_EQ(summary.linear_solver.direct_solutions, std::size_t(solutions));
    return solutions;
  };
  EXPECT_EQ(own_solutions(grid(14, 14, wavy)), 0);
  EXPECT_EQ(own_solutions(delaunay_patch(700, 3, wavy)), 2);      // u and v
}

// Of which only the user knows how it is made.
struct Solver_with_argument : Default_solver
{
  explicit Solver_with_argument(int /*argument*/) { }
};

TEST(Wrapped_authalic, factorizes_where_it_cannot_make_its_own_solver)
{
  typedef Discrete_authalic_parameterizer_3<Surface_mesh, CGAL::Default, Solver_with_argument> Parameterizer;
  Parameterizer flat(Parameterizer::Border_parameterizer(), Solver_with_argument(1));
  for (const Flat_mesh& m : { grid(14, 14, wavy), delaunay_patch(700, 3, wavy) }) {
    Surface_mesh mesh = make<Surface_mesh>(m);
    Wrapped_map<Surface_mesh> expected(mesh), found(mesh);
    EXPECT_EQ(expected.parameterize(flat, longest_border(mesh)), OK);
    Hierarchical_parameterizer_3<Parameterizer> parameterizer(parameters::flip_policy(Flip_policy::KEEP));
    EXPECT_EQ(found.parameterize(parameterizer, longest_border(mesh)), OK);
    found.expect_equal(expected, tolerance);
  }
}

// Solves nothing, and says that it did.
struct Lying_solver : Default_solver
{
  bool linear_solver(const Matrix&, const Vector&, Vector&, NT& d)
  {
    d = 1;
    return true;
  }
};

TEST(Wrapped_authalic, does_not_believe_its_own_solver)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(700, 3, wavy));
  Parameterization_summary summary;
  expect_equal_maps(mesh, Discrete_authalic_parameterizer_3<Surface_mesh>(),
                    Hierarchical_parameterizer_3<
                        Discrete_authalic_parameterizer_3<Surface_mesh, CGAL::Default, Lying_solver>>(
                        parameters::flip_policy(Flip_policy::KEEP).summary(std::ref(summary))));
  EXPECT_TRUE(summary.converged);
  EXPECT_EQ(summary.linear_solver.direct_solutions, 2u);
  EXPECT_LE(summary.linear_solver.residual, 1e-10);
}

// ---- one that has arguments of its own ----

TEST(Wrapped_iterative_authalic, iterates_as_CGAL_does)
{
  typedef Iterative_authalic_parameterizer_3<Surface_mesh> Parameterizer;
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(700, 3, wavy));
  const auto bhd = longest_border(mesh);
  Wrapped_map<Surface_mesh> expected(mesh), found(mesh);
  Parameterization_summary summary;
  unsigned int iterations = 6, hierarchical_iterations = 6;
  double error = -1, hierarchical_error = -1;
  EXPECT_EQ(expected.parameterize(Parameterizer(), bhd, iterations, error), OK);
  EXPECT_EQ(found.parameterize(Hierarchical_parameterizer_3<Parameterizer>(parameters::summary(std::ref(summary))), bhd,
                               hierarchical_iterations, hierarchical_error),
            OK);
  found.expect_equal(expected, tolerance);
  EXPECT_EQ(hierarchical_iterations, iterations);
  EXPECT_NEAR(hierarchical_error, error, 1e-6);
  EXPECT_EQ(summary.linear_solver.setups, 6u);
  EXPECT_EQ(summary.linear_solver.right_sides, 12u);

  expect_equal_maps(mesh, Parameterizer(), Hierarchical_parameterizer_3<Parameterizer>());
}

// Where a surface is large, its weights become smaller with each iteration, until CGAL's solver does not see them
// beside the rows of the border.
TEST(Wrapped_iterative_authalic, map_depends_neither_on_the_size_of_the_surface_nor_on_the_solver)
{
  typedef Iterative_authalic_parameterizer_3<Surface_mesh> Parameterizer;
  const auto map = [](Surface_mesh& mesh, double size, std::size_t most_iterations) {
    for (const auto v : vertices(mesh))
      mesh.point(v) = CGAL::ORIGIN + size * (mesh.point(v) - CGAL::ORIGIN);
    Parameterization_summary summary;
    const auto np = parameters::flip_policy(Flip_policy::KEEP).summary(std::ref(summary));
    Wrapped_map<Surface_mesh> result(mesh);
    EXPECT_EQ(result.parameterize(Hierarchical_parameterizer_3<Parameterizer>(np.number_of_iterations(most_iterations)),
                                  longest_border(mesh)),
              OK);
    EXPECT_TRUE(summary.converged);
    EXPECT_EQ(summary.linear_solver.failures, 0u);
    EXPECT_EQ(summary.linear_solver.direct_solutions, most_iterations == 0 ? summary.linear_solver.right_sides : 0);
    EXPECT_LE(summary.linear_solver.residual, 1e-10);
    return result;
  };
  for (const std::size_t most_iterations : { 0, 300 }) {
    Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(700, 3, wavy)), large_mesh = mesh;
    map(large_mesh, 1024, most_iterations).expect_equal(map(mesh, 1, 300), tolerance);
  }
}

// Each solution makes the next matrix, so what an iteration leaves grows.
TEST(Wrapped_iterative_authalic, errors_do_not_pile_up)
{
  typedef Iterative_authalic_parameterizer_3<Surface_mesh> Parameterizer;
  Surface_mesh mesh = make<Surface_mesh>(
      delaunay_patch(2000, 1, [](double x, double y) { return 3 * std::exp(-20 * (x * x + y * y)); }));
  Wrapped_map<Surface_mesh> by_factorizations(mesh), found(mesh);
  Parameterization_summary summary;
  const auto np = parameters::flip_policy(Flip_policy::KEEP).summary(std::ref(summary));
  EXPECT_EQ(by_factorizations.parameterize(Hierarchical_parameterizer_3<Parameterizer>(np.number_of_iterations(0)),
                                           longest_border(mesh)),
            OK);
  EXPECT_EQ(found.parameterize(Hierarchical_parameterizer_3<Parameterizer>(np), longest_border(mesh)), OK);
  EXPECT_LT(summary.linear_solver.direct_solutions, summary.linear_solver.right_sides);
  found.expect_equal(by_factorizations, 1e-8);
}

} // namespace test_wrapped_authalic
