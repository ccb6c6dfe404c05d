// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_HIERARCHICAL_BASE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_HIERARCHICAL_BASE_H

#include <CGAL/Surface_mesh_parameterization/Nested_iteration_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/concepts.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Refused.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/concept_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Short_calls.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Wrapped_as_rigid_as_possible_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Wrapped_orbifold_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Wrapped_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/adaptor_checks.h>

namespace CGAL::Surface_mesh_parameterization {

template <class, class, class> class ARAP_parameterizer_3;

namespace internal {

template <class Base>
struct Base_type
{
  typedef Base   type;
};

// How a parameterizer is run hierarchically.
template <class Parameterizer, class ConcurrencyTag>
constexpr auto hierarchical_base()
{
  if constexpr (!Shipped_check<Parameterizer>::value)
    return Base_type<Refused<Shipped_check<Parameterizer>>>();
  else if constexpr (is_refinable_parameterizer_v<Parameterizer>)
    return Base_type<Short_calls<Parameterizer, Nested_iteration_parameterizer_3<Parameterizer, ConcurrencyTag>>>();
  else if constexpr (is_rebindable_parameterizer_v<Parameterizer>)
    return Base_type<Short_calls<Parameterizer, Wrapped_parameterizer_3<Parameterizer, ConcurrencyTag>>>();
  else if constexpr (looks_refinable<Parameterizer>)
    return Base_type<Refused<Method_check<Parameterizer>>>();
  else
    return Base_type<Refused<No_parameterizer<Parameterizer>>>();
}

template <class Parameterizer, class ConcurrencyTag>
struct Hierarchical_base
{
  typedef typename decltype(hierarchical_base<Parameterizer, ConcurrencyTag>())::type   type;
};

template <class TriangleMesh, class BorderParameterizer, class SolverTraits, class ConcurrencyTag>
struct Hierarchical_base<ARAP_parameterizer_3<TriangleMesh, BorderParameterizer, SolverTraits>, ConcurrencyTag>
{
  typedef Short_calls<ARAP_parameterizer_3<TriangleMesh, BorderParameterizer, SolverTraits>,
                      Wrapped_as_rigid_as_possible_3<TriangleMesh, BorderParameterizer, ConcurrencyTag>>   type;
};

template <class SeamMesh, class SolverTraits, class ConcurrencyTag>
struct Hierarchical_base<Orbifold_Tutte_parameterizer_3<SeamMesh, SolverTraits>, ConcurrencyTag>
{
  typedef Wrapped_orbifold_parameterizer_3<SeamMesh, SolverTraits, ConcurrencyTag>   type;
};

} // namespace internal

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_HIERARCHICAL_BASE_H
