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
inline bool is_round(const Corner_mesh& mesh, const Border& border, double perimeter)
{
  constexpr double least_part_of_regular = 0.01, least_part_of_areas = 0.25;
  const double least_area = least_part_of_regular / (4 * CGAL_PI * double(border.size()));     // of a perimeter of 1
  const Point_3 middle = middle_of(mesh, border);
  double sum_of_areas = 0;
  Vector_3 sum_of_normals(0, 0, 0);
  for (const Index h : border) {
    const Vector_3 normal = 0.5 * CGAL::cross_product((mesh.points[mesh.source(h)] - middle) / perimeter,
                                                      (mesh.points[mesh.target(h)] - middle) / perimeter);
    const double area = std::sqrt(normal.squared_length());
    if (!(area >= least_area))
      return false;
    sum_of_areas += area;
    sum_of_normals = sum_of_normals + normal;
  }
  return std::sqrt(sum_of_normals.squared_length()) >= least_part_of_areas * sum_of_areas;
}

// The root of the area of some faces, over a length of about their size.
inline double relative_root_of_area(const Corner_mesh& mesh, const std::vector<Index>& faces, double unit)
{
  double sum = 0;
  for (const Index f : faces) {
    const Point_3& p = mesh.points[mesh.vertex[3 * f]];
    const Vector_3 normal = CGAL::cross_product((mesh.points[mesh.vertex[3 * f + 1]] - p) / unit,
                                                (mesh.points[mesh.vertex[3 * f + 2]] - p) / unit);
    sum += 0.5 * std::sqrt(normal.squared_length());
  }
  return std::sqrt(sum);
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
    const std::vector<Border>& all = borders_of_component[i];
    if (all.size() < 2)
      continue;
    std::vector<double> lengths;
    for (const Border& border : all)
      lengths.push_back(length(mesh, border));
    const std::size_t longest = std::size_t(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
    const double unit = lengths[longest],
                 greatest_length = hole_bound * relative_root_of_area(mesh, components[i], unit) * unit;
    for (std::size_t j = 0; j < all.size(); ++j)
      if (j != longest && all[j].size() >= 3 && lengths[j] <= greatest_length &&
          std::all_of(all[j].begin(), all[j].end(), [&](Index h) { return is_at_hole[h]; }) &&
          is_round(mesh, all[j], lengths[j])) {
        fill(all[j], mesh);
        ++result[i].holes;
        result[i].faces += all[j].size();
      }
  }
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_FILL_SMALL_HOLES_IMPL_H
