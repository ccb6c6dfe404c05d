// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHIES_H
#define HIERARCHIES_H

#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Progressive_mesh_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

// Hierarchies of tiny meshes, and what is asked of them.
namespace test_meshes {

namespace parameters = CGAL::parameters;
using SMP::Collapse_hierarchy_3;
using SMP::Level;
using SMP::Progressive_mesh_3;

inline Collapse_hierarchy_3 small_hierarchy(const Flat_mesh& m, std::size_t coarsest_size = 6, unsigned int seed = 0)
{
  return Collapse_hierarchy_3(surface(m), parameters::coarsest_size(coarsest_size).random_seed(seed));
}

inline Collapse_hierarchy_3 hierarchy_of(const Flat_mesh& m)
{
  return Collapse_hierarchy_3(surface(m), parameters::coarsest_size(20));
}

inline std::vector<Index_triangle> triangles_of_level(const Collapse_hierarchy_3& hierarchy, std::size_t level)
{
  Progressive_mesh_3 mesh(hierarchy);
  mesh.walk_to_level(level);
  return mesh.triangles();
}

// Calls f(mesh, hierarchy) for every tiny mesh, with two seeds.
template <class Function>
void for_each_hierarchy(Function f)
{
  for (const auto& [name, m] : named_meshes())
    for (const unsigned int seed : { 0u, 1u }) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      f(m, small_hierarchy(m, 6, seed));
    }
}

inline bool has_triangle(const std::vector<Index_triangle>& triangles, Index_triangle t)
{
  for (int i = 0; i < 3; ++i) {
    if (std::find(triangles.begin(), triangles.end(), t) != triangles.end())
      return true;
    std::rotate(t.begin(), t.begin() + 1, t.end());
  }
  return false;
}

// A mesh and the finest level of its hierarchy.
struct Finest_level
{
  Collapse_hierarchy_3 hierarchy;
  Level level;

  template <class NamedParameters>
  Finest_level(const Flat_mesh& m, const NamedParameters& np)
    : hierarchy(surface(m), np), level(hierarchy, hierarchy.number_of_levels() - 1)
  { }

  // A hierarchy of one level.
  explicit Finest_level(const Flat_mesh& m)
    : Finest_level(m, parameters::coarsest_size((std::numeric_limits<std::size_t>::max)()))
  { }

  Finest_level(const Finest_level&) = delete;
};

} // namespace test_meshes

#endif // HIERARCHIES_H
