// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_LINEAR_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_LINEAR_SOLVER_H

#include <CGAL/Surface_mesh_parameterization/Option_defaults.h>
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

// Residuals are relative to that of the free unknowns at 0, with rows scaled to unit diagonal.
struct Linear_solver_options
{
  // When an iteration ends: by the residual, or by the rounding error if that is greater.
  double tolerance = Option_defaults::tolerance_of_linear_solver;
  // Once it is below the tolerance, the residual goes on to this times the tolerance, or to what rounding leaves, as
  // long as so many steps in a row halve it; bi-conjugate gradients take two steps in an iteration.
  double aim = 1;
  int patience_below_tolerance = 4;
  std::size_t most_iterations = Option_defaults::iterations_of_linear_solver;
  int patience = 60;                    // iterations that do not halve the residual; an indefinite matrix may have many
  double rounding_error = 1e-15;        // a backward error of the free unknowns that is as good as the tolerance
  int most_starts = 3;                  // from the true residual, when rounding has let the carried one drift away

  // Minimal residuals, for matrices that are neither symmetric nor diagonally dominant.
  int patience_of_minimal_residuals = 10;
  std::size_t most_residuals = 40;      // iterations until a restart; each one keeps two vectors

  // After so many iterations, or half of the patience, one right side gets K-cycles. They take about three times as
  // long, but save more than that where an energy hardly changes with conformal motions, as in least squares conformal
  // maps.
  std::size_t most_v_cycles = 100;

  // When a matrix is solved without multigrid. A row is wild if the absolute values beside its diagonal sum up to more
  // than a factor times the diagonal; each one costs a few iterations.
  bool has_grids = true;
  double greatest_row_sum = (std::numeric_limits<double>::infinity)();      // that factor
  std::size_t most_wild_rows = 40;
  std::size_t rows_for_a_wild_one = 300;
  std::size_t most_vain_matrices = (std::numeric_limits<std::size_t>::max)();     // tried in a row and not solved

  // Solutions in a row that fail, after which Solver_gives_up is thrown.
  std::size_t most_failures = (std::numeric_limits<std::size_t>::max)();

  // Solutions without iteration: of a nearly singular matrix, none has a residual below the tolerance. Of one that is
  // regular by rounding only, they are huge, so that their backward error is small whatever they are.
  double worst_backward_error = 1e-10;
  double worst_residual = 1e-3;
  // Solves what multigrid does not solve; if the result has a residual above the tolerance, or if this is null, a
  // factorization does.
  Make_direct_solver make_direct_solver = nullptr;
  bool may_solve_directly = true;       // if not, what multigrid does not solve stays unsolved

  Loops loops;
  Run_progress* progress = nullptr;     // is told of each iteration, and may end them unsolved; may be null
  double part_of_rest = 0.9;            // of the progress's run: what a solution takes of the rest, more or less
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
  // right sides' size and maybe in their place, if all is solved.
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
