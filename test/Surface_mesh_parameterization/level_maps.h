// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef LEVEL_MAPS_H
#define LEVEL_MAPS_H

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/scale_to_area.h>

#include <gtest/gtest.h>

// Maps to start from.
namespace test_meshes {

using SMP::Level;
using SMP::OK;
using SMP::internal::Tutte_embedding;
using SMP::internal::scale_to_area;

// Tutte's map with the surface's area.
inline Level::Uv first_map(const Level& level)
{
  Level::Uv uv;
  EXPECT_EQ(Tutte_embedding::compute(level, uv), OK);
  scale_to_area(level, uv);
  return uv;
}

// The map of a planar mesh to itself.
inline Level::Uv identity_map(const Level& level)
{
  Level::Uv uv;
  for (Index v = 0; v < level.number_of_vertices(); ++v)
    uv.push_back(Point_2(level.point(v).x(), level.point(v).y()));
  return uv;
}

} // namespace test_meshes

#endif // LEVEL_MAPS_H
