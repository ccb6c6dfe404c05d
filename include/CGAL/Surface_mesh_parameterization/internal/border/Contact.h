// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_CONTACT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_CONTACT_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <array>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Three border vertices that an energy of one number, their distance or angle, keeps from meeting: the gradients of
// that number, and the energy's first and second derivative by it.
struct Contact
{
  std::array<Index, 3> vertices;
  std::array<Block_vector, 3> gradients;
  double first, second;
};

typedef std::vector<Contact>   Contacts;

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_CONTACT_H
