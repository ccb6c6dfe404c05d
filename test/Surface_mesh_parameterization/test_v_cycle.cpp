// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Multigrid for the systems of Newton's method: matrices of blocks, their products, the cycle and the iteration.

#include "hierarchies.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Pruned_prolongation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Galerkin_product.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/V_cycle.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/conjugate_gradients.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

// A random symmetric, diagonally dominant matrix with the pattern of a level's edges; and the same one, unscaled and dense.
struct Random_matrix
{
  Block_matrix matrix;
  Eigen::MatrixXd dense;

  Random_matrix(const Level& level, Random& random) : dense(Eigen::MatrixXd::Zero(2 * level.number_of_vertices(), 2 * level.number_of_vertices()))
  {
    const One_rings& rings = level.rings();
    matrix.set_pattern(rings.number_of_vertices(), rings.offsets(), rings.neighbors());
    for (Index v = 0; v < rings.number_of_vertices(); ++v)
      for (const Index w : rings[v])
        for (int e = 0; e < 4 && v < w; ++e)
          dense(2 * v + e / 2, 2 * w + e % 2) = dense(2 * w + e % 2, 2 * v + e / 2) = random(-1, 1);
    for (int i = 0; i < dense.rows(); ++i)
      dense(i, i) = 0.1 + dense.row(i).cwiseAbs().sum();
    for (Index v = 0; v < rings.number_of_vertices(); ++v) {
      matrix.set_diagonal(v, dense.block<2, 2>(2 * v, 2 * v));
      for (Index k = matrix.first[v]; k < matrix.first[v + 1]; ++k)
        matrix.blocks[k] = dense.block<2, 2>(2 * v, 2 * matrix.columns[k]);
    }
  }
};

Eigen::MatrixXd unscaled(const Block_matrix& a)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(2 * a.number_of_rows(), 2 * a.number_of_rows());
  for (Index i = 0; i < a.number_of_rows(); ++i) {
    result.block<2, 2>(2 * i, 2 * i) = a.unscaled_diagonal_block(i);
    for (Index k = a.first[i]; k < a.first[i + 1]; ++k)
      result.block<2, 2>(2 * i, 2 * a.columns[k]) = a.blocks[k] / (a.scale[i] * a.scale[a.columns[k]]);
  }
  return result;
}

Pair_vector random_pairs(std::size_t n, Random& random)
{
  Pair_vector result(n);
  for (Pair& pair : result)
    pair = { random(-1, 1), random(-1, 1) };
  return result;
}

TEST(Block_matrix, is_scaled_to_diagonal_blocks_of_trace_2)
{
  Random random(4);
  const Finest_level f(grid(5, 5, wavy));
  Random_matrix a(f.level, random);
  a.matrix.scale_blocks(Loops());
  EXPECT_NEAR((unscaled(a.matrix) - a.dense).norm(), 0, 1e-12 * a.dense.norm());
  for (Index i = 0; i < a.matrix.number_of_rows(); ++i) {
    EXPECT_NEAR(a.matrix.diagonal_block(i).trace(), 2, 1e-14);
  }
}

TEST(Block_matrix, relaxes_a_group_at_once_as_one_by_one)
{
  Random random(8);
  const Finest_level f(grid(20, 20, wavy), parameters::coarsest_size(20));
  Random_matrix a(f.level, random);
  a.matrix.scale_blocks(Loops());
  const Pair_vector b = random_pairs(f.level.number_of_vertices(), random);
  Pair_vector x = random_pairs(f.level.number_of_vertices(), random), y = x, z = x, scratch;
  for (std::size_t l = 1; l <= f.level.index(); ++l) {
    const Index begin = Index(f.hierarchy.number_of_vertices(l - 1)), end = Index(f.hierarchy.number_of_vertices(l));
    a.matrix.relax_forward(begin, end, b, x);
    a.matrix.relax_backward(begin, end, b, y);
    a.matrix.relax_at_once(Loops(), begin, end, b, z, scratch);
    EXPECT_EQ(x, y);
    EXPECT_EQ(x, z);
    for (Index i = begin; i < end; ++i)
      EXPECT_NEAR((a.matrix.row_times(i, x) - b[i]).norm(), 0, 1e-12);
  }
}

TEST(Galerkin_product, is_the_product_of_the_matrices)
{
  Random random(5);
  const Finest_level f(grid(12, 9, wavy), parameters::coarsest_size(20));
  const std::size_t finest = f.hierarchy.number_of_levels() - 1;
  const Pruned_prolongation p(f.hierarchy, finest - 3, finest, Loops());
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(2 * p.fine_size(), 2 * p.coarse_size());
  for (Index v = 0; v < p.fine_size(); ++v)
    for (int e = 0; e < 2; ++e)
      for (int k = 0; k < Pruned_prolongation::row_size; ++k)
        dense(2 * v + e, 2 * p.row(v).columns[k] + e) += p.row(v).weights[k];
  Random_matrix first(f.level, random);
  std::vector<Index> order(p.coarse_size());
  std::iota(order.rbegin(), order.rend(), 0);     // any order will do
  Galerkin_product product(first.matrix, p, order, Loops());
  for (int i = 0; i < 2; ++i) {     // the pattern serves for other values, too
    const Random_matrix a(f.level, random);
    Block_matrix coarse;
    product.compute(a.matrix, coarse, Loops());
    coarse.scale_blocks(Loops());
    const Eigen::MatrixXd expected = dense.transpose() * a.dense * dense;
    EXPECT_NEAR((unscaled(coarse) - expected).norm(), 0, 1e-12 * expected.norm());
  }
}

TEST(V_cycle, is_a_symmetric_positive_preconditioner)
{
  Random random(6);
  const Finest_level f(grid(40, 40, wavy));
  const Finest_level many(grid(40, 40, wavy), parameters::coarsest_size(20));
  for (const Level* level : { &f.level, &many.level }) {
    V_cycle cycle(*level);
    cycle.matrix() = Random_matrix(*level, random).matrix;
    cycle.setup();
    ASSERT_TRUE(cycle.is_ready());
    for (int i = 0; i < 5; ++i) {
      const Pair_vector x = random_pairs(level->number_of_vertices(), random), y = random_pairs(level->number_of_vertices(), random);
      const Pair_vector mx = cycle(x), my = cycle(y);
      EXPECT_NEAR(dot(Loops(), mx, y), dot(Loops(), x, my), 1e-10 * std::sqrt(dot(Loops(), mx, mx) * dot(Loops(), y, y)));
      EXPECT_GT(dot(Loops(), mx, x), 0);
    }
  }
}

TEST(Conjugate_gradients, reach_the_residual_they_are_asked_for)
{
  Random random(7);
  const Finest_level f(grid(40, 40, wavy), parameters::coarsest_size(20));
  V_cycle cycle(f.level);
  cycle.matrix() = Random_matrix(f.level, random).matrix;
  cycle.setup();
  for (const double tolerance : { 0.1, 1e-4, 1e-8 }) {
    Conjugate_gradients_space space;
    const Pair_vector b = random_pairs(f.level.number_of_vertices(), random);
    space.residual = b;
    const std::size_t iterations = conjugate_gradients(Loops(), cycle.matrix(), cycle, tolerance, 100, space);
    EXPECT_LT(iterations, 50u);
    double residual2 = 0;
    for (Index i = 0; i < b.size(); ++i)
      residual2 += (b[i] - cycle.matrix().row_times(i, space.solution)).squaredNorm();
    EXPECT_LE(std::sqrt(residual2), 1.001 * tolerance * std::sqrt(dot(Loops(), b, b)));
  }
}

} // namespace
