// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_UNFOLDING_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_UNFOLDING_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/unfolding.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The vertices that have a place, in the order in which they got it.
class Unfolding
{
public:
  Unfolding(const Level& level, Level::Uv& uv) : m_level(level), m_uv(uv), m_has_place(level.number_of_vertices(), 0)
  {
    m_uv.resize(level.number_of_vertices());
  }

  void run()
  {
    const Index first = 0, second = m_level.one_ring(first).front();
    place(first, Point_2(0, 0));
    place(second, Point_2(std::sqrt(CGAL::squared_distance(m_level.point(first), m_level.point(second))), 0));
    for (std::size_t i = 0; i < m_placed.size(); ++i)
      place_neighbors(m_placed[i]);
  }

private:
  void place(Index v, const Point_2& p)
  {
    m_uv[v] = p;
    m_has_place[v] = 1;
    m_placed.push_back(v);
  }

  // Of a vertex that has a place, as one of its neighbors has: turns around it, to the left, and at the border back.
  void place_neighbors(Index v)
  {
    const Level::Ring ring = m_level.one_ring(v);
    const std::size_t size = ring.size();
    std::size_t start = 0;
    while (!m_has_place[ring[start]])
      ++start;
    const std::size_t end = m_level.is_border(v) ? size : start + size;
    for (std::size_t i = start; i + 1 < end; ++i)
      if (const Index b = ring[(i + 1) % size]; !m_has_place[b])
        place_apex(b, v, ring[i % size]);
    for (std::size_t i = start; i > 0 && m_level.is_border(v); --i)
      place_apex(ring[i - 1], ring[i], v);
  }

  // In the triangle (v, a, b).
  void place_apex(Index v, Index a, Index b)
  {
    place(v, rest_corner(m_level.point(v), m_level.point(a), m_level.point(b)).similar_apex(m_uv[a], m_uv[b]));
  }

  const Level& m_level;
  Level::Uv& m_uv;
  std::vector<unsigned char> m_has_place;
  std::vector<Index> m_placed;
};

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool unfold(const Level& level, Level::Uv& uv)
{
  Unfolding(level, uv).run();
  return is_map_valid(level.rings(), uv);
}

inline double angle_sum(const Level& level, Index v)
{
  const Level::Ring ring = level.one_ring(v);
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector_3 to_a = level.point(ring[i]) - level.point(v),
                   to_b = level.point(ring[next_in_cycle(i, ring.size())]) - level.point(v);
    sum += std::atan2(std::sqrt(CGAL::cross_product(to_a, to_b).squared_length()), to_a * to_b);
  }
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
