// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices that keep their places.

#ifndef HELD_VERTICES_H
#define HELD_VERTICES_H

#include <string>

struct Input;

// Reads which vertices of the one chart of an input are held, and where, into its is_held and uvmap. The file has lines
// of three numbers: a vertex of the input, from 0, and its coordinates in the plane. Lines that are empty or begin with
// # are left out. Throws an Input_error.
void read_held_vertices(const std::string& file, Input& input);

#endif // HELD_VERTICES_H
