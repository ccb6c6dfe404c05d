// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_VERTEX_INSERTER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_VERTEX_INSERTER_H

#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Polygon_kernel_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Star.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The barycentric combination of places that was stored when a vertex was removed.
inline Point_2 stored_place(const std::vector<Point_2>& uv, const Index_triangle& parent,
                            const std::array<double, 3>& coordinates)
{
  const Point_2& kept = uv[parent[0]];
  return kept + coordinates[1] * (uv[parent[1]] - kept) + coordinates[2] * (uv[parent[2]] - kept);
}

// Puts a vertex V back into a map whose neighbors are placed, so that no triangle flips.
//
// Before V came, its star polygon was filled by a fan of positive triangles around W0, so W0 sees all of the polygon,
// and V fits into the kernel of the polygon near W0, if nowhere else. Candidates are
//   (a) the stored_place() (Hormann, Greiner, Campagna 1999, section 3); for an ear the place that makes its one
//       triangle similar to the one in space,
//   (b) the centroid of the kernel,
//   (c) if neither is valid, points that approach W0, from the centroid and from a direction in which the kernel lies;
//       an ear's approach the middle of its base.
// Border vertices come one by one, and the angles at a border neighbor W of V may involve another one, U, that has no
// place yet. W then sees U where it sees the coarse mesh: along the border at U's other border neighbor, across the
// surface at the vertex that U collapsed onto. So there is always room left for U.
//
// What is valid is decided by exact predicates; of several valid ones the one with the least energy (MIPS: it knows no
// scale) is taken.
class Vertex_inserter
{
public:
  // `is_placed` tells of a vertex whether it has its place; one without stands on the vertex that it collapsed onto.
  // Both are kept by reference.
  Vertex_inserter(const One_rings& rings, std::vector<Point_2>& uv, const std::vector<bool>& is_placed)
    : m_rings(rings), m_uv(uv), m_is_placed(is_placed)
  { }

  // Puts the given place into uv[v] if it is valid, and returns whether it is.
  bool insert_at(Index v, const Point_2& place)
  {
    if (!is_finite(place))
      return false;
    const Point_2 before = std::exchange(m_uv[v], place);
    m_inserted = v;
    const bool result = is_star_valid(m_rings, m_uv, *this, v);
    if (!result)
      m_uv[v] = before;
    return result;
  }

  // Puts the best place into uv[v]. Returns whether one was found. `corners` are the rest shapes around v.
  template <class Corners>
  bool insert(Index v, const Corners& corners, const Index_triangle& parent,
              const std::array<double, 3>& coordinates)
  {
    m_star.gather(m_rings, m_uv, v, corners, Triangle_weight::ONE);
    m_inserted = v;
    m_best_energy = (std::numeric_limits<double>::infinity)();

    const bool is_ear = parent[1] == parent[2];
    const Point_2 kept = m_uv[parent[0]];
    const Point_2 first = is_ear ? corners[0].similar_apex(m_uv[m_rings[v].front()], m_uv[m_rings[v].back()])
                                 : stored_place(m_uv, parent, coordinates);
    const Point_2 centroid = kernel_centroid(m_rings, m_uv, v, m_kernel);
    offer(v, first);
    offer(v, centroid);

    constexpr int most_halvings = 45;
    const Point_2 anchor = is_ear ? midpoint(m_uv[m_rings[v].front()], m_uv[m_rings[v].back()]) : kept;
    const Point_2 beside = is_ear ? first : anchor + direction_into_kernel(v, parent[0]);
    double fraction = 0.5;
    for (int i = 0; i < most_halvings && !has_place(); ++i, fraction *= 0.5) {
      offer(v, anchor + fraction * (centroid - anchor));
      offer(v, anchor + fraction * (beside - anchor));
    }
    m_uv[v] = has_place() ? m_best : kept;
    return has_place();
  }

  // Where w lies, seen from its neighbor v.
  const Point_2& operator()(Index w, Index v) const
  {
    if (m_is_placed[w] || w == m_inserted)
      return m_uv[w];
    const One_rings::Ring ring = m_rings[w];
    return m_uv[ring.front() == v ? ring.back() : ring.back() == v ? ring.front() : w];
  }

private:
  bool has_place() const { return m_best_energy < (std::numeric_limits<double>::infinity)(); }

  void offer(Index v, const Point_2& place)
  {
    const double energy = m_star.energy(place);
    if (!(energy < m_best_energy))
      return;
    m_uv[v] = place;
    if (is_star_valid(m_rings, m_uv, *this, v)) {
      m_best = place;
      m_best_energy = energy;
    }
  }

  // A vector from W0 into the kernel: along the bisector of the corner that the fan of W0 filled, as far as the shorter
  // edge there. Where V lies on the border, the two ends of its ring are joined by the coarse border edge, so that the
  // corner is the same; along its bisector neither the angles at W0 grow nor do those at V reach a turn.
  Vector_2 direction_into_kernel(Index v, Index kept) const
  {
    const One_rings::Ring ring = m_rings[v];
    const std::size_t size = ring.size(), slot = std::size_t(std::find(ring.begin(), ring.end(), kept) - ring.begin());
    const Vector_2 next = m_uv[ring[(slot + 1) % size]] - m_uv[kept],
                   previous = m_uv[ring[(slot + size - 1) % size]] - m_uv[kept];
    const double next_length = std::sqrt(next.squared_length()), previous_length = std::sqrt(previous.squared_length());
    const auto left = [](const Vector_2& x) { return Vector_2(-x.y(), x.x()); };
    return (std::min)(next_length, previous_length) * 0.5 *
           (left(next) / next_length - left(previous) / previous_length);
  }

  const One_rings& m_rings;
  std::vector<Point_2>& m_uv;
  const std::vector<bool>& m_is_placed;

  Index m_inserted = no_index;
  Star<MIPS_energy_2> m_star;
  Polygon_kernel_2 m_kernel;
  Point_2 m_best;
  double m_best_energy;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_VERTEX_INSERTER_H
