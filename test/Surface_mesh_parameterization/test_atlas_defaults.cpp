// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The defaults of an atlas are those of the manual: with them the atlas is the same, with other values another one.

#include "mesh_conversions.h"
#include "surface_with_corner_map.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <vector>

namespace test_atlas_defaults {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace np = CGAL::Surface_mesh_parameterization::parameters;

template <class Options, class Options_of_charts>
auto atlas_of(const Flat_mesh& m, const Options& options, const Options_of_charts& options_of_charts)
{
  Surface surface(m);
  EXPECT_TRUE(atlas_parameterization(surface.mesh, surface.uv, options, options_of_charts).is_ok());
  return surface.corners();
}

// Checks that a value is the default: set(value) are the options with it.
template <class Set, class Value>
void expect_default(const Flat_mesh& m, const Set& set, const Value& value, const std::vector<Value>& others)
{
  const auto none = np::default_values();
  const auto expected = atlas_of(m, none, none);
  EXPECT_TRUE(atlas_of(m, set(value), none) == expected);
  for (const Value& other : others)
    EXPECT_FALSE(atlas_of(m, set(other), none) == expected) << testing::PrintToString(other);
}

TEST(Default_of_atlases, distortion_bound)
{
  expect_default(sphere(9, 12), [](double x) { return np::distortion_bound(x); }, 4.5, { 4.1, 4.7 });
}

// Holes of 3.4 and of 6 edges, each edge a fortieth of the surface's width.
TEST(Default_of_atlases, holes)
{
  Flat_mesh m = grid(40, 40, wavy);
  const auto erase = [&](Index first, Index number) {
    m.triangles.erase(m.triangles.begin() + first, m.triangles.begin() + first + number);
  };
  erase(2 * (30 * 40 + 10), 4);
  erase(2 * (10 * 40 + 20), 1);
  expect_default(m, [](double x) { return np::hole_bound(x); }, 0.1, { 0.08, 0.2 });
  expect_default(m, [](bool x) { return np::join_borders(x); }, false, { true });
}

TEST(Default_of_atlases, overlap_bound)
{
  expect_default(ramp(100, 1.1), [](double x) { return np::overlap_bound(x); }, 0.2, { 0.15 });
  expect_default(ramp(100, 1.15), [](double x) { return np::overlap_bound(x); }, 0.2, { 0.3 });
}

TEST(Default_of_atlases, least_used_part)
{
  expect_default(grid(60, 8, wavy), [](double x) { return np::least_used_part(x); }, 0.25, { 0., 0.6 });
}

TEST(Default_of_atlases, packing)
{
  const Flat_mesh m = grid(8, 6, wavy);
  expect_default(m, [](double x) { return np::margin(x); }, 1. / 256, { 1. / 250, 1. / 262 });
  expect_default(m, [](bool x) { return np::unit_square(x); }, true, { false });
}

TEST(Default_of_charts, globally_injective)
{
  const Flat_mesh m = ramp(60, 1.05);
  const auto none = np::default_values();
  const auto expected = atlas_of(m, none, none);
  EXPECT_TRUE(atlas_of(m, none, np::globally_injective(true)) == expected);
  EXPECT_FALSE(atlas_of(m, none, np::globally_injective(false)) == expected);
}

} // namespace test_atlas_defaults
