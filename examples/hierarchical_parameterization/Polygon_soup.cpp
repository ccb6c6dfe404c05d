// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks points and polygons one by one.

#include "Polygon_soup.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

// A negative index of a file is a huge one here; it is told as it was.
void check_indices(const Polygon_soup& soup)
{
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    for (const std::size_t v : soup.polygons[f])
      if (v >= soup.points.size())
        throw Input_error{ face_text(f) + " refers to vertex " + std::to_string(static_cast<long long>(v)) +
                           "; there are " + std::to_string(soup.points.size()) + ", counted from 0" };
}

void check_coordinates(const Polygon_soup& soup)
{
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(soup.points[v][i]))
        throw Input_error{ vertex_text(v) + " has a coordinate that is not a finite number",
                           SMP::ERROR_WRONG_PARAMETER };
}

void check_corners(const Polygon_soup& soup, bool may_have_polygons, bool may_have_collapsed_triangles)
{
  Polygon_soup::Polygon sorted;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    sorted = soup.polygons[f];
    if (sorted.size() < 3 || (sorted.size() > 3 && !may_have_polygons))
      throw Input_error{ face_text(f) + " has " + std::to_string(sorted.size()) + " corners instead of three" +
                             (sorted.size() < 3 || sorted.size() > most_corners_to_triangulate
                                  ? ""
                                  : "; --triangulate cuts such faces into triangles"),
                         SMP::ERROR_NON_TRIANGULAR_MESH };
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end() && !(sorted.size() == 3 && may_have_collapsed_triangles))
      throw Input_error{ face_text(f) + " has " + vertex_text(*twice) + " twice" +
                             (sorted.size() == 3 ? "; --orient leaves such triangles out" : ""),
                         SMP::ERROR_NO_TOPOLOGICAL_DISC };
  }
}

std::size_t remove_collapsed_triangles(Polygon_soup& soup)
{
  const auto is_collapsed = [](const Polygon_soup::Polygon& p) {
    return p.size() == 3 && (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]);
  };
  const auto end = std::remove_if(soup.polygons.begin(), soup.polygons.end(), is_collapsed);
  const std::size_t number = std::size_t(soup.polygons.end() - end);
  soup.polygons.erase(end, soup.polygons.end());
  return number;
}
