// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERIZATION_SUMMARY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERIZATION_SUMMARY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationRef
///
/// the status of a run that a visitor stopped, a value that CGAL's enumeration leaves free. CGAL's
/// `get_error_message()` answers "Unknown error" for it, `error_message()` knows it
constexpr Error_code ERROR_STOPPED = Error_code(15);
static_assert(ERROR_WRONG_PARAMETER < ERROR_STOPPED, "the value of ERROR_STOPPED is a code of CGAL's");

/// \ingroup PkgHierarchicalParameterizationRef
///
/// What went wrong, and where.
struct Parameterization_error
{
  /// what `index` counts
  enum Place { NOWHERE, VERTEX, FACE };

  Error_code code = OK;       ///< `OK` if nothing went wrong
  Place place = NOWHERE;      ///< whether the error lies at a vertex, at a face, or at no particular place
  std::size_t index = 0;      ///< the position of that vertex or face in `vertices(mesh)` or `faces(mesh)`, from 0
  const char* cause = nullptr;      ///< what is wrong, in words, where the code can mean many things; else null. A
                                    ///< string literal: it stays valid, and nobody frees it
};

/// \ingroup PkgHierarchicalParameterizationRef
///
/// One level of a run.
struct Level_summary
{
  std::size_t vertices = 0;       ///< number of vertices
  std::size_t faces = 0;          ///< number of triangles
  /// the method's energy, as `Parameterization_summary::energy`, of the map with the new vertices, before refinement
  double energy_start = 0;
  double energy_end = 0;          ///< the same after refinement
  std::size_t iterations = 0;     ///< the method's iterations: Newton steps, sweeps, or those of a linear solver
  std::size_t cycles = 0;         ///< multigrid cycles in all Newton steps
  std::size_t vertex_visits = 0;  ///< steps of vertex relaxation, one vertex each
  bool converged = false;         ///< whether the method converged on this level, by its own criterion
  double seconds = 0;             ///< wall-clock time of insertion and refinement
};

/// \ingroup PkgHierarchicalParameterizationRef
///
/// What a `Multigrid_solver_traits` did.
struct Linear_solver_summary
{
  std::size_t setups = 0;             ///< matrices for which grids were set up, or which were to be solved without
  std::size_t right_sides = 0;        ///< right-hand sides that were given
  std::size_t failures = 0;           ///< right-hand sides that no solver solved, as was reported to the parameterizer
  /// the maximum number of iterations for one right-hand side, of conjugate gradients, BiCGSTAB or GMRES
  std::size_t iterations = 0;
  /// the maximum relative residual of a solution, recomputed at the end; rows scaled to unit diagonal. It is at most
  /// the tolerance, unless rounding leaves more, as of a nearly singular matrix
  double residual = 0;
  /// right-hand sides for which there was no multigrid, as with LSCM on small surfaces, or no convergence: the solver
  /// of the parameterizer solved, or a direct one
  std::size_t direct_solutions = 0;
  double seconds_setup = 0;           ///< wall-clock time of the setups
  double seconds_solve = 0;           ///< wall-clock time of the iterations and direct solutions
};

/// \ingroup PkgHierarchicalParameterizationRef
///
/// What a run of a parameterizer did, beyond the `Error_code` that it returns.
struct Parameterization_summary
{
  Parameterization_error error;           ///< what went wrong, and where
  /// whether the finest level converged; of a method that solves linear systems, whether it got all solutions. The
  /// guarantees about flips do not depend on it
  bool converged = false;
  /// the method's energy of the result. With `Triangle_weight::ONE`, as of MIPS, it is a sum over the triangles; with
  /// `AREA`, as of symmetric Dirichlet, the mean over the area. Both have no unit if the energy of a triangle has none.
  /// Springs are included, of a mean divided by the area. ARAP and edge energies are half of a sum, in squared units of
  /// the mesh and of the map, without springs. After a repair it is that of the new map, if the method has the energy
  /// of any map, see `RefinableParameterizer_3`. 0 for the linear methods of CGAL, unless another method's map replaced
  /// theirs: then it is that method's energy, and `levels` are its levels
  double energy = 0;
  /// from the coarsest level to the finest; the finest only where the run started from a map, be it the user's or one
  /// with cracks closed or many small holes filled; none for the linear methods of CGAL, unless their map was replaced
  std::vector<Level_summary> levels;
  /// triangles that the method flipped, before a repair, see `Flip_policy`; if there are none, interior vertices around
  /// which its map winds more than once, and border vertices whose angles sum to 360 degrees or more. Not counted if
  /// the policy is `KEEP`
  std::size_t flips = 0;
  /// vertices that the repair moved, those in the middle of filled holes included; all if the map was replaced
  std::size_t moved_vertices = 0;
  /// whether a method without flips made another map, since the repair failed, or left little of the map, or raised its
  /// energy much
  bool is_replaced = false;
  Linear_solver_summary linear_solver;    ///< of a method that solves linear systems by multigrid
  double seconds_hierarchy = 0;           ///< wall-clock time of reading the mesh and of building the hierarchy
  double seconds_parameterize = 0;        ///< wall-clock time from the coarsest level to the result

  /// whether there is a map
  bool is_ok() const { return error.code == OK; }
};

namespace internal {

template <class Summary>
struct Summary_check : std::is_same<Summary, std::reference_wrapper<Parameterization_summary>>
{
  static void tell()
  {
    static_assert(Summary_check::value,
                  "the named parameter 'summary' needs a reference to a Parameterization_summary, because a copy of it "
                  "would be filled: write summary(std::ref(s))");
  }
};

// The summary that the caller wants to have filled, given as `summary(std::ref(s))`, or null.
template <class NamedParameters>
Parameterization_summary* summary_of(const NamedParameters& np)
{
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::summary_t>::value) {
    const auto summary = parameters::get_parameter(np, internal_np::summary);
    typedef Summary_check<std::decay_t<decltype(summary)>>   Check;
    if constexpr (Check::value)
      return &summary.get();
    else
      Check::tell();
  }
  return nullptr;
}

} // namespace internal

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERIZATION_SUMMARY_H
