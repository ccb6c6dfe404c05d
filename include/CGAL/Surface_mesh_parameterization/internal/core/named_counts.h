// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_NAMED_COUNTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_NAMED_COUNTS_H

#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <cstddef>
#include <type_traits>

namespace CGAL::Surface_mesh_parameterization::internal {

// Sets `count` to the value of a named parameter, if there is one. Returns `false`, and leaves the count as it is, for
// a negative one: as a std::size_t, that would be huge.
template <class NamedParameters, class Tag>
bool set_count(const NamedParameters& np, Tag tag, std::size_t& count)
{
  if constexpr (!parameters::is_default_parameter<NamedParameters, Tag>::value) {
    const auto value = parameters::get_parameter(np, tag);
    if constexpr (std::is_signed<std::decay_t<decltype(value)>>::value)
      if (!(value >= 0))
        return false;
    count = static_cast<std::size_t>(value);
  }
  return true;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_NAMED_COUNTS_H
