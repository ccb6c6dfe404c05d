// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The connected components of a surface.

#ifndef COMPONENTS_H
#define COMPONENTS_H

#include "Mesh.h"

#include <cstddef>
#include <vector>

struct Component
{
  std::vector<Mesh::Face_index> faces;      // in the order of the mesh
  std::size_t number_of_borders = 0;
  std::size_t number_of_handles = 0;

  bool needs_cut() const { return number_of_borders == 0 || number_of_handles > 0; }
};

// The number of the component of each face; they are numbered by their first faces.
std::vector<std::size_t> number_components(const Mesh& mesh);

// In that order.
std::vector<Component> find_components(const Mesh& mesh);

// Some faces of a mesh as a mesh of its own. Faces and their corners keep their order.
Mesh mesh_of(const Mesh& mesh, const std::vector<Mesh::Face_index>& faces);

#endif // COMPONENTS_H
