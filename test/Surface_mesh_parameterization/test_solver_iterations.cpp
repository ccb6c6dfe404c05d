// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How many iterations Multigrid_solver_traits takes.

#include "mesh_conversions.h"
#include "multigrid_systems.h"
#include "real_meshes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace test_solver_iterations {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace test_systems;
namespace parameters = CGAL::parameters;

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
  std::size_t found = 0;
  for (const std::string name : { "face_1042.off", "three_peaks.off", "lion_head.off", "camelhead.off" }) {
    Flat_mesh m;
    if (!read_off(name, m))
      continue;
    ++found;
    EXPECT_LE(iterations(m, TypeParam()), 20u) << name;
  }
  if (found == 0)
    GTEST_SKIP() << "no mesh in " << data_folder();
}

// Half the edges are opposite to angles of up to 166 degrees: with cotangents so negative, incomplete factors of the
// matrix as it is make no smoother.
TEST(Multigrid_solver_traits_of_odd_weights, copes_with_obtuse_triangles)
{
  for (const Index n : { 60, 120 })
    EXPECT_LE(iterations(affine_image(grid(n, n, flat), 1, -4, 0, 1), Harmonic_edge_weights_3()), 12u) << n;
}

// Mean value weights of a surface, but for one row in every `distance`.
struct Some_wild_weights
{
  std::size_t distance, rows = 0;

  void operator()(const Point_3& v, const std::vector<Point_3>& ring, bool is_closed, std::vector<double>& weights)
  {
    Mean_value_edge_weights_3()(v, ring, is_closed, weights);
    if (++rows % distance == 0)
      weights[0] = -0.9 * std::accumulate(weights.begin() + 1, weights.end(), 0.);
  }
};

// A row that is far from diagonally dominant costs a few iterations.
TEST(Multigrid_solver_traits_of_odd_weights, copes_with_a_few_wild_rows)
{
  const Flat_mesh m = grid(120, 120, wavy);
  const std::size_t rows = 119 * 119;
  for (const std::size_t wild_rows : { 5, 10 })
    EXPECT_LE(iterations(m, Some_wild_weights{ rows / wild_rows }), 10 + 3 * wild_rows) << wild_rows;
}

// Uniform weights do not feel that a mesh is stretched, and neither does the iteration.
TEST(Multigrid_solver_traits_of_odd_weights, unit_edges_suit_uniform_weights)
{
  const Flat_mesh m = grid(120, 120, flat), stretched = affine_image(m, 6, 0, 0, 1);
  const std::size_t expected = iterations(m, Uniform_edge_weights_3());
  EXPECT_LE(iterations(stretched, Uniform_edge_weights_3(), 0, true), expected + 1);
  EXPECT_GE(iterations(stretched, Uniform_edge_weights_3(), 0, false), expected + 3);
}

} // namespace test_solver_iterations
