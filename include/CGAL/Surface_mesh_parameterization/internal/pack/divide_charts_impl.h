// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_DIVIDE_CHARTS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_DIVIDE_CHARTS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Run_watch.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Chart_part.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Flat_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/best_chord.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/divide_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Plane_path.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/turn_chart.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A chart, or a part of one, and what another cut would do.
struct Divided_part : Chart_part
{
  double box = 0;                           // the area that the least box around it takes
  Index start = no_index, goal = no_index;  // between which the best cut leads; `no_index` if there is none
  double gain = 0;                          // of that cut; 0 if it is not worth it
};

class Chart_divider
{
public:
  Chart_divider(const Atlas& atlas, const std::vector<bool>& has_map, const Pack_options& pack_options,
                const Division_options& options)
    : m_pack_options(pack_options), m_options(options)
  {
    m_pack_options.most_trials = options.most_trials;
    std::vector<Index> scratch(atlas.mesh.number_of_vertices(), no_index);
    for (std::size_t i = 0; i < atlas.charts.size(); ++i)
      if (has_map[i]) {
        Divided_part& part = m_parts.emplace_back();
        part.faces = atlas.charts[i];
        part.mesh = component_of(atlas.mesh, part.faces, scratch);
        part.uv = map_of(atlas, part.faces);
        m_area += area_in_plane(part.mesh, part.uv);
      }
  }

  void run()
  {
    if (find_used_part(m_pack_options.hasty()) >= m_options.least_used_part)
      return;
    double used_part = find_used_part(m_pack_options);
    if (used_part >= m_options.least_used_part || would_fill_square_by_default())
      return;
    for (Divided_part& part : m_parts)
      find_cut(part);
    std::vector<Divided_part> best_parts = m_parts;
    std::size_t best_size_of_seam = 0, divisions = 0;
    for (std::size_t packings = 1; packings < m_options.most_packings && divide_until_boxes_are_full(); ++packings) {
      const double other = find_used_part(m_pack_options);
      const double least_growth = m_losses > 0 ? m_options.least_growth_at_loss * double(m_divisions - divisions) : 0;
      if (other > (1 + least_growth) * used_part) {
        divisions = m_divisions;
        used_part = other;
        best_parts = m_parts;
        best_size_of_seam = m_seam.size();
      }
      if (used_part >= m_options.least_used_part)
        break;
    }
    m_parts = std::move(best_parts);
    m_seam.resize(best_size_of_seam);
  }

  const std::vector<Divided_part>& parts() const { return m_parts; }
  const std::vector<Index>& seam() const { return m_seam; }

private:
  double find_used_part(const Pack_options& options) const
  {
    std::vector<Flat_chart> charts;
    for (const Divided_part& part : m_parts)
      charts.push_back(chart_of(part.mesh, part.uv));
    return pack_charts(charts, options).used_part;
  }

  // Whether it is only margins wider than the default that leave the square empty: more charts have more of them.
  bool would_fill_square_by_default() const
  {
    const Pack_options defaults;
    if (m_pack_options.margin <= defaults.margin)
      return false;
    Pack_options narrow = m_pack_options;
    narrow.margin = defaults.margin;
    narrow.margin_of_chart = defaults.margin_of_chart;
    return find_used_part(narrow) >= m_options.least_used_part;
  }

  // Of what the boxes around all parts take, what the parts cover.
  double part_of_boxes() const
  {
    const auto add = [](double sum, const Divided_part& part) { return sum + part.box; };
    return m_area / std::accumulate(m_parts.begin(), m_parts.end(), 0., add);
  }

  // Where a part is to be cut.
  void find_cut(Divided_part& part) const
  {
    find_cut(part, m_options.least_part_of_chart * area_in_plane(part.mesh, part.uv));
    if (!(part.gain > m_options.least_gain * m_area))
      part.gain = 0;
  }

  // The same that leaves such an area of what the outer border encloses on each side, whatever that gains.
  void find_cut(Divided_part& part, double least_area) const
  {
    const std::vector<Index> border = outer_border(part.mesh, part.uv).halfedges;
    std::vector<Index> places;
    std::vector<Point_2> polygon;
    for (std::size_t i = 0; i < border.size(); i += border.size() / m_options.most_places + 1) {
      places.push_back(part.mesh.target(border[i]));
      polygon.push_back(part.uv[places.back()]);
    }
    const double side_of_square = m_greatest_length * std::sqrt(m_area / m_options.least_used_part);
    const Chord chord = best_chord(polygon, side_of_square, least_area, m_cost_of_length * std::sqrt(m_area));
    part.box = area_of_box(part.uv, side_of_square);
    part.gain = part.box - chord.cost;
    part.start = part.goal = no_index;
    if (std::isfinite(chord.cost)) {
      part.start = places[chord.begin];
      part.goal = places[chord.end];
    }
  }

  // Returns whether at least one part was divided.
  bool divide_until_boxes_are_full()
  {
    const std::size_t old_divisions = m_divisions;
    const double full = (std::min)(m_options.least_part_of_boxes * m_options.least_used_part,
                                   m_options.greatest_part_of_boxes);
    while (m_divisions < m_options.most_divisions && goes_on(m_pack_options.watch) && divide())
      if (part_of_boxes() >= full)
        break;
    return m_divisions > old_divisions;
  }

  // Makes the cut that gains most; where none is worth it, cuts may be longer and boxes shall be shorter. Returns
  // whether there is a cut.
  bool divide()
  {
    for (;;) {
      const auto gains_less = [](const Divided_part& a, const Divided_part& b) { return a.gain < b.gain; };
      const auto part = std::max_element(m_parts.begin(), m_parts.end(), gains_less);
      if (part != m_parts.end() && part->gain > 0) {
        if (divide(*part))
          return true;
        continue;
      }
      if (m_changes == m_options.most_changes)
        return divide_at_loss();
      ++m_changes;
      m_cost_of_length *= m_options.change_of_cost;
      m_greatest_length *= m_options.change_of_length;
      for (Divided_part& p : m_parts)
        find_cut(p);
    }
  }

  // Cuts the part whose box is emptiest, of those that can be cut. Returns whether there is one.
  bool divide_at_loss()
  {
    if (m_losses == m_options.most_losses)
      return false;
    ++m_losses;
    std::vector<std::pair<double, std::size_t>> parts;      // empty area and number
    for (std::size_t i = 0; i < m_parts.size(); ++i)
      parts.emplace_back(m_parts[i].box - area_in_plane(m_parts[i].mesh, m_parts[i].uv), i);
    std::sort(parts.rbegin(), parts.rend());
    return std::any_of(parts.begin(), parts.end(), [&](const auto& p) {
      Divided_part& part = m_parts[p.second];
      find_cut(part, m_options.least_part_at_loss * outer_border(part.mesh, part.uv).area);
      return part.start != no_index && divide(part);
    });
  }

  bool divide(Divided_part& part)
  {
    const std::vector<Index> cut = Plane_path(part.mesh, part.uv, part.start, part.goal).halfedges();
    std::vector<Divided_part> sides;
    for (Chart_part& side : sides_of(part, cut))
      static_cast<Chart_part&>(sides.emplace_back()) = std::move(side);
    if (sides.size() == 1) {
      part.gain = 0;
      return false;
    }
    ++m_divisions;
    for (const Index h : cut)
      if (!part.mesh.is_border(h))
        m_seam.push_back(part.halfedge_of_atlas(h));
    for (Divided_part& side : sides) {
      scale_to_area_in_space(side.mesh, side.uv);
      find_cut(side);
    }
    part = std::move(sides.front());
    m_parts.insert(m_parts.end(), std::make_move_iterator(sides.begin() + 1), std::make_move_iterator(sides.end()));
    return true;
  }

  Pack_options m_pack_options;
  const Division_options& m_options;
  std::vector<Divided_part> m_parts;
  double m_area = 0, m_cost_of_length = m_options.cost_of_length, m_greatest_length = m_options.greatest_length;
  std::size_t m_changes = 0, m_losses = 0;
  std::vector<Index> m_seam;
  std::size_t m_divisions = 0;
};

// The places of all corners, where those of some charts' parts have been changed.
inline std::vector<Point_2> corners_of(const Atlas& atlas, const std::vector<Divided_part>& parts)
{
  std::vector<Point_2> corners(atlas.mesh.number_of_halfedges());
  for (Index h = 0; h < atlas.mesh.number_of_halfedges(); ++h)
    corners[h] = atlas.uv[atlas.mesh.vertex[h]];
  for (const Divided_part& part : parts)
    for (Index h = 0; h < part.mesh.number_of_halfedges(); ++h)
      corners[part.halfedge_of_atlas(h)] = part.uv[part.mesh.vertex[h]];
  return corners;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<std::size_t> divide_charts(Atlas& atlas, const std::vector<bool>& has_map, const Pack_options& pack_options,
                                       const Division_options& options)
{
  std::vector<std::size_t> result(atlas.charts.size());
  std::iota(result.begin(), result.end(), std::size_t(0));
  if (atlas.charts.size() > options.most_charts)
    return result;
  Chart_divider divider(atlas, has_map, pack_options, options);
  divider.run();
  const std::vector<std::size_t> old_chart_of_face = chart_of_face(atlas);
  const std::vector<Point_2> corners = corners_of(atlas, divider.parts());
  for (const Index h : divider.seam())
    atlas.sever(h);
  split_charts(corners, atlas);
  result.clear();
  for (const std::vector<Index>& faces : atlas.charts)
    result.push_back(old_chart_of_face[faces.front()]);
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_DIVIDE_CHARTS_IMPL_H
