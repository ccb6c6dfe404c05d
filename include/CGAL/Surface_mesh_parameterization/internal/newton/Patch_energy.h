// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_PATCH_ENERGY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_PATCH_ENERGY_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/corner_hessian.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Unfolding_energy_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The energy of the triangles of a map at some vertices, as a function of the places of these, while all others stay.
class Patch_energy
{
public:
  // `uv` may change between the calls.
  Patch_energy(const One_rings& rings, const std::vector<Point_3>& points, const std::vector<Point_2>& uv)
    : m_rings(rings), m_points(points), m_uv(uv), m_unknown(uv.size(), no_index)
  { }

  // Makes these the vertices that may move.
  void set_vertices(const std::vector<Index>& vertices)
  {
    for (const Index v : m_vertices)
      m_unknown[v] = no_index;
    m_vertices = vertices;
    for (Index i = 0; i < m_vertices.size(); ++i)
      m_unknown[m_vertices[i]] = i;
    collect_triangles();
  }

  const std::vector<Index>& vertices() const { return m_vertices; }

  bool may_move(Index v) const { return m_unknown[v] != no_index; }

  // The position of each vertex of the map among them, `no_index` if it stays.
  const std::vector<Index>& unknowns() const { return m_unknown; }

  double area_of_image() const
  {
    double sum = 0;
    for (const Triangle& t : m_triangles)
      sum += doubled_area(m_uv[t.vertices[0]], m_uv[t.vertices[1]], m_uv[t.vertices[2]]);
    return 0.5 * sum;
  }

  // Scales the triangles in space so that their areas sum up to that area. Returns false if it is not positive and
  // finite.
  bool scale_to(double area_of_image)
  {
    double area = 0;
    for (const Triangle& t : m_triangles)
      area += 1 / t.corners[0].inverse_area;
    const double factor = area / area_of_image;
    if (!(factor > 0 && std::isfinite(factor)))
      return false;
    for (Triangle& t : m_triangles)
      for (Rest_corner& c : t.corners)
        c.inverse_area *= factor;
    return true;
  }

  double least_determinant() const
  {
    double least = (std::numeric_limits<double>::infinity)();
    for (const Triangle& t : m_triangles)
      least = (std::min)(least, t.determinant(m_uv));
    return least;
  }

  // Not finite where a triangle has no value, as a negative one has none if the width is 0.
  double operator()(const Unfolding_energy_2& energy) const
  {
    double sum = 0;
    for (const Triangle& t : m_triangles) {
      const double value = energy.value(t.squared_frobenius_norm(m_uv), t.determinant(m_uv));
      sum += value > 0 ? value : (std::numeric_limits<double>::infinity)();
    }
    return sum;
  }

  double mean_over_triangles(const Unfolding_energy_2& energy) const
  {
    return (*this)(energy) / double(m_triangles.size());
  }

  // Finds the step of Newton's method, x and y of each vertex that may move. Returns by what a small part of the step
  // lowers the energy, relative to that part; 0 if there is no step.
  double find_newton_direction(const Unfolding_energy_2& energy, std::vector<double>& direction) const
  {
    const Index n = Index(2 * m_vertices.size());
    std::vector<Matrix_entry> entries;
    std::vector<double> right_side(n, 0.);
    for (const Triangle& t : m_triangles)
      for (int i = 0; i < 3; ++i)
        if (may_move(t.vertices[i]))
          add_corner(energy, t, i, entries, right_side);
    const std::unique_ptr<Direct_solver> solver = factorize_symmetric(n, entries);
    if (!solver)
      return 0;
    direction.resize(n);
    solver->solve(right_side.data(), direction.data(), 1);
    return std::inner_product(direction.begin(), direction.end(), right_side.begin(), 0.);
  }

private:
  struct Triangle
  {
    std::array<Index, 3> vertices;
    std::array<Rest_corner, 3> corners;

    double determinant(const std::vector<Point_2>& uv) const
    {
      return corners[0].determinant(uv[vertices[0]], uv[vertices[1]], uv[vertices[2]]);
    }

    double squared_frobenius_norm(const std::vector<Point_2>& uv) const
    {
      return corners[0].squared_frobenius_norm(uv[vertices[0]], uv[vertices[1]], uv[vertices[2]]);
    }
  };

  void collect_triangles()
  {
    m_triangles.clear();
    for (const Index v : m_vertices) {
      m_rings.for_each_triangle(v, [&](Index a, Index b, std::size_t) {
        if ((may_move(a) && a < v) || (may_move(b) && b < v))
          return;
        const Point_3 &p = m_points[v], &q = m_points[a], &r = m_points[b];
        m_triangles.push_back({ { v, a, b }, { rest_corner(p, q, r), rest_corner(q, r, p), rest_corner(r, p, q) } });
      });
    }
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
      if (!may_move(w))
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
  const std::vector<Point_2>& m_uv;
  std::vector<Index> m_vertices;            // those that may move
  std::vector<Index> m_unknown;             // see unknowns()
  std::vector<Triangle> m_triangles;        // with a vertex that may move
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_PATCH_ENERGY_H
