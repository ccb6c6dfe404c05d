// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_NESTED_ITERATION_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_NESTED_ITERATION_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Refused.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/concept_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Run_setup.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/run_nested_iteration.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/place_border.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <memory>
#include <type_traits>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// The hierarchical parametrization of Hormann, Greiner and Campagna (1999). It builds a hierarchy of collapse groups
/// and lets a method parameterize the coarsest level. For each finer level it inserts the new vertices, and the method
/// refines the map from there.
///
/// If the method is flip-free, insertion creates no flips: a vertex goes to its stored barycentric coordinates or into
/// the kernel of its star polygon, tested by exact predicates. If not, a vertex goes to its stored coordinates, as in
/// the paper, or to the uv coordinates at which the method has fixed it. The same input, options and seed give the same
/// result.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam Method_ a model of `RefinableParameterizer_3`
/// \tparam ConcurrencyTag `CGAL::Parallel_tag` uses all threads that TBB has, and needs `CGAL::TBB_support`, as the
///         `Concurrency_tag` of the method itself does; the result is the same
template <class Method_, class ConcurrencyTag = Sequential_tag>
class Nested_iteration_parameterizer_3
{
  typedef internal::Checked<internal::Method_check<Method_>, Method_>   Method;
  typedef internal::Joined_names<
      internal::Names<internal_np::coarsest_size_t, internal_np::random_seed_t, internal_np::unit_edges_t,
                      internal_np::visitor_t, internal_np::fill_holes_t, internal_np::flip_policy_t,
                      internal_np::summary_t>,
      std::conditional_t<Method::is_flip_free, internal::Names<internal_np::initial_map_t>, internal::Names<>>,
      std::conditional_t<internal::keeps_borders_apart<Method>, internal::Names<internal_np::overlap_bound_t>,
                         internal::Names<>>,
      std::conditional_t<internal::holds_vertices<Method>, internal::Place_constraint_names,
                         internal::Names<>>>   Option_names;

public:
  typedef typename Method::Triangle_mesh   Triangle_mesh;   ///< the mesh type
  typedef typename Method::Triangle_mesh   TriangleMesh;    ///< the same, as CGAL names it
#ifdef DOXYGEN_RUNNING
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor
      halfedge_descriptor;   ///< a halfedge of the mesh
#else
  typedef typename internal::Mesh_descriptors<Triangle_mesh>::halfedge_descriptor   halfedge_descriptor;
#endif

  static_assert(!(Method::is_flip_free && internal::places_border<Method>),
                "the method has place_border() and is_flip_free, but a given place may leave no room for a triangle: "
                "see RefinableParameterizer_3");

  /// \param method the method that parameterizes every level. What its constructor was given for flat runs, such as
  ///        `fill_holes`, `vertex_is_constrained_map` or `summary`, is used for these runs, too, unless `np` has it
  /// \param np an optional sequence of \ref hp_named_parameters "named parameters" among these:
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{coarsest_size}
  ///     \cgalParamDescription{the maximum number of vertices of the coarsest level, if the mesh allows it}
  ///     \cgalParamType{an integer or floating-point number, at least 0, may be infinite}
  ///     \cgalParamDefault{100}
  ///     \cgalParamExtra{The coarsest level gets smaller if a flip-free method fails to map it without a flip.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{random_seed, unit_edges}
  ///     \cgalParamDescription{options of the hierarchy}
  ///     \cgalParamType{those of `Collapse_hierarchy_3`}
  ///     \cgalParamDefault{0 and `false`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{visitor}
  ///     \cgalParamDescription{is called with the levels and the progress, and can stop the run}
  ///     \cgalParamType{a model of `HierarchyVisitor_3`, or `std::ref` of one}
  ///     \cgalParamDefault{none}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{fill_holes}
  ///     \cgalParamDescription{whether every border except the outer one is closed by a virtual vertex in its middle,
  ///       so that a hole is mapped like a part of the surface}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`false`: holes are open in the result, but flip-free methods start from a map with filled
  ///       holes where small ones are many, or with cracks closed}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{flip_policy}
  ///     \cgalParamDescription{the treatment of flips}
  ///     \cgalParamType{`Flip_policy`}
  ///     \cgalParamDefault{`REPAIR`}
  ///     \cgalParamExtra{Flip-free methods do not need it.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{overlap_bound}
  ///     \cgalParamDescription{of methods that keep borders apart: the maximum fraction of the triangles, counted by
  ///       their centroids, that others may cover in the map without that constraint if borders are to be kept apart}
  ///     \cgalParamType{`double`, from 0 to 1}
  ///     \cgalParamDefault{1: borders are kept apart in any case}
  ///     \cgalParamExtra{Where more are covered, that map is the result, or a draft of it that has not `converged`, see
  ///       `Level::is_draft()`: it is to be divided, since keeping its borders apart would distort it far and take
  ///       long. It is the result, too, where keeping borders apart fails, leaves more than twice the energy after 80
  ///       iterations on the finest level, or raises it by more than 2 % in the end. Where no centroid is covered,
  ///       borders are kept apart in any case. It has no effect with `initial_map`, if there is a map to start from.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{initial_map}
  ///     \cgalParamDescription{of flip-free methods: whether `uvmap`, which must be readable then, holds a map to start
  ///       from. The method refines it on the finest level}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`false`}
  ///     \cgalParamExtra{Flips are repaired first, vertices whose coordinates are not finite are put between their
  ///       neighbors, and a map that is less than half or more than twice as long and wide as the surface's area asks
  ///       for is scaled to that. Where the method finds no map from there, it runs without a start.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{vertex_is_constrained_map}
  ///     \cgalParamDescription{of methods that have `holds_vertices`: vertices that keep the uv coordinates in `uvmap`,
  ///       to the last bit of doubles; `uvmap` must be readable then}
  ///     \cgalParamType{a readable property map from vertices to `bool`}
  ///     \cgalParamDefault{no vertex}
  ///     \cgalParamExtra{They stay on every level, unless they lie on the border between two others. The map is not
  ///       scaled. If all vertices of a border are constrained, to which one of CGAL's border parameterizers may have
  ///       given uv coordinates, the border is fixed.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{position_weight_map}
  ///     \cgalParamDescription{of the same methods: the energy is increased by the sum of these weights times the
  ///       squared distance between the uv coordinates of a vertex and those in `uvmap`, in the units of the mesh}
  ///     \cgalParamType{a readable property map from vertices to numbers that are not negative}
  ///     \cgalParamDefault{0 for all vertices}
  ///     \cgalParamExtra{With `Triangle_weight::AREA` the energy is that of the surface, not the mean.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{summary}
  ///     \cgalParamDescription{the object that receives what the run did}
  ///     \cgalParamType{`std::reference_wrapper<Parameterization_summary>`}
  ///     \cgalParamDefault{no summary is filled}
  ///     \cgalParamExtra{The object must live as long as the parameterizer runs.}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Nested_iteration_parameterizer_3(const Method& method = Method(),
                                            const NamedParameters& np = parameters::default_values())
    : m_method(method), m_visitor(internal::hierarchy_visitor_of(np)), m_setup(internal::run_setup_of(np, m_method))
  {
    internal::assert_names<Option_names>(np);
  }

  /// \param np the named parameters of `Method`, if its constructor takes any, and those above
  template <class NamedParameters, class = std::enable_if_t<internal::is_named_parameters<NamedParameters>>>
  explicit Nested_iteration_parameterizer_3(const NamedParameters& np)
    : Nested_iteration_parameterizer_3(make_method(internal::Checked_named_parameters<NamedParameters>(np)),
                                       internal::Checked_named_parameters<NamedParameters>(np))
  {
    typedef internal::Detected<internal::Option_names_of, Method>   Names_of_method;
    if constexpr (!std::is_void<Names_of_method>::value)
      internal::assert_names<internal::Joined_names<Option_names, Names_of_method>>(np);
    else if constexpr (!std::is_constructible<Method, const NamedParameters&>::value)
      internal::assert_names<Option_names>(np);
  }

  /// parameterizes the connected component of `mesh` that contains `bhd`.
  ///
  /// \param mesh the surface: triangles, no handles, one fan of triangles at each vertex; only read
  /// \param bhd a halfedge on the outer border of `mesh`
  /// \param uvmap a writable property map from vertices to points of the plane; untouched on an error
  /// \param vpmap a writable property map from vertices to `bool`: set for each vertex that got uv coordinates;
  /// untouched on an error
  ///
  /// \return `OK`; an error of `Mesh_component::error()`; the error of the method; `ERROR_WRONG_PARAMETER`, also if an
  ///         option is out of range, if the method fixed a vertex at coordinates that are not finite, if `uvmap` cannot
  ///         be read but must be, if the uv coordinates of a constrained vertex are not finite, if a weight is negative
  ///         or not finite, or if the result is not finite in the number type of `uvmap`; `ERROR_NO_1_TO_1_MAPPING` if
  ///         a vertex could not be inserted without a flip, because its neighbors lie too close together for doubles,
  ///         if a constrained vertex could not be brought to its uv coordinates without a flip, or if there are flips
  ///         and the `Flip_policy` is `FAIL`; `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`; `ERROR_BORDER_TOO_SHORT` or
  ///         `ERROR_NON_CONVEX_BORDER` if the border cannot be placed; `ERROR_STOPPED` if a visitor stopped the run.
  ///         \ref hp_rejected_inputs "Rejected inputs" has all causes. The `summary` names a constrained vertex that is
  ///         the cause, or the triangle whose corners contradict each other
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap, VertexIndexMap,
                          VertexParameterizedMap vpmap)
  {
    typedef std::conjunction<internal::Mesh_check<Triangle_mesh>,
                             internal::Uv_map_check<VertexUVMap, Triangle_mesh>>   Check;
    if constexpr (Check::value) {
      return internal::run_nested_iteration(m_method, m_setup, m_visitor.get(),
                                            internal::Loops::of<typename Method::Concurrency_tag, ConcurrencyTag>(),
                                            mesh, bhd, uvmap, vpmap);
    } else {
      Check::tell();
      return ERROR_WRONG_PARAMETER;
    }
  }

private:
  template <class NamedParameters>
  static Method make_method(const NamedParameters& np)
  {
    if constexpr (std::is_constructible<Method, const NamedParameters&>::value)
      return Method(np);
    else
      return Method();
  }

  Method m_method;
  std::shared_ptr<internal::Any_hierarchy_visitor> m_visitor;
  internal::Run_setup<Triangle_mesh> m_setup;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_NESTED_ITERATION_PARAMETERIZER_3_H
