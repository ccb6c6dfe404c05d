// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_SESSION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_SESSION_H

#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Solver_vector.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Unknown_marks.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Is thrown by the solver of a run, through the parameterizer that uses it, where the run is to end. Not each one
// would end by itself.
struct Solver_gives_up
{ };

// What the copies of a Multigrid_solver_traits share: the hierarchy, and the solver that was set up last.
class Multigrid_session
  : private Deferring_solver
{
public:
  typedef Solver_vector   Vector;

  // Returns null if there is to be no hierarchy.
  typedef std::function<std::shared_ptr<const Hierarchy_interpolation>()>   Make_hierarchy;

  // `defers`, for a solver of two right sides: a first solution with a matrix is put off until it is read, or until the
  // next right side comes: two of them are solved side by side in little more than the time of one. Whether that
  // succeeds is told by finish() only.
  Multigrid_session(std::shared_ptr<const Hierarchy_interpolation> interpolation, Mesh_unknowns unknowns,
                    const Linear_solver_options& options, Make_linear_solver make_solver, bool defers = false);

  // The unknowns are in the order of the hierarchy's input. The hierarchy is made when the first matrix needs it.
  Multigrid_session(Make_hierarchy make_hierarchy, const Linear_solver_options& options,
                    Make_linear_solver make_solver, bool defers = false);

  Multigrid_session(const Multigrid_session&) = delete;
  Multigrid_session& operator=(const Multigrid_session&) = delete;
  CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE ~Multigrid_session() override;

  const Linear_solver_summary& summary() const { return m_summary; }

  // Allows this: where a system's unknowns do not sit at the vertices in their order, the solution becomes marks of the
  // unknowns. The map that is made of these goes to read_marks(), and from then on it is known where they sit.
  void allow_marks() { m_marks.allow(); }
  bool has_given_marks() const { return m_marks.are_given(); }
  void read_marks(const std::vector<Point_2>& map) { m_marks.read(map, *m_unknowns); }

  // Sets up the solver for a matrix, unless it is the one of the last time; `tied_vertices` as for
  // make_multigrid_linear_solver(). Of unknowns that do not match the mesh, and of a matrix that does not suit
  // multigrid, the solver solves directly.
  bool set_up(const Sparse_matrix& matrix, const std::vector<Index>& tied_vertices = {});

  // Solves with a matrix for one right side. In a run, it gives up if the run is stopped, or after some failures.
  CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE virtual bool solve(const Sparse_matrix& matrix, const Vector& right_side,
                                                               Vector& solution);

  // Solves for one right side with the last matrix.
  bool solve(const Vector& right_side, Vector& solution);

  // Solves a system whose unknowns are in the order of the hierarchy's input, for as many right sides as the solver was
  // made for. The solutions may take their place.
  bool solve(std::shared_ptr<const Sparse_rows<double>> rows,
             const std::vector<const std::vector<double>*>& right_sides,
             const std::vector<std::vector<double>*>& solutions);

  // Finds what was put off. Returns false if one of the solutions that nobody has been told of could not be found:
  // those that finish() or a reader asked for. The second call of a pair tells of both itself.
  bool finish();

private:
  void solve_now() override { finish(); }
  bool suits_multigrid(const Sparse_rows<double>& rows) const;
  bool find_hierarchy();

  // Starts a stage of the run's progress, the part of it that a solution takes times a factor. Returns whether the run
  // may go on.
  bool start_stage(double factor) const;
  bool set_up(std::shared_ptr<const Sparse_rows<double>> rows, const std::vector<Index>& tied_vertices);
  bool set_up_multigrid(std::shared_ptr<const Sparse_rows<double>> rows, const std::vector<Index>& tied_vertices);
  bool make_solver(std::shared_ptr<const Sparse_rows<double>> rows, std::vector<Mesh_unknown> unknowns,
                   const std::vector<Index>& tied_vertices);
  bool put_off(const Vector& right_side, Vector& solution);
  bool solve(const std::vector<const std::vector<double>*>& right_sides,
             const std::vector<std::vector<double>*>& solutions);
  std::shared_ptr<Vector::Numbers> take_waiting_solution();

  Make_hierarchy m_make_hierarchy;
  std::shared_ptr<const Hierarchy_interpolation> m_interpolation;     // null until it is made
  std::optional<Mesh_unknowns> m_unknowns;
  Unknown_marks m_marks;
  Linear_solver_options m_options;
  Make_linear_solver m_make_solver;
  bool m_defers;
  std::unique_ptr<Linear_solver> m_solver;
  std::vector<double> m_waiting_right_side;
  std::shared_ptr<Vector::Numbers> m_waiting_solution;
  bool m_all_solved = true;       // of what was put off
  std::size_t m_failures = 0;     // in a row
  bool m_has_grids = false;       // the solver
  bool m_last_was_direct = false;
  std::size_t m_vain_matrices = 0;        // in a row, which the grids did not solve
  Linear_solver_summary m_summary;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MULTIGRID_SESSION_H
