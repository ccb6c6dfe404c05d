// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_STARTING_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_STARTING_MAP_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Makes a map that a user gives for a surface one to start from: mirrors it if all triangles are negative, and else
// repairs flips and finds places for vertices whose coordinates are not finite, see repair_map(). Returns whether the
// result is valid.
bool make_starting_map(const Triangulated_surface_3& surface, const Loops& loops, std::vector<Point_2>& uv);

typedef decltype(&make_starting_map)   Make_starting_map;

// The function above if named parameters ask for a start from a given map, else null. Header-only, it is compiled only
// where they may.
template <class NamedParameters>
Make_starting_map make_starting_map_of(const NamedParameters& np)
{
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::initial_map_t>::value)
    return parameters::get_parameter(np, internal_np::initial_map) ? &make_starting_map : nullptr;
  else
    return nullptr;
}

// Scales a valid map of a level to the surface's area if it is far from that, for instance in the unit square. Returns
// false if its area is none in doubles.
bool bring_to_scale(const Level& level, bool borders_must_not_meet, Level::Uv& uv);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/levels/starting_map_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_STARTING_MAP_H
