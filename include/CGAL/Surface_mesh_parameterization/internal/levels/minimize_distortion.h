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
