// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_BUILD_INTERPOLATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_BUILD_INTERPOLATION_H

#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>

#include <memory>

namespace CGAL::Surface_mesh_parameterization::internal {

// The hierarchy of a surface as a linear solver needs it. Where no visitor wants to see it, it is built without its
// faces; else it is null if the visitor has stopped the run, of which the options have the progress.
std::shared_ptr<const Hierarchy_interpolation>
build_interpolation(Triangulated_surface_3 surface, const Hierarchy_options& options, const Loops& loops,
                    Any_hierarchy_visitor*);
std::shared_ptr<const Hierarchy_interpolation>
build_visited_interpolation(Triangulated_surface_3 surface, const Hierarchy_options& options,
                            const Loops& loops, Any_hierarchy_visitor* visitor);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/build_interpolation_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_BUILD_INTERPOLATION_H
