// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that need no cut, but would be distorted far.

#include "closed_meshes.h"
#include "generated_meshes.h"
#include "hostile_meshes.h"
#include "surface_with_corner_map.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/atlas_quality.h>
#include <CGAL/Surface_mesh_parameterization/cut_to_disk.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace test_distorted_disks {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::Surface_mesh_parameterization::parameters;

constexpr double infinity = std::numeric_limits<double>::infinity();

// A sphere with a small hole, and a long tube with one open end.
TEST(Distorted_disk, is_cut_where_its_border_is_short)
{
  for (const Flat_mesh& m : { cap(30, 32, 0.97 * CGAL_PI), tube(30, 24, 12) }) {
    Surface cut(m), whole(m);
    const Atlas_summary summary = atlas_parameterization(cut.mesh, cut.uv),
                        summary_of_whole =
                            atlas_parameterization(whole.mesh, whole.uv, parameters::distortion_bound(infinity));
    ASSERT_TRUE(summary.is_ok() && summary_of_whole.is_ok());
    EXPECT_EQ(summary_of_whole.cut.seam_edges, 0u);
    EXPECT_GT(energy(whole), 8);
    ASSERT_EQ(summary.cut.components.size(), 1u);
    EXPECT_GT(summary.cut.components[0].branches, 0u);
    EXPECT_LE(summary.cut.components[0].distortion, 4.5);
    EXPECT_LT(energy(cut), 4.6);
    expect_one_to_one(cut);
    expect_one_to_one(whole);
  }
}

// A ball with six limbs, scaled.
Flat_mesh ball_with_limbs(int subdivisions, double scale)
{
  return moved(flat_mesh(hostile_meshes::octasphere(subdivisions)), [scale](const Point_3& p) {
    const auto direction = (p - CGAL::ORIGIN) / std::sqrt((p - CGAL::ORIGIN).squared_length());
    double radius = 1;
    for (const double cosine : { direction.x(), direction.y(), direction.z() }) {
      const double angle = std::acos((std::min)(1., std::abs(cosine)));
      radius += 2 * std::exp(-angle * angle / 0.09);
    }
    return CGAL::ORIGIN + scale * radius * direction;
  });
}

// Of a thin surface, any cut gains a little, and charts that have many are worse than one without.
TEST(Thin_surface, is_not_worse_for_its_cuts)
{
  for (const double thickness : { 1e-1, 1e-2, 1e-3 }) {
    SCOPED_TRACE(thickness);
    const Flat_mesh m = moved(flat_mesh(hostile_meshes::torus(30, 16)), [thickness](const Point_3& p) {
      return Point_3(p.x(), thickness * p.y(), thickness * p.z());
    });
    Surface cut(m), whole(m);
    ASSERT_TRUE(atlas_parameterization(cut.mesh, cut.uv).is_ok());
    ASSERT_TRUE(atlas_parameterization(whole.mesh, whole.uv, parameters::distortion_bound(infinity)).is_ok());
    EXPECT_LE(energy(cut), energy(whole));
    expect_one_to_one(cut);
  }
}

// A first cut leads from one tip to another, and one from each of the other four is enough.
TEST(Closed_surface, is_cut_from_each_limb_once)
{
  for (const int subdivisions : { 3, 4, 5 }) {
    Surface surface(ball_with_limbs(subdivisions, 1));
    const Cut_summary cut = cut_to_disk(surface.mesh, surface.seams);
    ASSERT_FALSE(cut.components.empty());
    EXPECT_EQ(cut.components[0].branches, 4u);
    EXPECT_LE(cut.components[0].distortion, 4.5);
  }
}

// With two holes, which are joined if that takes the shorter seam.
TEST(Distorted_disk, is_cut_alike_at_all_scales)
{
  const auto relative_length = [](double scale) {
    Flat_mesh m = ball_with_limbs(4, scale);
    for (const int f : { 684, 559 })
      m.triangles.erase(m.triangles.begin() + f);
    Surface surface(m);
    const Cut_summary cut = cut_to_disk(surface.mesh, surface.seams);
    EXPECT_EQ(cut.components.size(), 1u);
    for (const auto& component : cut.components)
      EXPECT_EQ(component.borders, 2u);
    return cut.seam_length / scale;
  };
  const double length = relative_length(1);
  EXPECT_GT(length, 0);
  EXPECT_EQ(relative_length(std::exp2(-10)), length);
}

// A tube with two open ends lies flat after one cut along it, and seams lead nowhere else.
TEST(Distorted_disk, a_tube_is_cut_from_one_end_to_the_other)
{
  constexpr Index rings = 30;
  constexpr double height = 0.3;      // of a ring
  Surface surface(open_tube(24, rings, height));
  const Atlas_summary summary = atlas_parameterization(surface.mesh, surface.uv);
  ASSERT_TRUE(summary.is_ok());
  EXPECT_EQ(summary.charts.size(), 1u);
  EXPECT_NEAR(summary.cut.seam_length, rings * height, 1e-9);
  EXPECT_EQ(summary.cut.components[0].branches, 0u);
  EXPECT_NEAR(energy(surface), 4, 1e-6);
  expect_one_to_one(surface);
}

// What is not distorted so far stays whole, unless the caller gives a bound.
TEST(Distorted_disk, stays_whole_below_the_bound)
{
  for (const Flat_mesh& m : { grid(12, 12, wavy), hemisphere(), cap(20, 24, 0.7 * CGAL_PI) }) {
    const auto number_of_seams = [&](const auto& np) {
      Surface surface(m);
      return cut_to_disk(surface.mesh, surface.seams, np).seam_edges;
    };
    EXPECT_EQ(number_of_seams(parameters::default_values()), 0u);
    EXPECT_EQ(number_of_seams(parameters::distortion_bound(infinity)), 0u);
    EXPECT_EQ(number_of_seams(parameters::distortion_bound(8)), 0u);
    EXPECT_GT(number_of_seams(parameters::distortion_bound(4.001)), 0u);
  }
}

// A bound that may be none.
TEST(Distorted_disk, bound_is_optional)
{
  const Flat_mesh m = cap(14, 16, 0.97 * CGAL_PI);
  const auto seam_length = [&](const auto& np) {
    Surface surface(m);
    return cut_to_disk(surface.mesh, surface.seams, np).seam_length;
  };
  EXPECT_EQ(seam_length(parameters::distortion_bound(std::optional<double>())),
            seam_length(parameters::default_values()));
  EXPECT_EQ(seam_length(parameters::distortion_bound(std::optional<double>(4.2))),
            seam_length(parameters::distortion_bound(4.2)));
  EXPECT_GT(seam_length(parameters::distortion_bound(4.2)), seam_length(parameters::default_values()));
}

} // namespace test_distorted_disks
