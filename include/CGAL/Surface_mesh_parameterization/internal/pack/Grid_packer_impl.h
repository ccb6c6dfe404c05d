// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_GRID_PACKER_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_GRID_PACKER_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/pack/Grid_packer.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/turn_chart.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Grid_packer::Grid_packer(const std::vector<Flat_chart>& charts, const std::vector<std::vector<Vector_2>>& directions,
                         double cell, std::size_t margin)
  : m_masks(charts.size()), m_margin(margin), m_strip(margin)
{
  Flat_chart turned;
  for (std::size_t i = 0; i < charts.size(); ++i)
    for (const Vector_2& direction : directions[i]) {
      turned = charts[i];
      turn_and_move(turned.points, direction, Vector_2(0, 0));
      m_masks[i].push_back(make_mask(rasterize(turned, cell)));
    }
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<std::size_t> Grid_packer::order_by_size() const
{
  std::vector<std::size_t> sizes, order(m_masks.size());
  for (const std::vector<Chart_mask>& masks : m_masks) {
    const std::size_t width = masks[0].width, height = masks[0].height, longest = (std::max)(width, height);
    sizes.push_back(longest * longest + width * height);
  }
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  return order;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::size_t Grid_packer::least_width() const
{
  Index result = 0;
  for (const std::vector<Chart_mask>& masks : m_masks) {
    Index least = (std::numeric_limits<Index>::max)();
    for (const Chart_mask& mask : masks)
      least = (std::min)(least, mask.width);
    result = (std::max)(result, least);
  }
  return result;
}

inline int size_class(Index length) { return int(4 * std::log2(double(length))); }

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Grid_packer::Choice Grid_packer::find(std::size_t chart, const Directions& directions, std::size_t most_top,
                                      First_rows& first_rows)
{
  Choice best;
  for (std::size_t i = 0; i < m_masks[chart].size(); i += directions.step) {
    const Chart_mask& mask = m_masks[chart][i];
    std::size_t& first_row =
        first_rows[{ size_class(mask.width), size_class(mask.height), directions.have_own_rows ? i : 0 }];
    if (const Strip::Place place = m_strip.find(mask, first_row, most_top); place.top < most_top) {
      best = { i, place };
      most_top = place.top;
    }
  }
  return best;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Grid_packer::Result Grid_packer::pack(const Plan& plan, std::size_t most_side)
{
  std::vector<unsigned int> levels(plan.order.size() + 1, 1);        // of the masks from there on
  for (std::size_t i = plan.order.size(); i-- > 0;) {
    levels[i] = levels[i + 1];
    for (const Chart_mask& mask : m_masks[plan.order[i]])
      levels[i] = (std::max)(levels[i], mask.number_of_levels());
  }

  Result result;
  result.places.resize(m_masks.size());
  result.directions.resize(m_masks.size());
  m_strip.start(plan.width, levels[0]);
  std::size_t right = 0;
  First_rows first_rows;
  for (std::size_t i = 0; i < plan.order.size(); ++i) {
    const std::size_t chart = plan.order[i];
    Choice choice;
    if (i < plan.places.size() && m_strip.fits(m_masks[chart][0], plan.places[i])) {
      choice.place = plan.places[i];
      choice.place.top = choice.place.y + m_masks[chart][0].height;
    } else
      choice = find(chart, plan.directions, most_side, first_rows);
    if (choice.place.top >= most_side)
      return {};
    const Chart_mask& mask = m_masks[chart][choice.direction];
    result.places[chart] = choice.place;
    result.directions[chart] = choice.direction;
    result.top = (std::max)(result.top, choice.place.top);
    right = (std::max)(right, choice.place.x + mask.width);
    if (i + 1 < plan.order.size())
      m_strip.put(mask, choice.place, levels[i + 1]);
  }
  result.side = (std::max)(right, result.top) + m_margin;
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_GRID_PACKER_IMPL_H
