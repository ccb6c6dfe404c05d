// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Star.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL::Surface_mesh_parameterization::internal {

// The weighted sum of the energies of a level's triangles, as a function of the map.
template <class Energy_>
class Level_energy
{
public:
  typedef Energy_   Energy;

  Level_energy(const Level& level, Triangle_weight weight, const Energy& energy = Energy()) : m_level(level), m_weight(weight), m_energy(energy) { }

  const Level& level() const { return m_level; }

  // What the triangle of a corner contributes, less its weight.
  Energy triangle_energy(const Rest_corner& c) const { return m_energy.of_area(1 / c.inverse_area); }

  double weight(const Rest_corner& c) const { return m_weight == Triangle_weight::AREA ? 1 / c.inverse_area : 1; }

  void gather(Index v, const Level::Uv& uv, Star<Energy>& star) const { star.gather(m_level.rings(), uv, v, m_level.rest_corners(v), m_weight, m_energy); }

  // The sum of f(v, a, b, corner) over the triangles vab, where f reads `uv` at their vertices.
  template <class Function>
  double sum(const Level::Uv& uv, const Function& f) const
  {
    return m_level.loops().sum(0, number_of_vertices(), 0., [&](Index v) {
      m_level.rings().prefetch_neighbors_after(v, uv);
      double sum = 0;
      for_each_triangle(v, [&](Index a, Index b, const Rest_corner& c) { sum += f(v, a, b, c); });
      return sum;
    });
  }

  // The least f(v, a, b, corner) over the triangles vab, infinity if there is none; likewise.
  template <class Function>
  double min(const Level::Uv& uv, const Function& f) const
  {
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    return m_level.loops().min(0, number_of_vertices(), infinity, [&](Index v) {
      m_level.rings().prefetch_neighbors_after(v, uv);
      double least = infinity;
      for_each_triangle(v, [&](Index a, Index b, const Rest_corner& c) { least = (std::min)(least, f(v, a, b, c)); });
      return least;
    });
  }

  // Infinite if a triangle is not positive and the energy keeps them so.
  double operator()(const Level::Uv& uv) const
  {
    return sum(uv, [&](Index v, Index a, Index b, const Rest_corner& c) {
      const Vector_2 ab = uv[b] - uv[a], x = uv[v] - uv[a], from_foot = x - c.foot * ab;
      const double doubled_area = cross(ab, x), scale = 0.5 * c.inverse_area;
      return Energy::is_flip_free && !(doubled_area > 0) ? (std::numeric_limits<double>::infinity)() :
             weight(c) * triangle_energy(c).value(scale * (from_foot.squared_length() / c.height + c.height * ab.squared_length()), scale * doubled_area);
    });
  }

  double total_weight() const
  {
    return m_level.loops().sum(0, number_of_vertices(), 0., [&](Index v) {
      double sum = 0;
      for_each_triangle(v, [&](Index, Index, const Rest_corner& c) { sum += weight(c); });
      return sum;
    });
  }

  // What energies are reported in: the sum, or the mean over the area if triangles are weighted by it.
  double unit() const { return m_weight == Triangle_weight::AREA ? total_weight() : 1; }

private:
  Index number_of_vertices() const { return Index(m_level.number_of_vertices()); }

  // The triangles of which v is the least vertex.
  template <class Function>
  void for_each_triangle(Index v, const Function& f) const
  {
    const Level::Ring ring = m_level.one_ring(v);
    const Rest_corner* const c = m_level.rest_corners(v);
    for (std::size_t i = 0; i < m_level.rings().number_of_triangles(v); ++i) {
      const Index a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      if (v < a && v < b)
        f(a, b, c[i]);
    }
  }

  const Level& m_level;
  Triangle_weight m_weight;
  Energy m_energy;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_H
