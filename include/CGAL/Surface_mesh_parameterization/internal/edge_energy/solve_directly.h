// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_SOLVE_DIRECTLY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_SOLVE_DIRECTLY_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/Edge_system.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The matrix of an edge system without its fixed vertices, its two right sides, and where its unknowns belong.
struct Edge_matrix
{
  Eigen::SparseMatrix<double> matrix;
  Eigen::MatrixX2d right_side;
  std::vector<Index> vertices;      // of the unknowns

  explicit Edge_matrix(const Edge_system& system)
  {
    const Level& level = system.level();
    std::vector<Index> unknown(system.size(), no_index);
    for (Index i = 0; i < system.size(); ++i)
      if (!level.is_fixed(i)) {
        unknown[i] = Index(vertices.size());
        vertices.push_back(i);
      }

    const Index n = Index(vertices.size());
    matrix.resize(n, n);
    right_side.setZero(n, 2);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(n + level.rings().number_of_slots());
    for (Index row = 0; row < n; ++row) {
      const Index i = vertices[row];
      const Level::Ring ring = level.one_ring(i);
      entries.emplace_back(row, row, system.sum_of_weights(i));
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Index j = ring[k];
        if (unknown[j] != no_index)
          entries.emplace_back(row, unknown[j], -system.weight(i, k));
        else
          right_side.row(row) += system.weight(i, k) * Eigen::RowVector2d(level.fixed_place(j).x(), level.fixed_place(j).y());
      }
    }
    matrix.setFromTriplets(entries.begin(), entries.end());
  }
};

// Solves an edge system by factorization. Returns `OK`, or `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM` if it is singular: for one, because no vertex is fixed.
template <bool is_symmetric>
Error_code solve_directly(const Edge_system& system, Level::Uv& uv)
{
  typedef Eigen::SparseMatrix<double>   Matrix;
  typedef std::conditional_t<is_symmetric, Eigen::SimplicialLDLT<Matrix>, Eigen::SparseLU<Matrix>>   Solver;

  const Level& level = system.level();
  uv.assign(system.size(), Point_2(0, 0));
  for (Index i = 0; i < system.size(); ++i)
    if (level.is_fixed(i))
      uv[i] = level.fixed_place(i);

  const Edge_matrix a(system);
  if (a.vertices.empty())
    return OK;
  if (a.vertices.size() == system.size())
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  Solver solver;
  solver.compute(a.matrix);
  if (solver.info() != Eigen::Success)
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  const Eigen::MatrixX2d solution = solver.solve(a.right_side);
  if (!solution.allFinite())
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  for (std::size_t row = 0; row < a.vertices.size(); ++row)
    uv[a.vertices[row]] = Point_2(solution(row, 0), solution(row, 1));
  return OK;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_SOLVE_DIRECTLY_H
