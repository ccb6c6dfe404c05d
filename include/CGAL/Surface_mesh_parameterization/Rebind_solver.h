// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_REBIND_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_REBIND_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

namespace CGAL::Surface_mesh_parameterization {

/// \cond SKIP_IN_MANUAL
template <class, class> class Orbifold_Tutte_parameterizer_3;
/// \endcond

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// Tells how a parameterizer is made to use another solver: `type` is the same parameterizer with `SolverTraits`.
///
/// Parameterizers with the template parameters of CGAL's, a mesh, a border parameterizer and solver traits, are covered. A specialization opens
/// `Hierarchical_parameterizer_3` to any other one that solves linear systems with one unknown, or the same number of unknowns, at each vertex, numbered by the
/// vertex index map that it is called with (`RebindableParameterizer_3`):
/// \code
///   namespace CGAL::Surface_mesh_parameterization {
///   template <class Mesh, class Solver, class NewSolver>
///   struct Rebind_solver<My_parameterizer_3<Mesh, Solver>, NewSolver> { typedef My_parameterizer_3<Mesh, NewSolver> type; };
///   }
/// \endcode
/// Such a parameterizer makes its solver by the default constructor, be it as the default of an argument of its own constructor.
template <class Parameterizer, class SolverTraits>
struct Rebind_solver { };

/// \cond SKIP_IN_MANUAL
template <template <class, class, class> class Parameterizer, class TriangleMesh, class BorderParameterizer, class OldSolverTraits, class SolverTraits>
struct Rebind_solver<Parameterizer<TriangleMesh, BorderParameterizer, OldSolverTraits>, SolverTraits>
{
  typedef Parameterizer<TriangleMesh, BorderParameterizer, SolverTraits>   type;
};

template <class SeamMesh, class OldSolverTraits, class SolverTraits>
struct Rebind_solver<Orbifold_Tutte_parameterizer_3<SeamMesh, OldSolverTraits>, SolverTraits>
{
  typedef Orbifold_Tutte_parameterizer_3<SeamMesh, SolverTraits>   type;
};
/// \endcond

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_REBIND_SOLVER_H
