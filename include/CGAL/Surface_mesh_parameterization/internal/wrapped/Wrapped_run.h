// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_RUN_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_RUN_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/best_similarity.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/flat_points.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/surface_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Wrapped_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/flat_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/parameterize_with_session.h>

#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// One run of a parameterizer that solves with the multigrid solver: the component that it works on, its hierarchy, and
// what is told of the run.
template <class TriangleMesh>
class Wrapped_run
{
public:
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor     vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor   halfedge_descriptor;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<int>>::const_type     Index_map;

  // Reads the component of `bhd`, whose box must have at least so many sides with a length. Whether the run can go on
  // is told by error().
  Wrapped_run(const TriangleMesh& mesh, halfedge_descriptor bhd, const Wrapped_options& options,
              int least_dimension = 1)
    : m_mesh(mesh), m_options(options), m_progress(options.visitor.get()), m_index(get(CGAL::dynamic_vertex_property_t<int>(), mesh))
  {
    summary() = Parameterization_summary();
    if (options.fault) {
      summary().error = { ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0, options.fault };
      return;
    }
    m_timer.start();
    Mesh_component<TriangleMesh> component(mesh, bhd, options.loops());
    summary().error = component.error();
    if (error() != OK)
      return;
    m_vertices = component.vertices_of_component();
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      put(m_index, m_vertices[i], int(i));
    m_surface = std::move(component.surface());
    m_border_size = m_surface.outer_border.size();
    m_scale_exponent = m_surface.scale_exponent;
    const int dimension = dimension_of_box(m_surface.points);
    if (dimension < least_dimension) {
      summary().error.code = ERROR_BORDER_TOO_SHORT;
      if (dimension > 0)
        summary().error.cause = "all points are on a line parallel to an axis, which has no place for CGAL's two pins";
    }
    m_progress.start_stage(0, 0, 1, m_vertices.size());
    summary().seconds_hierarchy = m_timer.time();
  }

  Error_code error() { return summary().error.code; }

  // The component's vertices, breadth first, and their numbers in that order.
  const std::vector<vertex_descriptor>& vertices() const { return m_vertices; }
  const Index_map& index() const { return m_index; }

  std::size_t border_size() const { return m_border_size; }

  // Of the power of two that scales the component to about size 1.
  int scale_exponent() const { return m_scale_exponent; }

  // The hierarchy, which is built by the first call; null if the visitor has stopped the run.
  const std::shared_ptr<const Hierarchy_interpolation>& interpolation()
  {
    if (!m_interpolation && error() == OK)
      build_hierarchy();
    return m_interpolation;
  }

  // Those of the run's solver, of which a solution takes this part of what is left of the run.
  Linear_solver_options solver_options(double part_of_rest)
  {
    Linear_solver_options result = m_options.solver;
    result.progress = &m_progress;
    result.part_of_rest = part_of_rest;
    return result;
  }

  // Makes a map by `parameterize()`, see parameterize_with_session().
  template <class Point, class Function>
  Error_code parameterize(const std::shared_ptr<Multigrid_session>& session, std::vector<Point>& uv,
                          const Function& parameterize)
  {
    Error_code code = ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    try {
      code = parameterize_with_session(session, uv, parameterize);
    }
    catch (const Solver_gives_up&) { }
    if (m_progress.is_stopped())
      code = ERROR_STOPPED;
    summary().linear_solver = session->summary();
    return close(code, uv);
  }

  // Does with the flips of a map what the policy says. A repair may give up if there is another method, see
  // is_map_lost().
  template <class Point>
  Error_code settle_flips(std::vector<Point>& uv, const std::vector<char>& is_placed, bool has_other_method)
  {
    if (m_options.flips.policy == Flip_policy::KEEP)
      return error();
    std::vector<Point_2> map = flat_map(uv);
    for (std::size_t i = 0; has_other_method && i < map.size(); ++i)
      if (is_placed[i])
        m_pins.push_back({ i, map[i] });
    m_rings.emplace().build(uv.size(), m_surface.triangles, m_options.loops());
    Flip_settlement settlement = m_options.flips;
    settlement.may_give_up = has_other_method;
    summary().error.code = internal::settle_flips(
        settlement, *m_rings, [this] { return whole_surface(); }, map, summary());
    if (error() != OK)
      fail(error());
    else if (summary().moved_vertices > 0)
      round_and_copy(map, uv);
    return error();
  }

  // Tells that the map is finished. Returns `OK`, or `ERROR_STOPPED`.
  Error_code finish()
  {
    if (!m_progress.finish())
      fail(ERROR_STOPPED);
    return error();
  }

  // After settle_flips(): whether a repair has left little of the map, or nothing.
  bool is_map_lost()
  {
    return m_options.flips.policy == Flip_policy::REPAIR &&
           (error() == ERROR_NO_1_TO_1_MAPPING || leaves_little(summary().moved_vertices, m_vertices.size()));
  }

  // Makes another map by `make_map(map, summary)`, of a method whose energy is the same for similar maps, so that it
  // can have two pins of this one. The summary tells of both. If there is none, a repaired map stays.
  template <class Point, class Function>
  Error_code replace_map(std::vector<Point>& uv, std::vector<char>& is_placed, const Function& make_map)
  {
    std::vector<Point_2> map(uv.size());
    Parameterization_summary other;
    if (const Error_code code = make_map(map, other); code != OK) {
      if (code == ERROR_STOPPED || error() != OK) {
        summary().error = other.error;
        summary().converged = false;
      }
      return error();
    }
    other.flips = summary().flips;
    other.moved_vertices = uv.size();
    other.is_replaced = true;
    other.linear_solver = summary().linear_solver;
    other.seconds_hierarchy += summary().seconds_hierarchy;
    other.seconds_parameterize = m_timer.time() - other.seconds_hierarchy;
    summary() = other;
    if (m_pins.size() == 2) {
      const auto &v = m_pins[0], &w = m_pins[1];
      const Similarity_2 similarity = best_similarity({ { map[v.first], v.second }, { map[w.first], w.second } });
      move_by(similarity, *m_rings, m_options.loops(), map);
    }
    round_and_copy(map, uv);
    is_placed.assign(uv.size(), true);
    return error();
  }

  Run_progress& progress() { return m_progress; }

  Parameterization_summary& summary() { return m_options.summary ? *m_options.summary : m_own_summary; }

private:
  static constexpr const char* cause_of_missing_place =
      "the parameterizer gave a vertex no uv coordinates, or some that are not finite";

  template <class Point>
  Error_code close(Error_code code, const std::vector<Point>& uv)
  {
    const bool has_no_place = code == OK && !is_finite_map(uv);
    if (has_no_place)
      code = ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    summary().error = { code, Parameterization_error::NOWHERE, 0, has_no_place ? cause_of_missing_place : nullptr };
    summary().converged = code == OK && summary().linear_solver.failures == 0;
    summary().seconds_parameterize = m_timer.time() - summary().seconds_hierarchy;
    return code;
  }

  // After close().
  void fail(Error_code code)
  {
    summary().error.code = code;
    summary().converged = false;
  }

  // Copies a map without flips to the user's numbers, where it must have none, either.
  template <class Point>
  void round_and_copy(std::vector<Point_2>& map, std::vector<Point>& uv)
  {
    if (!round_map(*m_rings, rounding_to<Point>(0), 0, map, m_options.loops()))
      fail(ERROR_NO_1_TO_1_MAPPING);
    for (std::size_t i = 0; i < uv.size(); ++i)
      uv[i] = Point(map[i].x(), map[i].y());
  }

  // The surface, whose points may have gone to the hierarchy.
  Triangulated_surface_3 whole_surface()
  {
    if (m_surface.points.empty()) {
      m_surface.points = flat_points(m_mesh, m_vertices);
      normalize(m_surface);
    }
    return std::move(m_surface);
  }

  // Of the surface there stays what the flip policy needs, less the points, which the mesh has.
  void build_hierarchy()
  {
    constexpr double part_of_hierarchy = 0.1;       // of the time, more or less
    CGAL::Real_timer timer;
    timer.start();
    Triangulated_surface_3 rest;
    if (m_options.flips.policy != Flip_policy::KEEP) {
      rest.triangles = m_surface.triangles;
      rest.outer_border = m_surface.outer_border;
    }
    Hierarchy_options options = m_options.hierarchy;
    options.progress = &m_progress;
    m_progress.start_stage(part_of_hierarchy);
    m_interpolation = m_options.build(std::move(m_surface), options, m_options.loops(), m_options.visitor.get());
    m_surface = std::move(rest);
    summary().seconds_hierarchy += timer.time();
    if (!m_interpolation)
      summary().error.code = ERROR_STOPPED;
  }

  const TriangleMesh& m_mesh;
  const Wrapped_options& m_options;
  Run_progress m_progress;
  CGAL::Real_timer m_timer;
  std::vector<vertex_descriptor> m_vertices;
  Index_map m_index;
  Triangulated_surface_3 m_surface;
  std::optional<One_rings> m_rings;     // of its vertices, once flips are settled
  std::vector<std::pair<std::size_t, Point_2>> m_pins;  // vertices that the parameterizer has fixed, and their places
  std::size_t m_border_size = 0;        // vertices on the outer border
  int m_scale_exponent = 0;
  std::shared_ptr<const Hierarchy_interpolation> m_interpolation;
  Parameterization_summary m_own_summary;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_RUN_H
