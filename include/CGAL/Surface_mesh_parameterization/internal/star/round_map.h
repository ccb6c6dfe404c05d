// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_ROUND_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_ROUND_MAP_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Rounds a coordinate, of which 2^exponent is one unit of the user's, to what the user's number type holds.
typedef double (*Round_coordinate)(double x, int exponent);

// That for a point type of the user's, null if its number type holds the doubles of a map of about size 1 in units of
// 2^-exponent times the user's: where these are denormal, it does not. 0 is for maps that are in the user's units.
template <class User_point_2>
Round_coordinate rounding_to(int exponent)
{
  constexpr int greatest_exponent_of_normal_map = 900;
  if constexpr (std::is_same<std::decay_t<decltype(std::declval<User_point_2>().x())>, float>::value)
    return [](double x, int e) { return std::ldexp(double(float(std::ldexp(x, -e))), e); };
  else if (exponent > greatest_exponent_of_normal_map)
    return [](double x, int e) { return std::ldexp(std::ldexp(x, -e), e); };
  else
    return nullptr;
}

// The same of points, with the exponent of their unit. By default nothing is rounded.
struct Rounding
{
  Round_coordinate round = nullptr;
  int exponent = 0;

  explicit operator bool() const { return round != nullptr; }
  Point_2 operator()(const Point_2& p) const
  {
    return round ? Point_2(round(p.x(), exponent), round(p.y(), exponent)) : p;
  }
};

// Whether the coordinates of a point, in the user's units, are finite in the user's numbers.
template <class User_point_2>
bool is_finite_in_users_numbers(const Point_2& p)
{
  return is_finite(Rounding{ rounding_to<User_point_2>(0) }(p));
}

// Why a map cannot be written where they are not.
inline constexpr const char* cause_of_overflow =
    "a coordinate of the map is too large for the numbers of uvmap, or is not a number";

// Rounds the coordinates of a valid map, or of the mirror image of one. A vertex whose star would not be valid any more
// goes to the middle of the kernel of its star, rounded. Returns whether the result is valid, or its mirror image. If
// `round` is null, there is nothing to do.
bool round_map(const One_rings& rings, Round_coordinate round, int exponent, std::vector<Point_2>& uv,
               const Loops& loops = Loops());

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_ROUND_MAP_H
