// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_BLOCK_MATRICES_H
#define RANDOM_BLOCK_MATRICES_H

#include "dense_matrices.h"

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Contact_pattern.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <Eigen/Core>

#include <cstddef>

// Random matrices and vectors of blocks.
namespace test_systems {

using SMP::Level;
using SMP::internal::Block_matrix;
using SMP::internal::Block_vector;
using SMP::internal::Block_vectors;
using SMP::internal::Contact_pattern;
using SMP::internal::One_rings;
using SMP::internal::Row_parts;

inline Block block_of(const Eigen::MatrixXd& dense, Index row, Index column)
{
  const Eigen::Matrix2d b = dense.block<2, 2>(2 * row, 2 * column);
  return Block(b(0, 0), b(0, 1), b(1, 0), b(1, 1));
}

// A random symmetric, diagonally dominant matrix with the pattern of a level's edges; and the same one, unscaled and
// dense.
struct Random_matrix
{
  Contact_pattern pattern;
  Block_matrix matrix;
  Eigen::MatrixXd dense;

  Random_matrix(const Level& level, Random& random, Index number_of_parts = 1)
    : pattern(level.rings(), Row_parts(level.hierarchy(), level.index(), number_of_parts)),
      dense(Eigen::MatrixXd::Zero(2 * level.number_of_vertices(), 2 * level.number_of_vertices()))
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

inline Eigen::Map<const Eigen::VectorXd> dense_of(const Block_vectors& x)
{
  return { &x.data()->x, 2 * Eigen::Index(x.size()) };
}

inline Block_vectors random_vectors(std::size_t n, Random& random)
{
  Block_vectors result(n);
  for (Block_vector& v : result)
    v = { random(-1, 1), random(-1, 1) };
  return result;
}

} // namespace test_systems

#endif // RANDOM_BLOCK_MATRICES_H
