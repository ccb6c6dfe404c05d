// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_GRID_PACKER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_GRID_PACKER_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Chart_mask.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Flat_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Strip.h>

#include <cstddef>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Charts on one grid, each in some directions.
class Grid_packer
{
public:
  // Which directions of a chart are tried.
  struct Directions
  {
    // Whether each one is tried from where charts of about that size fitted last in it. If not, all are tried from the
    // same row: that passes over most of them for good, and takes a third of the time.
    bool have_own_rows = true;
    std::size_t step = 1;                       // from one to the next
  };

  // In which order charts are put, and how wide the strip is.
  struct Plan
  {
    std::vector<std::size_t> order;
    std::size_t width;
    Directions directions = Directions();
    std::vector<Strip::Place> places = {};      // of the first charts, in their first direction, if they fit there
  };

  struct Result
  {
    std::size_t side = (std::numeric_limits<std::size_t>::max)();       // of the square, with half the margin around
    std::size_t top = 0;                        // the height of the strip
    std::vector<Strip::Place> places;           // of the charts
    std::vector<std::size_t> directions;        // of the charts: the number of the one that was taken
  };

  // Charts that are turned by the angles whose cosines and sines are the coordinates of vectors. Between charts so many
  // cells stay empty.
  Grid_packer(const std::vector<Flat_chart>& charts, const std::vector<std::vector<Vector_2>>& directions, double cell,
              std::size_t margin);

  std::size_t number_of_charts() const { return m_masks.size(); }

  // The charts that are large first; long ones are large.
  std::vector<std::size_t> order_by_size() const;

  // The least width that holds every chart.
  std::size_t least_width() const;

  // Packs the charts of a plan; gives up when the square cannot become smaller than `most_side`.
  Result pack(const Plan& plan, std::size_t most_side = (std::numeric_limits<std::size_t>::max)());

private:
  // Where charts of about a size begin to fit, about; in each direction they fit elsewhere.
  typedef std::map<std::tuple<int, int, std::size_t>, std::size_t>   First_rows;

  struct Choice
  {
    std::size_t direction = 0;
    Strip::Place place;
  };

  // The lowest place for a chart in any of the directions; nowhere if none ends below `most_top`.
  Choice find(std::size_t chart, const Directions& directions, std::size_t most_top, First_rows& first_rows);

  std::vector<std::vector<Chart_mask>> m_masks;         // of each chart, in its directions
  std::size_t m_margin;
  Strip m_strip;                                        // of the last packing
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/pack/Grid_packer_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_GRID_PACKER_H
