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
  double least_used_part = 0;               // of the square, up to which charts are divided
  std::size_t most_divisions = 50;
  std::size_t most_packings = 10, most_trials = 200;        // to see how much is used
  std::size_t most_charts = 200;            // more are not divided: no single one leaves much empty
  std::size_t most_places = 200;            // on the border of a chart, between which cuts are tried
  double least_part_of_chart = 0.02;        // on each side of a cut
  double least_gain = 0.005;                // of the area of all charts: by how much boxes around charts become smaller
  double cost_of_length = 0.2;              // of a cut as long as the root of that area, as a part of that area
  double greatest_length = 1.2;             // of a box, of the side of the square; longer ones should be cut
  // When no cut gains more than it costs, both become less, so often and by these factors.
  std::size_t most_changes = 4;
  double change_of_cost = 0.5, change_of_length = 0.9;
  // Then, so often, a part is cut although that makes boxes no smaller, since further cuts may, as of a frame. Of what
  // the part's outer border encloses so much is left on each side, and what is used has to grow by so much for a cut.
  std::size_t most_losses = 8;
  double least_part_at_loss = 0.3, least_growth_at_loss = 0.01;
  // What charts cover of the boxes around them before they are packed, as a part of `least_used_part`, and no more.
  double least_part_of_boxes = 0.9, greatest_part_of_boxes = 0.7;
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
