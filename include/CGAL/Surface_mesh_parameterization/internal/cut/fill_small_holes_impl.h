// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_FILL_SMALL_HOLES_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_FILL_SMALL_HOLES_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/cut/fill_small_holes.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

typedef std::vector<Index>   Border;      // a cycle of halfedges, as of borders()

inline Point_3 middle_of(const Corner_mesh& mesh, const Border& border)
{
  const double n = double(border.size());
  double x = 0, y = 0, z = 0;
  for (const Index h : border) {
    const Point_3& p = mesh.points[mesh.target(h)];
    x += p.x() / n;
    y += p.y() / n;
    z += p.z() / n;
  }
  return Point_3(x, y, z);
}

// Whether the triangles between the border and its middle suit a surface: none is much smaller than those of a regular
// polygon, and their normals do not cancel, as those of the two sides of a crack do.
inline bool is_round(const Corner_mesh& mesh, const Border& border)
{
  constexpr double least_part_of_regular = 0.01, least_part_of_areas = 0.25;
  const Point_3 middle = middle_of(mesh, border);
  const double perimeter = length(mesh, border),
               least_area = least_part_of_regular * perimeter * perimeter / (4 * CGAL_PI * double(border.size()));
  double sum_of_areas = 0;
  Vector_3 sum_of_normals(0, 0, 0);
  for (const Index h : border) {
    const Vector_3 normal = 0.5 * CGAL::cross_product(mesh.points[mesh.source(h)] - middle,
                                                      mesh.points[mesh.target(h)] - middle);
    const double area = std::sqrt(normal.squared_length());
    if (!(area >= least_area))
      return false;
    sum_of_areas += area;
    sum_of_normals = sum_of_normals + normal;
  }
  return std::sqrt(sum_of_normals.squared_length()) >= least_part_of_areas * sum_of_areas;
}

inline void fill(const Border& border, Corner_mesh& mesh)
{
  const Index middle = Index(mesh.points.size()), first = mesh.number_of_halfedges(), n = Index(border.size());
  mesh.points.push_back(middle_of(mesh, border));
  for (Index i = 0; i < n; ++i) {
    const Index h = border[i], new_h = first + 3 * i;      // leads back; from its ends spokes lead to the middle
    mesh.vertex.insert(mesh.vertex.end(), { mesh.source(h), middle, mesh.target(h) });
    mesh.opposite[h] = new_h;
    mesh.opposite.insert(mesh.opposite.end(), { h, first + 3 * (i == 0 ? n - 1 : i - 1) + 2,
                                                first + 3 * (i + 1 == n ? 0 : i + 1) + 1 });
  }
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Filled_holes> fill_small_holes(Corner_mesh& mesh, const std::vector<bool>& is_at_hole, double hole_bound)
{
  const std::vector<std::vector<Index>> components = connected_components(mesh);
  std::vector<Filled_holes> result(components.size());
  std::vector<Index> component_of_face(mesh.number_of_faces());
  for (Index i = 0; i < components.size(); ++i)
    for (const Index f : components[i])
      component_of_face[f] = i;
  std::vector<std::vector<Border>> borders_of_component(components.size());
  for (Border& border : borders(mesh))
    borders_of_component[component_of_face[border.front() / 3]].push_back(std::move(border));

  for (Index i = 0; i < components.size(); ++i) {
    std::vector<Border>& all = borders_of_component[i];
    if (all.size() < 2)
      continue;
    all.erase(std::max_element(all.begin(), all.end(), [&](const Border& a, const Border& b) {
      return length(mesh, a) < length(mesh, b);
    }));
    double area = 0;
    for (const Index f : components[i])
      area += area_of_face(mesh, f);
    for (const Border& border : all)
      if (border.size() >= 3 && length(mesh, border) <= hole_bound * std::sqrt(area) &&
          std::all_of(border.begin(), border.end(), [&](Index h) { return is_at_hole[h]; }) && is_round(mesh, border)) {
        fill(border, mesh);
        ++result[i].holes;
        result[i].faces += border.size();
      }
  }
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_FILL_SMALL_HOLES_IMPL_H
