// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_HOLES_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_HOLES_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/holes.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Border> holes(const Triangulated_surface_3& surface, const One_rings& rings)
{
  std::vector<bool> is_on_outer_border(surface.points.size(), false);
  for (const Index v : surface.outer_border)
    is_on_outer_border[v] = true;
  std::vector<Border> result = rings.borders();
  result.erase(std::remove_if(result.begin(), result.end(),
                              [&](const Border& border) { return is_on_outer_border[border.front()]; }),
               result.end());
  return result;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double perimeter(const std::vector<Point_3>& polygon)
{
  double result = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector_3 edge = polygon[next_in_cycle(i, polygon.size())] - polygon[i];
    result += std::hypot(edge.x(), edge.y(), edge.z());
  }
  return result;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool is_crack(const std::vector<Point_3>& hole)
{
  constexpr double greatest_area = 0.01;      // for the length 1; that of a square is 0.06
  const double length = perimeter(hole);
  Vector_3 doubled_area(0, 0, 0);
  for (std::size_t i = 1; length > 0 && i + 1 < hole.size(); ++i)
    doubled_area += CGAL::cross_product((hole[i] - hole[0]) / length, (hole[i + 1] - hole[0]) / length);
  return 0.5 * std::sqrt(doubled_area.squared_length()) <= greatest_area;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Point_3 middle_of_hole(const Hole_3& hole)
{
  constexpr double height_above_crack = 0.2;      // relative to the edges
  const double n = double(hole.places.size());
  Vector_3 middle(0, 0, 0);
  for (const Point_3& p : hole.places)
    middle += (p - CGAL::ORIGIN) / n;
  if (is_crack(hole.places)) {
    const double length = perimeter(hole.places);
    Vector_3 sum_of_normals(0, 0, 0);
    for (const auto& [p, q, r] : hole.triangles)
      sum_of_normals += CGAL::cross_product((q - p) / length, (r - p) / length);
    if (const double size = std::sqrt(sum_of_normals.squared_length()); std::isnormal(size))
      middle += height_above_crack * length / n / size * sum_of_normals;
  }
  return CGAL::ORIGIN + middle;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void fill_hole(const Border& hole, const One_rings& rings, Triangulated_surface_3& surface)
{
  std::vector<Point_3>& points = surface.points;
  const Index middle = Index(points.size());
  Hole_3 hole_in_space{ places_of(hole, [&](Index v) { return points[v]; }), {} };
  for (std::size_t i = 0; i < hole.size(); ++i) {
    const Index v = hole[i], next = hole[next_in_cycle(i, hole.size())];
    surface.triangles.push_back({ next, v, middle });
    hole_in_space.triangles.push_back({ points[v], points[next], points[rings[v][1]] });
  }
  points.push_back(middle_of_hole(hole_in_space));
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void fill_holes(Triangulated_surface_3& surface)
{
  const One_rings rings(surface.points.size(), surface.triangles);
  for (const Border& hole : holes(surface, rings))
    fill_hole(hole, rings, surface);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_HOLES_IMPL_H
