// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads meshes.

#ifndef READ_MESH_H
#define READ_MESH_H

#include "Mesh.h"
#include "errors.h"

#include <string>

struct Polygon_soup;

// Makes the mesh as it is: vertices that coincide stay apart, but in STL. With `is_triangulated`, polygons are cut into triangles.
Mesh make_mesh(Polygon_soup soup, bool is_triangulated);

// The mesh of the named file, or of the standard input for "-". Throws an Input_error.
Mesh read_mesh(const std::string& file, bool is_triangulated);

// Without a file: see face_mesh.h.
Mesh built_in_face();

#endif // READ_MESH_H
