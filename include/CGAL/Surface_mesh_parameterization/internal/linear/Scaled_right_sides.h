// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SCALED_RIGHT_SIDES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SCALED_RIGHT_SIDES_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Values.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Right sides, each times its scale, as one vector of their values. Missing columns are 0.
template <int columns>
struct Scaled_right_sides
{
  const std::vector<const double*>& right_sides;
  Values<double, columns> scales;

  Values<double, columns> operator[](Index i) const
  {
    Values<double, columns> values = Values<double, columns>::zero();
    for (int c = 0; c < columns; ++c)
      if (std::size_t(c) < right_sides.size())
        values[c] = scales[c] * right_sides[c][i];
    return values;
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SCALED_RIGHT_SIDES_H
