// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_RUN_NESTED_ITERATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_RUN_NESTED_ITERATION_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/detection.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration_attempts.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Refinable_method_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Run_setup.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Place_constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/orientation_of_places.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/place_border.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/position_in.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/read_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/write_map.h>

#include <CGAL/Real_timer.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A method of the package tells what is wrong with its options.
template <class Method>
using Fault_of_options = decltype(std::declval<const Method&>().fault_of_options());

// What is wrong with the options of a run, or with those of its method; null if nothing is.
template <class Method>
const char* fault_of_run(const Nested_iteration_options& options, [[maybe_unused]] const Method& method)
{
  const char* fault = options.fault();
  if constexpr (is_detected_as<const char*, Fault_of_options, Method>)
    fault = fault ? fault : method.fault_of_options();
  return fault;
}

inline Parameterization_error unreadable_map()
{
  return { ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0,
           "uvmap cannot be read, but the run starts from it or holds vertices there" };
}

// For a method of this package, how many vertices can be brought to given places at no cost: a map may be moved and
// turned, or scaled, too.
template <class Method>
using Places_at_no_cost = decltype(Method::places_at_no_cost);

// Takes the places of vertices from a surface if a map can be brought to them when it is done, so that it is free until
// then.
template <class Method>
std::vector<Triangulated_surface_3::Fixed_vertex> take_places_at_no_cost(Triangulated_surface_3& surface)
{
  std::vector<Triangulated_surface_3::Fixed_vertex>& fixed = surface.fixed_vertices;
  if constexpr (is_detected<Places_at_no_cost, Method>) {
    const bool coincide = fixed.size() == 2 && fixed[0].place == fixed[1].place;
    if (fixed.size() <= Method::places_at_no_cost && surface.springs.empty() && !coincide)
      return std::exchange(fixed, {});
  }
  return {};
}

// The run of a model of RefinableParameterizer_3 on the component of a mesh: what it takes from the mesh and from the
// user's map, and how both get the result.
template <class Method, class TriangleMesh, class VertexUVMap>
class Refinable_run
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor   halfedge_descriptor;
  typedef typename boost::property_traits<VertexUVMap>::value_type          User_point_2;

  static constexpr bool is_map_readable = Readable_uv_map_check<VertexUVMap, TriangleMesh>::value;

public:
  Refinable_run(Method& method, const Run_setup<TriangleMesh>& setup, const Loops& loops, const TriangleMesh& mesh,
                halfedge_descriptor bhd, VertexUVMap uvmap)
    : m_method(method), m_setup(setup), m_loops(loops), m_mesh(mesh), m_bhd(bhd), m_uvmap(uvmap),
      m_timer(started_timer()), m_component(mesh, bhd, loops)
  { }

  // Parameterizes the component, and writes to the property maps if all went well. The visitor may be null. Returns the
  // error that completes the summary.
  template <class VertexParameterizedMap>
  Parameterization_error run(Any_hierarchy_visitor* visitor, VertexParameterizedMap vpmap,
                             Parameterization_summary& summary)
  {
    if (const Parameterization_error error = place_vertices(); error.code != OK)
      return error;
    if (m_setup.options.fills_holes)
      m_component.fill_holes();
    const Nested_iteration_options options = make_options();
    std::vector<Point_2> uv;
    if (options.make_starting_map && !make_start(uv))
      return unreadable_map();
    const int scale_exponent = m_component.surface().scale_exponent;
    Refinable_method_of<Method> method(m_method, m_loops);
    Nested_iteration_attempts attempts(method, options, visitor, summary);
    if (attempts.run(std::move(m_component.surface()), m_timer, uv) != OK)
      return explained(summary.error, method.cause());
    if (m_orientation.is_mirrored != attempts.has_mirrored_places())
      mirror(uv);
    const Error_code status = write_map(m_component, scale_exponent, uv, m_uvmap, vpmap);
    return { status, Parameterization_error::NOWHERE, 0, status == OK ? nullptr : cause_of_overflow };
  }

private:
  static CGAL::Real_timer started_timer()
  {
    CGAL::Real_timer timer;
    timer.start();
    return timer;
  }

  // Gives vertices of the component the places that the method's border and the caller's constraints ask for.
  Parameterization_error place_vertices()
  {
    if (m_component.error().code != OK)
      return m_component.error();
    const Parameterization_error error = place_border(m_method, m_mesh, m_bhd, m_component);
    if (error.code != OK || m_setup.constraints.empty())
      return error;
    if constexpr (is_map_readable)
      return add_places(m_setup.constraints, m_mesh, m_uvmap, bool(m_setup.options.make_starting_map), m_component,
                        m_orientation);
    else
      return unreadable_map();
  }

  Nested_iteration_options make_options()
  {
    Nested_iteration_options result = m_setup.options;
    result.round = rounding_to<User_point_2>(m_component.surface().scale_exponent);
    result.flips.loops = m_loops;
    result.must_hold_places = !m_setup.constraints.empty();
    result.may_mirror_places = !m_orientation.is_certain;
    result.places_at_end = take_places_at_no_cost<Method>(m_component.surface());
    return result;
  }

  // Makes the map of the component's surface, in its units, that the user gives to start from, if it is one to start
  // from; else it is empty. Returns false if the user's map can only be written.
  bool make_start(std::vector<Point_2>& start)
  {
    if constexpr (is_map_readable) {
      start = read_map(m_component, m_component.surface().scale_exponent, m_uvmap);
      start.resize(m_component.surface().points.size(), nowhere());      // where holes were filled
      if (m_orientation.is_mirrored)
        mirror(start);
      if (!m_setup.options.make_starting_map(m_component.surface(), m_loops, start))
        start.clear();
    }
    return is_map_readable;
  }

  // An error of the engine, in terms of the mesh.
  Parameterization_error explained(Parameterization_error error, const char* cause_of_method) const
  {
    if (error.code == ERROR_WRONG_PARAMETER && !error.cause)
      error.cause = cause_of_method;
    else if (error.place == Parameterization_error::VERTEX)
      error.index = position_in(vertices(m_mesh), m_component.vertices_of_component()[error.index]);
    return error;
  }

  Method& m_method;
  const Run_setup<TriangleMesh>& m_setup;
  const Loops& m_loops;
  const TriangleMesh& m_mesh;
  halfedge_descriptor m_bhd;
  VertexUVMap m_uvmap;
  CGAL::Real_timer m_timer;
  Mesh_component<TriangleMesh> m_component;
  Orientation_of_places m_orientation;
};

// Runs a model of RefinableParameterizer_3 coarse to fine on the component of a mesh, and writes to the property maps
// if all went well. The visitor may be null.
template <class Method, class TriangleMesh, class VertexUVMap, class VertexParameterizedMap>
Error_code run_nested_iteration(Method method, const Run_setup<TriangleMesh>& setup, Any_hierarchy_visitor* visitor,
                                const Loops& loops, const TriangleMesh& mesh,
                                typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd, VertexUVMap uvmap,
                                VertexParameterizedMap vpmap)
{
  Parameterization_summary unused_summary;
  Parameterization_summary& summary = setup.summary ? *setup.summary : unused_summary;
  summary = Parameterization_summary();
  if (const char* fault = fault_of_run(setup.options, method))
    summary.error = { ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0, fault };
  else {
    Refinable_run<Method, TriangleMesh, VertexUVMap> run(method, setup, loops, mesh, bhd, uvmap);
    summary.error = run.run(visitor, vpmap, summary);
  }
  return summary.error.code;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_RUN_NESTED_ITERATION_H
