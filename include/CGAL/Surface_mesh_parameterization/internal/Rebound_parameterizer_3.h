// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_REBOUND_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_REBOUND_PARAMETERIZER_3_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Rebind_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/Component_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/internal/Multigrid_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/Solver_use.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Runs a parameterizer that solves linear systems with the multigrid solver in place of its own. Vertices are numbered breadth first, and the
// parameterizer writes to private maps, which are copied to the user's if all went well.
template <class Parameterizer>
class Rebound_parameterizer_3
{
  typedef typename Rebind_solver<Parameterizer, Multigrid_solver_traits>::type   Rebound;
  typedef Solver_use<Parameterizer>                                              Use;

public:
  typedef typename Parameterizer::Triangle_mesh                               Triangle_mesh;
  typedef typename Parameterizer::Triangle_mesh                               TriangleMesh;
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor    halfedge_descriptor;

  // The arguments are those of `Parameterizer`'s constructor, less the solver; named parameters may follow them:
  // - `coarsest_size`, `random_seed`: of the hierarchy, see Collapse_hierarchy_3
  // - `tolerance`, `number_of_iterations`: of the solver, see Multigrid_solver_traits
  // - `visitor`: a model of HierarchyVisitor_3, whose hierarchy_built() is called
  // - `summary`: a std::reference_wrapper<Parameterization_summary> that receives what the run did
  Rebound_parameterizer_3() : Rebound_parameterizer_3(parameters::default_values()) { }

  template <class First, class... Others, class = std::enable_if_t<!std::is_base_of<Rebound_parameterizer_3, First>::value>>
  explicit Rebound_parameterizer_3(const First& first, const Others&... others)
  {
    const auto arguments = std::make_tuple(first, others...);
    constexpr std::size_t last = sizeof...(others);
    typedef std::decay_t<decltype(std::get<last>(arguments))>   Last;
    if constexpr (is_named_parameters<Last>) {
      keep_arguments(arguments, std::make_index_sequence<last>());
      set_options(std::get<last>(arguments));
    } else {
      keep_arguments(arguments, std::make_index_sequence<last + 1>());
      set_options(parameters::default_values());
    }
  }

  // Further arguments are handed on, as the number of iterations of Iterative_authalic_parameterizer_3.
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap, class... Others>
  Error_code parameterize(Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap, VertexIndexMap, VertexParameterizedMap vpmap, Others&&... others)
  {
    typedef typename boost::property_traits<VertexUVMap>::value_type                                          User_point_2;
    typedef typename boost::property_map<Triangle_mesh, CGAL::dynamic_vertex_property_t<int>>::const_type      Index_map;

    Parameterization_summary unused_summary;
    Parameterization_summary& summary = m_summary ? *m_summary : unused_summary;
    summary = Parameterization_summary();
    CGAL::Real_timer timer;
    timer.start();

    Mesh_component<Triangle_mesh> component(mesh, bhd);
    summary.error = component.error();
    if (summary.error.code != OK)
      return summary.error.code;
    const auto& vertices = component.vertices_of_component();
    const auto hierarchy = std::make_shared<const Collapse_hierarchy_3>(m_build(std::move(component.surface())));
    summary.seconds_hierarchy = timer.time();
    if (!m_visitor->hierarchy_built(*hierarchy)) {
      summary.stopped = true;
      return summary.error.code = ERROR_NO_1_TO_1_MAPPING;
    }

    const Index_map index = get(CGAL::dynamic_vertex_property_t<int>(), std::as_const(mesh));
    std::vector<User_point_2> uv(vertices.size());
    std::vector<char> is_placed(vertices.size(), false);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      put(index, vertices[i], int(i));
      if (get(vpmap, vertices[i])) {
        uv[i] = get(uvmap, vertices[i]);
        is_placed[i] = true;
      }
    }

    std::function<bool(std::size_t)> is_locked;
    if (Use::locks_placed_vertices)
      is_locked = [&is_placed](std::size_t i) { return bool(is_placed[i]); };
    const auto session = std::make_shared<Multigrid_session>(hierarchy, Mesh_unknowns(ranks(*hierarchy), is_locked), m_options, Use::solves_in_pairs);
    const Multigrid_solver_traits::Scope scope{ Multigrid_solver_traits(session) };
    summary.error.code = m_make()->parameterize(mesh, bhd, Component_map<Index_map, User_point_2>{ index, &uv }, index,
                                                Component_map<Index_map, char>{ index, &is_placed }, std::forward<Others>(others)...);
    if (summary.error.code == OK && !(session->finish() && are_finite(uv)))
      summary.error.code = ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    summary.linear_solver = session->summary();
    summary.seconds_parameterize = timer.time() - summary.seconds_hierarchy;
    if (summary.error.code != OK)
      return summary.error.code;

    summary.converged = true;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      put(uvmap, vertices[i], uv[i]);
      put(vpmap, vertices[i], bool(is_placed[i]));
    }
    return OK;
  }

private:
  // Each run makes its own parameterizer, inside the scope of its solver; and some of CGAL's cannot be copied.
  template <class Tuple, std::size_t... positions>
  void keep_arguments(const Tuple& arguments, std::index_sequence<positions...>)
  {
    m_make = [arguments] { (void)arguments; return std::make_unique<Rebound>(std::get<positions>(arguments)...); };
  }

  template <class NamedParameters>
  void set_options(const NamedParameters& np)
  {
    m_build = [np](Triangulated_surface_3 surface) { return Collapse_hierarchy_3(std::move(surface), np); };
    m_options = linear_solver_options_of(np);
    m_visitor = hierarchy_visitor_of(np);
    m_summary = summary_of(np);
  }

  // The ranks of the component's vertices, in its order.
  static std::vector<Index> ranks(const Collapse_hierarchy_3& hierarchy)
  {
    std::vector<Index> result(hierarchy.number_of_vertices());
    for (Index rank = 0; rank < result.size(); ++rank)
      result[hierarchy.input_vertex(rank)] = rank;
    return result;
  }

  template <class Point>
  static bool are_finite(const std::vector<Point>& points)
  {
    for (const Point& p : points)
      if (!std::isfinite(CGAL::to_double(p.x())) || !std::isfinite(CGAL::to_double(p.y())))
        return false;
    return true;
  }

  std::function<std::unique_ptr<Rebound>()> m_make;
  std::function<Collapse_hierarchy_3(Triangulated_surface_3)> m_build;
  Multigrid_linear_solver::Options m_options;
  std::shared_ptr<Any_hierarchy_visitor> m_visitor;
  Parameterization_summary* m_summary = nullptr;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_REBOUND_PARAMETERIZER_3_H
