// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_SEPARATE_BORDERS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_SEPARATE_BORDERS_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

namespace CGAL::Surface_mesh_parameterization::internal {

// Moves new border vertices of a level until no two border edges cross. Precondition: the map is valid, and without the
// new vertices no two cross.
//
// A new vertex V goes toward a point of the coarse border edge in whose place it and its two border edges come: as far
// along as V is in space, if that lies in the closure of the kernel of V's star, so that no triangle flips on the way.
// If not, toward one nearer to the vertex that V collapsed onto, which itself lies there. Returns whether that was
// enough.
bool separate_borders(const Level& level, Level::Uv& uv);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/border/separate_borders_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_SEPARATE_BORDERS_H
