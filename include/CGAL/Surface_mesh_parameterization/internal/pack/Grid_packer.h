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
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Charts on one grid, each in some directions.
class Grid_packer
{
public:
  // In which order charts are put, and how wide the strip is.
  struct Plan
  {
    std::vector<std::size_t> order;
    std::size_t width;
    // Whether each direction is tried from where charts of about that size fitted last in it. If not, all of a chart's
    // are tried from the same row: that passes over most directions for good, and takes a third of the time.
    bool tries_each_direction = true;
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
  Result pack(const Plan& plan, std::size_t most_side = (std::numeric_limits<std::size_t>::max)()) const;

private:
  std::vector<std::vector<Chart_mask>> m_masks;         // of each chart, in its directions
  std::size_t m_margin;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/pack/Grid_packer_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_GRID_PACKER_H
