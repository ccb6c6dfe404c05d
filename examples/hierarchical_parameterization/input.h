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

// All of the named file. Throws an Input_error.
std::string read_content(const std::string& file, bool may_be_empty = false);

struct Soup_options
{
  bool is_triangulated = false;          // polygons are cut into triangles
  bool is_oriented = false;              // faces are turned, points doubled where that does not make a surface, and
                                         // corners left out that repeat the one before
  bool is_stitched = false;              // borders that coincide are joined
};

// Makes the mesh as it is but for the options: vertices that coincide stay apart, but in STL. The number of faces
// that were left out, as they have less than three vertices, is added to `left_out` unless that is null.
Mesh make_mesh(Polygon_soup soup, const Soup_options& options, std::size_t* left_out = nullptr);

// The mesh of the named file, or of the standard input for "-". Throws an Input_error.
Mesh read_mesh(const std::string& file, const Soup_options& options, std::size_t* left_out = nullptr);

// Without a file: see face_mesh.h.
Mesh built_in_face();

// What of a file is parameterized.
struct Input_options : Soup_options
{
  bool takes_all_components = false;     // or the one with the most faces
  bool cuts = false;                     // components that are closed or have handles
  bool makes_atlas = false;              // even of one component that needs no cut
};

// A mesh, and the part of it that is parameterized: as one chart, whose map gives the vertices places, or as an atlas,
// whose map gives the corners of the faces places.
struct Input
{
  std::string name;
  Mesh mesh;
  std::vector<Mesh::Face_index> faces;     // that are parameterized
  bool is_atlas = false;
  Mesh::Halfedge_index border;             // of one chart: on its longest border
  UV_map uvmap;                            // of one chart; a method fills it in
  Held_map is_held;                        // of one chart: vertices that keep their places in uvmap
  Corner_map corner_map;                   // of an atlas; no corner of a face that has no map has a finite place
  std::size_t number_of_borders = 0;       // of the part, before it is cut
  std::size_t number_of_components = 0;    // of the mesh
  std::size_t collapsed_faces = 0;         // that the mesh does not have, as they have less than three vertices
  std::size_t number_of_pieces = 0;        // components that is_stitched would join with others, or could not
  std::vector<Mesh::Face_index> left_out;  // a face of each component that would have to be cut, but may not be
};

// Whether each vertex is one of the faces that are parameterized.
std::vector<bool> vertices_of_faces(const Input& input);

// Takes the component with the most faces as one chart. Throws an Input_error if it would have to be cut.
void choose_component(Input& input);

// The named file, the standard input, or the built-in face if there is no name. One component that needs no cut becomes
// one chart, unless the options make it an atlas. Throws an Input_error.
void read_input(const std::string& file, const Input_options& options, Input& input);

// Reads the places of the input's vertices into its uvmap: from PLY with the vertex properties u and v, or s and t, or
// from OBJ with texture coordinates that do not differ at the corners of a vertex.
void read_start(const std::string& file, Input& input);

#endif // INPUT_H
