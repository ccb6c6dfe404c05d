// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INPUT_SURFACE_H
#define INPUT_SURFACE_H

#include "face_mesh.h"

#include <CGAL/Surface_mesh/IO/OFF.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <array>
#include <iostream>

// What the small examples run on: the component with the longest border of an OFF file, or the face if `file` is null.
// Returns whether there is one, and else tells why not.
template <class Mesh>
bool read_surface_with_border(const char* file, Mesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  if (file == nullptr) {
    make_face(mesh);
    return true;
  }
  if (!CGAL::IO::read_OFF(file, mesh)) {
    std::cerr << file << ": cannot be read as an OFF file of a manifold surface\n";
    return false;
  }
  const auto border = PMP::longest_border(mesh).first;
  if (border == Mesh::null_halfedge()) {
    std::cerr << file << ": the surface has no border\n";
    return false;
  }
  PMP::keep_connected_components(mesh, std::array{ mesh.face(mesh.opposite(border)) });
  mesh.collect_garbage();
  return true;
}

#endif // INPUT_SURFACE_H
