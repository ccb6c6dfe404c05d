// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_STEPS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_STEPS_H

#include <CGAL/Surface_mesh_parameterization/Atlas_summary.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Chart_part.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/divide_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// What atlas_parameterization() does, and what it tells of it, whatever the mesh and the method are.

namespace CGAL::Surface_mesh_parameterization::internal {

// The face of a chart at which an error lies, as a face of the mesh; the chart's first one if it lies nowhere.
inline Parameterization_error error_in_mesh(const Parameterization_error& error, const Corner_mesh& chart,
                                            const std::vector<Index>& faces)
{
  Parameterization_error result = error;
  if (error.code == OK)
    return result;
  result.place = Parameterization_error::FACE;
  result.index = faces.front();
  if (error.code == ERROR_NO_1_TO_1_MAPPING && error.place == Parameterization_error::NOWHERE && !error.cause)
    result.cause = "no map without flips was found of the chart with this face";
  if (error.place == Parameterization_error::FACE)
    result.index = faces[error.index];
  else if (error.place == Parameterization_error::VERTEX)
    for (Index h = chart.number_of_halfedges(); h-- > 0;)
      if (chart.vertex[h] == error.index)
        result.index = faces[h / 3];      // the first one in the end: virtual faces come last
  return result;
}

// A part of a chart with its map, and what the mesh of the part tells for the atlas.
struct Part_with_map
{
  std::vector<Index> faces;                 // of the atlas's mesh
  std::vector<Index> border;                // halfedges of that
  std::vector<Point_2> uv;                  // of the part's vertices; none if it has no map
  Parameterization_summary summary;

  Part_with_map(Chart_part part, Parameterization_summary summary_of_part) : summary(std::move(summary_of_part))
  {
    summary.error = error_in_mesh(summary.error, part.mesh, part.faces);
    for (Index h = 0; h < part.mesh.number_of_halfedges(); ++h)
      if (part.mesh.is_border(h))
        border.push_back(part.halfedge_of_atlas(h));
    faces = std::move(part.faces);
    if (summary.is_ok())
      uv = std::move(part.uv);
  }
};

typedef std::vector<Part_with_map>   Parts_with_map;

// Severs charts between their parts, of which each chart has at least one.
inline void sever_parts(const std::vector<Parts_with_map>& parts, Atlas& atlas, Atlas_summary& result)
{
  const std::size_t old_number_of_charts = atlas.charts.size();
  bool is_severed = false;
  for (const Parts_with_map& parts_of_chart : parts)
    for (const Part_with_map& part : parts_of_chart)
      for (const Index h : part.border)
        if (!atlas.mesh.is_border(h)) {
          atlas.sever(h);
          is_severed = true;
        }
  if (!is_severed)
    return;
  split_vertices(atlas.mesh);
  atlas.charts = connected_components(atlas.mesh);
  result.divisions += atlas.charts.size() - old_number_of_charts;
  result.chart_of_face = chart_of_face(atlas);
}

// Makes parts of charts the charts of an atlas. Returns which have a map.
inline std::vector<bool> take_parts(const std::vector<Parts_with_map>& parts, Atlas& atlas, Atlas_summary& result)
{
  sever_parts(parts, atlas, result);
  std::vector<const Part_with_map*> part_of_chart(atlas.charts.size());
  for (const Parts_with_map& parts_of_chart : parts)
    for (const Part_with_map& part : parts_of_chart)
      part_of_chart[result.chart_of_face[part.faces.front()]] = &part;

  atlas.uv.assign(atlas.mesh.number_of_vertices(), Point_2(0, 0));
  std::vector<bool> has_map;
  for (std::size_t i = 0; i < atlas.charts.size(); ++i) {
    const Part_with_map& part = *part_of_chart[i];
    if (!part.uv.empty())
      set_map(atlas, part.faces, part.uv);
    has_map.push_back(part.summary.is_ok());
    result.charts.push_back({ part.faces.size(), part.summary });
    if (result.is_ok())
      result.error = part.summary.error;
  }
  return has_map;
}

// Takes a part of so many faces from a chart: with its share of the chart's seconds, while all that the repair of flips
// did is told of the first part.
inline Atlas_summary::Chart take_part(Atlas_summary::Chart& chart, std::size_t faces)
{
  Atlas_summary::Chart part = chart;
  const double share = double(faces) / double(chart.faces);
  part.faces = faces;
  part.summary.seconds_hierarchy *= share;
  part.summary.seconds_parameterize *= share;
  chart.summary.flips = chart.summary.moved_vertices = 0;
  return part;
}

// Divides the charts that have a map, so that they fill the square better, and keeps the summary up to date.
inline void divide_charts_and_tell(Atlas& atlas, std::vector<bool>& has_map, const Pack_options& pack_options,
                                   double least_used_part, Atlas_summary& result)
{
  Division_options options;
  options.least_used_part = least_used_part;
  const std::vector<std::size_t> chart_before = divide_charts(atlas, has_map, pack_options, options);
  if (atlas.charts.size() == result.charts.size())
    return;
  result.divisions += atlas.charts.size() - result.charts.size();
  result.chart_of_face = chart_of_face(atlas);
  const std::vector<bool> old_has_map = std::move(has_map);
  std::vector<Atlas_summary::Chart> old_charts = std::move(result.charts);
  has_map.clear();
  result.charts.clear();
  for (std::size_t i = 0; i < atlas.charts.size(); ++i) {
    const std::size_t old = chart_before[i];
    has_map.push_back(old_has_map[old]);
    result.charts.push_back(take_part(old_charts[old], atlas.charts[i].size()));
  }
}

// The area that charts with a map cover in the plane, without virtual faces.
inline double area_of_surface(const Atlas& atlas, const std::vector<bool>& has_map)
{
  double sum = 0;
  for (std::size_t i = 0; i < atlas.charts.size(); ++i)
    for (const Index f : atlas.charts[i])
      if (has_map[i] && f < atlas.number_of_faces())
        sum += 0.5 * std::abs(doubled_area(atlas.uv[atlas.mesh.vertex[3 * f]], atlas.uv[atlas.mesh.vertex[3 * f + 1]],
                                           atlas.uv[atlas.mesh.vertex[3 * f + 2]]));
  return sum;
}

// Packs the charts that have a map. Those that have none afterwards, as rounding left no room for it, are told.
inline void pack(Atlas& atlas, std::vector<bool>& has_map, const Pack_options& options, Round_coordinate round,
                 Atlas_summary& result)
{
  const std::vector<bool> had_map = has_map;
  const Packing packing = pack_atlas(atlas, has_map, options, round);
  if (packing.side == 0)
    has_map.assign(has_map.size(), false);
  else
    result.used_part = area_of_surface(atlas, has_map) / (packing.side * packing.side);
  for (std::size_t i = 0; i < has_map.size(); ++i)
    if (had_map[i] && !has_map[i]) {
      Parameterization_error& error = result.charts[i].summary.error;
      error = error_of_packing(packing, { round, atlas.scale_exponent }, atlas.charts[i].front());
      if (result.is_ok())
        result.error = error;
    }
}

// Opens the holes in what is told, without the virtual faces. A chart that is joined only across holes becomes several,
// and one of nothing but virtual faces is none.
inline void open_holes(const Atlas& atlas, Atlas_summary& result)
{
  if (!atlas.has_closed_holes())
    return;
  std::vector<Atlas_summary::Chart> old_charts = std::move(result.charts);
  const std::vector<std::size_t> old_chart_of_face = std::move(result.chart_of_face);
  const std::vector<std::vector<Index>> pieces = connected_components(atlas.surface());
  result.charts.clear();
  result.chart_of_face.assign(atlas.number_of_faces(), 0);
  for (const std::vector<Index>& faces : pieces) {
    for (const Index f : faces)
      result.chart_of_face[f] = result.charts.size();
    result.charts.push_back(take_part(old_charts[old_chart_of_face[faces.front()]], faces.size()));
    Parameterization_error& error = result.charts.back().summary.error;
    if (error.place == Parameterization_error::FACE &&
        !std::binary_search(faces.begin(), faces.end(), Index(error.index)))
      error.index = faces.front();
  }
  if (result.error.place == Parameterization_error::FACE) {
    const auto failed = std::find_if(result.charts.begin(), result.charts.end(),
                                     [](const Atlas_summary::Chart& chart) { return !chart.summary.is_ok(); });
    result.error = failed == result.charts.end() ? Parameterization_error() : failed->summary.error;
  }
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_STEPS_H
