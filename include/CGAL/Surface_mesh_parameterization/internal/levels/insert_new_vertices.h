// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_INSERT_NEW_VERTICES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_INSERT_NEW_VERTICES_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

namespace CGAL::Surface_mesh_parameterization::internal {

// Inserts the new vertices of a level (Hormann, Greiner, Campagna 1999, step 2b) into a flip-free map of the next
// coarser level and keeps it flip-free. A vertex goes to its place in `wanted`, if that is given, or where it is fixed,
// if there is no flip then. Returns the first vertex for which no place was found, `no_index` if there is none.
Index insert_new_vertices(const Level& level, Level::Uv& uv, const Level::Uv* wanted = nullptr);

// Puts the new vertices of a level, flips or not, where they are fixed or where their stored coordinates have them in
// the map of the next coarser level: an ear between its two neighbors.
void insert_at_stored_places(const Level& level, Level::Uv& uv);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/levels/insert_new_vertices_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_INSERT_NEW_VERTICES_H
