// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_PATCH_UNFOLDER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_PATCH_UNFOLDER_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/corner_hessian.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Unfolding_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

struct Patch_unfolder_options
{
  int most_steps = 25, most_steps_of_valid_map = 10, most_halvings = 20;
  double sufficient_decrease = 1e-4;      // of the energy, relative to what the slope promises
  double least_decrease = 0.01;           // relative, of a step from a valid map that is worth another one
  // The width of the energy: relative to the least determinant, where that is negative, and at least. Where the energy
  // is at its minimum, and the map is not valid, a smaller width follows.
  double relative_width = 0.2, least_width = 1e-6, decrease_of_width = 0.1;
};

// Gives valid places to some vertices of a map, while all others stay where they are: first each in the middle of its
// neighbors, as in Tutte's embedding, and where that is not enough, by Newton's method for an energy that unfolds
// triangles; at the end it lowers the MIPS energy.
class Patch_unfolder
{
public:
  Patch_unfolder(const One_rings& rings, const std::vector<Point_3>& points, std::vector<Point_2>& uv,
                 const Patch_unfolder_options& options = Patch_unfolder_options())
    : m_rings(rings), m_points(points), m_uv(uv), m_options(options), m_unknown(uv.size(), no_index)
  { }

  // Returns false, with all vertices where they were, if it finds no valid places for some `vertices`. These are few: a
  // factorization for each step takes time and memory.
  bool run(const std::vector<Index>& vertices)
  {
    m_vertices = vertices;
    for (Index i = 0; i < m_vertices.size(); ++i)
      m_unknown[m_vertices[i]] = i;
    const std::vector<Point_2> before = places();
    collect_triangles();
    const double area_before = area_of_image();
    const bool is_valid = place_in_the_middle() && scale_to(area_before) && unfold();
    if (is_valid)
      lower_energy();
    else
      set_places(before);
    for (const Index v : m_vertices)
      m_unknown[v] = no_index;
    return is_valid;
  }

private:
  struct Triangle
  {
    std::array<Index, 3> vertices;
    std::array<Rest_corner, 3> corners;     // scaled so that the sum of all areas is that of the image

    double determinant(const std::vector<Point_2>& uv) const
    {
      const auto& [v, a, b] = vertices;
      return 0.5 * corners[0].inverse_area * cross(uv[a] - uv[v], uv[b] - uv[v]);
    }

    double frobenius(const std::vector<Point_2>& uv) const
    {
      const auto& [v, a, b] = vertices;
      const Rest_corner& c = corners[0];
      const Vector_2 ab = uv[b] - uv[a], from_foot = (uv[v] - uv[a]) - c.foot * ab;
      return 0.5 * c.inverse_area * (from_foot.squared_length() / c.height + c.height * ab.squared_length());
    }
  };

  bool is_unknown(Index v) const { return m_unknown[v] != no_index; }

  std::vector<Point_2> places() const
  {
    std::vector<Point_2> result;
    result.reserve(m_vertices.size());
    for (const Index v : m_vertices)
      result.push_back(m_uv[v]);
    return result;
  }

  void set_places(const std::vector<Point_2>& places)
  {
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      m_uv[m_vertices[i]] = places[i];
  }

  void collect_triangles()
  {
    m_triangles.clear();
    for (const Index v : m_vertices) {
      const One_rings::Ring ring = m_rings[v];
      for (std::size_t i = 0; i < m_rings.number_of_triangles(v); ++i) {
        const Index a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
        if ((is_unknown(a) && a < v) || (is_unknown(b) && b < v))
          continue;
        const Point_3 &p = m_points[v], &q = m_points[a], &r = m_points[b];
        m_triangles.push_back({ { v, a, b }, { rest_corner(p, q, r), rest_corner(q, r, p), rest_corner(r, p, q) } });
      }
    }
  }

  double area_of_image() const
  {
    double doubled_area = 0;
    for (const Triangle& t : m_triangles)
      doubled_area += cross(m_uv[t.vertices[1]] - m_uv[t.vertices[0]], m_uv[t.vertices[2]] - m_uv[t.vertices[0]]);
    return 0.5 * doubled_area;
  }

  // Scales the triangles in space by the area of the image. If no border is free, that depends on what stays only; else
  // it is too small for vertices in the middle of their neighbors, so the one before is taken if it can be. Returns
  // false if it is not positive: then there are no valid places.
  bool scale_to(double area_before)
  {
    const bool is_border_free =
        std::any_of(m_vertices.begin(), m_vertices.end(), [this](Index v) { return m_rings.is_border(v); });
    double area = 0;
    for (const Triangle& t : m_triangles)
      area += 1 / t.corners[0].inverse_area;
    double factor = is_border_free ? area / area_before : 0;
    if (!(factor > 0 && std::isfinite(factor)))
      factor = area / area_of_image();
    for (Triangle& t : m_triangles)
      for (Rest_corner& c : t.corners)
        c.inverse_area *= factor;
    return factor > 0 && std::isfinite(factor);
  }

  // Returns false if no vertex stays, or where doubles end.
  bool place_in_the_middle()
  {
    const Index n = Index(m_vertices.size());
    std::vector<Matrix_entry> entries;
    std::vector<double> right_sides(2 * n, 0.), solutions(2 * n);
    bool does_any_stay = false;
    for (Index i = 0; i < n; ++i) {
      const One_rings::Ring ring = m_rings[m_vertices[i]];
      entries.push_back({ i, i, double(ring.size()) });
      for (const Index w : ring)
        if (is_unknown(w))
          entries.push_back({ i, m_unknown[w], -1 });
        else {
          does_any_stay = true;
          right_sides[i] += m_uv[w].x();
          right_sides[n + i] += m_uv[w].y();
        }
    }
    const std::unique_ptr<Direct_solver> solver = does_any_stay ? factorize_symmetric(n, entries) : nullptr;
    if (!solver)
      return false;
    solver->solve(right_sides.data(), solutions.data(), 2);
    for (Index i = 0; i < n; ++i)
      m_uv[m_vertices[i]] = Point_2(solutions[i], solutions[n + i]);
    return std::all_of(solutions.begin(), solutions.end(), [](double x) { return std::isfinite(x); });
  }

  // Returns whether the map is valid at the end.
  bool unfold()
  {
    double width = (std::numeric_limits<double>::infinity)();
    for (int i = 0; i < m_options.most_steps; ++i) {
      const double least = least_determinant();
      if (least > 0 && is_valid())
        return true;
      width = (std::min)(width, (std::max)(-m_options.relative_width * least, m_options.least_width));
      if (step(Unfolding_energy_2(width)))
        continue;
      if (width <= m_options.decrease_of_width * m_options.least_width)
        return false;
      width *= m_options.decrease_of_width;
    }
    return is_valid();
  }

  // Precondition: the map is valid, and stays so.
  void lower_energy()
  {
    const Unfolding_energy_2 energy(0);
    for (int i = 0; i < m_options.most_steps_of_valid_map; ++i) {
      const std::vector<Point_2> before = places();
      const double energy_before = energy_of(energy);
      if (!step(energy))
        return;
      if (!is_valid()) {
        set_places(before);
        return;
      }
      if (!(energy_of(energy) < (1 - m_options.least_decrease) * energy_before))
        return;
    }
  }

  bool is_valid() const
  {
    return std::all_of(m_vertices.begin(), m_vertices.end(), [this](Index v) {
      return is_fan_valid(m_rings, m_uv, v) && std::all_of(m_rings[v].begin(), m_rings[v].end(), [this](Index w) {
               return is_unknown(w) || !turns_too_far(m_rings, Place_of_vertex{ m_uv }, w);
             });
    });
  }

  double least_determinant() const
  {
    double least = (std::numeric_limits<double>::infinity)();
    for (const Triangle& t : m_triangles)
      least = (std::min)(least, t.determinant(m_uv));
    return least;
  }

  // Not finite where a triangle has no value, as a negative one has none if the width is 0.
  double energy_of(const Unfolding_energy_2& energy) const
  {
    double sum = 0;
    for (const Triangle& t : m_triangles) {
      const double value = energy.value(t.frobenius(m_uv), t.determinant(m_uv));
      sum += value > 0 ? value : (std::numeric_limits<double>::infinity)();
    }
    return sum;
  }

  // A step of Newton's method, shortened until it lowers the energy. Returns whether there is one.
  bool step(const Unfolding_energy_2& energy)
  {
    constexpr double least_relative_slope = 1e-12;
    std::vector<double> direction;
    const double slope = find_direction(energy, direction), start_energy = energy_of(energy);
    if (!(slope > least_relative_slope * start_energy))
      return false;
    const std::vector<Point_2> start = places();
    double length = 1;
    for (int i = 0; i < m_options.most_halvings; ++i, length *= 0.5) {
      for (std::size_t k = 0; k < m_vertices.size(); ++k)
        m_uv[m_vertices[k]] = start[k] + length * Vector_2(direction[2 * k], direction[2 * k + 1]);
      if (energy_of(energy) < start_energy - m_options.sufficient_decrease * length * slope)
        return true;
    }
    set_places(start);
    return false;
  }

  // Returns by what a short step in this direction lowers the energy, relative to the step; 0 if there is none.
  double find_direction(const Unfolding_energy_2& energy, std::vector<double>& direction) const
  {
    const Index n = Index(2 * m_vertices.size());
    std::vector<Matrix_entry> entries;
    std::vector<double> right_side(n, 0.);
    for (const Triangle& t : m_triangles)
      for (int i = 0; i < 3; ++i)
        if (is_unknown(t.vertices[i]))
          add_corner(energy, t, i, entries, right_side);
    const std::unique_ptr<Direct_solver> solver = factorize_symmetric(n, entries);
    if (!solver)
      return 0;
    direction.resize(n);
    solver->solve(right_side.data(), direction.data(), 1);
    return std::inner_product(direction.begin(), direction.end(), right_side.begin(), 0.);
  }

  void add_corner(const Unfolding_energy_2& energy, const Triangle& t, int i, std::vector<Matrix_entry>& entries,
                  std::vector<double>& right_side) const
  {
    const Index v = t.vertices[i], a = t.vertices[(i + 1) % 3], b = t.vertices[(i + 2) % 3];
    const Corner_hessian h = corner_hessian(energy, t.corners[i], 1, m_uv[a] - m_uv[v], m_uv[b] - m_uv[v]);
    const Index row = 2 * m_unknown[v];
    right_side[row] -= h.gradient.x;
    right_side[row + 1] -= h.gradient.y;
    const auto add = [&](Index w, double factor, const Block& block) {
      if (!is_unknown(w))
        return;
      const Index column = 2 * m_unknown[w];
      entries.push_back({ row, column, factor * block.xx() });
      entries.push_back({ row, column + 1, factor * block.xy() });
      entries.push_back({ row + 1, column, factor * block.yx() });
      entries.push_back({ row + 1, column + 1, factor * block.yy() });
    };
    add(v, 1, h.to_v);
    add(b, 1, h.to_b);
    add(a, -1, h.to_v + h.to_b);
  }

  const One_rings& m_rings;
  const std::vector<Point_3>& m_points;
  std::vector<Point_2>& m_uv;
  Patch_unfolder_options m_options;
  std::vector<Index> m_vertices;            // those that may move
  std::vector<Index> m_unknown;             // the place of each vertex among them, no_index if it stays
  std::vector<Triangle> m_triangles;        // with a vertex that may move
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_PATCH_UNFOLDER_H
