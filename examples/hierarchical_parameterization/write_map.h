// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes maps.

#ifndef WRITE_MAP_H
#define WRITE_MAP_H

#include <cstddef>
#include <string>

class Output_files;
struct Input;

// Writes the mesh with its map: as PLY, which may be binary, or as glTF if the name says so, otherwise as OBJ. Returns
// how many triangles of the map the rounding to floats has spoilt, in glTF.
std::size_t write_mesh(Output_files& files, const std::string& name, bool is_binary, Input& input);

// Draws the map as SVG.
void write_picture(Output_files& files, const std::string& name, const Input& input);

#endif // WRITE_MAP_H
