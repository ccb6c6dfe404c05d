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
#include <CGAL/Surface_mesh_parameterization/internal/levels/Refinable_method.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Run_setup.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Place_constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/place_border.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/position_in.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/read_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/write_map.h>

#include <CGAL/Real_timer.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A model of RefinableParameterizer_3 as the engine sees it.
template <class Method>
class Refinable_method_of final
  : public Refinable_method
{
public:
  Refinable_method_of(Method& method, const Loops& loops) : m_method(method), m_loops(loops) { }

  bool is_flip_free() const override { return Method::is_flip_free; }
  Loops loops() const override { return m_loops; }
  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv) override
  {
    return checked(m_method.parameterize_coarsest(level, uv), level, uv);
  }
  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary) override
  {
    return checked(m_method.refine(level, uv, summary), level, uv);
  }
  bool leave_room() override
  {
    if constexpr (is_detected<Room_left, Method>)
      return m_method.leave_room();
    return false;
  }
  bool keep_borders_apart([[maybe_unused]] bool yes) override
  {
    if constexpr (keeps_borders_apart<Method>)
      return m_method.keep_borders_apart(yes);
    return false;
  }

  bool has_energy() const override { return is_detected<Energy_of, Method>; }
  bool has_flip_free_alternative() const override
  {
    return is_detected<Energy_of, Method> && is_detected<Refined_without_flips, Method>;
  }
  double energy([[maybe_unused]] const Level& level, [[maybe_unused]] const Level::Uv& uv) const override
  {
    if constexpr (is_detected<Energy_of, Method>)
      return m_method.energy(level, uv);
    return 0;
  }
  Error_code refine_without_flips([[maybe_unused]] const Level& level, [[maybe_unused]] Level::Uv& uv,
                                  [[maybe_unused]] Level_summary& summary) override
  {
    if constexpr (is_detected<Refined_without_flips, Method>)
      return checked(m_method.refine_without_flips(level, uv, summary), level, uv);
    return ERROR_NO_1_TO_1_MAPPING;
  }

  // Results without flips need no repair, and their methods do not compile it.
  Error_code settle_flips(const Flip_settlement& settlement, const One_rings& rings,
                          Function_ref<Triangulated_surface_3()> make_surface, Level::Uv& uv,
                          Parameterization_summary& summary) const override
  {
    if constexpr (is_result_flip_free<Method>)
      return settlement.policy == Flip_policy::KEEP || has_no_flips(rings, uv, settlement.loops)
                 ? OK : ERROR_NO_1_TO_1_MAPPING;
    else {
      const Error_code status = internal::settle_flips(settlement, rings, make_surface, uv, summary);
      if (status == OK && settlement.policy != Flip_policy::KEEP && !places_border<Method>)
        mirror_back(rings, uv);
      return status;
    }
  }

  // Why the method has returned ERROR_WRONG_PARAMETER.
  const char* cause() const
  {
    return m_has_resized_map ? "the method has changed the number of places in the map of a level"
                             : "the method refuses one of its options";
  }

private:
  // What the method returns, unless its map is none of the level.
  Error_code checked(Error_code status, const Level& level, const Level::Uv& uv)
  {
    m_has_resized_map = status == OK && uv.size() != level.number_of_vertices();
    return m_has_resized_map ? ERROR_WRONG_PARAMETER : status;
  }

  // The optional members of the concept.
  template <class M>
  using Room_left = decltype(std::declval<M&>().leave_room());

  template <class M>
  using Energy_of = decltype(std::declval<const M&>().energy(std::declval<const Level&>(),
                                                             std::declval<const Level::Uv&>()));

  template <class M>
  using Refined_without_flips = decltype(std::declval<M&>().refine_without_flips(
      std::declval<const Level&>(), std::declval<Level::Uv&>(), std::declval<Level_summary&>()));

  Method& m_method;
  Loops m_loops;
  bool m_has_resized_map = false;
};

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

// Does what add_places() does, or returns `ERROR_WRONG_PARAMETER` if the map can only be written.
template <class TriangleMesh, class VertexUVMap>
Parameterization_error add_places_if_readable(const Place_constraints<TriangleMesh>& constraints,
                                              const TriangleMesh& mesh, VertexUVMap uvmap, bool is_start,
                                              Mesh_component<TriangleMesh>& component, bool& is_mirrored)
{
  if (constraints.empty())
    return Parameterization_error();
  if constexpr (Readable_uv_map_check<VertexUVMap, TriangleMesh>::value)
    return add_places(constraints, mesh, uvmap, is_start, component, is_mirrored);
  else
    return unreadable_map();
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

// Makes the map of a component's surface, in its units, that the user gives to start from, if it is one to start from;
// else it is empty. Returns false if the user's map can only be written.
template <class TriangleMesh, class VertexUVMap>
bool make_start_if_readable(Make_starting_map make_starting_map, bool must_mirror, const Loops& loops,
                            Mesh_component<TriangleMesh>& component, VertexUVMap uvmap, std::vector<Point_2>& start)
{
  if constexpr (Readable_uv_map_check<VertexUVMap, TriangleMesh>::value) {
    start = read_map(component, component.surface().scale_exponent, uvmap);
    start.resize(component.surface().points.size(), nowhere());      // where holes were filled
    if (must_mirror)
      mirror(start);
    if (!make_starting_map(component.surface(), loops, start))
      start.clear();
    return true;
  } else
    return false;
}

// Gives vertices of a component the places that the method's border and the caller's constraints ask for.
template <class Method, class TriangleMesh, class VertexUVMap>
Parameterization_error place_vertices(Method& method, const Run_setup<TriangleMesh>& setup, const TriangleMesh& mesh,
                                      typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd,
                                      VertexUVMap uvmap, Mesh_component<TriangleMesh>& component, bool& is_mirrored)
{
  if (component.error().code != OK)
    return component.error();
  if (const Parameterization_error error = place_border(method, mesh, bhd, component); error.code != OK)
    return error;
  return add_places_if_readable(setup.constraints, mesh, uvmap, bool(setup.options.make_starting_map), component,
                                is_mirrored);
}

template <class Method, class User_point_2, class TriangleMesh>
Nested_iteration_options options_of_run(const Run_setup<TriangleMesh>& setup, const Loops& loops,
                                        Triangulated_surface_3& surface)
{
  Nested_iteration_options result = setup.options;
  result.round = rounding_to<User_point_2>(surface.scale_exponent);
  result.flips.loops = loops;
  result.must_hold_places = !setup.constraints.empty();
  result.places_at_end = take_places_at_no_cost<Method>(surface);
  return result;
}

// Completes what the summary tells of the error of a run.
template <class TriangleMesh>
void explain(const TriangleMesh& mesh, const Mesh_component<TriangleMesh>& component, const char* cause_of_method,
             Parameterization_error& error)
{
  if (error.code == ERROR_WRONG_PARAMETER && !error.cause)
    error.cause = cause_of_method;
  else if (error.place == Parameterization_error::VERTEX)
    error.index = position_in(vertices(mesh), component.vertices_of_component()[error.index]);
}

// Runs a model of RefinableParameterizer_3 coarse to fine on the component of a mesh, and writes to the property maps
// if all went well. The visitor may be null.
template <class Method, class TriangleMesh, class VertexUVMap, class VertexParameterizedMap>
Error_code run_nested_iteration(Method method, const Run_setup<TriangleMesh>& setup, Any_hierarchy_visitor* visitor,
                                const Loops& loops, const TriangleMesh& mesh,
                                typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd, VertexUVMap uvmap,
                                VertexParameterizedMap vpmap)
{
  typedef typename boost::property_traits<VertexUVMap>::value_type   User_point_2;
  Parameterization_summary unused_summary;
  Parameterization_summary& summary = setup.summary ? *setup.summary : unused_summary;
  summary = Parameterization_summary();
  if (const char* fault = fault_of_run(setup.options, method)) {
    summary.error = { ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0, fault };
    return ERROR_WRONG_PARAMETER;
  }
  CGAL::Real_timer timer;
  timer.start();
  Mesh_component<TriangleMesh> component(mesh, bhd, loops);
  bool is_mirrored = false;
  summary.error = place_vertices(method, setup, mesh, bhd, uvmap, component, is_mirrored);
  if (summary.error.code != OK)
    return summary.error.code;
  if (setup.options.fills_holes)
    component.fill_holes();

  const Nested_iteration_options options = options_of_run<Method, User_point_2>(setup, loops, component.surface());
  std::vector<Point_2> uv;
  if (options.make_starting_map &&
      !make_start_if_readable(options.make_starting_map, is_mirrored, loops, component, uvmap, uv)) {
    summary.error = unreadable_map();
    return summary.error.code;
  }
  const int scale_exponent = component.surface().scale_exponent;
  Refinable_method_of<Method> engine_method(method, loops);
  Nested_iteration_attempts attempts(engine_method, options, visitor, summary);
  if (attempts.run(std::move(component.surface()), timer, uv) != OK) {
    explain(mesh, component, engine_method.cause(), summary.error);
    return summary.error.code;
  }
  if (is_mirrored)
    mirror(uv);
  summary.error.code = write_map(component, scale_exponent, uv, uvmap, vpmap);
  if (summary.error.code != OK)
    summary.error.cause = cause_of_overflow;
  return summary.error.code;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_RUN_NESTED_ITERATION_H
