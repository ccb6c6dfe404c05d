// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_CROSSINGS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_CROSSINGS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/box_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>

#include <CGAL/Bbox_2.h>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Border_edge> border_edges(const One_rings& rings)
{
  std::vector<Border_edge> edges;
  for (Index v = 0; v < rings.number_of_vertices(); ++v)
    if (rings.is_border(v))
      edges.push_back({ v, rings[v].front() });
  return edges;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool do_cross(const Border_edge& e, const Border_edge& f, const std::vector<Point_2>& uv)
{
  const auto folds_back = [&](Index a, Index b, Index c) {    // the edges ab and bc
    return exact_orientation(uv[a], uv[b], uv[c]) == COLLINEAR && !are_strictly_ordered_xy(uv[a], uv[b], uv[c]);
  };
  if (e.target == f.source && f.target == e.source)
    return true;
  if (e.target == f.source)
    return folds_back(e.source, e.target, f.target);
  if (f.target == e.source)
    return folds_back(f.source, f.target, e.target);
  return do_segments_meet(uv[e.source], uv[e.target], uv[f.source], uv[f.target]);
}

inline std::vector<Bbox_2> boxes_of(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv)
{
  std::vector<Bbox_2> boxes;
  boxes.reserve(edges.size());
  for (const Border_edge& e : edges)
    boxes.push_back(uv[e.source].bbox() + uv[e.target].bbox());
  return boxes;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void for_each_crossing(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv,
                       Function_ref<void(std::size_t, std::size_t)> f)
{
  for_each_pair_of_boxes(boxes_of(edges, uv), [&](std::size_t i, std::size_t j) {
    if (do_cross(edges[i], edges[j], uv))
      f(i, j);
  });
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool has_crossings(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv)
{
  return has_crossings(edges, uv, [](std::size_t, std::size_t) { return true; });
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool has_crossings(const std::vector<Border_edge>& edges, const std::vector<Point_2>& uv,
                   Function_ref<bool(std::size_t, std::size_t)> counts)
{
  return any_pair_of_boxes(boxes_of(edges, uv), [&](std::size_t i, std::size_t j) {
    return counts(i, j) && do_cross(edges[i], edges[j], uv);
  });
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_CROSSINGS_IMPL_H
