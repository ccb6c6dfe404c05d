// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_CONCEPT_CHECKS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_CONCEPT_CHECKS_H

#include <CGAL/Surface_mesh_parameterization/Distortion_derivatives_2.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/detection.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>

#include <type_traits>
#include <utility>
#include <vector>

// What the concepts of this package ask for. The `value` of each X_check<T> tells whether all is there; what depends on
// T is not instantiated otherwise. Then `tell()` does not compile: it has one sentence for what is missing first. Of
// several checks std::conjunction is the first one that fails. The assertions are no part of the classes, because clang
// takes a class with a failed assertion for incomplete.

namespace CGAL::Surface_mesh_parameterization {

class Collapse_hierarchy_3;
class Level;
struct Level_summary;
struct Parameterization_progress;
struct Atlas_progress;

namespace internal {

// Types that exist where T has what they name.
namespace concept_checks {

template <class T> using Minimum = decltype(T::minimum);
template <class T> using Is_scale_invariant = std::bool_constant<T::is_scale_invariant>;
template <class T> using Is_flip_free = std::bool_constant<T::is_flip_free>;
template <class T> using Is_result_flip_free = std::bool_constant<T::is_result_flip_free>;
template <class T> using Holds_vertices = std::bool_constant<T::holds_vertices>;
template <class T> using Is_symmetric = std::bool_constant<T::is_symmetric>;
template <class T> using Triangle_mesh_of = typename T::Triangle_mesh;
template <class T> using Concurrency_tag_of = typename T::Concurrency_tag;
template <class T> using Solver_traits_of = typename T::Solver_traits;
template <class T> using Of_area = decltype(std::declval<const T&>().of_area(1.));
template <class T> using Value = decltype(std::declval<const T&>().value(2., 1.));
template <class T> using Derivatives = decltype(std::declval<const T&>().derivatives(2., 1.));

template <class T>
using Weights_of_ring = decltype(std::declval<T&>()(std::declval<const Point_3&>(),
                                                    std::declval<const std::vector<Point_3>&>(), true,
                                                    std::declval<std::vector<double>&>()));
template <class T>
using Hierarchy_built = decltype(std::declval<T&>().hierarchy_built(std::declval<const Collapse_hierarchy_3&>()));
template <class T>
using Level_parameterized = decltype(std::declval<T&>().level_parameterized(
    std::declval<const Level&>(), std::declval<const std::vector<Point_2>&>(), std::declval<const Level_summary&>()));
template <class T>
using Progressed = decltype(std::declval<T&>().progressed(std::declval<const Parameterization_progress&>()));
template <class T>
using Atlas_progressed = decltype(std::declval<T&>().progressed(std::declval<const Atlas_progress&>()));
template <class T>
using Parameterize_coarsest = decltype(std::declval<T&>().parameterize_coarsest(
    std::declval<const Level&>(), std::declval<std::vector<Point_2>&>()));
template <class T>
using Refine = decltype(std::declval<T&>().refine(std::declval<const Level&>(), std::declval<std::vector<Point_2>&>(),
                                                  std::declval<Level_summary&>()));
template <class T>
using Linear_solver_call = decltype(std::declval<T&>().linear_solver(
    std::declval<const typename T::Matrix&>(), std::declval<const typename T::Vector&>(),
    std::declval<typename T::Vector&>(), std::declval<typename T::NT&>()));

template <class T> using Rebound = typename T::type;

template <class T, class MeshReference, class Mesh, class... Others>
using Parameterize = decltype(std::declval<T&>().parameterize(
    std::declval<MeshReference>(), std::declval<Halfedge_of<Mesh>>(), std::declval<Any_uv_map<Mesh>>(),
    std::declval<Any_index_map<Mesh>>(), std::declval<Any_bool_map<Mesh>>(), std::declval<Others>()...));
template <class T, class Mesh>
using Place_border = decltype(std::declval<T&>().place_border(
    std::declval<const Mesh&>(), std::declval<Halfedge_of<Mesh>>(), std::declval<Any_uv_map<Mesh>>(),
    std::declval<Any_index_map<Mesh>>(), std::declval<Any_bool_map<Mesh>>()));

template <class Energy>
struct Energy_check
{
  static constexpr int missing = first_missing(
      { std::is_default_constructible<Energy>::value && std::is_copy_constructible<Energy>::value &&
            std::is_copy_assignable<Energy>::value && !std::is_final<Energy>::value,
        is_detected_as<double, Minimum, Energy>, is_detected<Is_scale_invariant, Energy>,
        is_detected<Is_flip_free, Energy>, is_detected_as<Energy, Of_area, Energy>,
        is_detected_as<double, Value, Energy>, is_detected_as<Distortion_derivatives_2, Derivatives, Energy> });
  static constexpr bool value = missing < 0;

  static void tell()
  {
    static_assert(missing != 0, "Energy has no default or copy constructor or no assignment, or is final: see "
                                "DistortionEnergy_2");
    static_assert(missing != 1, "Energy has no constant minimum, a double: see DistortionEnergy_2");
    static_assert(missing != 2, "Energy has no constant is_scale_invariant: see DistortionEnergy_2");
    static_assert(missing != 3, "Energy has no constant is_flip_free: see DistortionEnergy_2");
    static_assert(missing != 4, "Energy has no of_area(double) const that returns an Energy: see DistortionEnergy_2");
    static_assert(missing != 5, "Energy has no value(double, double) const that returns a double: see "
                                "DistortionEnergy_2");
    static_assert(missing != 6, "Energy has no derivatives(double, double) const that returns "
                                "Distortion_derivatives_2: see DistortionEnergy_2");
  }
};

template <class EdgeWeights>
struct Edge_weights_check
{
  static constexpr int missing = first_missing(
      { std::is_copy_constructible<EdgeWeights>::value, is_detected<Is_symmetric, EdgeWeights>,
        is_detected<Weights_of_ring, EdgeWeights> });
  static constexpr bool value = missing < 0;

  static void tell()
  {
    static_assert(missing != 0, "EdgeWeights has no copy constructor: see EdgeWeights_3");
    static_assert(missing != 1, "EdgeWeights has no constant is_symmetric: see EdgeWeights_3");
    static_assert(missing != 2, "EdgeWeights has no operator()(const Point_3&, const std::vector<Point_3>&, bool, "
                                "std::vector<double>&): see EdgeWeights_3");
  }
};

template <class Visitor>
struct Visitor_check
{
  static constexpr int missing = first_missing(
      { std::is_copy_constructible<Visitor>::value, is_detected_as<bool, Hierarchy_built, Visitor>,
        is_detected_as<bool, Level_parameterized, Visitor>, is_detected_as<bool, Progressed, Visitor> });
  static constexpr bool value = missing < 0;

  static void tell()
  {
    static_assert(missing != 0, "the visitor has no copy constructor: see HierarchyVisitor_3");
    static_assert(missing != 1, "the visitor has no hierarchy_built(const Collapse_hierarchy_3&) that returns a bool: "
                                "see HierarchyVisitor_3");
    static_assert(missing != 2, "the visitor has no level_parameterized(const Level&, const Level::Uv&, const "
                                "Level_summary&) that returns a bool: see HierarchyVisitor_3");
    static_assert(missing != 3, "the visitor has no progressed(const Parameterization_progress&) that returns a bool: "
                                "see HierarchyVisitor_3");
  }
};

template <class Visitor>
struct Atlas_visitor_check : std::bool_constant<is_detected_as<bool, Atlas_progressed, Visitor>>
{
  static void tell()
  {
    static_assert(Atlas_visitor_check::value,
                  "the atlas's visitor has no progressed(const Atlas_progress&) that returns a bool: see AtlasVisitor");
  }
};

template <class SolverTraits>
constexpr bool is_solver = is_detected_as<bool, Linear_solver_call, SolverTraits>;

template <class T, class Mesh>
constexpr bool has_parameterize = is_detected_as<Error_code, Parameterize, T, std::add_lvalue_reference_t<Mesh>, Mesh>;

template <class BorderParameterizer, class Mesh>
struct Border_parameterizer_check
  : std::bool_constant<is_detected_as<Error_code, Parameterize, BorderParameterizer, const Mesh&, Mesh>>
{
  static void tell()
  {
    static_assert(Border_parameterizer_check::value,
                  "BorderParameterizer has no parameterize(const TriangleMesh&, halfedge_descriptor, uvmap, vimap, "
                  "vpmap) that returns an Error_code: see CGAL's Parameterizer_3");
  }
};

template <class Method>
struct Method_check
{
  static constexpr int missing = first_missing(
      { std::is_copy_constructible<Method>::value, is_detected<Triangle_mesh_of, Method>,
        is_detected<Concurrency_tag_of, Method>, is_detected<Is_flip_free, Method>,
        is_detected_as<Error_code, Parameterize_coarsest, Method>, is_detected_as<Error_code, Refine, Method> });
  static constexpr bool value = missing < 0;

  static void tell()
  {
    static_assert(missing != 0, "the method has no copy constructor: see RefinableParameterizer_3");
    static_assert(missing != 1, "the method has no type Triangle_mesh: see RefinableParameterizer_3");
    static_assert(missing != 2, "the method has no type Concurrency_tag: see RefinableParameterizer_3");
    static_assert(missing != 3, "the method has no constant is_flip_free: see RefinableParameterizer_3");
    static_assert(missing != 4, "the method has no parameterize_coarsest(const Level&, Level::Uv&) that returns an "
                                "Error_code: see RefinableParameterizer_3");
    static_assert(missing != 5, "the method has no refine(const Level&, Level::Uv&, Level_summary&) that returns an "
                                "Error_code: see RefinableParameterizer_3");
  }
};

} // namespace concept_checks

using concept_checks::Border_parameterizer_check;
using concept_checks::Atlas_visitor_check;
using concept_checks::Edge_weights_check;
using concept_checks::Energy_check;
using concept_checks::Method_check;
using concept_checks::Visitor_check;

} // namespace internal

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_CONCEPT_CHECKS_H
