// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PACK_CHARTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PACK_CHARTS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Flat_chart.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

class Run_watch;

struct Pack_options
{
  static constexpr double greatest_margin = 0.1, greatest_margin_of_chart = 0.25;

  double margin = 1. / 256;              // between charts, of the side of the square; half of it at the sides
  double margin_of_chart = 1. / 32;      // and no more, of the side of the n-th part of the square
  bool fills_unit_square = true;         // whether the square becomes the unit square
  std::size_t cells_of_chart = 128;      // a side of a chart of mean area has about so many cells of the grid
  std::size_t least_cells = 1024, most_cells = 6400;       // on a side of the square
  std::size_t most_widths = 8, most_placements = 5000;     // of strips that are tried, and of charts in all of them
  std::size_t most_trials = 1000;                          // of orders of large charts
  Run_watch* watch = nullptr;            // asks whether to go on trying; null if nobody does

  // The same for a packing that takes next to no time, and seldom fills more than the one with these options.
  Pack_options hasty() const
  {
    Pack_options result = *this;
    result.cells_of_chart = 32;
    result.least_cells = 256;
    result.most_widths = 2;
    result.most_trials = 0;
    return result;
  }

  bool is_valid() const { return margin >= 0 && margin <= greatest_margin; }
};

struct Packing
{
  double side = 0;              // of the square that holds all charts
  double used_part = 0;         // of its area
  double distance = 0;          // between charts, at least, and half of it to the sides of the square
};

// Moves and turns charts, so that they lie in a square with a corner at the origin, and do not meet.
//
// Charts are put one after the other, the largest first, each at about the lowest place where it fits, in one of four
// directions, on a grid whose cells are taken if a triangle meets them. Several widths are tried. Charts that are a
// great part of all are turned by more angles and tried in many orders, on a coarser grid.
Packing pack_charts(std::vector<Flat_chart>& charts, const Pack_options& options);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/pack/pack_charts_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PACK_CHARTS_H
