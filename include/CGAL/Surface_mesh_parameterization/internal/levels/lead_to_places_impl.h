// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_LEAD_TO_PLACES_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_LEAD_TO_PLACES_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/levels/Place_leader.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/lead_to_places.h>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code lead_to_places(const Level_energy& energy, bool borders_must_not_meet, Level::Uv& uv,
                          Level_summary& summary)
{
  Place_leader leader(energy, borders_must_not_meet, uv, summary);
  if (leader.is_done())
    return OK;
  if (!leader.run())
    return ERROR_STOPPED;
  return leader.is_done() ? OK : ERROR_NO_1_TO_1_MAPPING;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_LEAD_TO_PLACES_IMPL_H
