// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_CROSSINGS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_CROSSINGS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// An edge of a border, with the surface to its left.
struct Border_edge
{
  Index source, target;
};

inline std::vector<Border_edge> border_edges(const One_rings& rings)
{
  std::vector<Border_edge> edges;
  for (Index v = 0; v < rings.number_of_vertices(); ++v)
    if (rings.is_border(v))
      edges.push_back({ v, rings[v].front() });
  return edges;
}

// Whether two border edges meet in the plane anywhere but in a vertex that they share.
inline bool do_cross(const Border_edge& e, const Border_edge& f, const std::vector<Point_2>& uv)
{
  const auto folds_back = [&](Index a, Index b, Index c) {    // the edges ab and bc
    return orientation(uv[a], uv[b], uv[c]) == COLLINEAR && !collinear_are_strictly_ordered_along_line(uv[a], uv[b], uv[c]);
  };
  if (e.target == f.source && f.target == e.source)
    return true;
  if (e.target == f.source)
    return folds_back(e.source, e.target, f.target);
  if (f.target == e.source)
    return folds_back(f.source, f.target, e.target);
  return do_intersect(Flat_kernel::Segment_2(uv[e.source], uv[e.target]), Flat_kernel::Segment_2(uv[f.source], uv[f.target]));
}

// Calls f(i, j) for any two edges that meet in the plane, but for a vertex that they share. Exact, and near-linear where few edges are near each other.
// Precondition: no coordinate is infinite or no number.
template <class Function>
void for_each_crossing(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv, const Function& f)
{
  typedef CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>   Box;
  std::vector<Box> boxes;
  boxes.reserve(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
    boxes.emplace_back(uv[edges[i].source].bbox() + uv[edges[i].target].bbox(), i);
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    if (do_cross(edges[a.info()], edges[b.info()], uv))
      f(a.info(), b.info());
  });
}

inline bool has_crossings(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv)
{
  bool result = false;
  for_each_crossing(edges, uv, [&](std::size_t, std::size_t) { result = true; });
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_CROSSINGS_H
