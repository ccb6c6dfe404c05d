// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Matrices of blocks: the parts of their rows, their products, and sweeps of Gauss and Seidel.

#include "dense_matrices.h"
#include "hierarchies.h"
#include "random_block_matrices.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Pruned_prolongation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Galerkin_product.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Krylov_methods.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Rows_by_part.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/level_parts.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace test_block_matrices {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;
using test_systems::Random_matrix;
using test_systems::dense_of;
using test_systems::random_vectors;
namespace parameters = CGAL::parameters;

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

TEST(Row_parts, are_stretches_of_the_input_and_hold_every_row_once)
{
  const Finest_level f(grid(40, 30, wavy), parameters::coarsest_size(20));
  const std::size_t n = f.hierarchy.number_of_vertices(f.hierarchy.number_of_levels() - 1);
  for (const std::size_t level : { std::size_t(3), f.level.index() }) {
    const Row_parts parts(f.hierarchy, level, 4), halves(f.hierarchy, level, 8);
    std::vector<Index> rows;
    for (Index part = 0; part < 4; ++part) {
      std::vector<Index> forward, backward;
      parts.for_each_row(part, [&](Index row) { forward.push_back(row); });
      parts.for_each_row_backward(part, [&](Index row) { backward.push_back(row); });
      EXPECT_TRUE(std::is_sorted(forward.begin(), forward.end()));
      EXPECT_TRUE(std::equal(forward.begin(), forward.end(), backward.rbegin(), backward.rend()));
      for (const Index row : forward) {
        EXPECT_EQ(parts.part_of(row), part);
        EXPECT_EQ(halves.part_of(row) / 2, part);
        EXPECT_GE(4 * std::size_t(f.hierarchy.input_vertex(row)), part * n);
        EXPECT_LT(4 * std::size_t(f.hierarchy.input_vertex(row)), (part + 1) * n + 4);
      }
      rows.insert(rows.end(), forward.begin(), forward.end());
    }
    std::sort(rows.begin(), rows.end());
    std::vector<Index> all(f.hierarchy.number_of_vertices(level));
    std::iota(all.begin(), all.end(), Index(0));
    EXPECT_EQ(rows, all);
  }
}

TEST(Row_parts, are_as_many_as_rows_allow)
{
  Row_parts_options options;
  options.least_rows = 30;
  options.rows_of_two_parts = 100;
  for (const auto& [rows, parts] : std::vector<std::pair<std::size_t, Index>>{
           { 1, 1 }, { 29, 1 }, { 30, 2 }, { 399, 2 }, { 400, 4 }, { 1600, 8 }, { 100000000, 1024 } })
    EXPECT_EQ(number_of_parts(rows, options), parts) << rows;

  Flat_mesh m = grid(40, 40, wavy);
  options.rows_of_two_parts = m.points.size() / 4;
  EXPECT_EQ(level_parts(Finest_level(m).level, options).number_of_parts(), 4u);

  std::vector<Index> place(m.points.size());      // the same in random order, where parts would be no regions
  std::iota(place.begin(), place.end(), Index(0));
  Random(1).shuffle(place);
  const Flat_mesh ordered = m;
  for (Index v = 0; v < place.size(); ++v)
    m.points[place[v]] = ordered.points[v];
  for (Index_triangle& t : m.triangles)
    for (Index& v : t)
      v = place[v];
  EXPECT_EQ(level_parts(Finest_level(m).level, options).number_of_parts(), 1u);
}

TEST(Block_matrix, half_of_it_multiplies_as_the_whole)
{
  Random random(8);
  const Finest_level f(grid(12, 9, wavy));
  for (const Index number_of_parts : { 1, 4 }) {
    Random_matrix a(f.level, random, number_of_parts);
    a.matrix.scale_blocks(Loops());
    const Eigen::MatrixXd dense = scaled(a);
    const Block_vectors x = random_vectors(f.level.number_of_vertices(), random);
    Block_vectors y(x.size());
    a.matrix.multiply(x, y, Loops());
    EXPECT_NEAR((dense_of(y) - dense * dense_of(x)).norm(), 0, 1e-12);
    double energy = 0;
    for (Index i = 0; i < x.size(); ++i)
      energy += a.matrix.energy_of_row(i, x);
    EXPECT_NEAR(energy, dense_of(x).dot(dense * dense_of(x)), 1e-12);
  }
}

// M of a sweep x + M^-1 (b - A x) in this order of the rows: A but for what joins a row to later ones or to those of
// other parts; joints add half of their norms to the diagonals of their rows.
Eigen::MatrixXd matrix_of_sweep(const Eigen::MatrixXd& a, const Row_parts& parts, const std::vector<Index>& order)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(a.rows(), a.cols());
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = 0; j < order.size(); ++j) {
      const Eigen::Index row = 2 * order[i], column = 2 * order[j];
      const auto block = a.block<2, 2>(row, column);
      if (parts.part_of(order[i]) != parts.part_of(order[j]))
        result.block<2, 2>(row, row) += 0.5 * block.norm() * Eigen::Matrix2d::Identity();
      else if (j <= i)
        result.block<2, 2>(row, column) += block;
    }
  return result;
}

TEST(Block_matrix, sweeps_are_those_of_Gauss_and_Seidel_in_each_part)
{
  Random random(9);
  const Finest_level f(grid(12, 9, wavy));
  for (const Index number_of_parts : { 1, 4 }) {
    Random_matrix a(f.level, random, number_of_parts);
    a.matrix.scale_blocks(Loops());
    const Eigen::MatrixXd dense = scaled(a);
    const std::size_t n = f.level.number_of_vertices();
    std::vector<Index> order(n);
    std::iota(order.begin(), order.end(), 0);
    const Block_vectors b = random_vectors(n, random);
    const double precision = number_of_parts == 1 ? 1e-12 : 1e-6;      // the damping is in single precision
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Block_vectors x(n, { nan, nan }), right(n, Block_vector::zero());
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(2 * n);
    const auto sweep = [&] {
      expected += matrix_of_sweep(dense, a.matrix.parts(), order).lu().solve(dense_of(b) - dense * expected);
    };
    for (const bool is_last : { false, true }) {
      a.matrix.relax_forward(b, !is_last, is_last, x, right, Loops());
      sweep();
      EXPECT_NEAR((dense_of(x) - expected).norm(), 0, precision);
    }
    EXPECT_NEAR((dense_of(right) - (dense * dense_of(x) - dense_of(b))).norm(), 0, 1e-12);

    right.assign(n, Block_vector::zero());
    std::reverse(order.begin(), order.end());
    for (int i = 0; i < 2; ++i) {
      a.matrix.relax_backward(b, x, right, Loops());
      sweep();
      EXPECT_NEAR((dense_of(x) - expected).norm(), 0, precision);
      EXPECT_EQ(dense_of(right).norm(), 0);
    }
  }
}

// A sweep lowers the energy of any positive definite matrix. Of this one, with parts of two rows each, sweeps without
// damping would raise it: most of its greatest eigenvalue, nearly 3 times the diagonal, is in blocks that join parts.
TEST(Block_matrix, sweeps_converge_however_parts_are_joined)
{
  const Finest_level f(grid(12, 9, wavy));
  Random random(12);
  const Random_matrix of_edges(f.level, random, 64);
  Block_matrix a = of_edges.matrix;
  for (Index v = 0; v < a.number_of_rows(); ++v) {
    a.set_diagonal(v, Block(1, 0, 0, 1));
    for (Index k = a.first[v]; k < a.first[v + 1]; ++k)
      a.blocks[k] = Block(0.3, 0, 0, 0.3);
  }
  a.scale_blocks(Loops());
  const std::size_t n = a.number_of_rows();
  const Block_vectors b(n, Block_vector::zero());
  Block_vectors x = random_vectors(n, random), right(n, Block_vector::zero()), ax(n);
  double energy = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 20; ++i) {
    a.multiply(x, ax, Loops());
    EXPECT_LT(inner_product(Loops(), x, ax), energy);
    energy = inner_product(Loops(), x, ax);
    a.relax_backward(b, x, right, Loops());
  }
}

TEST(Rows_by_part, come_all_once_and_those_of_two_parts_last)
{
  const Finest_level f(grid(40, 30, wavy), parameters::coarsest_size(20));
  const std::size_t fine = f.level.index(), coarse = fine - 3;
  const Pruned_prolongation p(f.hierarchy, coarse, fine, Loops());
  const Row_parts parts(f.hierarchy, fine, 4);
  std::vector<Index> rows;
  std::size_t last_inside = 0, first_split = p.fine_size();
  const auto is_inside = [&](Index part, Index row) {
    const auto& columns = p.new_row(row).columns;
    return std::all_of(columns.begin(), columns.end(), [&](Index c) { return parts.part_of(c) == part; });
  };
  Rows_by_part(parts, Index(p.coarse_size()), is_inside).for_each(Loops(), [&](Index row) {
    if (is_inside(parts.part_of(row), row))
      last_inside = rows.size();
    else
      first_split = (std::min)(first_split, rows.size());
    rows.push_back(row);
  });
  EXPECT_LT(last_inside, first_split);
  EXPECT_LT(first_split, rows.size());      // there are some
  std::sort(rows.begin(), rows.end());
  std::vector<Index> all(p.fine_size() - p.coarse_size());
  std::iota(all.begin(), all.end(), Index(p.coarse_size()));
  EXPECT_EQ(rows, all);
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
  for (const Index number_of_parts : { 1, 4 }) {
    Galerkin_product product(p, Row_parts(f.hierarchy, finest - 3, number_of_parts), order);
    for (int i = 0; i < 2; ++i) {     // the pattern serves for other values, too
      const Random_matrix a(f.level, random, number_of_parts);
      Block_matrix coarse;
      product.compute(a.matrix, coarse, Loops());
      coarse.scale_blocks(Loops());
      const Eigen::MatrixXd expected = dense.transpose() * a.dense * dense;
      EXPECT_NEAR((unscaled(coarse) - expected).norm(), 0, 1e-12 * expected.norm());
      for (Index row = 0; row < coarse.number_of_rows(); ++row)
        for (Index k = coarse.first[row]; k < coarse.first[row + 1]; ++k)
          EXPECT_EQ(k >= coarse.first_joint[row],
                    coarse.parts().part_of(row) != coarse.parts().part_of(coarse.columns[k]));
    }
  }
}

} // namespace test_block_matrices
