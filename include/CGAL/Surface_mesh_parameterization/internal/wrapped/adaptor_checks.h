// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_ADAPTOR_CHECKS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_ADAPTOR_CHECKS_H

#include <CGAL/Surface_mesh_parameterization/concepts.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/concept_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Solver_use.h>

#include <CGAL/Default.h>

#include <type_traits>

namespace CGAL::Surface_mesh_parameterization::internal {

// Of the arguments of CGAL's parameterizers, whose bodies would stumble over them.
template <class Parameterizer, bool = Solver_use<Parameterizer>::is_shipped>
struct Shipped_check : std::true_type { };

template <class Border, class Mesh>
struct Shipped_border_check
  : std::bool_constant<std::is_same<Border, Default>::value || concept_checks::has_parameterize<Border, Mesh>>
{
  static void tell()
  {
    static_assert(Shipped_border_check::value,
                  "the BorderParameterizer of the parameterizer has no parameterize(TriangleMesh&, "
                  "halfedge_descriptor, uvmap, vimap, vpmap) that returns an Error_code: see CGAL's Parameterizer_3");
  }
};

template <class Solver>
struct Shipped_solver_check : std::bool_constant<std::is_same<Solver, Default>::value || is_solver_traits_v<Solver>>
{
  static void tell()
  {
    static_assert(Shipped_solver_check::value,
                  "the SolverTraits of the parameterizer have no NT, Matrix, Vector or linear_solver(const Matrix&, "
                  "const Vector&, Vector&, NT&) that returns a bool: see CGAL's SparseLinearAlgebraTraits_d");
  }
};

template <template <class, class, class> class Parameterizer, class Mesh, class Border, class Solver>
struct Shipped_check<Parameterizer<Mesh, Border, Solver>, true>
  : std::conjunction<Mesh_check<Mesh>, Shipped_border_check<Border, Mesh>, Shipped_solver_check<Solver>>
{ };

template <class T> using Refine_member = decltype(&T::refine);
template <class T> using Parameterize_coarsest_member = decltype(&T::parameterize_coarsest);

// Whether a class has one of the members that only a model of RefinableParameterizer_3 needs.
template <class Parameterizer>
constexpr bool looks_refinable =
    is_detected<Refine_member, Parameterizer> || is_detected<Parameterize_coarsest_member, Parameterizer>;

template <class Parameterizer>
constexpr bool has_three_arguments = false;

template <template <class, class, class> class Parameterizer, class Mesh, class Border, class Solver>
constexpr bool has_three_arguments<Parameterizer<Mesh, Border, Solver>> = true;

// Tells why a parameterizer that is not refinable does not run with another solver either.
template <class Parameterizer>
struct No_parameterizer
{
  static void tell()
  {
    constexpr bool has_solver = is_detected<concept_checks::Solver_traits_of, Parameterizer>;
    constexpr bool is_like_CGALs = has_three_arguments<Parameterizer>;
    static_assert(!has_solver,
                  "P has a solver, but P is no template whose third argument are its solver traits, so it cannot get "
                  "the multigrid solver: specialize Rebind_solver<P, SolverTraits>, or make P a template of mesh, "
                  "border parameterizer and solver traits that hands these to its base class");
    static_assert(has_solver || !is_like_CGALs,
                  "the third template argument of P are no solver traits with linear_solver(A, B, X, D), so it is not "
                  "replaced by the multigrid solver: if P solves with another argument, specialize Rebind_solver<P, "
                  "SolverTraits>");
    static_assert(has_solver || is_like_CGALs,
                  "P is no parameterizer that runs hierarchically: it is no RefinableParameterizer_3, which has "
                  "parameterize_coarsest(level, uv) and refine(level, uv, summary), and no RebindableParameterizer_3, "
                  "for which Rebind_solver<P, SolverTraits> has a type");
  }
};

// Of a mesh that is given to a parameterizer.
template <class Parameterizer, class Mesh>
struct Same_mesh_check : std::is_convertible<const Mesh&, const typename Parameterizer::Triangle_mesh&>
{
  static void tell()
  {
    static_assert(Same_mesh_check::value, "mesh is of another type than the Triangle_mesh of the parameterizer");
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_ADAPTOR_CHECKS_H
