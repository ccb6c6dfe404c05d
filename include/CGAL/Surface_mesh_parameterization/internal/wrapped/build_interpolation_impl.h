// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_BUILD_INTERPOLATION_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_BUILD_INTERPOLATION_IMPL_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/build_interpolation.h>

#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::shared_ptr<const Hierarchy_interpolation>
build_interpolation(Triangulated_surface_3 surface, const Hierarchy_options& options, const Loops& loops,
                    Any_hierarchy_visitor*)
{
  return std::make_shared<const Hierarchy_interpolation>(std::move(surface), options, loops);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::shared_ptr<const Hierarchy_interpolation>
build_visited_interpolation(Triangulated_surface_3 surface, const Hierarchy_options& options,
                            const Loops& loops, Any_hierarchy_visitor* visitor)
{
  const Collapse_hierarchy_3 hierarchy(std::move(surface), options, loops);
  const bool may_go_on = !options.progress->is_stopped() && visitor->hierarchy_built(hierarchy);
  return may_go_on ? std::make_shared<const Hierarchy_interpolation>(hierarchy, options.has_unit_edges) : nullptr;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_BUILD_INTERPOLATION_IMPL_H
