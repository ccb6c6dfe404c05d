// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NUMBER_OF_FLAT_TRIANGLES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NUMBER_OF_FLAT_TRIANGLES_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// How many of a level's triangles are so flat in space that their rest shape is another one.
inline std::size_t number_of_flat_triangles(const Level& level)
{
  const auto triangles = level.triangles();
  return std::size_t(std::count_if(triangles.begin(), triangles.end(), [&](const Level::Triangle& t) {
    const Point_3 &p = level.point(t[0]), &q = level.point(t[1]), &r = level.point(t[2]);
    const double longest2 =
        (std::max)({ CGAL::squared_distance(p, q), CGAL::squared_distance(q, r), CGAL::squared_distance(r, p) });
    return is_height_raised(doubled_area(p, q, r), longest2);
  }));
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NUMBER_OF_FLAT_TRIANGLES_H
