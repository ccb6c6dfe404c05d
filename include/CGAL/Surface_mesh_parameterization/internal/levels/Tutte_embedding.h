// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_TUTTE_EMBEDDING_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_TUTTE_EMBEDDING_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <CGAL/number_utils.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The first map of a level: its outer border goes onto a circle, at distances in proportion to the edges in space, every other vertex to the mean
// of its neighbors (Tutte 1963). Each further border is closed by a virtual vertex in its middle. In exact arithmetic the map has no flip;
// whether it has in doubles is tested.
class Tutte_embedding
{
public:
  // Returns `OK`, `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`, or `ERROR_NO_1_TO_1_MAPPING` if a triangle is not positive; `uv` is meaningful only with `OK`.
  static Error_code compute(const Level& level, Level::Uv& uv)
  {
    std::vector<std::vector<Index>> borders = find_borders(level);
    const auto outer = std::find_if(borders.begin(), borders.end(), [&](const std::vector<Index>& border)
                                    { return level.hierarchy().is_on_outer_border(border.front()); });
    std::swap(borders.front(), *outer);

    uv.assign(level.number_of_vertices(), Point_2(0, 0));
    place_on_circle(level, borders.front(), uv);
    const Error_code status = solve(level, borders, uv);
    if (status != OK)
      return status;
    return is_map_valid(level.rings(), uv) ? OK : ERROR_NO_1_TO_1_MAPPING;
  }

private:
  // Every border as a cycle of vertices, with the surface to its left.
  static std::vector<std::vector<Index>> find_borders(const Level& level)
  {
    std::vector<std::vector<Index>> borders;
    std::vector<bool> is_found(level.number_of_vertices(), false);
    for (Index start = 0; start < level.number_of_vertices(); ++start)
      if (level.is_border(start) && !is_found[start]) {
        borders.emplace_back();
        for (Index v = start; !is_found[v]; v = level.one_ring(v).front()) {
          is_found[v] = true;
          borders.back().push_back(v);
        }
      }
    return borders;
  }

  static double edge_length(const Level& level, Index a, Index b) { return std::sqrt(CGAL::squared_distance(level.point(a), level.point(b))); }

  static double border_length(const Level& level, const std::vector<Index>& border)
  {
    double length = 0;
    for (std::size_t i = 0; i < border.size(); ++i)
      length += edge_length(level, border[i], border[(i + 1) % border.size()]);
    return length;
  }

  // An edge that is much shorter than the others, or has no length at all, is taken for a longer one: the polygon must be strictly convex.
  static void place_on_circle(const Level& level, const std::vector<Index>& border, Level::Uv& uv)
  {
    const double mean = border_length(level, border) / double(border.size()), shortest = mean > 0 ? 0.1 * mean : 1;
    std::vector<double> arc(1, 0.);
    for (std::size_t i = 0; i < border.size(); ++i)
      arc.push_back(arc.back() + (std::max)(shortest, edge_length(level, border[i], border[(i + 1) % border.size()])));
    for (std::size_t i = 0; i < border.size(); ++i) {
      const double angle = 2 * CGAL_PI * arc[i] / arc.back();
      uv[border[i]] = Point_2(std::cos(angle), std::sin(angle));
    }
  }

  // Solves the graph Laplacian of all vertices but those of borders[0], with one more vertex for every other border.
  static Error_code solve(const Level& level, const std::vector<std::vector<Index>>& borders, Level::Uv& uv)
  {
    const std::size_t n = level.number_of_vertices();
    std::vector<Index> unknown(n, 0);
    for (Index v : borders.front())
      unknown[v] = no_index;
    Index number_of_unknowns = 0;
    for (Index& u : unknown)
      u = u == no_index ? no_index : number_of_unknowns++;
    const Index first_virtual = number_of_unknowns;
    number_of_unknowns += Index(borders.size() - 1);
    if (number_of_unknowns == 0)
      return OK;

    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> diagonal(number_of_unknowns, 0.);
    Eigen::MatrixX2d right_side = Eigen::MatrixX2d::Zero(number_of_unknowns, 2);
    for (Index v = 0; v < n; ++v) {
      if (unknown[v] == no_index)
        continue;
      for (Index w : level.one_ring(v)) {
        diagonal[unknown[v]] += 1;
        if (unknown[w] == no_index)
          right_side.row(unknown[v]) += Eigen::RowVector2d(uv[w].x(), uv[w].y());
        else
          entries.emplace_back(unknown[v], unknown[w], -1.);
      }
    }
    for (std::size_t b = 1; b < borders.size(); ++b)
      for (Index v : borders[b]) {
        const Index middle = first_virtual + Index(b - 1);
        diagonal[middle] += 1;
        diagonal[unknown[v]] += 1;
        entries.emplace_back(middle, unknown[v], -1.);
        entries.emplace_back(unknown[v], middle, -1.);
      }
    for (Index u = 0; u < number_of_unknowns; ++u)
      entries.emplace_back(u, u, diagonal[u]);

    Eigen::SparseMatrix<double> matrix(number_of_unknowns, number_of_unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success)
      return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    const Eigen::MatrixX2d solution = solver.solve(right_side);
    for (Index v = 0; v < n; ++v)
      if (unknown[v] != no_index)
        uv[v] = Point_2(solution(unknown[v], 0), solution(unknown[v], 1));
    return OK;
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_TUTTE_EMBEDDING_H
