// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Multigrid for the systems of Newton's method: matrices of blocks, their products, the cycle and the iteration.

#include "hierarchies.h"
#include "level_maps.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Pruned_prolongation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_multigrid.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Galerkin_product.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Grouped_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Krylov_methods.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Contact_pattern.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>
#include <vector>

namespace test_v_cycle {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

Block block_of(const Eigen::MatrixXd& dense, Index row, Index column)
{
  const Eigen::Matrix2d b = dense.block<2, 2>(2 * row, 2 * column);
  return Block(b(0, 0), b(0, 1), b(1, 0), b(1, 1));
}

Eigen::Matrix2d dense_of(const Block& b)
{
  Eigen::Matrix2d result;
  result << b.xx(), b.xy(), b.yx(), b.yy();
  return result;
}

// A random symmetric, diagonally dominant matrix with the pattern of a level's edges; and the same one, unscaled and
// dense.
struct Random_matrix
{
  Contact_pattern pattern;
  Block_matrix matrix;
  Eigen::MatrixXd dense;

  Random_matrix(const Level& level, Random& random)
    : pattern(level.rings()), dense(Eigen::MatrixXd::Zero(2 * level.number_of_vertices(), 2 * level.number_of_vertices()))
  {
    const One_rings& rings = level.rings();
    pattern.give_to(matrix);
    for (Index v = 0; v < rings.number_of_vertices(); ++v)
      for (const Index w : rings[v])
        for (int e = 0; e < 4 && v < w; ++e)
          dense(2 * v + e / 2, 2 * w + e % 2) = dense(2 * w + e % 2, 2 * v + e / 2) = random(-1, 1);
    for (int i = 0; i < dense.rows(); ++i)
      dense(i, i) = 0.1 + dense.row(i).cwiseAbs().sum();
    for (Index v = 0; v < rings.number_of_vertices(); ++v) {
      matrix.set_diagonal(v, block_of(dense, v, v));
      for (Index k = matrix.first[v]; k < matrix.first[v + 1]; ++k)
        matrix.blocks[k] = block_of(dense, v, matrix.columns[k]);
    }
  }
};

Eigen::MatrixXd unscaled(const Block_matrix& a)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(2 * a.number_of_rows(), 2 * a.number_of_rows());
  for (Index i = 0; i < a.number_of_rows(); ++i) {
    result.block<2, 2>(2 * i, 2 * i) = dense_of(a.unscaled_diagonal_block(i));
    for (Index k = a.first[i]; k < a.first[i + 1]; ++k) {
      const Index j = a.columns[k];
      const Eigen::Matrix2d block = dense_of(a.blocks[k] / (a.scale[i] * a.scale[j]));
      result.block<2, 2>(2 * i, 2 * j) = block;
      result.block<2, 2>(2 * j, 2 * i) = block.transpose();
    }
  }
  return result;
}

// The matrix itself, from the dense one: S A S.
Eigen::MatrixXd scaled(const Random_matrix& a)
{
  Eigen::VectorXd scale(a.dense.rows());
  for (Eigen::Index e = 0; e < scale.size(); ++e)
    scale[e] = a.matrix.scale[e / 2];
  return scale.asDiagonal() * a.dense * scale.asDiagonal();
}

Eigen::Map<const Eigen::VectorXd> dense_of(const Block_vectors& x) { return { &x.data()->x, 2 * Eigen::Index(x.size()) }; }

Block_vectors random_vectors(std::size_t n, Random& random)
{
  Block_vectors result(n);
  for (Block_vector& v : result)
    v = { random(-1, 1), random(-1, 1) };
  return result;
}

bool are_equal(const Block_vectors& x, const Block_vectors& y)
{
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [](const Block_vector& a, const Block_vector& b) { return a.x == b.x && a.y == b.y; });
}

TEST(Block_matrix, is_scaled_to_diagonal_blocks_of_trace_2)
{
  Random random(4);
  const Finest_level f(grid(5, 5, wavy));
  Random_matrix a(f.level, random);
  a.matrix.scale_blocks(Loops());
  EXPECT_NEAR((unscaled(a.matrix) - a.dense).norm(), 0, 1e-12 * a.dense.norm());
  for (Index i = 0; i < a.matrix.number_of_rows(); ++i) {
    EXPECT_NEAR(dense_of(a.matrix.diagonal_block(i)).trace(), 2, 1e-14);
  }
}

TEST(Block_matrix, half_of_it_multiplies_as_the_whole)
{
  Random random(8);
  const Finest_level f(grid(12, 9, wavy));
  Random_matrix a(f.level, random);
  a.matrix.scale_blocks(Loops());
  const Eigen::MatrixXd dense = scaled(a);
  const Block_vectors x = random_vectors(f.level.number_of_vertices(), random);
  Block_vectors y(x.size());
  a.matrix.multiply(x, y);
  EXPECT_NEAR((dense_of(y) - dense * dense_of(x)).norm(), 0, 1e-12);
  double energy = 0;
  for (Index i = 0; i < x.size(); ++i)
    energy += a.matrix.energy_of_row(i, x);
  EXPECT_NEAR(energy, dense_of(x).dot(dense * dense_of(x)), 1e-12);
}

// Gauss-Seidel steps on all rows, in the given order.
void relax(const Eigen::MatrixXd& a, const std::vector<Index>& order, const Block_vectors& b, Eigen::VectorXd& x)
{
  for (const Index i : order) {
    const Eigen::Vector2d residual = (dense_of(b) - a * x).segment<2>(2 * i);
    x.segment<2>(2 * i) += a.block<2, 2>(2 * i, 2 * i).inverse() * residual;
  }
}

TEST(Block_matrix, sweeps_are_those_of_Gauss_and_Seidel)
{
  Random random(9);
  const Finest_level f(grid(12, 9, wavy));
  Random_matrix a(f.level, random);
  a.matrix.scale_blocks(Loops());
  const Eigen::MatrixXd dense = scaled(a);
  const std::size_t n = f.level.number_of_vertices();
  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), 0);
  const Block_vectors b = random_vectors(n, random);
  Block_vectors x(n), right(n, Block_vector::zero());
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(2 * n);
  for (const bool is_last : { false, true }) {
    a.matrix.relax_forward(b, is_last, x, right);
    relax(dense, order, b, expected);
    EXPECT_NEAR((dense_of(x) - expected).norm(), 0, 1e-12);
  }
  EXPECT_NEAR((dense_of(right) - (dense * expected - dense_of(b))).norm(), 0, 1e-12);

  right.assign(n, Block_vector::zero());
  std::reverse(order.begin(), order.end());
  for (int sweep = 0; sweep < 2; ++sweep) {
    a.matrix.relax_backward(b, x, right);
    relax(dense, order, b, expected);
    EXPECT_NEAR((dense_of(x) - expected).norm(), 0, 1e-12);
    EXPECT_EQ(dense_of(right).norm(), 0);
  }
}

// What several threads do is the same, to the last digit.
TEST(Grouped_rows, do_what_the_matrix_does)
{
  Random random(10);
  const Finest_level f(grid(20, 20, wavy), parameters::coarsest_size(20));
  Random_matrix a(f.level, random);
  a.matrix.scale_blocks(Loops());
  const std::size_t n = f.level.number_of_vertices();
  std::vector<Index> group_ends;
  for (std::size_t l = 0; l <= f.level.index(); ++l)
    group_ends.push_back(Index(f.hierarchy.number_of_vertices(l)));
  ASSERT_TRUE(Grouped_rows::can_be_grouped(a.matrix, group_ends));
  const Grouped_rows grouped(a.matrix, group_ends, Loops());
  const Block_vectors b = random_vectors(n, random);
  Block_vectors x(n), right(n, Block_vector::zero()), y = x, right_of_y = right, ax(n), ay(n);
  for (const bool is_last : { false, true }) {
    a.matrix.relax_forward(b, is_last, x, right);
    grouped.relax_forward(b, is_last, y, right_of_y);
    EXPECT_TRUE(are_equal(x, y));
    EXPECT_TRUE(are_equal(right, right_of_y));
  }
  right.assign(n, Block_vector::zero());
  right_of_y = right;
  a.matrix.relax_backward(b, x, right);
  grouped.relax_backward(b, y, right_of_y);
  EXPECT_TRUE(are_equal(x, y));
  a.matrix.multiply(x, ax);
  grouped.multiply(y, ay);
  EXPECT_TRUE(are_equal(ax, ay));

  EXPECT_FALSE(Grouped_rows::can_be_grouped(a.matrix, { group_ends.front(), Index(n) }));
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
  std::vector<Index> order(p.coarse_size());
  std::iota(order.rbegin(), order.rend(), 0);     // any order will do
  Galerkin_product product(p, order);
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
  Block_multigrid_options one_sweep, two_sweeps;
  one_sweep.sweeps = 1;
  for (const Level* level : { &f.level, &many.level })
    for (const Block_multigrid_options& options : { one_sweep, two_sweeps }) {
      Block_multigrid multigrid(*level, options);
      const Random_matrix a(*level, random);
      multigrid.matrix() = a.matrix;
      multigrid.setup();
      ASSERT_TRUE(multigrid.is_ready());
      for (int i = 0; i < 5; ++i) {
        const Block_vectors x = random_vectors(level->number_of_vertices(), random),
                            y = random_vectors(level->number_of_vertices(), random);
        const Block_vectors mx = multigrid.cycle(x), my = multigrid.cycle(y);
        EXPECT_NEAR(inner_product(Loops(), mx, y), inner_product(Loops(), x, my),
                    1e-10 * std::sqrt(inner_product(Loops(), mx, mx) * inner_product(Loops(), y, y)));
        EXPECT_GT(inner_product(Loops(), mx, x), 0);
      }
    }
}

// The system as the method sees it.
struct Block_system
{
  Block_multigrid& multigrid;
  double target;
  Loops sequential = {};

  Index number_of_rows() const { return multigrid.matrix().number_of_rows(); }
  const Loops& loops() const { return sequential; }
  double multiply(const Block_vectors& x, Block_vectors& y, const Block_vectors& z) const
  {
    multigrid.multiply(x, y);
    return inner_product(sequential, z, y);
  }
  Block_vectors& precondition(const Block_vectors& r) { return multigrid.cycle(r); }
  double squared_size(Index, const Block_vector& r) const { return inner_product(r, r); }
  double direction_factor(double a, double b) const { return SMP::internal::quotient(a, b); }
  bool is_finished(double squared_norm) const { return std::sqrt(squared_norm) <= target; }
};

TEST(Conjugate_gradients, reach_the_residual_they_are_asked_for)
{
  Random random(7);
  const Finest_level f(grid(40, 40, wavy), parameters::coarsest_size(20));
  Block_multigrid multigrid(f.level);
  const Random_matrix a(f.level, random);
  multigrid.matrix() = a.matrix;
  multigrid.setup();
  for (const double tolerance : { 0.1, 1e-4, 1e-8 }) {
    const Block_vectors b = random_vectors(f.level.number_of_vertices(), random);
    const double target = tolerance * std::sqrt(inner_product(Loops(), b, b));
    Block_system system{ multigrid, target };
    Block_vectors x(b.size(), Block_vector::zero()), residual = b, scratch(b.size());
    const std::size_t iterations = conjugate_gradients(system, x, residual, scratch, 100);
    EXPECT_LT(iterations, 50u);
    Block_vectors ax(b.size());
    multigrid.multiply(x, ax);
    EXPECT_LE((dense_of(b) - dense_of(ax)).norm(), 1.001 * target);
  }
}

// The cycles that reduce the residual by a factor of 100 for the Hessian of MIPS at a conformal map, where the right
// side is that of an almost conformal motion.
std::size_t cycles_for_conformal_motion(Index n)
{
  const Finest_level f(grid(n, n, flat), parameters::coarsest_size(20));
  const Level::Uv uv = identity_map(f.level);
  const Level_energy_of<MIPS_energy_2> energy(f.level, Triangle_weight::ONE);
  Block_multigrid multigrid(f.level, multigrid_options_of(energy));
  const Contact_pattern pattern(f.level.rings());
  pattern.give_to(multigrid.matrix());
  Block_vectors gradient(uv.size()), motion, b(uv.size());
  energy.assemble(uv, 0, gradient, multigrid.matrix());
  multigrid.setup();
  for (Index v = 0; v < uv.size(); ++v) {
    const std::complex<double> z(uv[v].x() - 0.4, uv[v].y() - 0.3), w = z * z * z / multigrid.matrix().scale[v];
    motion.emplace_back(w.real(), w.imag());
  }
  multigrid.multiply(motion, b);
  Block_system system{ multigrid, 0.01 * std::sqrt(inner_product(Loops(), b, b)) };
  Block_vectors x(b.size(), Block_vector::zero()), scratch(b.size());
  return conjugate_gradients(system, x, b, scratch, 100);
}

TEST(Conjugate_gradients, need_not_many_more_cycles_for_conformal_motions_on_more_grids)
{
  // 20,000 vertices and 1300. With plain V-cycles there would be four times as many, or more.
  EXPECT_LE(cycles_for_conformal_motion(140), 3 * cycles_for_conformal_motion(35));
}

} // namespace test_v_cycle
