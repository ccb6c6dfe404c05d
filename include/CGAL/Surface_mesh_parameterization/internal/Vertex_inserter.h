// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VERTEX_INSERTER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VERTEX_INSERTER_H

#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/Star.h>
#include <CGAL/Surface_mesh_parameterization/internal/Polygon_kernel_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/star_validity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Puts a vertex V back into a map whose neighbors are placed, so that no triangle flips.
//
// Before V came, its star polygon was filled by a fan of positive triangles around W0, so W0 sees all of the polygon, and V fits
// into the kernel of the polygon near W0, if nowhere else. Candidates are
//   (a) the barycentric combination that was stored when V was removed (Hormann, Greiner, Campagna 1999, section 3); for an
//       ear the place that makes its one triangle similar to the one in space,
//   (b) the centroid of the kernel,
//   (c) if neither is valid, points that approach W0 from the centroid or from the middle of the corner at W0.
// What is valid is decided by exact predicates; of several valid ones the one with the least energy (MIPS: it knows no scale) is taken.
class Vertex_inserter
{
public:
  // Takes (a) from uv[v] and leaves the best place there. Returns whether one was found. `corners` are the rest shapes around v.
  bool insert(const One_rings& rings, Index v, const Rest_corner* corners, const Index_triangle& parent, std::vector<Point_2>& uv)
  {
    m_star.gather(rings, uv, v, corners, Triangle_weight::ONE);
    m_best_energy = (std::numeric_limits<double>::infinity)();

    const Point_2 kept = uv[parent[0]], stored = uv[v];
    const bool is_ear = parent[1] == parent[2];
    offer(rings, v, is_ear ? corners[0].similar_apex(uv[rings[v].front()], uv[rings[v].back()]) : stored, uv);

    const Point_2 centroid = kernel_centroid(rings, v, uv);
    offer(rings, v, centroid, uv);

    constexpr int most_halvings = 40;
    const Point_2 beside_kept = kept + corner_bisector(rings, v, parent[0], uv);
    double fraction = 0.5;
    for (int i = 0; i < most_halvings && !has_place(); ++i, fraction *= 0.5) {
      offer(rings, v, kept + fraction * (centroid - kept), uv);
      offer(rings, v, kept + fraction * (beside_kept - kept), uv);
    }
    uv[v] = has_place() ? m_best : stored;
    return has_place();
  }

private:
  bool has_place() const { return m_best_energy < (std::numeric_limits<double>::infinity)(); }

  void offer(const One_rings& rings, Index v, const Point_2& place, std::vector<Point_2>& uv)
  {
    const double energy = m_star.energy(place);
    if (!(energy < m_best_energy))
      return;
    uv[v] = place;
    if (is_star_valid(rings, uv, v)) {
      m_best = place;
      m_best_energy = energy;
    }
  }

  // The kernel of a border vertex's star is unbounded: it is clipped to the box that bounds the ring.
  Point_2 kernel_centroid(const One_rings& rings, Index v, const std::vector<Point_2>& uv)
  {
    const One_rings::Ring ring = rings[v];
    const Point_2& origin = uv[ring.front()];
    double half_width = 0;
    for (Index w : ring)
      half_width = (std::max)({ half_width, std::abs(uv[w].x() - origin.x()), std::abs(uv[w].y() - origin.y()) });
    m_kernel.reset(origin, half_width);
    for (std::size_t i = 0; i < rings.number_of_triangles(v); ++i)
      m_kernel.clip(uv[ring[i]], uv[ring[i + 1 == ring.size() ? 0 : i + 1]]);
    return m_kernel.is_empty() ? origin : m_kernel.centroid();
  }

  // A vector from W0 into the kernel: along the bisector of the two half-planes at W0, as long as the shorter edge there. At the end of an
  // open ring there is one edge and one half-plane.
  static Vector_2 corner_bisector(const One_rings& rings, Index v, Index kept, const std::vector<Point_2>& uv)
  {
    const One_rings::Ring ring = rings[v];
    const std::size_t size = ring.size(), slot = std::size_t(std::find(ring.begin(), ring.end(), kept) - ring.begin());
    const bool has_next = slot + 1 < size || !rings.is_border(v), has_previous = slot > 0 || !rings.is_border(v);
    const Vector_2 next = has_next ? uv[ring[(slot + 1) % size]] - uv[kept] : Vector_2(0, 0);
    const Vector_2 previous = has_previous ? uv[ring[(slot + size - 1) % size]] - uv[kept] : Vector_2(0, 0);
    const double next_length = std::sqrt(next.squared_length()), previous_length = std::sqrt(previous.squared_length());
    const auto left = [](const Vector_2& x) { return Vector_2(-x.y(), x.x()); };
    if (!has_previous)
      return left(next);
    if (!has_next)
      return -left(previous);
    return (std::min)(next_length, previous_length) * 0.5 * (left(next) / next_length - left(previous) / previous_length);
  }

  Star<MIPS_energy_2> m_star;
  Polygon_kernel_2 m_kernel;
  Point_2 m_best;
  double m_best_energy;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VERTEX_INSERTER_H
