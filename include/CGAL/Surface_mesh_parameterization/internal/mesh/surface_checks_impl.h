// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_SURFACE_CHECKS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_SURFACE_CHECKS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/surface_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <CGAL/Bbox_3.h>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Disk_check check_disk_with_holes(const Triangulated_surface_3& surface, const Loops& loops)
{
  One_rings rings;
  rings.build(surface.points.size(), surface.triangles, loops);
  if (const Index bad_vertex = rings.first_non_manifold_vertex(); bad_vertex != no_index)
    return { false, bad_vertex };
  // A connected surface whose vertices have one fan each is a disk with holes exactly if V - E + F = 2 - (number
  // of borders).
  long long border_edges = 0;
  for (Index v = 0; v < surface.points.size(); ++v)
    border_edges += rings.is_border(v);
  const long long faces = (long long)(surface.triangles.size()), edges = (3 * faces + border_edges) / 2;
  return { (long long)(surface.points.size()) - edges + faces == 2 - (long long)(rings.borders().size()), no_index };
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void normalize(Triangulated_surface_3& surface)
{
  CGAL::Bbox_3 box;
  for (const Point_3& p : surface.points)
    box += p.bbox();
  // Halves, so that the sums of huge coordinates stay finite.
  const double center[3] = { 0.5 * box.xmin() + 0.5 * box.xmax(), 0.5 * box.ymin() + 0.5 * box.ymax(),
                             0.5 * box.zmin() + 0.5 * box.zmax() };
  const int exponent = scale_exponent_of(box);
  for (Point_3& p : surface.points)
    p = times_power_of_two(Point_3(p.x() - center[0], p.y() - center[1], p.z() - center[2]), exponent);
  surface.scale_exponent = exponent;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_SURFACE_CHECKS_IMPL_H
