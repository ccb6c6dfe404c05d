// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_LEAD_TO_PLACES_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_LEAD_TO_PLACES_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Place_leader.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/lead_to_places.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_with_springs.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code lead_to_places(const Level_energy_with_springs& energy, bool borders_must_not_meet, Level::Uv& uv,
                          Level_summary& summary)
{
  Place_leader leader(energy, borders_must_not_meet, uv, summary);
  if (!leader.run())
    return ERROR_STOPPED;
  return leader.are_fixed_vertices_at_places() ? OK : ERROR_NO_1_TO_1_MAPPING;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void take_better_places(const Level_energy& energy, Level::Uv& uv)
{
  const Level& level = energy.level();
  const std::vector<Index> fixed = fixed_vertices(level);
  const std::vector<Triangulated_surface_3::Spring> pulled = springs_of(level);
  if (fixed.size() + pulled.size() < level.number_of_vertices())
    return;
  Level::Uv places(level.number_of_vertices(), nowhere());
  for (const Triangulated_surface_3::Spring& spring : pulled)
    places[spring.vertex] = spring.place;
  for (const Index v : fixed)
    places[v] = level.fixed_place(v);
  const bool is_valid = is_map_valid(level.rings(), places, level.loops());
  if (energy.is_flip_free() && !is_valid)
    return;
  const bool must_be_taken = is_valid && !displaced_vertices(level, uv).empty();
  if (must_be_taken || energy(places) < energy(uv))
    uv = std::move(places);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void move_to_single_place(const Level& level, Level::Uv& uv)
{
  const std::vector<Index> fixed = fixed_vertices(level);
  if (fixed.size() != 1 || displaced_vertices(level, uv).empty())
    return;
  const Point_2& place = level.fixed_place(fixed.front());
  const Vector_2 way = place - uv[fixed.front()];
  Level::Uv moved(uv.size());
  level.for_each_vertex([&](Index v) { moved[v] = uv[v] + way; });
  moved[fixed.front()] = place;
  if (is_map_valid(level.rings(), moved, level.loops()))
    uv = std::move(moved);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_LEAD_TO_PLACES_IMPL_H
