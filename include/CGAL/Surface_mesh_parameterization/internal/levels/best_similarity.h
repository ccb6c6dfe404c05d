// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_BEST_SIMILARITY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_BEST_SIMILARITY_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <cmath>
#include <complex>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A similarity of the plane that keeps orientation: z -> to + factor (z - from), in complex numbers.
struct Similarity_2
{
  typedef std::complex<double>   Complex;

  Complex from = 0, to = 0, factor = 1;

  static Complex complex(const Point_2& p) { return Complex(p.x(), p.y()); }

  // Whether it maps the plane to more than a point.
  bool is_regular() const { return std::abs(factor) > 0 && std::isfinite(std::abs(factor)); }

  Point_2 operator()(const Point_2& p) const
  {
    const Complex z = to + factor * (complex(p) - from);
    return Point_2(z.real(), z.imag());
  }
};

// The similarity that brings the first points of pairs, of which there is one at least, to the second ones, best in the
// sense of least squares. A translation if the first ones are all the same.
inline Similarity_2 best_similarity(const std::vector<std::pair<Point_2, Point_2>>& pairs)
{
  Similarity_2 result;
  for (const auto& [p, q] : pairs) {
    result.from += Similarity_2::complex(p);
    result.to += Similarity_2::complex(q);
  }
  result.from /= double(pairs.size());
  result.to /= double(pairs.size());
  Similarity_2::Complex product(0, 0);
  double squares = 0;
  for (const auto& [p, q] : pairs) {
    const Similarity_2::Complex z = Similarity_2::complex(p) - result.from;
    product += std::conj(z) * (Similarity_2::complex(q) - result.to);
    squares += std::norm(z);
  }
  if (squares > 0)
    result.factor = product / squares;
  return result;
}

// Moves a valid map by the similarity that brings the first points of pairs nearest to the second ones, if there is one
// and the map stays valid.
inline void move_by_best_similarity(const std::vector<std::pair<Point_2, Point_2>>& pairs, const One_rings& rings,
                                    const Loops& loops, std::vector<Point_2>& uv)
{
  if (pairs.empty())
    return;
  const Similarity_2 similarity = best_similarity(pairs);
  if (!similarity.is_regular())
    return;
  std::vector<Point_2> moved;
  moved.reserve(uv.size());
  for (const Point_2& p : uv)
    moved.push_back(similarity(p));
  if (is_map_valid(rings, moved, loops))
    uv.swap(moved);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_BEST_SIMILARITY_H
