// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_LEAD_TO_PLACES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_LEAD_TO_PLACES_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_with_springs.h>

namespace CGAL::Surface_mesh_parameterization::internal {

// Brings the vertices of a level whose places are given there, and those that stiff springs pull near to theirs, in a
// valid map that stays valid. An energy that keeps triangles positive decides how the others follow. If
// `borders_must_not_meet`, no borders do that did not before.
//
// Returns `OK`; `ERROR_NO_1_TO_1_MAPPING` if some of the first are still elsewhere, as near as they came; or
// `ERROR_STOPPED`.
Error_code lead_to_places(const Level_energy_with_springs& energy, bool borders_must_not_meet, Level::Uv& uv,
                          Level_summary& summary);

// Where all vertices of a level have given places, or springs that pull them to some, takes these if that is a valid
// map and the given places are not yet met, or if it has lower energy, and is valid where the energy keeps triangles
// positive.
void take_better_places(const Level_energy& energy, Level::Uv& uv);

// Where the place of one vertex only is given, moves the map there, if it stays valid.
void move_to_single_place(const Level& level, Level::Uv& uv);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/levels/lead_to_places_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_LEAD_TO_PLACES_H
