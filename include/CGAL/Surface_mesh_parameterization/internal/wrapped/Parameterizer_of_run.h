// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_PARAMETERIZER_OF_RUN_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_PARAMETERIZER_OF_RUN_H

#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Rebind_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Conformal_system.h>

namespace CGAL::Surface_mesh_parameterization {

template <class, class, class> class LSCM_parameterizer_3;

namespace internal {

// What a run makes of the arguments of a parameterizer's constructor: mostly the parameterizer with another solver.
template <class Parameterizer>
struct Parameterizer_of_run
  : Rebind_solver<Parameterizer, Multigrid_solver_traits>
{ };

template <class M, class B, class S>
struct Parameterizer_of_run<LSCM_parameterizer_3<M, B, S>>
{
  typedef Conformal_system<M, typename LSCM_parameterizer_3<M, B, S>::Border_parameterizer>   type;
};

} // namespace internal

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_PARAMETERIZER_OF_RUN_H
