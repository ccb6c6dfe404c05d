// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_LINEAR_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_LINEAR_SOLVER_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

struct Linear_solver_options
{
  // Of the residual, relative to that of the free unknowns at 0; rows scaled to unit diagonal. What is less than the
  // rounding error counts as that.
  double tolerance = 1e-10;
  // Once it is below the tolerance, the residual goes on to this times the tolerance, or to what rounding leaves, as
  // long as so many steps in a row halve it; bi-conjugate gradients take two steps in an iteration.
  double aim = 1;
  int patience_below_tolerance = 4;
  std::size_t most_iterations = 300;
  // Rounding lets the residual that an iteration carries along drift away from the true one: then it starts again from
  // there, at most so often.
  int most_starts = 3;
  // The most iterations in which the residual is not halved: of an indefinite matrix it may wander about for ever.
  int patience = 60;
  // The same of minimal residuals, for matrices that are neither symmetric nor diagonally dominant, which never grow;
  // and the most iterations for which they keep two vectors each, before they start again.
  int patience_of_minimal_residuals = 10;
  std::size_t most_residuals = 40;
  // An iteration may come as near to the solution as rounding allows, and its residual stay above the tolerance: then
  // the backward error of the free unknowns is below this.
  double rounding_error = 1e-15;
  // Of a solution without iteration: of a nearly singular matrix, none has a residual below the tolerance.
  double worst_backward_error = 1e-10;
  // The relative residual, as above, of such solutions. Of a matrix that is regular only by rounding, the solution is
  // huge: next to its terms any residual is small, and the backward error tells nothing.
  double worst_residual = 1e-3;
  // After so many iterations, or when half of the patience is gone, one right side has K-cycles: they take about three
  // times as long, but where an energy hardly changes with conformal motions, as that of least squares conformal maps,
  // they save more than that in the end.
  std::size_t most_v_cycles = 100;
  Loops loops;                // of the solver
  bool has_grids = true;      // else matrices are solved without multigrid
  // A matrix is solved without multigrid if more than so many rows are wild, or more than one of so many: the entries
  // beside the diagonal have a sum of absolute values that is greater than this, relative to the diagonal. Each one
  // takes a few iterations.
  double greatest_row_sum = (std::numeric_limits<double>::infinity)();
  std::size_t most_wild_rows = 40;
  std::size_t rows_for_a_wild_one = 300;
  // After so many matrices in a row that multigrid has tried to solve in vain, the next ones are solved without it.
  std::size_t most_vain_matrices = (std::numeric_limits<std::size_t>::max)();
  // For what multigrid does not solve, and to be checked: if its residual is above the tolerance, a factorization takes
  // over. Null: a factorization at once.
  Make_direct_solver make_direct_solver = nullptr;
  bool may_solve_directly = true;       // if not, what multigrid does not solve stays unsolved
  Run_progress* progress = nullptr;     // is told of each iteration, and may end them unsolved; may be null
  double part_of_rest = 0.9;            // of the progress's run: a solution takes so much of what is left, more or less
};

inline bool is_stopped(const Linear_solver_options& options)
{
  return options.progress && options.progress->is_stopped();
}

struct Linear_solver_result
{
  bool is_solved = false;
  bool is_direct = false;       // not by multigrid
  bool is_factorized = false;   // by a factorization, which no other solver has to try before
  std::size_t iterations = 0;
  double residual = 0;          // the relative one, computed at the end; the greatest of the right sides
};

// Solves linear systems with one matrix.
class Linear_solver
{
public:
  virtual ~Linear_solver() = default;

  virtual const std::shared_ptr<const Sparse_rows<double>>& rows() const = 0;

  // Solves for one right side, or for two side by side if the solver was made for them; writes the solutions, of the
  // right sides' size, if all is solved.
  virtual Linear_solver_result solve(const std::vector<const double*>& right_sides,
                                     const std::vector<double*>& solutions, const Linear_solver_options& options) = 0;
};

// A Multigrid_linear_solver for a matrix, and for so many right sides side by side. The other arguments as there.
//
// A template for the sake of who uses the package header-only: what does not solve linear systems, or not in pairs,
// need not compile it.
template <int most_right_sides>
std::unique_ptr<Linear_solver>
make_multigrid_linear_solver(const Hierarchy_interpolation* hierarchy, std::shared_ptr<const Sparse_rows<double>> rows,
                             std::vector<Mesh_unknown> unknowns, const std::vector<Index>& tied_vertices,
                             const Loops& loops);

typedef decltype(&make_multigrid_linear_solver<1>)   Make_linear_solver;

#ifdef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
extern template std::unique_ptr<Linear_solver>
make_multigrid_linear_solver<1>(const Hierarchy_interpolation*, std::shared_ptr<const Sparse_rows<double>>,
                                std::vector<Mesh_unknown>, const std::vector<Index>&, const Loops&);
extern template std::unique_ptr<Linear_solver>
make_multigrid_linear_solver<2>(const Hierarchy_interpolation*, std::shared_ptr<const Sparse_rows<double>>,
                                std::vector<Mesh_unknown>, const std::vector<Index>&, const Loops&);
#endif

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_LINEAR_SOLVER_H
