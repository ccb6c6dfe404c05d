// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Nested_iteration_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Rebind_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Wrapped_as_rigid_as_possible_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Wrapped_orbifold_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Wrapped_parameterizer_3.h>

#include <CGAL/boost/graph/properties.h>

#include <type_traits>
#include <utility>

namespace CGAL::Surface_mesh_parameterization {

/// \cond SKIP_IN_MANUAL
template <class, class, class> class ARAP_parameterizer_3;
/// \endcond

namespace internal {

template <class Parameterizer, class = void>
struct Is_refinable : std::false_type { };

template <class Parameterizer>
struct Is_refinable<Parameterizer, std::void_t<
    typename Parameterizer::Triangle_mesh, typename Parameterizer::Concurrency_tag, std::bool_constant<Parameterizer::is_flip_free>,
    decltype(std::declval<Parameterizer&>().parameterize_coarsest(std::declval<const Level&>(), std::declval<Level::Uv&>())),
    decltype(std::declval<Parameterizer&>().refine(std::declval<const Level&>(), std::declval<Level::Uv&>(), std::declval<Level_summary&>()))>>
  : std::true_type { };

template <class Parameterizer, class = void>
struct Has_rebindable_solver : std::false_type { };

template <class Parameterizer>
struct Has_rebindable_solver<Parameterizer, std::void_t<
    typename Parameterizer::Triangle_mesh, typename Rebind_solver<Parameterizer, Multigrid_solver_traits>::type>>
  : std::true_type { };

// How a parameterizer is run hierarchically.
template <class Parameterizer>
struct Hierarchical_base
{
  static constexpr bool is_refinable = Is_refinable<Parameterizer>::value;
  static_assert(is_refinable || Has_rebindable_solver<Parameterizer>::value,
                "Hierarchical_parameterizer_3<P>: P can be wrapped in neither way. Either P models RefinableParameterizer_3, that is, it has the types "
                "Triangle_mesh and Concurrency_tag, the constant is_flip_free and the members parameterize_coarsest(level, uv) and "
                "refine(level, uv, summary); or P solves linear systems through solver traits and Rebind_solver<P, Multigrid_solver_traits> has a type.");
  typedef std::conditional_t<is_refinable, Nested_iteration_parameterizer_3<Parameterizer>, Wrapped_parameterizer_3<Parameterizer>>   type;
};

template <class TriangleMesh, class BorderParameterizer, class SolverTraits>
struct Hierarchical_base<ARAP_parameterizer_3<TriangleMesh, BorderParameterizer, SolverTraits>>
{
  typedef Wrapped_as_rigid_as_possible_3<TriangleMesh, BorderParameterizer>   type;
};

template <class SeamMesh, class SolverTraits>
struct Hierarchical_base<Orbifold_Tutte_parameterizer_3<SeamMesh, SolverTraits>>
{
  typedef Wrapped_orbifold_parameterizer_3<SeamMesh, SolverTraits>   type;
};

} // namespace internal

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// Runs a parameterizer hierarchically.
///
/// A method that improves a given map (`RefinableParameterizer_3`) runs coarse to fine, level by level, by `Nested_iteration_parameterizer_3`,
/// whose constructor this class then has.
///
/// A parameterizer that solves linear systems, as most of CGAL's do, gives the same map as without this class, found by multigrid
/// (`Multigrid_solver_traits`, `Rebind_solver`). The constructor takes what that parameterizer's constructor takes, but for the solver, and then named parameters:
/// - `tolerance`, `number_of_iterations`: of the solver, see `Multigrid_solver_traits`
/// - `coarsest_size`, `random_seed`, `unit_edges`: of the hierarchy, see `Collapse_hierarchy_3`; `unit_edges` is `true` by default for
///   `Barycentric_mapping_parameterizer_3`, whose weights know nothing of lengths
/// - `flip_policy`: a `Flip_policy`: what becomes of a map with flips; default `FAIL`. Where a repair had to move more than a tenth of the vertices of LSCM's map,
///   the map of `MIPS_parameterizer_3` takes its place
/// - `fill_holes`: whether every further border is closed by a virtual vertex in the middle of it; default `false`: the border of a hole is free. On a `Surface_mesh`, and on a
///   `Polyhedron_3` if the constructor takes nothing else; otherwise an `ERROR_WRONG_PARAMETER`
/// - `visitor`: a model of `HierarchyVisitor_3`, of which `hierarchy_built()` is called
/// - `summary`: a `std::reference_wrapper<Parameterization_summary>` that receives what the run did; it must live as long as the parameterizer runs
///
/// CGAL's `ARAP_parameterizer_3` is the exception: in its place runs `As_rigid_as_possible_parameterizer_3`, level by level, which minimizes the same energy. The
/// constructor takes what CGAL's takes, but for the solver: `(lambda)` or `(border_parameterizer, lambda, iterations, tolerance)`, and then the named parameters of
/// that method and of `Nested_iteration_parameterizer_3`. The border parameterizer is not used.
///
/// CGAL's `Orbifold_Tutte_parameterizer_3` keeps its own call, `parameterize(mesh, bhd, cmap, uvmap, vimap)`, and its flips.
///
/// On an error the user's maps are untouched. Any other type is refused when it is compiled.
///
/// \code
///   namespace SMP = CGAL::Surface_mesh_parameterization;
///   SMP::Hierarchical_parameterizer_3<SMP::MIPS_parameterizer_3<Mesh>> mips;
///   SMP::Error_code status = SMP::parameterize(mesh, mips, bhd, uvmap);
///
///   typedef SMP::Square_border_arc_length_parameterizer_3<Mesh>   Border;
///   SMP::Hierarchical_parameterizer_3<SMP::Mean_value_coordinates_parameterizer_3<Mesh, Border>> mean_value(Border(v0, v1, v2, v3));
///   status = SMP::parameterize(mesh, mean_value, bhd, uvmap);
/// \endcode
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam Parameterizer a model of `RefinableParameterizer_3` or of `RebindableParameterizer_3`, or another one of CGAL's that is named above
template <class Parameterizer>
class Hierarchical_parameterizer_3
  : public internal::Hierarchical_base<Parameterizer>::type
{
  typedef typename internal::Hierarchical_base<Parameterizer>::type   Base;

public:
  using Base::Base;
};

/// \ingroup PkgHierarchicalParameterizationRef
///
/// parameterizes the connected component of `mesh` that contains `bhd`: what CGAL's `parameterize()` does, but without its preconditions. A mesh with
/// isolated vertices is one to parameterize, and what is no surface, as a closed mesh with a null halfedge, gets an error, whether assertions are checked or not.
///
/// \param mesh a triangulated surface
/// \param parameterizer the parameterizer
/// \param bhd a halfedge on the outer border of `mesh`
/// \param uvmap a writable property map from vertices to points of the plane; untouched on an error
///
/// \return what the parameterizer returns
template <class TriangleMesh, class Parameterizer, class Halfedge, class VertexUVMap>
Error_code parameterize(TriangleMesh& mesh, Hierarchical_parameterizer_3<Parameterizer> parameterizer, Halfedge bhd, VertexUVMap uvmap)
{
  return parameterizer.parameterize(mesh, bhd, uvmap, get(CGAL::dynamic_vertex_property_t<int>(), mesh), get(CGAL::dynamic_vertex_property_t<bool>(), mesh));
}

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H
