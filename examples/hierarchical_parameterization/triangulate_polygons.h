// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TRIANGULATE_POLYGONS_H
#define TRIANGULATE_POLYGONS_H

#include "Polygon_soup.h"

// Puts triangles in the places of polygons: n - 2 for n corners, of the polygon's orientation. Throws an Input_error if
// there are more than 500 corners, and edges that cross or touch in the projection to the coordinate plane that shows
// the polygon largest. Precondition: the indices, coordinates and corners have been checked.
void triangulate_polygons(Polygon_soup& soup);

#endif // TRIANGULATE_POLYGONS_H
