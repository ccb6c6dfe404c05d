// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_REBIND_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_REBIND_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/core/concept_checks.h>

#include <CGAL/Default.h>

namespace CGAL::Surface_mesh_parameterization {

/// \cond SKIP_IN_MANUAL
template <class, class> class Orbifold_Tutte_parameterizer_3;

namespace internal {

// The solver traits of a parameterizer whose third template argument they are: where that is CGAL's default, the
// parameterizer tells which it takes.
template <class Parameterizer, class ThirdArgument>
struct Solver_traits_of
{
  typedef ThirdArgument   type;
};

template <class Parameterizer>
struct Solver_traits_of<Parameterizer, Default>
{
  typedef Detected<concept_checks::Solver_traits_of, Parameterizer>   type;
};

template <bool is_solver, class Rebound>
struct Rebound_solver { };

template <class Rebound>
struct Rebound_solver<true, Rebound>
{
  typedef Rebound   type;
};

} // namespace internal
/// \endcond

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// The member `type` is the same parameterizer with the solver `SolverTraits`.
///
/// It is defined for all parameterizers with the template parameters of CGAL's: a mesh, a border parameterizer and
/// solver traits. The last argument must have the `linear_solver()` of a `SparseLinearAlgebraTraits_d`. If it is
/// `CGAL::Default`, the parameterizer must have a type `Solver_traits` that has it. For any other model of
/// `RebindableParameterizer_3`, specialize it, and `Hierarchical_parameterizer_3` takes the parameterizer. Such a
/// parameterizer solves linear systems whose unknowns sit at the vertices:
/// \code
///   namespace CGAL::Surface_mesh_parameterization {
///   template <class Mesh, class Solver, class NewSolver>
///   struct Rebind_solver<My_parameterizer_3<Mesh, Solver>, NewSolver>
///   {
///     typedef My_parameterizer_3<Mesh, NewSolver> type;
///   };
///   }
/// \endcode
/// Such a parameterizer makes its solver by the default constructor, for example as the default of an argument of its
/// own constructor.
///
/// A class that derives from one of CGAL's parameterizers is such a template, too, if it hands the solver to its base:
/// \code
///   template <class Mesh, class Border = CGAL::Default, class Solver = CGAL::Default>
///   class My_parameterizer_3 : public SMP::Fixed_border_parameterizer_3<Mesh, Border, Solver> { ... };
/// \endcode
template <class Parameterizer, class SolverTraits>
struct Rebind_solver { };

/// \cond SKIP_IN_MANUAL
template <template <class, class, class> class Parameterizer, class TriangleMesh, class BorderParameterizer,
          class OldSolverTraits, class SolverTraits>
struct Rebind_solver<Parameterizer<TriangleMesh, BorderParameterizer, OldSolverTraits>, SolverTraits>
  : internal::Rebound_solver<
        internal::concept_checks::is_solver<typename internal::Solver_traits_of<
            Parameterizer<TriangleMesh, BorderParameterizer, OldSolverTraits>, OldSolverTraits>::type>,
        Parameterizer<TriangleMesh, BorderParameterizer, SolverTraits>>
{ };

template <class SeamMesh, class OldSolverTraits, class SolverTraits>
struct Rebind_solver<Orbifold_Tutte_parameterizer_3<SeamMesh, OldSolverTraits>, SolverTraits>
{
  typedef Orbifold_Tutte_parameterizer_3<SeamMesh, SolverTraits>   type;
};
/// \endcond

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_REBIND_SOLVER_H
