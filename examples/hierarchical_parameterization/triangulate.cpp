// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts polygons into triangles.

#include "Polygon_soup.h"

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

// Whether the triangles have all edges of a polygon of n corners, and other edges in pairs.
bool is_triangulation(const std::vector<CGAL::Triple<int, int, int>>& triangles, int n)
{
  std::vector<std::pair<int, int>> edges;
  for (const CGAL::Triple<int, int, int>& t : triangles)
    edges.insert(edges.end(), { { t.first, t.second }, { t.second, t.third }, { t.third, t.first } });
  for (int i = 0; i < n; ++i)
    edges.emplace_back((i + 1) % n, i);              // the other side of the polygon's
  std::sort(edges.begin(), edges.end());
  return triangles.size() == std::size_t(n - 2) && std::adjacent_find(edges.begin(), edges.end()) == edges.end()
         && std::all_of(edges.begin(), edges.end(), [&](const std::pair<int, int>& e) {
              return std::binary_search(edges.begin(), edges.end(), std::make_pair(e.second, e.first));
            });
}

} // namespace

// Not by CGAL's triangulate_faces(), which writes out of bounds where a corner of a face lies on another edge
// or corner of it.
void triangulate(Polygon_soup& soup)
{
  constexpr std::size_t most_corners = 500;          // the time goes with the third power
  std::vector<Polygon_soup::Polygon> result;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    const Polygon_soup::Polygon& polygon = soup.polygons[f];
    if (polygon.size() == 3) {
      result.push_back(polygon);
      continue;
    }
    if (polygon.size() > most_corners)
      throw Input_error{ face_text(f) + " has more than " + std::to_string(most_corners) + " corners", SMP::ERROR_NON_TRIANGULAR_MESH };
    std::vector<Kernel::Point_3> corners;
    for (const std::size_t v : polygon)
      corners.push_back(soup.points[v]);
    std::vector<CGAL::Triple<int, int, int>> triangles;
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
      corners, std::back_inserter(triangles), CGAL::parameters::use_delaunay_triangulation(false).use_2d_constrained_delaunay_triangulation(false));
    if (!is_triangulation(triangles, int(polygon.size())))
      throw Input_error{ face_text(f) + " cannot be triangulated", SMP::ERROR_NON_TRIANGULAR_MESH };
    for (const CGAL::Triple<int, int, int>& t : triangles)
      result.push_back({ polygon[std::size_t(t.first)], polygon[std::size_t(t.second)], polygon[std::size_t(t.third)] });
  }
  soup.polygons = std::move(result);
}
