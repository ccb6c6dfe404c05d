// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_PREFETCH_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_PREFETCH_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <boost/config.hpp>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// Asks for the memory at an address that will be read soon. Does nothing where the compiler offers no way. This, and
// each function that does nothing else, must be inlined by force: gcc leaves out calls that change nothing.
BOOST_FORCEINLINE void prefetch([[maybe_unused]] const void* address)
{
#ifdef __GNUC__       // clang, too
  __builtin_prefetch(address);
#endif
}

constexpr std::size_t prefetch_distance = 64;

// In a loop over a list of indices into an array, at place k: asks for the element that is needed some places later.
// Neighbors come from many groups of ranks, of which the processor alone cannot see in advance where they lie.
template <class Array>
BOOST_FORCEINLINE void prefetch_element_after(std::size_t k, const Index* indices, std::size_t number_of_indices,
                                              const Array& array)
{
  if (k + prefetch_distance < number_of_indices)
    prefetch(&array[indices[k + prefetch_distance]]);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_PREFETCH_H
