// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_NESTED_ITERATION_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_NESTED_ITERATION_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Progressive_mesh_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/insert_new_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/place_border.h>
#include <CGAL/Surface_mesh_parameterization/internal/write_map.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Real_timer.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// The hierarchical parametrization of Hormann, Greiner and Campagna (1999): builds a hierarchy of collapse groups, lets a method
/// parameterize the coarsest level, and for each finer level inserts its vertices and lets the method refine the map from there.
///
/// For a method whose maps are free of flips, insertion creates none: a vertex goes to its stored barycentric place or into the kernel of its star polygon,
/// tested by exact predicates. For others it goes to its stored place, as in the paper, or to the place that the method has fixed.
/// The same input, options and seed give the same result.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam Method a model of `RefinableParameterizer_3`
template <class Method>
class Nested_iteration_parameterizer_3
{
public:
  typedef typename Method::Triangle_mesh                                      Triangle_mesh;
  typedef typename Method::Triangle_mesh                                      TriangleMesh;
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor    halfedge_descriptor;

  static_assert(!(Method::is_flip_free && internal::Places_border<Method>::value),
                "Nested_iteration_parameterizer_3<Method>: a method with place_border() cannot promise is_flip_free, for a given place may leave no room for a triangle.");

  /// \param method the method that parameterizes every level
  /// \param np
  /// - `coarsest_size`: the coarsest level has at most that many vertices, where the mesh allows it; default 100. It is made smaller when the
  ///   method fails to lay out the coarsest level without a flip
  /// - `random_seed`: seed of the hierarchy; default 0
  /// - `visitor`: a model of `HierarchyVisitor_3`; default: none
  /// - `summary`: a `std::reference_wrapper<Parameterization_summary>` that receives what the run did; it must live as long as the parameterizer runs
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Nested_iteration_parameterizer_3(const Method& method = Method(), const NamedParameters& np = parameters::default_values())
    : m_method(method), m_visitor(internal::hierarchy_visitor_of(np)), m_summary(internal::summary_of(np))
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    m_coarsest_size = choose_parameter(get_parameter(np, internal_np::coarsest_size), m_coarsest_size);
    m_seed = choose_parameter(get_parameter(np, internal_np::random_seed), m_seed);
  }

  /// parameterizes the connected component of `mesh` that contains `bhd`.
  ///
  /// \param mesh the surface: triangles, no handles, one fan of triangles at each vertex; only read
  /// \param bhd a halfedge on the outer border of `mesh`
  /// \param uvmap a writable property map from vertices to points of the plane; untouched on an error
  /// \param vpmap a writable property map from vertices to `bool`: set for each vertex that got a place; untouched on an error
  ///
  /// \return `OK`; an error of `Mesh_component` or of the method; `ERROR_WRONG_PARAMETER` if the method fixed a vertex at no finite place;
  /// `ERROR_NO_1_TO_1_MAPPING` if a vertex could not be inserted without a flip because its neighbors lie too close together for doubles, or if the
  /// visitor stopped the run
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap, VertexIndexMap, VertexParameterizedMap vpmap)
  {
    Parameterization_summary unused_summary;
    Parameterization_summary& summary = m_summary ? *m_summary : unused_summary;

    // A coarsest level that the method cannot lay out without a flip is coarsened further: the vertices come back by insertion. Where doubles leave no
    // room for one of them, another hierarchy may.
    constexpr unsigned int most_seeds = 3;
    std::size_t coarsest_size = m_coarsest_size;
    for (unsigned int seed = m_seed; ; ) {
      summary = Parameterization_summary();
      CGAL::Real_timer timer;
      timer.start();
      Mesh_component<Triangle_mesh> component(mesh, bhd);
      summary.error = component.error();
      if (summary.error.code == OK)
        summary.error.code = internal::place_border(m_method, mesh, bhd, component);
      if (summary.error.code != OK)
        return summary.error.code;

      const Collapse_hierarchy_3 hierarchy(std::move(component.surface()), parameters::coarsest_size(coarsest_size).random_seed(seed),
                                           typename Method::Concurrency_tag());
      summary.seconds_hierarchy = timer.time();

      Level::Uv uv;
      summary.error.code = parameterize_levels(hierarchy, uv, summary);
      summary.seconds_parameterize = timer.time() - summary.seconds_hierarchy;
      if (summary.error.code == OK)
        internal::write_map(component, hierarchy, uv, uvmap, vpmap);

      if (!Method::is_flip_free || summary.error.code != ERROR_NO_1_TO_1_MAPPING || summary.stopped)
        return summary.error.code;
      const bool has_coarsest_map = !summary.levels.empty(), is_coarsest_possible = hierarchy.number_of_vertices(0) > coarsest_size;
      if (has_coarsest_map ? ++seed == m_seed + most_seeds : is_coarsest_possible)
        return summary.error.code;
      if (!has_coarsest_map)
        coarsest_size /= 2;
    }
  }

private:
  // The algorithm of the paper, section 3: with the levels built, for i from 0 to n parameterize level i, starting from
  // the map of level i-1 with the vertices inserted that level i has in addition.
  Error_code parameterize_levels(const Collapse_hierarchy_3& hierarchy, Level::Uv& uv, Parameterization_summary& summary)
  {
    if (!m_visitor->hierarchy_built(hierarchy))
      return stop(summary);

    Progressive_mesh_3 mesh(hierarchy);
    Level level(mesh, 0, internal::Loops::of<typename Method::Concurrency_tag>());
    for (std::size_t i = 0; i < hierarchy.number_of_levels(); ++i) {
      CGAL::Real_timer timer;
      timer.start();
      if (i > 0) {
        mesh.walk_to_level(i);
        level.follow_mesh(i);
      }

      const Error_code status = i == 0 ? m_method.parameterize_coarsest(level, uv) : insert_new_vertices(level, uv);
      if (status != OK)
        return status;

      summary.levels.emplace_back();
      Level_summary& level_summary = summary.levels.back();
      level_summary.vertices = level.number_of_vertices();
      level_summary.faces = level.number_of_faces();
      const Error_code refined = m_method.refine(level, uv, level_summary);
      level_summary.seconds = timer.time();
      if (refined != OK)
        return refined;
      if (!m_visitor->level_parameterized(level, uv, level_summary))
        return stop(summary);
    }
    summary.energy = summary.levels.back().energy_end;
    summary.converged = summary.levels.back().converged;
    return OK;
  }

  static Error_code insert_new_vertices(const Level& level, Level::Uv& uv)
  {
    if (Method::is_flip_free)
      return internal::insert_new_vertices(level, uv) == internal::no_index ? OK : ERROR_NO_1_TO_1_MAPPING;
    internal::insert_at_stored_places(level, uv);
    return OK;
  }

  static Error_code stop(Parameterization_summary& summary)
  {
    summary.stopped = true;
    return ERROR_NO_1_TO_1_MAPPING;
  }

  Method m_method;
  std::shared_ptr<internal::Any_hierarchy_visitor> m_visitor;
  Parameterization_summary* m_summary;
  std::size_t m_coarsest_size = Collapse_hierarchy_3::default_coarsest_size;
  unsigned int m_seed = 0;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_NESTED_ITERATION_PARAMETERIZER_3_H
