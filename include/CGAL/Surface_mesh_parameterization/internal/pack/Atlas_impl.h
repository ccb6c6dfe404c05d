// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/turn_chart.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

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
std::vector<std::size_t> chart_of_face(const Atlas& atlas)
{
  std::vector<std::size_t> result(atlas.mesh.number_of_faces());
  for (std::size_t i = 0; i < atlas.charts.size(); ++i)
    for (const Index f : atlas.charts[i])
      result[f] = i;
  return result;
}

// Scales the map of a chart so that triangles stay positive.
inline void scale_map(const Corner_mesh& chart, double scale, std::vector<Point_2>& uv)
{
  const std::vector<Index_triangle> triangles = triangles_of(chart);
  const auto is_good = [&](const std::vector<Point_2>& result) {
    return is_positive({ result, triangles }) || !is_positive({ uv, triangles });
  };
  scale_map(scale, is_good, uv);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double area_in_plane(const Corner_mesh& mesh, const std::vector<Point_2>& uv)
{
  double area = 0;
  for (const Index_triangle& t : triangles_of(mesh))
    area += 0.5 * std::abs(doubled_area(uv[t[0]], uv[t[1]], uv[t[2]]));
  return area;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool scale_to_area_in_space(const Corner_mesh& chart, std::vector<Point_2>& uv)
{
  double area_in_space = 0;
  for (Index f = 0; f < chart.number_of_faces(); ++f)
    area_in_space += area_of_face(chart, f);
  const double scale = std::sqrt(area_in_space / area_in_plane(chart, uv));
  if (!(std::isfinite(scale) && scale > 0))
    return false;
  scale_map(chart, scale, uv);
  return true;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void scale_to_size_in_space(const Corner_mesh& chart, std::vector<Point_2>& uv)
{
  constexpr double least_size = 1e-6;
  CGAL::Bbox_3 box;
  for (const Point_3& p : chart.points)
    box += p.bbox();
  if (const double size = half_width_of(box_of(uv)); size > 0)
    scale_map(chart, (std::max)(least_size, half_width_of(box)) / size, uv);
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
void set_map(Atlas& atlas, const std::vector<Index>& faces, const std::vector<Point_2>& uv)
{
  const std::vector<Index> vertices = vertices_of(atlas.mesh, faces);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    atlas.uv[vertices[i]] = uv[i];
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Flat_chart chart_of(const Corner_mesh& mesh, std::vector<Point_2> uv)
{
  return { std::move(uv), triangles_of(mesh) };
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

inline bool are_within(const std::vector<Point_2>& points, const std::vector<Point_2>& others, double distance)
{
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!((points[i] - others[i]).squared_length() <= distance * distance))
      return false;
  return true;
}

// Whether the wanted charts lie in a square, and do not overlap.
inline bool are_apart(const Atlas& atlas, const std::vector<bool>& is_wanted, double side)
{
  std::vector<Border_edge> edges;
  std::vector<Index> chart_of_edge;
  Index number_of_charts = 0;
  for (std::size_t i = 0; i < atlas.charts.size(); ++i)
    if (is_wanted[i]) {
      for (const Index f : atlas.charts[i])
        for (Index h = 3 * f; h < 3 * f + 3; ++h)
          if (atlas.mesh.is_border(h)) {
            const Point_2& p = atlas.uv[atlas.mesh.target(h)];
            if (!(p.x() > 0 && p.y() > 0 && p.x() < side && p.y() < side))
              return false;
            edges.push_back({ atlas.mesh.source(h), atlas.mesh.target(h) });
            chart_of_edge.push_back(number_of_charts);
          }
      ++number_of_charts;
    }
  return are_charts_apart(edges, chart_of_edge, atlas.uv);
}

// How triangles of a chart are turned.
enum class Chart_sign { POSITIVE, MIRRORED, MIXED };

inline Chart_sign sign_of(const Flat_chart& chart)
{
  return is_positive(chart) ? Chart_sign::POSITIVE : is_mirrored(chart) ? Chart_sign::MIRRORED : Chart_sign::MIXED;
}

// Rounds the places of a chart without flips, whose shape is that in the atlas times a scale, so that it keeps none and
// its borders do not meet. Returns whether it could.
inline bool round_without_flips(Flat_chart& chart, std::vector<Point_2> shape, double scale, Chart_sign sign,
                                double most_size, const Rounding& round,
                                Function_ref<Triangulated_surface_3()> make_surface)
{
  if (sign == Chart_sign::MIRRORED) {
    mirror(chart.points);
    mirror(shape);
  }
  const bool is_rounded = round_chart(chart, scaled(shape, scale), most_size, round, make_surface) &&
                          part_borders(chart, shape, round);
  if (sign == Chart_sign::MIRRORED)
    mirror(chart.points);
  return is_rounded;
}

// Packs charts, each at its rounded places. `strayed` are those that had to be changed so much for this that they may
// meet others or leave the square.
inline Packing place_charts(Atlas& atlas, std::vector<bool>& is_wanted, const Pack_options& options,
                            Round_coordinate round_coordinate, std::vector<std::size_t>& strayed)
{
  std::vector<Flat_chart> charts;
  std::vector<Index> scratch(atlas.mesh.number_of_vertices(), no_index);
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < atlas.charts.size(); ++i)
    if (is_wanted[i]) {
      charts.push_back(chart_of(component_of(atlas.mesh, atlas.charts[i], scratch), map_of(atlas, atlas.charts[i])));
      numbers.push_back(i);
    }
  std::vector<Chart_sign> signs;
  for (const Flat_chart& chart : charts)
    signs.push_back(sign_of(chart));
  Packing packing = pack_charts(charts, options);
  if (packing.side == 0)
    return packing;
  const double scale = options.fills_unit_square ? 1 / packing.side : 1;
  if (options.fills_unit_square)
    atlas.scale_exponent = 0;
  const Rounding round{ round_coordinate, atlas.scale_exponent };
  packing.side *= scale;
  packing.distance *= scale;
  if (!is_finite(round(Point_2(packing.side, packing.side)))) {
    is_wanted.assign(is_wanted.size(), false);
    return packing;
  }

  const double most_distance = 0.25 * packing.distance;         // two charts may come nearer to each other
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const std::size_t number = numbers[i];
    const std::vector<Index>& faces = atlas.charts[number];
    Flat_chart& chart = charts[i];
    chart.points = scaled(std::move(chart.points), scale);
    const std::vector<Point_2> exact = chart.points;
    if (signs[i] != Chart_sign::MIXED) {
      is_wanted[number] =
          round_without_flips(chart, map_of(atlas, faces), scale, signs[i], most_distance, round,
                              [&] { return surface_of(component_of(atlas.mesh, faces, scratch)); });
      if (is_wanted[number] && !are_within(chart.points, exact, most_distance))
        strayed.push_back(number);
    } else
      for (Point_2& p : chart.points)
        p = round(p);
    set_map(atlas, faces, chart.points);
  }
  return packing;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Packing pack_atlas(Atlas& atlas, std::vector<bool>& is_wanted, const Pack_options& options, Round_coordinate round)
{
  constexpr int most_attempts = 3;      // a chart that strayed is packed again as it is now
  for (int i = 1;; ++i) {
    std::vector<std::size_t> strayed;
    const Packing packing = place_charts(atlas, is_wanted, options, round, strayed);
    if (strayed.empty() || are_apart(atlas, is_wanted, packing.side))
      return packing;
    if (i == most_attempts) {
      for (const std::size_t number : strayed)
        is_wanted[number] = false;
      return packing;
    }
  }
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Parameterization_error error_of_packing(const Packing& packing, const Rounding& round, Index first_face)
{
  if (!is_finite(round(Point_2(packing.side, packing.side))))
    return { ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0, cause_of_overflow };
  return { ERROR_NO_1_TO_1_MAPPING, Parameterization_error::FACE, first_face,
           packing.side == 0 ? "the charts have no area" : cause_of_lost_chart };
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_IMPL_H
