// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_ORIENTATION_OF_PLACES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_ORIENTATION_OF_PLACES_H

#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/fixed_places.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

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

// Whether all corners of a triangle have their places.
inline bool has_fixed_triangle(const Triangulated_surface_3& surface)
{
  const std::vector<bool> is_fixed = are_fixed(surface);
  return std::any_of(surface.triangles.begin(), surface.triangles.end(), [&](const Index_triangle& t) {
    return is_fixed[t[0]] && is_fixed[t[1]] && is_fixed[t[2]];
  });
}

struct Orientation_of_places
{
  bool is_mirrored = false;     // the places are, and the map has to be
  bool is_certain = true;       // else a map may tell better
};

// Mirrors the places of a surface if the map has to be mirrored: if the border is, or the user's map `start` if the run
// starts from it, as far as triangles between given places do not tell otherwise.
inline Orientation_of_places orient_places(Triangulated_surface_3& surface, const std::vector<Point_2>* start)
{
  constexpr std::size_t fewest_places = 3;      // two suit a map and its mirror image
  if (surface.fixed_vertices.empty() && surface.springs.empty())
    return {};
  Orientation_of_places result;
  result.is_mirrored = start ? is_start_mirrored(surface, *start) : is_border_mirrored(surface);
  if (result.is_mirrored)
    mirror_places(surface);
  if (!start && is_border_fixed(surface))
    return result;
  result.is_certain = start || surface.fixed_vertices.size() < fewest_places || has_fixed_triangle(surface);
  if (!has_contradiction(surface))
    return result;
  mirror_places(surface);
  if (has_contradiction(surface))
    mirror_places(surface);
  else
    result.is_mirrored = !result.is_mirrored;
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_ORIENTATION_OF_PLACES_H
