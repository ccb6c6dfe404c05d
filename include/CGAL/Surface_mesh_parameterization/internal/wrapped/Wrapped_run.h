// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_RUN_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_RUN_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/settle_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// One run of a parameterizer that solves with the multigrid solver: the component that it works on, its hierarchy, and what is told of the run.
template <class TriangleMesh>
class Wrapped_run
{
public:
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor                                    vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor                                  halfedge_descriptor;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<int>>::const_type     Index_map;

  // Reads the component of `bhd`, and has `build(surface)` make the interpolation on its hierarchy: a shared pointer, null if the user has stopped the run.
  // `summary` may be null. Whether the run can go on is told by error().
  template <class Build>
  Wrapped_run(const TriangleMesh& mesh, halfedge_descriptor bhd, const Build& build, Parameterization_summary* summary)
    : m_index(get(CGAL::dynamic_vertex_property_t<int>(), mesh)), m_users_summary(summary)
  {
    this->summary() = Parameterization_summary();
    m_timer.start();
    Mesh_component<TriangleMesh> component(mesh, bhd);
    this->summary().error = component.error();
    if (error() != OK)
      return;
    m_vertices = component.vertices_of_component();
    m_triangles = component.surface().triangles;
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      put(m_index, m_vertices[i], int(i));
    m_interpolation = build(std::move(component.surface()));
    this->summary().seconds_hierarchy = m_timer.time();
    if (!m_interpolation) {
      this->summary().stopped = true;
      this->summary().error.code = ERROR_NO_1_TO_1_MAPPING;
    }
  }

  Error_code error() const { return (m_users_summary ? *m_users_summary : m_own_summary).error.code; }

  // The component's vertices, breadth first, and their numbers in that order.
  const std::vector<vertex_descriptor>& vertices() const { return m_vertices; }
  const Index_map& index() const { return m_index; }

  const std::shared_ptr<const Hierarchy_interpolation>& interpolation() const { return m_interpolation; }

  // The ranks of the vertices, in their order.
  std::vector<Index> ranks() const
  {
    std::vector<Index> result(m_interpolation->number_of_vertices());
    for (Index rank = 0; rank < result.size(); ++rank)
      result[m_interpolation->input_vertex(rank)] = rank;
    return result;
  }

  // Calls `parameterize()`, which makes a parameterizer whose solver is that of the session and writes its map to `uv`.
  template <class Point, class Function>
  Error_code parameterize(const std::shared_ptr<Multigrid_session>& session, const std::vector<Point>& uv, const Function& parameterize)
  {
    const Multigrid_solver_traits::Scope scope{ Multigrid_solver_traits(session) };
    Error_code code = parameterize();
    if (code == OK && !(session->finish() && are_finite(uv)))
      code = ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    summary().error.code = code;
    summary().converged = code == OK;
    summary().linear_solver = session->summary();
    summary().seconds_parameterize = m_timer.time() - summary().seconds_hierarchy;
    return code;
  }

  // Does with the flips of a map of `mesh` what the policy says.
  template <class Point>
  Error_code settle_flips(const TriangleMesh& mesh, halfedge_descriptor bhd, Flip_policy policy, std::vector<Point>& uv)
  {
    if (policy == Flip_policy::KEEP)
      return error();
    std::vector<Point_2> map;
    for (const Point& p : uv)
      map.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
    const auto make_surface = [&] { return std::move(Mesh_component<TriangleMesh>(mesh, bhd).surface()); };
    summary().error.code = internal::settle_flips(m_triangles, One_rings(uv.size(), m_triangles), make_surface, policy, map, summary());
    if (summary().moved_vertices > 0)
      for (std::size_t i = 0; i < uv.size(); ++i)
        uv[i] = Point(map[i].x(), map[i].y());
    return error();
  }

  // Whether so many vertices were moved by a repair that little is left of the map.
  bool is_mostly_moved() { return summary().moved_vertices > m_vertices.size() / 10; }

  Parameterization_summary& summary() { return m_users_summary ? *m_users_summary : m_own_summary; }

private:
  template <class Point>
  static bool are_finite(const std::vector<Point>& points)
  {
    for (const Point& p : points)
      if (!std::isfinite(CGAL::to_double(p.x())) || !std::isfinite(CGAL::to_double(p.y())))
        return false;
    return true;
  }

  CGAL::Real_timer m_timer;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<Index_triangle> m_triangles;
  Index_map m_index;
  std::shared_ptr<const Hierarchy_interpolation> m_interpolation;
  Parameterization_summary* m_users_summary;
  Parameterization_summary m_own_summary;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_RUN_H
