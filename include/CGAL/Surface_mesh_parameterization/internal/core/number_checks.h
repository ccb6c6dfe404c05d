// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_NUMBER_CHECKS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_NUMBER_CHECKS_H

#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <type_traits>

namespace CGAL::Surface_mesh_parameterization::internal {

template <class NamedParameters, class Tag>
bool is_negative_or_nan([[maybe_unused]] const NamedParameters& np, [[maybe_unused]] Tag tag)
{
  if constexpr (!parameters::is_default_parameter<NamedParameters, Tag>::value) {
    const auto value = parameters::get_parameter(np, tag);
    if constexpr (std::is_signed<std::decay_t<decltype(value)>>::value)
      return !(value >= 0);
  }
  return false;
}

// What is wrong with the named parameters of a hierarchy; null if nothing is. As a std::size_t, a negative count would
// be a huge one.
template <class NamedParameters>
const char* fault_of_hierarchy(const NamedParameters& np)
{
  return is_negative_or_nan(np, internal_np::coarsest_size) ? "coarsest_size is negative" : nullptr;
}

// The same with those of a method or solver of the package.
template <class NamedParameters>
const char* fault_of_numbers(const NamedParameters& np)
{
  return is_negative_or_nan(np, internal_np::tolerance)               ? "tolerance is negative or no number"
         : is_negative_or_nan(np, internal_np::lambda)                ? "lambda is negative or no number"
         : is_negative_or_nan(np, internal_np::number_of_iterations)  ? "number_of_iterations is negative"
         : is_negative_or_nan(np, internal_np::number_of_local_steps) ? "number_of_local_steps is negative"
                                                                      : fault_of_hierarchy(np);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_NUMBER_CHECKS_H
