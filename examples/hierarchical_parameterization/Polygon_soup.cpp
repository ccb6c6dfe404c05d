// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks points and polygons one by one, and mends what is wrong with them.

#include "Polygon_soup.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

// A negative index of a file is a huge one here; it is told as it was.
void check_indices(const Polygon_soup& soup, std::size_t first_vertex)
{
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    for (const std::size_t v : soup.polygons[f])
      if (v >= soup.points.size())
        throw Input_error{ face_text(f) + " refers to vertex " +
                           std::to_string(static_cast<long long>(v + first_vertex)) + "; there are " +
                           std::to_string(soup.points.size()) + ", counted from " + std::to_string(first_vertex) };
}

void check_coordinates(const Polygon_soup& soup)
{
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(soup.points[v][i]))
        throw Input_error{ vertex_text(v) + " has a coordinate that is not a finite number",
                           SMP::ERROR_WRONG_PARAMETER };
}

namespace {

Polygon_soup::Polygon without_repeated_corners(Polygon_soup::Polygon polygon)
{
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while (polygon.size() > 1 && polygon.back() == polygon.front())
    polygon.pop_back();
  return polygon;
}

bool has_vertex_twice(Polygon_soup::Polygon polygon, std::size_t& vertex)
{
  std::sort(polygon.begin(), polygon.end());
  const auto twice = std::adjacent_find(polygon.begin(), polygon.end());
  if (twice == polygon.end())
    return false;
  vertex = *twice;
  return true;
}

} // namespace

void check_corners(const Polygon_soup& soup, bool may_have_polygons, bool may_have_collapsed_faces)
{
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    const Polygon_soup::Polygon& polygon = soup.polygons[f];
    const bool is_collapsed = polygon.size() < 3;
    if (is_collapsed ? !may_have_collapsed_faces : polygon.size() > 3 && !may_have_polygons)
      throw Input_error{ face_text(f) + " has " + std::to_string(polygon.size()) + " corners instead of three" +
                             (is_collapsed ? "; --orient leaves such faces out"
                                           : "; --triangulate cuts such faces into triangles"),
                         SMP::ERROR_NON_TRIANGULAR_MESH };
    std::size_t vertex;
    if (has_vertex_twice(polygon, vertex))
      throw Input_error{ face_text(f) + " has " + vertex_text(vertex) + " twice" +
                             (has_vertex_twice(without_repeated_corners(polygon), vertex)
                                  ? ""
                                  : "; --orient leaves such corners out"),
                         SMP::ERROR_NO_TOPOLOGICAL_DISC };
  }
}

void merge_points(Polygon_soup& soup)
{
  std::vector<Polygon_soup::Point> merged;
  std::vector<std::size_t> image;
  std::map<Polygon_soup::Point, std::size_t> index_of;
  for (const Polygon_soup::Point& p : soup.points) {
    const auto [found, is_new] = index_of.emplace(p, merged.size());
    if (is_new)
      merged.push_back(p);
    image.push_back(found->second);
  }
  for (Polygon_soup::Polygon& polygon : soup.polygons)
    for (std::size_t& v : polygon)
      v = image[v];
  soup.points = std::move(merged);
}

void remove_repeated_corners(Polygon_soup& soup)
{
  for (Polygon_soup::Polygon& polygon : soup.polygons)
    polygon = without_repeated_corners(polygon);
}

std::size_t remove_collapsed_faces(Polygon_soup& soup)
{
  const auto is_collapsed = [](const Polygon_soup::Polygon& polygon) { return polygon.size() < 3; };
  const auto end = std::remove_if(soup.polygons.begin(), soup.polygons.end(), is_collapsed);
  const std::size_t number = std::size_t(soup.polygons.end() - end);
  soup.polygons.erase(end, soup.polygons.end());
  return number;
}
