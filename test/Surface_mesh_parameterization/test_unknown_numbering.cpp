// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Parameterizers that number the unknowns of their systems as they like.

#include "mesh_conversions.h"
#include "test_meshes.h"
#include "wrapped_maps.h"

#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Two_vertices_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Origin.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace test_unknown_numbering {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace wrapped_maps;
namespace parameters = CGAL::parameters;

typedef Two_vertices_parameterizer_3<Surface_mesh>   Two_vertices;

// ---- orders: the new numbers of n unknowns ----

struct As_it_is
{
  static std::vector<Index> numbers(Index n)
  {
    std::vector<Index> result(n);
    std::iota(result.begin(), result.end(), Index(0));
    return result;
  }
};

struct Shuffled
{
  static std::vector<Index> numbers(Index n)
  {
    std::vector<Index> result = As_it_is::numbers(n);
    Random random(5);
    for (Index i = n; i > 1; --i)
      std::swap(result[i - 1], result[random.below(i)]);
    return result;
  }
};

struct Even_ones_first
{
  static std::vector<Index> numbers(Index n)
  {
    std::vector<Index> result(n);
    for (Index i = 0; i < n; ++i)
      result[i] = i / 2 + (i % 2 == 0 ? 0 : (n + 1) / 2);
    return result;
  }
};

// A solver that numbers the unknowns anew before it hands them on.
template <class Order, class Solver>
struct Renumbering_solver : Solver
{
  typedef typename Solver::Matrix   Matrix;
  typedef typename Solver::Vector   Vector;

  bool linear_solver(const Matrix& matrix, const Vector& right_side, Vector& x, double& d)
  {
    const auto rows = matrix.rows();
    const Index n = rows->number_of_rows();
    const std::vector<Index> number = Order::numbers(n);
    Matrix renumbered(n);
    Vector b(n), y(n);
    for (Index i = 0; i < n; ++i) {
      b[number[i]] = right_side[i];
      for (Index k = rows->first[i]; k < rows->first[i + 1]; ++k)
        renumbered.set_coef(number[i], number[rows->columns[k]], rows->values[k], true);
    }
    if (!Solver::linear_solver(renumbered, b, y, d))
      return false;
    for (Index i = 0; i < n; ++i)
      x[i] = y[number[i]];
    return true;
  }
};

// ---- parameterizers with such a solver ----

// One unknown for each vertex, two right sides.
template <class Mesh, class Order, class Solver>
struct Mean_value_of
  : Mean_value_coordinates_parameterizer_3<Mesh, Circular_border_arc_length_parameterizer_3<Mesh>,
                                           Renumbering_solver<Order, Solver>>
{
};

// Two unknowns for each vertex but the pinned ones. Only CGAL's own class is known to copy its solution.
template <class Mesh, class Order, class Solver>
struct LSCM_of
  : LSCM_parameterizer_3<Mesh, Two_vertices_parameterizer_3<Mesh>, Renumbering_solver<Order, Solver>>
{
};

// Counts how often it is called.
template <class Mesh, class Order, class Solver>
struct Counted_mean_value : Mean_value_of<Mesh, Order, Solver>
{
  template <class UVMap, class IndexMap, class ParameterizedMap>
  Error_code parameterize(Mesh& mesh, Halfedge<Mesh> bhd, UVMap uvmap, IndexMap vimap, ParameterizedMap vpmap,
                          int& calls)
  {
    ++calls;
    return Mean_value_of<Mesh, Order, Solver>::parameterize(mesh, bhd, uvmap, vimap, vpmap);
  }
};

// Does not copy the solution.
template <class Mesh, class Order, class Solver>
struct Double_mean_value : Mean_value_of<Mesh, Order, Solver>
{
  template <class UVMap, class IndexMap, class ParameterizedMap>
  Error_code parameterize(Mesh& mesh, Halfedge<Mesh> bhd, UVMap uvmap, IndexMap vimap, ParameterizedMap vpmap)
  {
    const Error_code code = Mean_value_of<Mesh, Order, Solver>::parameterize(mesh, bhd, uvmap, vimap, vpmap);
    for (const auto v : vertices(mesh))
      put(uvmap, v, CGAL::ORIGIN + 2 * (get(uvmap, v) - CGAL::ORIGIN));
    return code;
  }
};

// ---- runs ----

// A mesh with its map by an adaptor.
struct Parameterized
{
  Surface_mesh mesh = make<Surface_mesh>(cap(105, 100, 0.5 * CGAL_PI));      // more than a grid of complex unknowns
  Wrapped_map<Surface_mesh> mapped{ mesh };
  Parameterization_summary summary;

  Parameterized() = default;
  Parameterized(const Parameterized&) = delete;

  template <class Parameterizer, class... Others>
  void parameterize(Others&... others)
  {
    const auto np = parameters::flip_policy(Flip_policy::KEEP).summary(std::ref(summary));
    const Error_code code =
        mapped.parameterize(Hierarchical_parameterizer_3<Parameterizer>(np), longest_border(mesh), others...);
    EXPECT_EQ(code, OK);
  }

  // The map of a parameterizer without adaptor.
  template <class Parameterizer>
  void parameterize_flat()
  {
    EXPECT_EQ(mapped.parameterize(Parameterizer(), longest_border(mesh)), OK);
  }
};

template <class Parameterizer, class Expected>
void expect_as_fast_as(const char* name)
{
  SCOPED_TRACE(name);
  Parameterized run, expected;
  run.parameterize<Parameterizer>();
  expected.parameterize<Expected>();
  run.mapped.expect_equal(expected.mapped, 1e-7);
  EXPECT_NEAR(double(run.summary.linear_solver.iterations), double(expected.summary.linear_solver.iterations), 1)
      << "sums in another order are rounded otherwise";
  EXPECT_EQ(run.summary.linear_solver.right_sides, expected.summary.linear_solver.right_sides);
  EXPECT_EQ(run.summary.linear_solver.direct_solutions, 0u);
  EXPECT_LE(run.summary.linear_solver.iterations, 50u);
}

template <template <class, class, class> class Parameterizer, class Order>
using With = Parameterizer<Surface_mesh, Order, Multigrid_solver_traits>;

typedef Mean_value_coordinates_parameterizer_3<Surface_mesh>         CGAL_mean_value;
typedef LSCM_by_multigrid<Surface_mesh, Two_vertices>                CGAL_LSCM;

TEST(Unknown_numbering, does_not_matter)
{
  expect_as_fast_as<With<Mean_value_of, As_it_is>, CGAL_mean_value>("mean value");
  expect_as_fast_as<With<Mean_value_of, Shuffled>, CGAL_mean_value>("mean value, shuffled");
  expect_as_fast_as<With<LSCM_of, As_it_is>, CGAL_LSCM>("LSCM");
  expect_as_fast_as<With<LSCM_of, Shuffled>, CGAL_LSCM>("LSCM, shuffled");
  expect_as_fast_as<With<LSCM_of, Even_ones_first>, CGAL_LSCM>("LSCM, u before v");
}

TEST(Unknown_numbering, is_looked_for_only_if_it_is_not_that_of_the_vertices)
{
  int calls = 0;
  Parameterized run;
  run.parameterize<With<Counted_mean_value, As_it_is>>(calls);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(run.summary.linear_solver.direct_solutions, 0u);
}

// Further arguments may be changed by a call, so that there is no second one.
TEST(Unknown_numbering, is_not_looked_for_if_there_are_further_arguments)
{
  int calls = 0;
  Parameterized run, expected;
  run.parameterize<With<Counted_mean_value, Shuffled>>(calls);
  expected.parameterize_flat<CGAL_mean_value>();
  run.mapped.expect_equal(expected.mapped, 1e-7);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(run.summary.linear_solver.direct_solutions, 2u);
  EXPECT_EQ(run.summary.linear_solver.iterations, 0u) << "no time is lost with wrong grids";
}

TEST(Unknown_numbering, that_the_map_does_not_show_leads_to_a_direct_solution)
{
  Parameterized run, expected;
  run.parameterize<With<Double_mean_value, Shuffled>>();
  expected.parameterize_flat<CGAL_mean_value>();
  for (const auto v : vertices(run.mesh))
    put(expected.mapped.uvmap, v, CGAL::ORIGIN + 2 * (get(expected.mapped.uvmap, v) - CGAL::ORIGIN));
  run.mapped.expect_equal(expected.mapped, 1e-7);
  EXPECT_EQ(run.summary.linear_solver.direct_solutions, 2u);
  EXPECT_EQ(run.summary.linear_solver.iterations, 0u);
}

// A pinned vertex may look as if it were an unknown.
TEST(Unknown_numbering, is_not_mistaken_for_a_given_place)
{
  Parameterized run, run_of_CGAL, expected;
  for (Parameterized* r : { &run, &run_of_CGAL, &expected }) {
    put(r->mapped.uvmap, Surface_mesh::Vertex_index(42), Kernel::Point_2(SMP::internal::Mesh_unknowns::mark(7), 0.9));
    put(r->mapped.vpmap, Surface_mesh::Vertex_index(42), true);
  }
  run.parameterize<With<LSCM_of, As_it_is>>();
  run_of_CGAL.parameterize<CGAL_LSCM>();
  expected.parameterize_flat<CGAL_LSCM>();
  run.mapped.expect_equal(expected.mapped, tolerance);
  run_of_CGAL.mapped.expect_equal(expected.mapped, tolerance);
  EXPECT_EQ(run.summary.linear_solver.direct_solutions, 1u);
  EXPECT_EQ(run_of_CGAL.summary.linear_solver.direct_solutions, 0u) << "its numbering is known";
}

} // namespace test_unknown_numbering
