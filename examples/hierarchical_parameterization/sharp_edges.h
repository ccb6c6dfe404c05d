// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seams along sharp edges.

#ifndef SHARP_EDGES_H
#define SHARP_EDGES_H

#include "Mesh.h"

// Parts the surface into regions along the edges at which it turns by at least so many degrees, and makes seams of the
// edges between different regions: a sharp edge that ends inside a region is none.
void part_at_sharp_edges(Mesh& mesh, double angle, Seam_map seams);

#endif // SHARP_EDGES_H
