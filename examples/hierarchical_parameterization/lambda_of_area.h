// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef LAMBDA_OF_AREA_H
#define LAMBDA_OF_AREA_H

#include "Mesh.h"

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <limits>

// The lambda of arap for some faces of a mesh: CGAL's default for a surface of area 1, times the area. So the map does
// not depend on the unit of the lengths. Where doubles cannot hold areas, or their squares, no change of scale is
// allowed.
template <class FaceRange>
double lambda_of_area(const FaceRange& faces, const Mesh& mesh)
{
  constexpr double lambda_of_unit_area = 1000;
  const double lambda = lambda_of_unit_area * CGAL::Polygon_mesh_processing::area(faces, mesh);
  return lambda > 0 ? lambda : std::numeric_limits<double>::infinity();
}

#endif // LAMBDA_OF_AREA_H
