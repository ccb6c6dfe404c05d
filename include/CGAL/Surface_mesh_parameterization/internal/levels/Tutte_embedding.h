// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_TUTTE_EMBEDDING_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_TUTTE_EMBEDDING_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

namespace CGAL::Surface_mesh_parameterization::internal {

// The first map of a level: its outer border goes onto a circle, at distances in proportion to the edges in space,
// every other vertex to the mean of its neighbors (Tutte 1963). Each further border is closed by a virtual vertex in
// its middle. In exact arithmetic the map has no flip; whether it has in doubles is tested.
//
// Returns `OK`, `ERROR_NO_TOPOLOGICAL_DISC` without an outer border, `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`, or
// `ERROR_NO_1_TO_1_MAPPING` if a triangle is not positive; then `uv` is what doubles gave.
Error_code compute_Tutte_embedding(const Level& level, Level::Uv& uv);

// The same with the outer border at given places. They may be such that the map has flips, or not be given for all of
// the border, which is `ERROR_NO_1_TO_1_MAPPING`, too.
Error_code compute_Tutte_embedding_at_places(const Level& level, Level::Uv& uv);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_TUTTE_EMBEDDING_H
