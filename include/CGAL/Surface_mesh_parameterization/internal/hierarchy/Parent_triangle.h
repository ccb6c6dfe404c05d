// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_PARENT_TRIANGLE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_PARENT_TRIANGLE_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A half-edge collapse moves V onto a neighbor W0, whose position does not change:
//
//        W3------W2                 W3------W2
//       /  \    /  \               /  \      \             the star of V becomes the fan of W0:
//      /    \  /    \             /     \     \            triangles (W0, Wi, Wi+1), i = 1 .. n-1,
//    W4------V-----W1    --->    W4-___  \     W1          the two triangles at the edge VW0 vanish
//      \    /  \    /             \     ---\  /
//       \  /    \  /               \        \/             a border vertex V collapses along the border:
//        W5-----W0                  W5------W0             its ring is open, W0 is one of its ends

// The triangle of the fan that holds V, and V's barycentric coordinates in it.
struct Parent_triangle
{
  std::array<Index, 3> slots;              // W0, Wi, Wi+1 as positions in the ring of V
  std::array<double, 2> coordinates;       // with respect to Wi and Wi+1: sigma and tau; rho = 1 - sigma - tau
};

// The quality of a triangle in the plane: its signed area by its longest squared edge; at most sqrt(3)/4, negative for
// a flipped one.
inline double shape_quality(const Vector_2& a, const Vector_2& b, const Vector_2& c)
{
  const Vector_2 ab = b - a, ac = c - a, bc = c - b;
  const double longest = (std::max)({ ab.squared_length(), ac.squared_length(), bc.squared_length() });
  return longest > 0 ? 0.5 * cross(ab, ac) / longest : 0;
}

// The same of a triangle in space, which cannot be flipped.
inline double shape_quality(const Point_3& a, const Point_3& b, const Point_3& c)
{
  const Vector_3 ab = b - a, ac = c - a, bc = c - b;
  const double longest = (std::max)({ ab.squared_length(), ac.squared_length(), bc.squared_length() });
  return longest > 0 ? 0.5 * std::sqrt(CGAL::cross_product(ab, ac).squared_length()) / longest : 0;
}

// The quality of the worst triangle at V, the origin, with the flattened ring.
inline double worst_quality_of_star(const std::vector<Vector_2>& flat_ring, bool is_closed)
{
  const Vector_2 origin(0, 0);
  double worst = is_closed ? shape_quality(origin, flat_ring.back(), flat_ring.front()) : 1;
  for (std::size_t i = 0; i + 1 < flat_ring.size(); ++i)
    worst = (std::min)(worst, shape_quality(origin, flat_ring[i], flat_ring[i + 1]));
  return worst;
}

// The quality of the worst triangle that a collapse onto ring position w0, an end of an open ring, leaves, in space or
// with the flattened ring; of an ear's, that leaves none, 1. It stops at the first triangle that is not better than
// `bound`, and returns what it has found then.
template <class Place>
double worst_quality_after_collapse(const std::vector<Place>& ring, std::size_t w0,
                                    double bound = -(std::numeric_limits<double>::infinity)())
{
  const std::size_t size = ring.size();
  double worst = 1;
  std::size_t i = next_in_cycle(w0, size);
  for (std::size_t k = 2; k < size && worst > bound; ++k) {
    const std::size_t j = next_in_cycle(i, size);
    worst = (std::min)(worst, shape_quality(ring[w0], ring[i], ring[j]));
    i = j;
  }
  return worst;
}

// Where V, the origin, lies in the fan of ring position w0: the triangle in which its least barycentric coordinate is
// greatest. Precondition: an interior vertex; the triangles of the fan are positive.
inline Parent_triangle find_parent_triangle(const std::vector<Vector_2>& flat_ring, std::size_t w0)
{
  const std::size_t size = flat_ring.size();
  const Vector_2& a = flat_ring[w0];
  Parent_triangle best;
  best.slots = { Index(w0), Index((w0 + 1) % size), Index((w0 + 2) % size) };
  best.coordinates = { 0, 0 };
  double best_least = -(std::numeric_limits<double>::infinity)();
  for (std::size_t k = 1; k + 1 < size; ++k) {
    const std::size_t i = (w0 + k) % size, j = (w0 + k + 1) % size;
    const Vector_2 &b = flat_ring[i], &c = flat_ring[j];
    const std::array<double, 3> areas = { cross(b, c), cross(c, a), cross(a, b) };
    const double area = areas[0] + areas[1] + areas[2];
    const double least = *std::min_element(areas.begin(), areas.end()) / area;
    if (!(area > 0 && least > best_least))      // the area of a thin triangle far away may be lost by rounding
      continue;
    best_least = least;
    const std::array<double, 3> inside = { (std::max)(areas[0], 0.), (std::max)(areas[1], 0.),
                                           (std::max)(areas[2], 0.) };
    const double sum = inside[0] + inside[1] + inside[2];
    best.slots = { Index(w0), Index(i), Index(j) };
    best.coordinates = { inside[1] / sum, inside[2] / sum };
  }
  return best;
}

// Where a border vertex V that collapses onto one end W0 of its open ring lies on the coarse border edge from W0 to the
// other end Wn, by arc length. V may lie outside the coarse fan, so its third coordinate is 0. An ear leaves no fan:
// its parent is the edge, Wn twice.
inline Parent_triangle find_parent_border_edge(const std::vector<Vector_2>& flat_ring, std::size_t w0)
{
  const std::size_t last = flat_ring.size() - 1, other = w0 == 0 ? last : 0;
  const bool is_ear = last == 1;
  const std::size_t beside = is_ear ? other : w0 == 0 ? last - 1 : 1;     // of the coarse triangle at the edge
  const double to_kept = std::sqrt(flat_ring[w0].squared_length()),
               to_other = std::sqrt(flat_ring[other].squared_length());
  const double fraction = to_kept + to_other > 0 ? to_kept / (to_kept + to_other) : 0.5;
  Parent_triangle parent;
  if (w0 == 0) {
    parent.slots = { Index(w0), Index(beside), Index(other) };
    parent.coordinates = { 0, fraction };
  } else {
    parent.slots = { Index(w0), Index(other), Index(beside) };
    parent.coordinates = { fraction, 0 };
  }
  return parent;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_PARENT_TRIANGLE_H
