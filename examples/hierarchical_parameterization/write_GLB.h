// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes glTF.

#ifndef WRITE_GLB_H
#define WRITE_GLB_H

#include "Mesh.h"

#include <cstddef>
#include <iosfwd>

// Whether the program was built with the library that does it.
bool can_write_GLB();

// Writes a mesh with its map as binary glTF 2.0. Vertices are split along seams, and those that belong to no face are
// left out. Coordinates are floats; along an axis on which the mesh is far from the origin, they are relative to the
// translation of its node. The origin of glTF's texture coordinates is the upper left corner, so that v becomes 1 - v.
// Faces with a corner without a finite place are a primitive without texture coordinates. Throws a std::runtime_error
// if a coordinate is too large for a float, or the mesh for the format. Returns how many triangles of the map are
// without area, there or in space, or turned over, in floats only.
std::size_t write_GLB(std::ostream& out, const Mesh& mesh, const Corner_map& corner_map);

#endif // WRITE_GLB_H
