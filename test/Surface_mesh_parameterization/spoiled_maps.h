// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPOILED_MAPS_H
#define SPOILED_MAPS_H

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "one_to_one_maps.h"
#include "test_meshes.h"

#include <cstddef>
#include <vector>

// Maps that have lost some of their places.
namespace one_to_one {

inline std::size_t number_of_changes_since(const Points& before, const Mapped_mesh& m)
{
  std::size_t result = 0;
  for (const auto v : vertices(m.mesh))
    result += m.uvmap[v] != before[v];
  return result;
}

// The plane's map of a grid, in which some vertices have lost their places.
struct Spoiled_map : Mapped_mesh_with_border
{
  std::vector<Kernel::Point_2> good;

  Spoiled_map() : Mapped_mesh_with_border(grid(24, 20, wavy))
  {
    project();
    good = uv();
  }

  std::size_t number_of_changes() const { return number_of_changes_since(good, *this); }
};

} // namespace one_to_one

#endif // SPOILED_MAPS_H
