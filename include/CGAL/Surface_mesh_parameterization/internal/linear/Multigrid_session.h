// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_SESSION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_SESSION_H

#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_linear_solver.h>

#include <CGAL/Eigen_vector.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// What the copies of a Multigrid_solver_traits share: the interpolation, and the solver that was set up last.
class Multigrid_session
{
public:
  typedef Eigen_vector<double>   Vector;

  // `solves_in_pairs`: the caller solves twice with every matrix before it looks at a solution, and calls finish() at the end.
  Multigrid_session(std::shared_ptr<const Hierarchy_interpolation> interpolation, Mesh_unknowns unknowns, const Multigrid_linear_solver::Options& options,
                    bool solves_in_pairs = false)
    : m_interpolation(std::move(interpolation)), m_unknowns(std::move(unknowns)), m_options(options), m_solves_in_pairs(solves_in_pairs)
  { }

  virtual ~Multigrid_session() = default;

  const Linear_solver_summary& summary() const { return m_summary; }

  // Sets up the solver for a matrix, unless it is the one of the last time; `tied_vertices` as for Multigrid_linear_solver.
  bool set_up(const Sparse_matrix& matrix, const std::vector<Index>& tied_vertices = {})
  {
    std::shared_ptr<const Sparse_rows<double>> rows = matrix.rows();
    if (m_solver && m_solver->rows() == rows)
      return true;
    m_solver.reset();
    const std::size_t n = rows->number_of_rows();
    std::vector<Mesh_unknown> unknowns = m_unknowns.of_system(n);
    if (matrix.column_dimension() != matrix.row_dimension() || unknowns.size() != n)
      return false;
    CGAL::Real_timer timer;
    timer.start();
    m_solver = std::make_unique<Multigrid_linear_solver>(*m_interpolation, std::move(rows), std::move(unknowns), tied_vertices);
    ++m_summary.setups;
    m_summary.seconds_setup += timer.time();
    return true;
  }

  // Solves with a matrix for one right side.
  virtual bool solve(const Sparse_matrix& matrix, const Vector& right_side, Vector& solution)
  {
    return m_solves_in_pairs ? solve_with_next(matrix, right_side, solution) : set_up(matrix) && solve(right_side, solution);
  }

  // Solves for one right side with the last matrix.
  bool solve(const Vector& right_side, Vector& solution)
  {
    return m_solver && solve<1>({ &right_side }, { &solution });
  }

  // Solves what still waits for its partner.
  bool finish()
  {
    Vector* const solution = std::exchange(m_waiting_solution, nullptr);
    return !solution || (m_solver && solve<1>({ &m_waiting_right_side }, { solution }));
  }

private:
  // Puts a right side off until the next one comes: two of them are solved side by side in little more than the time of one.
  bool solve_with_next(const Sparse_matrix& matrix, const Vector& right_side, Vector& solution)
  {
    if (m_waiting_solution && m_solver && m_solver->rows() == matrix.rows()) {
      Vector* const first_solution = std::exchange(m_waiting_solution, nullptr);
      return solve<2>({ &m_waiting_right_side, &right_side }, { first_solution, &solution });
    }
    if (!finish() || !set_up(matrix))
      return false;
    m_waiting_right_side = right_side.eigen_object();
    m_waiting_solution = &solution;
    return true;
  }

  // Right sides as one vector of their values.
  template <int columns>
  struct Side_by_side
  {
    const std::array<const Vector::EigenType*, columns>& right_sides;

    Values<double, columns> operator[](Index i) const
    {
      Values<double, columns> values;
      for (int c = 0; c < columns; ++c)
        values[c] = (*right_sides[c])[i];
      return values;
    }
  };

  template <int columns>
  bool solve(const std::array<const Vector::EigenType*, columns>& right_sides, const std::array<Vector*, columns>& solutions)
  {
    CGAL::Real_timer timer;
    timer.start();
    const Index n = m_solver->rows()->number_of_rows();
    if (std::any_of(right_sides.begin(), right_sides.end(), [n](const Vector::EigenType* b) { return std::size_t(b->size()) != n; }))
      return false;
    Value_vector<double, columns> x;
    const Multigrid_linear_solver::Result result = m_solver->solve(Side_by_side<columns>{ right_sides }, x, m_options);
    m_summary.right_sides += columns;
    m_summary.iterations = (std::max)(m_summary.iterations, result.iterations);
    m_summary.residual = (std::max)(m_summary.residual, result.residual);
    m_summary.direct_solutions += result.is_direct ? columns : 0;
    if (result.is_solved)
      for (int c = 0; c < columns; ++c) {
        solutions[c]->resize(n);
        for (Index i = 0; i < n; ++i)
          (*solutions[c])[i] = x[i][c];
      }
    m_summary.seconds_solve += timer.time();
    return result.is_solved;
  }

  std::shared_ptr<const Hierarchy_interpolation> m_interpolation;
  Mesh_unknowns m_unknowns;
  Multigrid_linear_solver::Options m_options;
  bool m_solves_in_pairs;
  std::unique_ptr<Multigrid_linear_solver> m_solver;
  Vector::EigenType m_waiting_right_side;
  Vector* m_waiting_solution = nullptr;
  Linear_solver_summary m_summary;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_SESSION_H
