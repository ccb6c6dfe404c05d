// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_UNFOLDING_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_UNFOLDING_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/unfolding.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Of a triangle, at v.
inline double corner_angle(const Level& level, Index v, Index a, Index b)
{
  const Vector_3 to_a = level.point(a) - level.point(v), to_b = level.point(b) - level.point(v);
  return std::atan2(std::sqrt(CGAL::cross_product(to_a, to_b).squared_length()), to_a * to_b);
}

// Turns from vertex to vertex. Directions are handed on as angles: computed from places, they would have the rounding
// of all places before, which grows from needle to needle.
class Unfolding
{
public:
  Unfolding(const Level& level, Level::Uv& uv)
    : m_level(level), m_uv(uv), m_start(level.number_of_vertices(), no_index), m_direction(level.number_of_vertices())
  {
    m_uv.resize(level.number_of_vertices());
  }

  void run()
  {
    const Index first = 0;
    place(first, Point_2(0, 0), m_level.one_ring(first).front(), 0);
    for (std::size_t i = 0; i < m_placed.size(); ++i)
      place_neighbors(m_placed[i]);
  }

private:
  void place(Index v, const Point_2& p, Index start, double direction)
  {
    m_uv[v] = p;
    m_start[v] = start;
    m_direction[v] = direction;
    m_placed.push_back(v);
  }

  // A neighbor w of v, unless it has a place.
  void place_around(Index v, Index w, double direction)
  {
    if (m_start[w] != no_index)
      return;
    const double distance = std::sqrt(CGAL::squared_distance(m_level.point(v), m_level.point(w)));
    place(w, m_uv[v] + distance * Vector_2(std::cos(direction), std::sin(direction)), v,
          std::remainder(direction + CGAL_PI, 2 * CGAL_PI));
  }

  // Turns around v, to the left, and at the border back.
  void place_neighbors(Index v)
  {
    const Level::Ring ring = m_level.one_ring(v);
    const std::size_t size = ring.size(), start = std::find(ring.begin(), ring.end(), m_start[v]) - ring.begin(),
                      end = m_level.is_border(v) ? size : start + size;
    double direction = m_direction[v];
    place_around(v, ring[start], direction);
    for (std::size_t i = start; i + 1 < end; ++i) {
      const Index a = ring[i % size], b = ring[(i + 1) % size];
      direction += corner_angle(m_level, v, a, b);
      place_around(v, b, direction);
    }
    direction = m_direction[v];
    for (std::size_t i = start; i > 0 && m_level.is_border(v); --i) {
      direction -= corner_angle(m_level, v, ring[i - 1], ring[i]);
      place_around(v, ring[i - 1], direction);
    }
  }

  const Level& m_level;
  Level::Uv& m_uv;
  std::vector<Index> m_start;           // by vertex: the neighbor where the turn begins; none if it has no place
  std::vector<double> m_direction;      // by vertex: to there
  std::vector<Index> m_placed;          // in the order in which they got their places
};

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool unfold(const Level& level, Level::Uv& uv)
{
  Unfolding(level, uv).run();
  return is_map_valid(level.rings(), uv, level.loops());
}

inline double angle_sum(const Level& level, Index v)
{
  const Level::Ring ring = level.one_ring(v);
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += corner_angle(level, v, ring[i], ring[next_in_cycle(i, ring.size())]);
  return sum;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool is_almost_developable(const Level& level)
{
  constexpr double greatest_curvature = 0.1;
  double curvature = 0;
  for (Index v = 0; v < level.number_of_vertices() && curvature <= greatest_curvature; ++v)
    if (!level.is_border(v))
      curvature += std::abs(2 * CGAL_PI - angle_sum(level, v));
  return curvature <= greatest_curvature;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_UNFOLDING_IMPL_H
