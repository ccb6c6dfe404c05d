// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_POSITION_IN_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_POSITION_IN_H

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace CGAL::Surface_mesh_parameterization::internal {

// The position of a vertex or face in the mesh's own order, `range`: errors tell it.
template <class Range, class Descriptor>
std::size_t position_in(const Range& range, Descriptor d)
{
  return std::size_t(std::distance(range.begin(), std::find(range.begin(), range.end(), d)));
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_POSITION_IN_H
