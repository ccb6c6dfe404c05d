// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_TUTTE_EMBEDDING_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_TUTTE_EMBEDDING_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/place_in_the_middle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

inline double space_edge_length(const Level& level, Index a, Index b)
{
  return std::sqrt(CGAL::squared_distance(level.point(a), level.point(b)));
}

inline double space_border_length(const Level& level, const std::vector<Index>& border)
{
  double length = 0;
  for (std::size_t i = 0; i < border.size(); ++i)
    length += space_edge_length(level, border[i], border[next_in_cycle(i, border.size())]);
  return length;
}

// An edge that is much shorter than the others, or has no length at all, is taken for a longer one: the polygon must be
// strictly convex.
inline void place_on_circle(const Level& level, const std::vector<Index>& border, Level::Uv& uv)
{
  constexpr double shortest_edge = 0.1;      // of the mean one
  const double mean = space_border_length(level, border) / double(border.size()),
               shortest = mean > 0 ? shortest_edge * mean : 1;
  std::vector<double> arc(1, 0.);
  for (std::size_t i = 0; i < border.size(); ++i)
    arc.push_back(arc.back() +
                  (std::max)(shortest, space_edge_length(level, border[i], border[next_in_cycle(i, border.size())])));
  for (std::size_t i = 0; i < border.size(); ++i) {
    const double angle = 2 * CGAL_PI * arc[i] / arc.back();
    uv[border[i]] = Point_2(std::cos(angle), std::sin(angle));
  }
}

// Returns whether places are given for all of the border.
inline bool place_as_given(const Level& level, const std::vector<Index>& border, Level::Uv& uv)
{
  std::vector<bool> is_fixed(uv.size(), false);
  for (const Index v : fixed_vertices(level)) {
    is_fixed[v] = true;
    uv[v] = level.fixed_place(v);
  }
  return std::all_of(border.begin(), border.end(), [&](Index v) { return is_fixed[v]; });
}

// Calls `place_border(border, uv)`, which returns whether it could place the outer border.
template <class Function>
Error_code compute_Tutte_embedding(const Level& level, const Function& place_border, Level::Uv& uv)
{
  std::vector<std::vector<Index>> borders = level.rings().borders();
  const auto outer = std::find_if(borders.begin(), borders.end(), [&](const std::vector<Index>& border) {
    return level.hierarchy().is_on_outer_border(border.front());
  });
  if (outer == borders.end())
    return ERROR_NO_TOPOLOGICAL_DISC;
  std::swap(borders.front(), *outer);
  const std::vector<Index> border = std::move(borders.front());
  borders.erase(borders.begin());
  uv.assign(level.number_of_vertices(), Point_2(0, 0));
  if (!place_border(border, uv))
    return ERROR_NO_1_TO_1_MAPPING;

  std::vector<Index> unknown(uv.size(), 0), vertices;
  for (const Index v : border)
    unknown[v] = no_index;
  for (Index v = 0; v < uv.size(); ++v)
    if (unknown[v] != no_index) {
      unknown[v] = Index(vertices.size());
      vertices.push_back(v);
    }
  if (!vertices.empty() && !place_in_the_middle(level.rings(), vertices, unknown, borders, uv))
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  return is_map_valid(level.rings(), uv, level.loops()) ? OK : ERROR_NO_1_TO_1_MAPPING;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code compute_Tutte_embedding(const Level& level, Level::Uv& uv)
{
  const auto on_circle = [&](const std::vector<Index>& border, Level::Uv& map) {
    place_on_circle(level, border, map);
    return true;
  };
  return compute_Tutte_embedding(level, on_circle, uv);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code compute_Tutte_embedding_at_places(const Level& level, Level::Uv& uv)
{
  const auto as_given = [&](const std::vector<Index>& border, Level::Uv& map) {
    return place_as_given(level, border, map);
  };
  return compute_Tutte_embedding(level, as_given, uv);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_TUTTE_EMBEDDING_IMPL_H
