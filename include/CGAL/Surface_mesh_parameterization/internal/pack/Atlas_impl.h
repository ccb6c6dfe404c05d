// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Index> vertices_of(const Corner_mesh& mesh, const std::vector<Index>& faces)
{
  std::vector<Index> vertices;
  for (const Index f : faces)
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (vertices.empty() || mesh.vertex[h] > vertices.back())
        vertices.push_back(mesh.vertex[h]);
  return vertices;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void scale_to_area_in_space(const Corner_mesh& chart, std::vector<Point_2>& uv)
{
  double area_in_space = 0, area_in_plane = 0;
  for (Index h = 0; h < chart.number_of_halfedges(); h += 3) {
    const Index a = chart.vertex[h], b = chart.vertex[h + 1], c = chart.vertex[h + 2];
    area_in_space += doubled_area(chart.points[a], chart.points[b], chart.points[c]);
    area_in_plane += std::abs(doubled_area(uv[a], uv[b], uv[c]));
  }
  const double scale = std::sqrt(area_in_space / area_in_plane);
  if (std::isfinite(scale) && scale > 0)
    for (Point_2& p : uv)
      p = Point_2(scale * p.x(), scale * p.y());
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Point_2> map_of(const Atlas& atlas, const std::vector<Index>& faces)
{
  std::vector<Point_2> uv;
  for (const Index v : vertices_of(atlas.mesh, faces))
    uv.push_back(atlas.uv[v]);
  return uv;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Chart chart_of(const Corner_mesh& mesh, std::vector<Point_2> uv)
{
  Chart chart{ std::move(uv), {} };
  for (Index h = 0; h < mesh.number_of_halfedges(); h += 3)
    chart.triangles.push_back({ mesh.vertex[h], mesh.vertex[h + 1], mesh.vertex[h + 2] });
  return chart;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void make_charts(const std::vector<Point_2>& corners, Atlas& atlas)
{
  Corner_mesh& mesh = atlas.mesh;
  for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if (const Index o = mesh.opposite[h];
        o != no_index &&
        (corners[h] != corners[Corner_mesh::previous(o)] || corners[o] != corners[Corner_mesh::previous(h)]))
      mesh.sever(h);
  split_charts(corners, atlas);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void split_charts(const std::vector<Point_2>& corners, Atlas& atlas)
{
  Corner_mesh& mesh = atlas.mesh;
  split_vertices(mesh);
  atlas.charts = connected_components(mesh);
  atlas.uv.resize(mesh.number_of_vertices());
  for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
    atlas.uv[mesh.vertex[h]] = corners[h];
}

inline bool is_positive(const Chart& chart)
{
  return std::all_of(chart.triangles.begin(), chart.triangles.end(), [&](const Index_triangle& t) {
    return is_left_turn(chart.points[t[0]], chart.points[t[1]], chart.points[t[2]]);
  });
}

// Moves vertices of a chart that has got flips by rounding. Returns whether it has none then.
inline bool repair(Chart& chart, const Corner_mesh& component, Round_coordinate round)
{
  std::size_t unused_number = 0;
  return repair_map(surface_of(component), false, chart.points, unused_number) == OK &&
         round_map(One_rings(chart.points.size(), chart.triangles), round, 0, chart.points) &&
         is_positive(chart);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Packing pack_atlas(Atlas& atlas, const std::vector<bool>& is_wanted, const Pack_options& options,
                   Round_coordinate round)
{
  std::vector<Chart> charts;
  std::vector<Index> scratch(atlas.mesh.number_of_vertices(), no_index);
  std::vector<std::size_t> numbers;
  std::vector<bool> was_positive;
  for (std::size_t i = 0; i < atlas.charts.size(); ++i)
    if (is_wanted[i]) {
      charts.push_back(chart_of(component_of(atlas.mesh, atlas.charts[i], scratch), map_of(atlas, atlas.charts[i])));
      was_positive.push_back(is_positive(charts.back()));
      numbers.push_back(i);
    }
  Packing packing = pack_charts(charts, options);
  const double scale = options.fills_unit_square && packing.side > 0 ? 1 / packing.side : 1;
  const auto finished = [&](double x) {
    return round ? round(scale * x, 0) : scale * x;
  };
  for (std::size_t i = 0; i < charts.size(); ++i) {
    for (Point_2& p : charts[i].points)
      p = Point_2(finished(p.x()), finished(p.y()));
    const std::vector<Index>& faces = atlas.charts[numbers[i]];
    if (was_positive[i] && !is_positive(charts[i]) &&
        !repair(charts[i], component_of(atlas.mesh, faces, scratch), round))
      return {};
    const std::vector<Index> vertices = vertices_of(atlas.mesh, faces);
    for (std::size_t j = 0; j < vertices.size(); ++j)
      atlas.uv[vertices[j]] = charts[i].points[j];
  }
  packing.side *= scale;
  return packing;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_IMPL_H
