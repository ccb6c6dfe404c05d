// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_NUMBER_CHECKS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_NUMBER_CHECKS_H

#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <cstddef>
#include <initializer_list>
#include <limits>
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

// A count among the named parameters, or the given one. One that is greater than any std::size_t, as infinity, is the
// greatest; which are none, the functions below tell.
template <class NamedParameters, class Tag>
std::size_t chosen_count([[maybe_unused]] const NamedParameters& np, [[maybe_unused]] Tag tag, std::size_t count)
{
  if constexpr (!parameters::is_default_parameter<NamedParameters, Tag>::value) {
    const auto value = parameters::get_parameter(np, tag);
    if constexpr (std::is_floating_point<std::decay_t<decltype(value)>>::value) {
      constexpr std::size_t greatest = (std::numeric_limits<std::size_t>::max)();
      count = !(value > 0) ? 0 : value < double(greatest) ? std::size_t(value) : greatest;
    } else
      count = std::size_t(value);
  }
  return count;
}

// What is wrong with the named parameters of a hierarchy; null if nothing is.
template <class NamedParameters>
const char* fault_of_hierarchy(const NamedParameters& np)
{
  return is_negative_or_nan(np, internal_np::coarsest_size) ? "coarsest_size is negative or no number" : nullptr;
}

// What is wrong with the counts among the named parameters of a method or solver, which are std::size_t afterwards:
// a negative one would be huge.
template <class NamedParameters>
const char* fault_of_counts(const NamedParameters& np)
{
  return is_negative_or_nan(np, internal_np::number_of_iterations)    ? "number_of_iterations is negative or no number"
         : is_negative_or_nan(np, internal_np::number_of_local_steps) ? "number_of_local_steps is negative or no number"
                                                                      : nullptr;
}

inline const char* fault_of_tolerance(double tolerance)
{
  return tolerance >= 0 ? nullptr : "tolerance is negative or no number";
}

inline const char* fault_of_lambda(double lambda)
{
  return lambda >= 0 ? nullptr : "lambda is negative or no number";
}

// The first fault of all; null if there is none.
inline const char* first_fault(std::initializer_list<const char*> faults)
{
  for (const char* fault : faults)
    if (fault)
      return fault;
  return nullptr;
}

// What is wrong with any of these.
template <class NamedParameters>
const char* fault_of_numbers(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  return first_fault({ fault_of_tolerance(choose_parameter(get_parameter(np, internal_np::tolerance), 0.)),
                       fault_of_lambda(choose_parameter(get_parameter(np, internal_np::lambda), 0.)),
                       fault_of_counts(np), fault_of_hierarchy(np) });
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_NUMBER_CHECKS_H
