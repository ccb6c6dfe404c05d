// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_DIVIDE_CHARTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_DIVIDE_CHARTS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/pack_charts.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

struct Division_options
{
  double least_used_part = 0;               // of the square: the aim
  std::size_t most_divisions = 50;
  std::size_t most_packings = 10;           // to see how much is used
  std::size_t most_trials = 200;            // of each packing
  std::size_t most_charts = 200;            // of an atlas: if there are more, no single one leaves much empty
  // What charts have to cover of the boxes around them before they are packed, in parts of `least_used_part`; and
  // absolutely, if that is less.
  double least_part_of_boxes = 0.9, greatest_part_of_boxes = 0.7;

  // A cut. Areas are relative to that of all charts, lengths to the root of that.
  std::size_t most_places = 200;            // on the border of a chart, between which cuts are tried
  double least_part_of_chart = 0.02;        // the area on each side, relative to the chart
  double least_gain = 0.005;                // of the area of boxes
  double cost_of_length = 0.2;              // the area that a cut of length 1 has to gain
  double greatest_length = 1.2;             // of a box, in sides of the square: longer ones should be cut

  // When no cut gains more than it costs, cost and length change by these factors, so many times.
  std::size_t most_changes = 4;
  double change_of_cost = 0.5, change_of_length = 0.9;
  // Then, so many times, a part is cut although that makes boxes no smaller, since further cuts may, as of a frame.
  std::size_t most_losses = 8;
  double least_part_at_loss = 0.3;          // the area on each side, relative to what the outer border encloses
  double least_growth_at_loss = 0.01;       // of the used part by each cut
};

// Divides charts of an atlas that have a map until they fill the square well enough if they are packed as the options
// say, or as well as they did in any try. Returns of which chart each one was a part.
//
// A cut is nearly straight in the plane, from one vertex of a chart's outer border to another, and chosen so that the
// boxes around both sides are small and fit in the square, and the cut is short; where none makes boxes smaller, one
// through the part with the emptiest box. The map stays, but each part is scaled to its area in space.
std::vector<std::size_t> divide_charts(Atlas& atlas, const std::vector<bool>& has_map, const Pack_options& pack_options,
                                       const Division_options& options);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/pack/divide_charts_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_DIVIDE_CHARTS_H
