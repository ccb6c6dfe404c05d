// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is parameterized.

#ifndef INPUT_H
#define INPUT_H

#include "Mesh.h"
#include "errors.h"

#include <cstddef>
#include <string>
#include <vector>

struct Polygon_soup;

// Makes the mesh as it is: vertices that coincide stay apart, but in STL. With `is_triangulated`, polygons are
// cut into triangles.
Mesh make_mesh(Polygon_soup soup, bool is_triangulated);

// The mesh of the named file, or of the standard input for "-". Throws an Input_error.
Mesh read_mesh(const std::string& file, bool is_triangulated);

// Without a file: see face_mesh.h.
Mesh built_in_face();

// A mesh, and the part of it that is parameterized: its largest component.
struct Input
{
  std::string name;
  Mesh mesh;
  std::vector<Mesh::Face_index> faces;     // of the largest component
  Mesh::Halfedge_index border;             // on its longest border
  UV_map uvmap;                            // of the vertices; a method fills it in
  std::size_t number_of_borders = 0;
  std::size_t number_of_components = 0;
};

// Finds the component with the most faces and its borders.
void choose_component(Input& input);

// The named file, the standard input, or the built-in face if there is no name. Throws an Input_error.
void read_input(const std::string& file, bool is_triangulated, Input& input);

// Reads the places of the input's vertices into its uvmap: from PLY with the vertex properties u and v, or s and t, or
// from OBJ with texture coordinates that do not differ at the corners of a vertex.
void read_start(const std::string& file, Input& input);

#endif // INPUT_H
