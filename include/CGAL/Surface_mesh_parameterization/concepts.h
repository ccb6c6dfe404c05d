// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_CONCEPTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_CONCEPTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Rebind_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/concept_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>

#include <type_traits>

/// \file concepts.h
/// Decides at compile time whether a type meets the requirements of a concept. The classes and functions of the package
/// assert this by themselves. With C++20 there is also a concept of the name of each requirement:
/// `template <DistortionEnergy_2 Energy>`.

namespace CGAL::Surface_mesh_parameterization {

/// \cond SKIP_IN_MANUAL
class Multigrid_solver_traits;
/// \endcond

/// \addtogroup PkgHierarchicalParameterizationTraits
/// @{

/// whether `Mesh` is a mesh that this package reads, see \ref hp_mesh "the requirements". The lists of vertices and
/// faces, the descriptors, the traversal and the points are checked, dynamic properties are not
template <class Mesh>
constexpr bool is_triangle_mesh_v = internal::Mesh_check<Mesh>::value;

/// whether `UVMap` is a writable property map from the vertices of `Mesh` to points of the plane
template <class UVMap, class Mesh>
constexpr bool is_uv_map_v = std::conjunction<internal::Mesh_check<Mesh>, internal::Uv_map_check<UVMap, Mesh>>::value;

/// whether `Energy` is a model of `DistortionEnergy_2`
template <class Energy>
constexpr bool is_distortion_energy_v = internal::Energy_check<Energy>::value;

/// whether `Weights` is a model of `EdgeWeights_3`
template <class Weights>
constexpr bool is_edge_weights_v = internal::Edge_weights_check<Weights>::value;

/// whether `Visitor` is a model of `HierarchyVisitor_3`
template <class Visitor>
constexpr bool is_hierarchy_visitor_v = internal::Visitor_check<Visitor>::value;

/// whether `Visitor` is a model of `AtlasVisitor`
template <class Visitor>
constexpr bool is_atlas_visitor_v = internal::Atlas_visitor_check<Visitor>::value;

/// whether `Traits` has the types and the `linear_solver(A, B, X, D)` of CGAL's `SparseLinearAlgebraTraits_d`
template <class Traits>
constexpr bool is_solver_traits_v = internal::concept_checks::is_solver<Traits>;

/// whether `Parameterizer` has the `parameterize()` of CGAL's `Parameterizer_3`; true also for CGAL's border
/// parameterizers
template <class Parameterizer>
constexpr bool is_parameterizer_v = internal::concept_checks::has_parameterize<
    Parameterizer, internal::Detected<internal::concept_checks::Triangle_mesh_of, Parameterizer>>;

/// whether `Parameterizer` is a model of `RefinableParameterizer_3`
template <class Parameterizer>
constexpr bool is_refinable_parameterizer_v = internal::Method_check<Parameterizer>::value;

/// whether `Parameterizer` is a model of `RebindableParameterizer_3`: whether `Rebind_solver` can give it another
/// solver
template <class Parameterizer>
constexpr bool is_rebindable_parameterizer_v =
    internal::is_detected<internal::concept_checks::Triangle_mesh_of, Parameterizer> &&
    internal::is_detected<internal::concept_checks::Rebound, Rebind_solver<Parameterizer, Multigrid_solver_traits>>;

/// @}

#if defined(__cpp_concepts) && __cpp_concepts >= 201907L
/// \cond SKIP_IN_MANUAL
template <class Energy> concept DistortionEnergy_2 = is_distortion_energy_v<Energy>;
template <class Weights> concept EdgeWeights_3 = is_edge_weights_v<Weights>;
template <class Visitor> concept AtlasVisitor = is_atlas_visitor_v<Visitor>;
template <class Visitor> concept HierarchyVisitor_3 = is_hierarchy_visitor_v<Visitor>;
template <class Parameterizer> concept Parameterizer_3 = is_parameterizer_v<Parameterizer>;
template <class Parameterizer> concept RefinableParameterizer_3 = is_refinable_parameterizer_v<Parameterizer>;
template <class Parameterizer> concept RebindableParameterizer_3 = is_rebindable_parameterizer_v<Parameterizer>;
template <class Traits> concept SparseLinearAlgebraTraits_d = is_solver_traits_v<Traits>;
/// \endcond
#endif

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_CONCEPTS_H
