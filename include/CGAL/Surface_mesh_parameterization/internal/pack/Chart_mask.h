// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_CHART_MASK_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_CHART_MASK_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Bitmap.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Flat_chart.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The cells that a chart takes on a grid, as squares whose sides are powers of two. They may overlap. The largest ones
// come first: where these do not fit, the others need no look.
struct Chart_mask
{
  struct Square
  {
    Index x, y;                   // its corner next to the origin
    unsigned int level;           // its side is 2^level
  };

  Index width = 0, height = 0;
  std::vector<Square> squares;

  // The least number above those of the squares.
  unsigned int number_of_levels() const { return squares.front().level + 1; }
};

// The cells that triangles of a chart meet, or nearly so. No point has a negative coordinate.
Bitmap rasterize(const Flat_chart& chart, double cell);

// Squares that cover just the cells that are taken.
Chart_mask make_mask(const Bitmap& cells);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/pack/Chart_mask_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_CHART_MASK_H
