// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_DETECTION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_DETECTION_H

#include <initializer_list>
#include <type_traits>

namespace CGAL::Surface_mesh_parameterization::internal {

template <class Void, template <class...> class Expression, class... Arguments>
struct Detector
{
  typedef void   type;
  static constexpr bool exists = false;
  template <class>
  static constexpr bool converts_to = false;
};

template <template <class...> class Expression, class... Arguments>
struct Detector<std::void_t<Expression<Arguments...>>, Expression, Arguments...>
{
  typedef Expression<Arguments...>   type;
  static constexpr bool exists = true;
  template <class Result>
  static constexpr bool converts_to = std::is_convertible<Expression<Arguments...>, Result>::value;
};

// Whether the type `Expression<Arguments...>` exists.
template <template <class...> class Expression, class... Arguments>
constexpr bool is_detected = Detector<void, Expression, Arguments...>::exists;

// That type, or void.
template <template <class...> class Expression, class... Arguments>
using Detected = typename Detector<void, Expression, Arguments...>::type;

// Whether it exists and converts to `Result`.
template <class Result, template <class...> class Expression, class... Arguments>
constexpr bool is_detected_as = Detector<void, Expression, Arguments...>::template converts_to<Result>;

// Whether it exists and is std::true_type.
template <template <class...> class Expression, class... Arguments>
constexpr bool is_detected_true = std::is_same<Detected<Expression, Arguments...>, std::true_type>::value;

// Of requirements in the order in which they are told, the number of the first one that is not met; -1 if all are.
constexpr int first_missing(std::initializer_list<bool> requirements)
{
  int number = 0;
  for (const bool is_met : requirements) {
    if (!is_met)
      return number;
    ++number;
  }
  return -1;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_DETECTION_H
