// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIGRID_SYSTEMS_H
#define MULTIGRID_SYSTEMS_H

#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/boost/graph/properties.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Systems that sit on a mesh, with their solvers.
namespace test_systems {

using namespace test_meshes;
namespace parameters = CGAL::parameters;
using SMP::Multigrid_solver_traits;
using SMP::internal::Sparse_matrix;

typedef Multigrid_solver_traits::Vector   Vector;

// An edge energy's matrix with an unknown at each vertex in the order of the input; rows of border vertices hold
// nothing but the diagonal.
template <class EdgeWeights>
Sparse_matrix edge_matrix(const Flat_mesh& m, EdgeWeights edge_weights)
{
  const One_rings rings(m.points.size(), m.triangles);
  Sparse_matrix result(m.points.size());
  std::vector<Point_3> ring;
  std::vector<double> weights;
  for (Index v = 0; v < m.points.size(); ++v) {
    double sum = 0;
    if (!rings.is_border(v)) {
      ring.clear();
      for (const Index w : rings[v])
        ring.push_back(m.points[w]);
      edge_weights(m.points[v], ring, true, weights);
      std::size_t i = 0;
      for (const Index w : rings[v]) {
        result.set_coef(v, w, -weights[i], true);
        sum += weights[i++];
      }
    }
    result.set_coef(v, v, sum == 0 ? 1 : sum, true);
  }
  return result;
}

// A system of which the solution is known.
struct Known_system
{
  Sparse_matrix matrix;
  Vector right_side, expected;

  explicit Known_system(Sparse_matrix m)
    : matrix(std::move(m)), right_side(matrix.row_dimension()), expected(matrix.row_dimension())
  {
    const auto rows = matrix.rows();
    Random random(11);
    for (int i = 0; i < matrix.row_dimension(); ++i)
      expected[i] = random(-1, 1);
    for (int i = 0; i < matrix.row_dimension(); ++i)
      for (Index k = rows->first[i]; k < rows->first[i + 1]; ++k)
        right_side[i] += rows->values[k] * expected[rows->columns[k]];
  }

  double error(const Vector& x) const
  {
    double result = 0;
    for (std::size_t i = 0; i < expected.size(); ++i)
      result = std::isnan(x[i]) ? x[i] : (std::max)(result, std::abs(x[i] - expected[i]));
    return result;
  }
};

// The system with its rows negated, but for those that give a value.
inline Known_system negative(const Known_system& system)
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

// A mesh with a solver on it, whose unknowns have the order of the vertices.
struct Solver_on_mesh
{
  Surface_mesh mesh;
  Multigrid_solver_traits solver;

  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Solver_on_mesh(const Flat_mesh& m, const NamedParameters& np = parameters::default_values())
    : mesh(make<Surface_mesh>(m)), solver(mesh, longest_border(mesh), get(CGAL::vertex_index, mesh), np)
  { }
};

// Checks that a solver finds the solution of a system.
inline void expect_solved(Multigrid_solver_traits& solver, const Known_system& system, double tolerance = 1e-8)
{
  Vector x;
  double d;
  EXPECT_TRUE(solver.linear_solver(system.matrix, system.right_side, x, d));
  EXPECT_LT(system.error(x), tolerance);
}

} // namespace test_systems

#endif // MULTIGRID_SYSTEMS_H
