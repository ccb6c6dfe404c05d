// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PREFETCH_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PREFETCH_H

#include <boost/config.hpp>

namespace CGAL::Surface_mesh_parameterization::internal {

// Asks for the memory at an address that will be read soon. Does nothing where the compiler has no word for it. This and functions that do nothing else
// must be inlined by force: gcc takes a call that changes nothing for superfluous.
BOOST_FORCEINLINE void prefetch([[maybe_unused]] const void* address)
{
#ifdef __GNUC__       // clang, too
  __builtin_prefetch(address);
#endif
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PREFETCH_H
