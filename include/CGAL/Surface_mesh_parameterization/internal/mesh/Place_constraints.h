// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_PLACE_CONSTRAINTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_PLACE_CONSTRAINTS_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/fixed_places.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/position_in.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/read_map.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
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

inline void mirror_places(Triangulated_surface_3& surface)
{
  for (Triangulated_surface_3::Fixed_vertex& fixed : surface.fixed_vertices)
    mirror(fixed.place);
  for (Triangulated_surface_3::Spring& s : surface.springs)
    mirror(s.place);
}

// Whether the given places on the outer border run around the map the wrong way, so that all triangles have to be
// negative. Some of CGAL's border parameterizers place a border so. The outer border is in the order in which
// Mesh_component reads it, with the surface to the right. Where no place is given along more than half of the border,
// nothing is said: the others may lie along a side, or in a bay.
inline bool is_border_mirrored(const Triangulated_surface_3& surface)
{
  const std::vector<const Point_2*> place = fixed_places(surface);
  const std::vector<Index>& border = surface.outer_border;
  std::vector<Point_2> polygon;
  std::vector<double> at;                   // of the border's length, from its first vertex on
  double length = 0;
  for (std::size_t i = 0; i < border.size(); ++i) {
    if (place[border[i]]) {
      polygon.push_back(*place[border[i]]);
      at.push_back(length);
    }
    const Index next = border[next_in_cycle(i, border.size())];
    length += std::sqrt((surface.points[next] - surface.points[border[i]]).squared_length());
  }
  for (std::size_t i = 0; i < at.size(); ++i)
    if ((i + 1 == at.size() ? at[0] + length : at[i + 1]) - at[i] > 0.5 * length)
      return false;
  return doubled_area(polygon) > 0;
}

inline bool is_border_fixed(const Triangulated_surface_3& surface)
{
  const std::vector<const Point_2*> place = fixed_places(surface);
  return std::all_of(surface.outer_border.begin(), surface.outer_border.end(), [&](Index v) { return place[v]; });
}

// Whether more triangles of a map are negative than positive, or as many and the border is mirrored.
inline bool is_start_mirrored(const Triangulated_surface_3& surface, const std::vector<Point_2>& uv)
{
  std::size_t positive = 0, negative = 0;
  for (const Index_triangle& t : surface.triangles) {
    const double area = doubled_area(uv[t[0]], uv[t[1]], uv[t[2]]);
    positive += area > 0;
    negative += area < 0;
  }
  return negative > positive || (negative == positive && is_border_mirrored(surface));
}

// A triangle that its corners' given places turn over or make degenerate, or the number of triangles if there is none.
inline std::size_t first_contradiction(const Triangulated_surface_3& surface)
{
  const std::vector<const Point_2*> place = fixed_places(surface);
  std::size_t f = 0;
  for (; f < surface.triangles.size(); ++f) {
    const Index_triangle& t = surface.triangles[f];
    const Point_2 *const a = place[t[0]], *const b = place[t[1]], *const c = place[t[2]];
    const auto coincide = [](const Point_2* p, const Point_2* q) { return p && q && *p == *q; };
    if ((a && b && c && !is_left_turn(*a, *b, *c)) || coincide(a, b) || coincide(b, c) || coincide(c, a))
      break;
  }
  return f;
}

inline bool has_contradiction(const Triangulated_surface_3& surface)
{
  return first_contradiction(surface) < surface.triangles.size();
}

// Mirrors the places of a surface if the map has to be mirrored, which it returns: if the border is, or the user's map
// `start` if the run starts from it, as far as triangles between given places do not tell otherwise.
inline bool mirror_places_if_needed(Triangulated_surface_3& surface, const std::vector<Point_2>* start)
{
  if (surface.fixed_vertices.empty() && surface.springs.empty())
    return false;
  const bool is_mirrored = start ? is_start_mirrored(surface, *start) : is_border_mirrored(surface);
  if (is_mirrored)
    mirror_places(surface);
  const bool is_certain = !start && is_border_fixed(surface);
  if (is_certain || !has_contradiction(surface))
    return is_mirrored;
  mirror_places(surface);
  if (!has_contradiction(surface))
    return !is_mirrored;
  mirror_places(surface);
  return is_mirrored;
}

// Adds to a component's surface the places that the constraints ask for, as the user's map has them, but mirrored if
// the map has to be, which `is_mirrored` tells then.
// Returns `ERROR_WRONG_PARAMETER` for a place that is not finite or a weight that is negative or not finite,
// `ERROR_NO_1_TO_1_MAPPING` for a triangle that given places leave no room for, and which.
template <class TriangleMesh, class VertexUVMap>
Parameterization_error add_places(const Place_constraints<TriangleMesh>& constraints, const TriangleMesh& mesh,
                                  VertexUVMap uvmap, bool is_start, Mesh_component<TriangleMesh>& component,
                                  bool& is_mirrored)
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
                              : (is_fixed || weight > 0) && !is_finite(uv[i]) ? "a given place is not finite"
                                                                              : nullptr;
    if (cause)
      return { ERROR_WRONG_PARAMETER, Parameterization_error::VERTEX, position_in(vertices(mesh), v), cause };
    if (is_fixed)
      surface.fixed_vertices.push_back({ Index(i), uv[i] });
    else if (weight > 0)
      surface.springs.push_back({ Index(i), uv[i], stiffness });
  }
  is_mirrored = mirror_places_if_needed(surface, is_start ? &uv : nullptr);
  if (const std::size_t f = first_contradiction(surface); f < surface.triangles.size())
    return { ERROR_NO_1_TO_1_MAPPING, Parameterization_error::FACE,
             position_in(faces(mesh), component.faces_of_component()[f]),
             "the places of constrained vertices leave a triangle no room" };
  return Parameterization_error();
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_PLACE_CONSTRAINTS_H
