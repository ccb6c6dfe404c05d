// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_PLACE_CONSTRAINTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_PLACE_CONSTRAINTS_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/orientation_of_places.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/position_in.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/read_map.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The vertices of a mesh that the user holds at their places in the plane, and those that are pulled there, with
// weights. Either function may be empty.
template <class TriangleMesh>
struct Place_constraints
{
  typedef typename Mesh_descriptors<TriangleMesh>::vertex_descriptor   vertex_descriptor;

  std::function<bool(vertex_descriptor)> is_constrained;
  std::function<double(vertex_descriptor)> weight;

  bool empty() const { return !is_constrained && !weight; }
};

typedef Names<internal_np::vertex_is_constrained_t, internal_np::position_weight_t>   Place_constraint_names;

// A map that is given as a named parameter, from the vertices of a mesh to values that are read as `Value`, as a
// function; an empty one if it is not given.
template <class Value, class TriangleMesh, class Tag, class NamedParameters>
auto function_of_vertex_map(const NamedParameters& np, Tag tag)
{
  typedef typename Mesh_descriptors<TriangleMesh>::vertex_descriptor   vertex_descriptor;
  std::function<Value(vertex_descriptor)> result;
  if constexpr (!parameters::is_default_parameter<NamedParameters, Tag>::value) {
    const auto map = parameters::get_parameter(np, tag);
    typedef Vertex_map_check<std::decay_t<decltype(map)>, TriangleMesh, Value>   Check;
    if constexpr (Check::value)
      result = [map](vertex_descriptor v) { return Value(get(map, v)); };
    else
      Check::tell();
  }
  return result;
}

// The constraints that named parameters tell.
template <class TriangleMesh, class NamedParameters>
Place_constraints<TriangleMesh> place_constraints_of(const NamedParameters& np)
{
  Place_constraints<TriangleMesh> result;
  if constexpr (Mesh_check<TriangleMesh>::value) {
    result.is_constrained = function_of_vertex_map<bool, TriangleMesh>(np, internal_np::vertex_is_constrained);
    result.weight = function_of_vertex_map<double, TriangleMesh>(np, internal_np::position_weight_map);
  }
  return result;
}

// Adds to a component's surface the places that the constraints ask for, as the user's map has them, but mirrored if
// the map has to be, as far as can be told, see orient_places().
// Returns `ERROR_WRONG_PARAMETER` for a place that is not finite or a weight that is negative or not finite,
// `ERROR_NO_1_TO_1_MAPPING` for a triangle that given places leave no room for, and which.
template <class TriangleMesh, class VertexUVMap>
Parameterization_error add_places(const Place_constraints<TriangleMesh>& constraints, const TriangleMesh& mesh,
                                  VertexUVMap uvmap, bool is_start, Mesh_component<TriangleMesh>& component,
                                  Orientation_of_places& orientation)
{
  Triangulated_surface_3& surface = component.surface();
  const std::vector<Point_2> uv = read_map(component, surface.scale_exponent, uvmap);
  for (std::size_t i = 0; i < uv.size(); ++i) {
    const auto v = component.vertices_of_component()[i];
    const bool is_fixed = constraints.is_constrained && constraints.is_constrained(v);
    const double weight = constraints.weight && !is_fixed ? constraints.weight(v) : 0;
    const double stiffness = 2 * std::ldexp(weight, -2 * surface.scale_exponent);
    const char* const cause = !(weight >= 0 && std::isfinite(stiffness))
                                  ? "a weight is negative, or too large, or not a number"
                              : (is_fixed || weight > 0) && !is_finite(uv[i]) ? "given uv coordinates are not finite"
                                                                              : nullptr;
    if (cause)
      return { ERROR_WRONG_PARAMETER, Parameterization_error::VERTEX, position_in(vertices(mesh), v), cause };
    if (is_fixed)
      surface.fixed_vertices.push_back({ Index(i), uv[i] });
    else if (weight > 0)
      surface.springs.push_back({ Index(i), uv[i], stiffness });
  }
  orientation = orient_places(surface, is_start ? &uv : nullptr);
  if (const std::size_t f = first_contradiction(surface); f < surface.triangles.size())
    return { ERROR_NO_1_TO_1_MAPPING, Parameterization_error::FACE,
             position_in(faces(mesh), component.faces_of_component()[f]),
             "the places of constrained vertices leave a triangle no room" };
  return Parameterization_error();
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_PLACE_CONSTRAINTS_H
