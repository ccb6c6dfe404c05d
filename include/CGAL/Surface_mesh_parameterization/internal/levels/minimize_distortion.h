// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_DISTORTION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_DISTORTION_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>

namespace CGAL::Surface_mesh_parameterization::internal {

// Tutte's map of a level, scaled to the surface's area, or near the places of vertices if some are given or wished for.
// Returns what compute_Tutte_embedding() does.
Error_code compute_first_map(const Level& level, Level::Uv& uv);

// The same, or the unfolded level if that is a map of less energy. No borders meet if the options say so.
Error_code choose_first_map(const Level_energy& energy, const Refinement_options& options, Level::Uv& uv);

// The factor that brings a map to the area of the surface; 0 if the surface has none in doubles.
double scale_of_area(const Level& level, const Level::Uv& uv);

// Scales a map so that it has the area of the surface. Where rounding would spoil it, the nearest power of two is taken
// instead, which is exact. Where `borders_must_not_meet`, that counts as spoilt, too.
void scale_to_area(const Level& level, bool borders_must_not_meet, Level::Uv& uv);

// Minimizes an energy from a map that is valid, if the energy keeps triangles positive, with the springs of the level.
// Vertices whose places are given are brought there, or held where they are if the energy lets triangles flip.
// Returns `OK`, `ERROR_STOPPED`, or `ERROR_NO_1_TO_1_MAPPING` if on the finest level one could not be brought to its
// place; so do the others.
Error_code minimize_energy(const Level_energy& energy, Level::Uv& uv, const Refinement_options& options,
                           Level_summary& summary);

// The same for a map that must stay free of flips, and of borders that meet if the options say so. If the result is
// bad, other starts are tried, unless places are given or wished for; these also keep it from being scaled.
// Returns `ERROR_NO_1_TO_1_MAPPING` also if the borders could not be separated, and may return `GIVEN_UP`.
Error_code minimize_flip_free(const Level_energy& energy, bool scales_to_area, Level::Uv& uv,
                              const Refinement_options& options, Level_summary& summary);

// Minimizes the as-rigid-as-possible energy with lambda = 0, see Conformal_refiner. There are no springs.
Error_code minimize_conformal_energy(const Level& level, Level::Uv& uv, const Refinement_options& options,
                                     Level_summary& summary);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/levels/minimize_distortion_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_DISTORTION_H
