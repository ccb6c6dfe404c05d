// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_TRIANGULATED_SURFACE_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_TRIANGULATED_SURFACE_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationHierarchy
///
/// A surface with borders, as flat arrays. A hierarchy is built from it. The surface must be connected and have no
/// handles, and one fan of triangles around each vertex. `Mesh_component` makes it from any mesh and checks this. The
/// points are of `CGAL::Simple_cartesian<double>`.
struct Triangulated_surface_3
{
  /// the vertices, scaled so that the size of the surface is about 1
  std::vector<internal::Point_3> points;

  /// three indices of points for each triangle, counter-clockwise
  std::vector<internal::Index_triangle> triangles;

  /// the vertices of the outer border, in any order; other borders are holes
  std::vector<internal::Index> outer_border;

  /// a length in `points`, and in the plane, is `2^scale_exponent` times the length in the user's units
  int scale_exponent = 0;

  /// a vertex whose uv coordinates are given
  struct Fixed_vertex
  {
    internal::Index vertex;     ///< index of a point
    internal::Point_2 place;    ///< its uv coordinates, in the units of `points`
  };

  /// the vertices whose uv coordinates are given, each at most once
  std::vector<Fixed_vertex> fixed_vertices = {};

  /// a vertex that a spring pulls to uv coordinates: it adds `stiffness / 2` times the squared distance to the
  /// energy of a map
  struct Spring
  {
    internal::Index vertex;     ///< index of a point
    internal::Point_2 place;    ///< its uv coordinates, in the units of `points`
    double stiffness;           ///< for distances in the units of `points`
  };

  /// the springs, at most one for each vertex. Coarse levels have those of their vertices
  std::vector<Spring> springs = {};
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_TRIANGULATED_SURFACE_3_H
