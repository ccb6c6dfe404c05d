// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ROUND_CHART_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ROUND_CHART_H

#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Flat_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Whether all triangles of a chart are positive.
bool is_positive(const Flat_chart& chart);

// Whether they all are negative.
bool is_mirrored(const Flat_chart& chart);

// Rounds the places of a chart whose shape has positive triangles so that they are positive, and returns whether it
// could. Vertices move within their stars; if that fails, the shape is scaled up around the middle of its place, up to
// a size; if that fails, too, flips are repaired, with the surface in space.
bool round_chart(Flat_chart& chart, const std::vector<Point_2>& shape, double most_size, const Rounding& round,
                 Function_ref<Triangulated_surface_3()> make_surface);

// Moves border vertices of a chart a little into it, where rounding has made borders meet that do not in its shape.
// Returns whether that is done, or they met before.
bool part_borders(Flat_chart& chart, const std::vector<Point_2>& shape, const Rounding& round);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/pack/round_chart_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ROUND_CHART_H
