// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_HOLES_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_HOLES_IMPL_H

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
void fill_hole(const Border& hole, const One_rings& rings, Triangulated_surface_3& surface)
{
  constexpr double height_above_crack = 0.2;      // relative to the edges
  std::vector<Point_3>& points = surface.points;
  const Index middle = Index(points.size());
  const double n = double(hole.size());
  Vector_3 center(0, 0, 0), normal(0, 0, 0);      // the latter of the triangles along the hole
  for (std::size_t i = 0; i < hole.size(); ++i) {
    const Index v = hole[i], next = hole[i + 1 == hole.size() ? 0 : i + 1];
    surface.triangles.push_back({ next, v, middle });
    center += (points[v] - CGAL::ORIGIN) / n;
    normal += CGAL::cross_product(points[next] - points[v], points[rings[v][1]] - points[v]);
  }
  const auto place = [&](Index v) { return points[v]; };
  if (const double size = std::sqrt(normal.squared_length()); size > 0 && is_crack(hole, place))
    center += height_above_crack * length_of_border(hole, place) / n / size * normal;
  points.push_back(CGAL::ORIGIN + center);
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
