// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_COVERED_TRIANGLES_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_COVERED_TRIANGLES_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/border/box_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/covered_triangles.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void for_each_covered_triangle(const std::vector<Index_triangle>& triangles, const std::vector<Point_2>& uv,
                               Function_ref<void(std::size_t, std::size_t)> f)
{
  std::vector<Point_2> centroids;
  std::vector<Bbox_2> boxes_of_centroids, boxes;
  for (const Index_triangle& t : triangles) {
    const Point_2 &a = uv[t[0]], &b = uv[t[1]], &c = uv[t[2]];
    centroids.emplace_back((a.x() + b.x() + c.x()) / 3, (a.y() + b.y() + c.y()) / 3);
    boxes_of_centroids.push_back(centroids.back().bbox());
    boxes.push_back(a.bbox() + b.bbox() + c.bbox());
  }
  const auto is_in = [&](const Point_2& p, const Index_triangle& t) {
    for (int i = 0; i < 3; ++i)
      if (!(cross(uv[t[(i + 1) % 3]] - uv[t[i]], p - uv[t[i]]) > 0))
        return false;
    return true;
  };
  for_each_pair_of_boxes(boxes_of_centroids, boxes, [&](std::size_t i, std::size_t j) {
    if (i != j && is_in(centroids[i], triangles[j]))
      f(i, j);
  });
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double covered_part(const std::vector<Index_triangle>& triangles, const std::vector<Point_2>& uv)
{
  std::vector<bool> is_covered(triangles.size(), false);
  for_each_covered_triangle(triangles, uv, [&](std::size_t i, std::size_t) { is_covered[i] = true; });
  return double(std::count(is_covered.begin(), is_covered.end(), true)) / double(triangles.size());
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_COVERED_TRIANGLES_IMPL_H
