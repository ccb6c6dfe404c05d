// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef LEVEL_MAPS_H
#define LEVEL_MAPS_H

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/first_maps.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_refiner.h>

#include <gtest/gtest.h>

// Maps to start from, and to go on.
namespace test_meshes {

using SMP::Level;
using SMP::Level_summary;
using SMP::OK;
using SMP::Refinement_options;
using SMP::internal::compute_Tutte_embedding;
using SMP::internal::scale_to_area;

// Tutte's map with the surface's area.
inline Level::Uv first_map(const Level& level)
{
  Level::Uv uv;
  EXPECT_EQ(compute_Tutte_embedding(level, uv), OK);
  scale_to_area(level, false, uv);
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

template <class Energy>
void refine(const Level& level, Level::Uv& uv, const Refinement_options& options, Level_summary& summary)
{
  const SMP::internal::Level_energy_of<Energy> energy(level, options.triangle_weight);
  SMP::internal::Level_refiner(energy, uv, options, summary).run();
}

} // namespace test_meshes

#endif // LEVEL_MAPS_H
