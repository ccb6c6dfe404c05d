// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Progressive_mesh_3.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/insert_new_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/settle_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/place_border.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/write_map.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Real_timer.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// What a run of nested iteration takes besides the mesh.
struct Nested_iteration_options
{
  std::size_t coarsest_size = Collapse_hierarchy_3::default_coarsest_size;    // a flat run: as many as there are
  unsigned int seed = 0;
  bool unit_edges = false;
  bool fills_holes = false;
  Flip_policy flip_policy = Flip_policy::FAIL;      // for what methods leave that do not keep triangles positive

  // Takes from named parameters what they hold.
  template <class NamedParameters>
  void set(const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    coarsest_size = choose_parameter(get_parameter(np, internal_np::coarsest_size), coarsest_size);
    seed = choose_parameter(get_parameter(np, internal_np::random_seed), seed);
    unit_edges = choose_parameter(get_parameter(np, internal_np::unit_edges), unit_edges);
    fills_holes = choose_parameter(get_parameter(np, internal_np::fill_holes), fills_holes);
    flip_policy = choose_parameter(get_parameter(np, internal_np::flip_policy), flip_policy);
  }
};

// The hierarchical parametrization of Hormann, Greiner and Campagna (1999) of one component of a mesh by a model of RefinableParameterizer_3, and what is tried
// when doubles leave no room for a map without flips.
template <class Method>
class Nested_iteration
{
  typedef typename Method::Triangle_mesh                                     Triangle_mesh;
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor   halfedge_descriptor;

public:
  // The method may be changed by leave_room().
  Nested_iteration(Method& method, const Nested_iteration_options& options, Any_hierarchy_visitor& visitor, Parameterization_summary& summary)
    : m_method(method), m_options(options), m_visitor(visitor), m_summary(summary)
  { }

  // Writes to the property maps only if all went well.
  template <class VertexUVMap, class VertexParameterizedMap>
  Error_code run(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap, VertexParameterizedMap vpmap)
  {
    do
      attempt(mesh, bhd, uvmap, vpmap);
    while (m_summary.error.code == ERROR_NO_1_TO_1_MAPPING && !m_summary.stopped && can_try_another_way());
    return m_summary.error.code;
  }

private:
  template <class VertexUVMap, class VertexParameterizedMap>
  void attempt(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap, VertexParameterizedMap vpmap)
  {
    m_summary = Parameterization_summary();
    CGAL::Real_timer timer;
    timer.start();
    Mesh_component<Triangle_mesh> component(mesh, bhd, typename Method::Concurrency_tag());
    m_summary.error = component.error();
    if (m_summary.error.code == OK)
      m_summary.error.code = place_border(m_method, mesh, bhd, component);
    if (m_summary.error.code != OK)
      return;
    if (m_options.fills_holes)
      component.fill_holes();

    const auto np = parameters::unit_edges(m_options.unit_edges).coarsest_size(m_options.coarsest_size).random_seed(m_options.seed);
    const Collapse_hierarchy_3 hierarchy(std::move(component.surface()), np, typename Method::Concurrency_tag());
    m_size_of_coarsest_level = hierarchy.number_of_vertices(0);
    m_summary.seconds_hierarchy = timer.time();

    Level::Uv uv;
    m_summary.error.code = parameterize_levels(hierarchy, uv);
    m_summary.seconds_parameterize = timer.time() - m_summary.seconds_hierarchy;
    if (m_summary.error.code == OK)
      write_map(component, hierarchy, uv, uvmap, vpmap);
  }

  // A coarsest level that the method cannot lay out without a flip is coarsened further: the vertices come back by insertion. Where doubles leave no
  // room for one of them, another hierarchy may, and at last a more careful method.
  bool can_try_another_way()
  {
    constexpr unsigned int most_seeds = 3;
    if (!Method::is_flip_free || m_is_finished)
      return false;
    if (!m_summary.levels.empty()) {
      ++m_options.seed;
      return ++m_number_of_seeds < most_seeds || leave_room(m_method, 0);
    }
    if (m_size_of_coarsest_level > m_options.coarsest_size)   // the mesh allows no coarser one
      return false;
    m_options.coarsest_size = m_size_of_coarsest_level / 2;
    return true;
  }

  // The algorithm of the paper, section 3: with the levels built, for i from 0 to n parameterize level i, starting from
  // the map of level i-1 with the vertices inserted that level i has in addition.
  Error_code parameterize_levels(const Collapse_hierarchy_3& hierarchy, Level::Uv& uv)
  {
    if (!m_visitor.hierarchy_built(hierarchy))
      return stop();

    Progressive_mesh_3 mesh(hierarchy);
    Level level(mesh, 0, Loops::of<typename Method::Concurrency_tag>());
    for (std::size_t i = 0; i < hierarchy.number_of_levels(); ++i) {
      CGAL::Real_timer timer;
      timer.start();
      if (i > 0) {
        mesh.walk_to_level(i);
        level.follow_mesh(i);
      }

      const Error_code status = i == 0 ? m_method.parameterize_coarsest(level, uv) : insert(level, uv);
      if (status != OK)
        return status;

      m_summary.levels.emplace_back();
      Level_summary& level_summary = m_summary.levels.back();
      level_summary.vertices = level.number_of_vertices();
      level_summary.faces = level.number_of_faces();
      const Error_code refined = m_method.refine(level, uv, level_summary);
      level_summary.seconds = timer.time();
      if (refined != OK)
        return refined;
      if (!m_visitor.level_parameterized(level, uv, level_summary))
        return stop();
    }
    m_summary.energy = m_summary.levels.back().energy_end;
    m_summary.converged = m_summary.levels.back().converged;
    m_is_finished = true;
    return settle_flips(level.triangles(), level.rings(), [&] { return surface_of(level); }, m_options.flip_policy, uv, m_summary);
  }

  // The finest level as a surface, its vertices by rank.
  static Triangulated_surface_3 surface_of(const Level& level)
  {
    Triangulated_surface_3 surface;
    surface.triangles = level.triangles();
    for (Index v = 0; v < level.number_of_vertices(); ++v) {
      surface.points.push_back(level.point(v));
      if (level.hierarchy().is_on_outer_border(v))
        surface.outer_border.push_back(v);
    }
    return surface;
  }

  static Error_code insert(const Level& level, Level::Uv& uv)
  {
    if (Method::is_flip_free)
      return insert_new_vertices(level, uv) == no_index ? OK : ERROR_NO_1_TO_1_MAPPING;
    insert_at_stored_places(level, uv);
    return OK;
  }

  Error_code stop()
  {
    m_summary.stopped = true;
    return ERROR_NO_1_TO_1_MAPPING;
  }

  // Calls the optional member of the concept.
  template <class M>
  static auto leave_room(M& method, int) -> decltype(method.leave_room()) { return method.leave_room(); }
  template <class M>
  static bool leave_room(M&, ...) { return false; }

  Method& m_method;
  Nested_iteration_options m_options;
  Any_hierarchy_visitor& m_visitor;
  Parameterization_summary& m_summary;
  std::size_t m_size_of_coarsest_level = 0;
  unsigned int m_number_of_seeds = 0;
  bool m_is_finished = false;       // the method, with a map of the finest level
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_H
