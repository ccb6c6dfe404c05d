// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A hierarchy taken apart and put together again, and one level of it.

#include "hierarchies.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Progressive_mesh_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace test_progressive_mesh {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using internal::no_index;

TEST(Progressive_mesh, splitting_back_gives_the_input)
{
  for_each_hierarchy([](const Flat_mesh& m, const Collapse_hierarchy_3& h) {
    const auto expect_input = [&](const std::vector<Index_triangle>& triangles) {
      ASSERT_EQ(triangles.size(), m.triangles.size());
      for (Index f = 0; f < triangles.size(); ++f) {
        Index_triangle t = { h.input_vertex(triangles[f][0]), h.input_vertex(triangles[f][1]),
                             h.input_vertex(triangles[f][2]) };
        const Index_triangle& input = m.triangles[h.input_face(f)];
        std::rotate(t.begin(), std::find(t.begin(), t.end(), input[0]), t.end());
        EXPECT_EQ(t, input);
      }
    };
    Progressive_mesh_3 mesh(h);
    const std::vector<Index_triangle> coarsest = mesh.triangles();
    while (mesh.number_of_vertices() < h.number_of_vertices())
      mesh.split_vertex();
    expect_input(mesh.triangles());
    while (mesh.number_of_vertices() > h.number_of_vertices(0))
      mesh.collapse_vertex();
    EXPECT_EQ(mesh.triangles(), coarsest);
    for (std::size_t level = 0; level < h.number_of_levels(); ++level) {
      mesh.walk_to_level(level);
      EXPECT_EQ(mesh.triangles().size(), h.number_of_faces(level));
    }
    expect_input(mesh.triangles());
    mesh.walk_to_level(0);
    EXPECT_EQ(mesh.triangles(), coarsest);
  });
}

TEST(Progressive_mesh, is_a_manifold_after_every_single_split)
{
  for (const Flat_mesh& m : { grid(12, 9, wavy), disk_with_hole(), strip(20) }) {
    const Collapse_hierarchy_3 h = small_hierarchy(m);
    Progressive_mesh_3 mesh(h);
    const long characteristic = euler_characteristic(m.points.size(), m.triangles);
    while (mesh.number_of_vertices() < h.number_of_vertices()) {
      mesh.split_vertex();
      EXPECT_EQ(One_rings(mesh.number_of_vertices(), mesh.triangles()).first_non_manifold_vertex(), no_index);
      EXPECT_EQ(euler_characteristic(mesh.number_of_vertices(), mesh.triangles()), characteristic);
    }
  }
}

TEST(Level, shows_one_level)
{
  const Collapse_hierarchy_3 h = small_hierarchy(grid(12, 9, wavy));
  for (std::size_t i = 0; i < h.number_of_levels(); ++i) {
    const Level level(h, i);
    EXPECT_EQ(level.index(), i);
    EXPECT_EQ(level.is_finest(), i + 1 == h.number_of_levels());
    EXPECT_EQ(level.number_of_vertices(), h.number_of_vertices(i));
    EXPECT_EQ(level.number_of_faces(), h.number_of_faces(i));
    EXPECT_EQ(level.first_new_vertex(), i == 0 ? 0 : h.number_of_vertices(i - 1));
    EXPECT_EQ(&level.hierarchy(), &h);
    for (Index v = 0; v < level.number_of_vertices(); ++v)
      for (std::size_t k = 0; k + 1 < level.one_ring(v).size(); ++k)
        EXPECT_TRUE(has_triangle(level.triangles(), { v, level.one_ring(v)[k], level.one_ring(v)[k + 1] }));
  }
}

TEST(Level, goes_to_any_other_level)
{
  const Collapse_hierarchy_3 h = small_hierarchy(grid(12, 9, wavy));
  Level level(h);
  ASSERT_GT(h.number_of_levels(), 4u);
  const std::size_t finest = h.number_of_levels() - 1;
  for (const std::size_t i : { std::size_t(1), finest, finest, finest - 3, finest - 1, std::size_t(0), finest }) {
    level.go_to(i);
    const Level fresh(h, i);
    EXPECT_EQ(level.index(), i);
    EXPECT_EQ(level.triangles(), fresh.triangles());
    ASSERT_EQ(level.number_of_vertices(), fresh.number_of_vertices());
    ASSERT_EQ(level.rings().number_of_slots(), fresh.rings().number_of_slots());
    for (Index v = 0; v < level.number_of_vertices(); ++v) {
      EXPECT_EQ(level.is_border(v), fresh.is_border(v));
      ASSERT_EQ(level.one_ring(v), fresh.one_ring(v));
      for (std::size_t k = 0; k < level.rings().number_of_triangles(v); ++k) {
        const internal::Rest_corner &c = level.rest_corners(v)[k], &expected = fresh.rest_corners(v)[k];
        EXPECT_TRUE(c.foot == expected.foot && c.height == expected.height && c.inverse_area == expected.inverse_area);
      }
    }
  }
}

} // namespace test_progressive_mesh
