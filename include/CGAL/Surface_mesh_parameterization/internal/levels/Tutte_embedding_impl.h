// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_TUTTE_EMBEDDING_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_TUTTE_EMBEDDING_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
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
    length += space_edge_length(level, border[i], border[(i + 1) % border.size()]);
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
                  (std::max)(shortest, space_edge_length(level, border[i], border[(i + 1) % border.size()])));
  for (std::size_t i = 0; i < border.size(); ++i) {
    const double angle = 2 * CGAL_PI * arc[i] / arc.back();
    uv[border[i]] = Point_2(std::cos(angle), std::sin(angle));
  }
}


// Solves the graph Laplacian of all vertices but those of borders[0], with one more vertex for every other border.
inline Error_code solve_graph_Laplacian(const Level& level, const std::vector<std::vector<Index>>& borders,
                                        Level::Uv& uv)
{
  const Index n = Index(level.number_of_vertices());
  std::vector<Index> unknown(n, 0);
  for (const Index v : borders.front())
    unknown[v] = no_index;
  Index number_of_unknowns = 0;
  for (Index& u : unknown)
    u = u == no_index ? no_index : number_of_unknowns++;
  const Index first_virtual = number_of_unknowns;
  number_of_unknowns += Index(borders.size() - 1);
  if (number_of_unknowns == 0)
    return OK;

  std::vector<Matrix_entry> entries;
  std::vector<double> diagonal(number_of_unknowns, 0.), right_sides(2 * std::size_t(number_of_unknowns), 0.),
      solutions(right_sides.size());
  double *const x = right_sides.data(), *const y = x + number_of_unknowns;
  const auto join = [&](Index u, Index w) {
    diagonal[u] += 1;
    entries.push_back({ u, w, -1 });
  };
  for (Index v = 0; v < n; ++v)
    for (const Index w : level.one_ring(v))
      if (const Index u = unknown[v]; u != no_index && unknown[w] != no_index)
        join(u, unknown[w]);
      else if (u != no_index) {
        diagonal[u] += 1;
        x[u] += uv[w].x();
        y[u] += uv[w].y();
      }
  for (std::size_t b = 1; b < borders.size(); ++b)
    for (const Index v : borders[b]) {
      join(first_virtual + Index(b - 1), unknown[v]);
      join(unknown[v], first_virtual + Index(b - 1));
    }
  for (Index u = 0; u < number_of_unknowns; ++u)
    entries.push_back({ u, u, diagonal[u] });

  const std::unique_ptr<Direct_solver> solver = factorize_symmetric(number_of_unknowns, entries);
  if (!solver)
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  solver->solve(right_sides.data(), solutions.data(), 2);
  for (Index v = 0; v < n; ++v)
    if (unknown[v] != no_index)
      uv[v] = Point_2(solutions[unknown[v]], solutions[number_of_unknowns + unknown[v]]);
  return OK;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code compute_Tutte_embedding(const Level& level, Level::Uv& uv)
{
  std::vector<std::vector<Index>> borders = level.rings().borders();
  const auto outer = std::find_if(borders.begin(), borders.end(), [&](const std::vector<Index>& border) {
    return level.hierarchy().is_on_outer_border(border.front());
  });
  std::swap(borders.front(), *outer);
  uv.assign(level.number_of_vertices(), Point_2(0, 0));
  place_on_circle(level, borders.front(), uv);
  const Error_code status = solve_graph_Laplacian(level, borders, uv);
  if (status != OK)
    return status;
  return is_map_valid(level.rings(), uv) ? OK : ERROR_NO_1_TO_1_MAPPING;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_TUTTE_EMBEDDING_IMPL_H
