// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FIRST_MAPS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FIRST_MAPS_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_with_springs.h>

namespace CGAL::Surface_mesh_parameterization::internal {

// Tutte's map of a level: on the finest one with the outer border at its places, if they are given and the map is
// valid; else scaled to the surface's area, or near the places of vertices if some are given or wished for. Returns
// what compute_Tutte_embedding() does.
Error_code compute_first_map(const Level& level, Level::Uv& uv);

// The same; or the unfolded level if that is a map of less energy, and the other is not at all the given places. No
// borders meet if the options say so.
Error_code choose_first_map(const Level_energy& energy, const Refinement_options& options, Level::Uv& uv);

// Replaces a map by the unfolded level, if that is a map of less energy, or there is none yet. Returns whether it did.
bool unfold_to_lower_energy(const Level_energy& energy, bool has_map, const Refinement_options& options,
                            Level::Uv& uv);

// Brings a map as near to the places that are given or wished for as a similarity can, if it stays valid.
void move_near_places(const Level& level, Level::Uv& uv);

// Where no place is given, moves a map as a whole to where springs pull it, by the best motion or the best similarity,
// if that lowers the energy. A spring may come with a fine level and pull from far away: it would crush the triangles
// around its vertex.
void follow_springs(const Level_energy_with_springs& energy, Level::Uv& uv);

// Scales a map so that the energy is about least: Tutte's map of a long surface is far too small in most places if it
// has the right area.
void scale_to_energy(const Level_energy& energy, Level::Uv& uv);

// Scales a map so that it has the area of the surface. Where rounding would spoil it, the nearest power of two is taken
// instead, which is exact. Where `borders_must_not_meet`, that counts as spoilt, too.
void scale_to_area(const Level& level, bool borders_must_not_meet, Level::Uv& uv);

// The same where an energy that is finite has to stay so, too. Returns it.
double scale_to_area(const Level_energy& energy, bool borders_must_not_meet, Level::Uv& uv);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/levels/first_maps_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FIRST_MAPS_H
