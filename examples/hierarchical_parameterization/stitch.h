// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces whose points are there several times.

#ifndef STITCH_H
#define STITCH_H

#include "Mesh.h"

#include <cstddef>

// Joins border edges of a triangle mesh that have the same two end points, exactly, and opposite directions; not where
// three or more coincide. Faces and their corners keep their order, and so do the vertices that are left: of those that
// are joined, the first one.
void stitch(Mesh& mesh);

// How many components have a border edge whose end points are those of a border edge of another component. stitch()
// joins the two if they have opposite directions and there is no third one.
std::size_t number_of_separate_pieces(const Mesh& mesh);

#endif // STITCH_H
