// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_UNFOLDING_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_UNFOLDING_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

namespace CGAL::Surface_mesh_parameterization::internal {

// Lays out vertex by vertex, each by its distance from one that lies there already and the angles around that. A
// developable surface, and one without interior vertices, is unfolded so without distortion. The way to a vertex is as
// short as can be, in edges.
//
// Returns whether the map is valid. If it is not, `uv` has no meaning.
bool unfold(const Level& level, Level::Uv& uv);

// Whether the angles around the vertices within the surface sum to full turns, but for a tenth in all: only then it
// may be unfolded without distortion, or hardly any.
bool is_almost_developable(const Level& level);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/levels/unfolding_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_UNFOLDING_H
