// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_SURFACE_CHECKS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_SURFACE_CHECKS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/surface_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

inline bool has_neighbor_twice(const One_rings::Ring& ring)
{
  constexpr std::size_t most_neighbors_to_compare = 32;
  if (ring.size() > most_neighbors_to_compare) {
    std::vector<Index> neighbors(ring.begin(), ring.end());
    std::sort(neighbors.begin(), neighbors.end());
    return std::adjacent_find(neighbors.begin(), neighbors.end()) != neighbors.end();
  }
  for (auto v = ring.begin(); v != ring.end(); ++v)
    if (std::find(ring.begin(), v, *v) != v)
      return true;
  return false;
}

// The vertex that a Disk_check tells of.
inline Index bad_vertex_of(const One_rings& rings, const std::vector<Index>& border_vertices, const Loops& loops)
{
  if (const Index v = rings.first_non_manifold_vertex(); v != no_index)
    return v;
  const auto closed = std::find_if_not(border_vertices.begin(), border_vertices.end(),
                                       [&](Index v) { return rings.is_border(v); });
  if (closed != border_vertices.end())
    return *closed;
  return loops.min(0, Index(rings.number_of_vertices()), no_index,
                   [&](Index v) { return has_neighbor_twice(rings[v]) ? v : no_index; });
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Disk_check check_disk_with_holes(const Triangulated_surface_3& surface, const std::vector<Index>& border_vertices,
                                 const Loops& loops)
{
  One_rings rings;
  rings.build(surface.points.size(), surface.triangles, loops);
  if (const Index v = bad_vertex_of(rings, border_vertices, loops); v != no_index)
    return { false, v };
  // A connected surface whose vertices have one fan each is a disk with holes exactly if V - E + F = 2 - (number
  // of borders).
  long long border_edges = 0;
  for (Index v = 0; v < surface.points.size(); ++v)
    border_edges += rings.is_border(v);
  const long long faces = (long long)(surface.triangles.size()), edges = (3 * faces + border_edges) / 2;
  return { (long long)(surface.points.size()) - edges + faces == 2 - (long long)(rings.borders().size()), no_index };
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
int dimension_of_box(const std::vector<Point_3>& points)
{
  CGAL::Bbox_3 box;
  for (const Point_3& p : points)
    box += p.bbox();
  return int(box.xmax() > box.xmin()) + int(box.ymax() > box.ymin()) + int(box.zmax() > box.zmin());
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
