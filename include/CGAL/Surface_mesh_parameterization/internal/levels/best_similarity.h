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

struct Wanted_move
{
  Point_2 from, to;
  double weight = 1;
};

// The similarity that makes the given moves best, in the sense of weighted least squares; there is at least one move. A
// translation if all begin at the same point.
inline Similarity_2 best_similarity(const std::vector<Wanted_move>& moves)
{
  Similarity_2 result;
  double weights = 0;
  for (const Wanted_move& move : moves) {
    result.from += move.weight * Similarity_2::complex(move.from);
    result.to += move.weight * Similarity_2::complex(move.to);
    weights += move.weight;
  }
  result.from /= weights;
  result.to /= weights;
  Similarity_2::Complex product(0, 0);
  double squares = 0;
  for (const Wanted_move& move : moves) {
    const Similarity_2::Complex z = Similarity_2::complex(move.from) - result.from;
    product += move.weight * std::conj(z) * (Similarity_2::complex(move.to) - result.to);
    squares += move.weight * std::norm(z);
  }
  if (squares > 0)
    result.factor = product / squares;
  return result;
}

// The part of the variance of where the moves lead that the best similarity leaves: from 0 if it makes all of them, to
// 1 if it is no better than to move all to one point.
inline double unexplained_variance(const std::vector<Wanted_move>& moves)
{
  const Similarity_2 similarity = best_similarity(moves);
  double variance = 0, rest = 0;
  for (const Wanted_move& move : moves) {
    const Similarity_2::Complex to = Similarity_2::complex(move.to);
    variance += move.weight * std::norm(to - similarity.to);
    rest += move.weight * std::norm(to - Similarity_2::complex(similarity(move.from)));
  }
  return variance > 0 ? rest / variance : 0;
}

// The best similarity that keeps lengths: a motion.
inline Similarity_2 best_motion(const std::vector<Wanted_move>& moves)
{
  Similarity_2 result = best_similarity(moves);
  result.factor = std::abs(result.factor) > 0 ? result.factor / std::abs(result.factor) : 1;
  return result;
}

// Moves a valid map by a similarity. Returns whether it is still valid; if not, it stays where it was.
inline bool move_by(const Similarity_2& similarity, const One_rings& rings, const Loops& loops,
                    std::vector<Point_2>& uv)
{
  if (!similarity.is_regular())
    return false;
  std::vector<Point_2> moved;
  moved.reserve(uv.size());
  for (const Point_2& p : uv)
    moved.push_back(similarity(p));
  const bool is_valid = is_map_valid(rings, moved, loops);
  if (is_valid)
    uv.swap(moved);
  return is_valid;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_BEST_SIMILARITY_H
