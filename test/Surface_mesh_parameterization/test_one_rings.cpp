// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The neighbors of every vertex, in their order.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_one_rings {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;

std::set<Index_triangle> rotated_to_least(const std::vector<Index_triangle>& triangles)
{
  std::set<Index_triangle> result;
  for (Index_triangle t : triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.insert(t);
  }
  return result;
}

TEST(One_rings, hold_every_triangle_at_each_of_its_corners)
{
  std::vector<std::pair<std::string, Flat_mesh>> meshes = named_meshes();
  meshes.push_back({ "sphere", sphere(5, 8) });
  meshes.push_back({ "large hub on border", open_fan(500) });
  for (const auto& [name, m] : meshes) {
    SCOPED_TRACE(name);
    const One_rings rings(m.points.size(), m.triangles);
    EXPECT_EQ(rings.first_non_manifold_vertex(), no_index);
    std::vector<Index_triangle> triangles;
    for (Index v = 0; v < m.points.size(); ++v) {
      const One_rings::Ring ring = rings[v];
      EXPECT_EQ(rings.number_of_triangles(v), ring.size() - (rings.is_border(v) ? 1 : 0));
      for (std::size_t i = 0; i < rings.number_of_triangles(v); ++i)
        triangles.push_back({ v, ring[i], ring[(i + 1) % ring.size()] });
    }
    EXPECT_EQ(triangles.size(), 3 * m.triangles.size());
    EXPECT_EQ(rotated_to_least(triangles), rotated_to_least(m.triangles));
  }
}

TEST(One_rings, border_vertices_are_the_ends_of_edges_with_one_triangle)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    std::map<std::pair<Index, Index>, int> edges;
    for (const Index_triangle& t : m.triangles)
      for (int i = 0; i < 3; ++i)
        ++edges[std::minmax({ t[i], t[(i + 1) % 3] })];
    std::vector<bool> is_border(m.points.size(), false);
    for (const auto& [edge, count] : edges)
      if (count == 1)
        is_border[edge.first] = is_border[edge.second] = true;
    const One_rings rings(m.points.size(), m.triangles);
    for (Index v = 0; v < m.points.size(); ++v) {
      EXPECT_EQ(rings.is_border(v), is_border[v]);
      if (is_border[v]) {
        EXPECT_EQ((edges[std::minmax({ v, rings[v].front() })]), 1);
        EXPECT_EQ((edges[std::minmax({ v, rings[v].back() })]), 1);
      }
    }
  }
}

TEST(One_rings, count_borders)
{
  const auto count = [](const Flat_mesh& m) { return One_rings(m.points.size(), m.triangles).borders().size(); };
  EXPECT_EQ(count(sphere(4, 6)), 0u);
  EXPECT_EQ(count(single_triangle()), 1u);
  EXPECT_EQ(count(fan(500)), 1u);
  EXPECT_EQ(count(disk_with_hole()), 2u);
  EXPECT_EQ(count(annulus(12)), 2u);
  EXPECT_EQ(count(grid_with_holes(20)), 4u);
}

TEST(One_rings, borders_are_cycles_with_the_surface_to_the_left)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    std::set<std::pair<Index, Index>> edges;
    for (const Index_triangle& t : m.triangles)
      for (int i = 0; i < 3; ++i)
        edges.insert({ t[i], t[(i + 1) % 3] });
    const One_rings rings(m.points.size(), m.triangles);
    std::multiset<Index> found;
    for (const std::vector<Index>& border : rings.borders())
      for (std::size_t i = 0; i < border.size(); ++i) {
        const Index v = border[i], w = border[(i + 1) % border.size()];
        found.insert(v);
        EXPECT_EQ(edges.count({ v, w }), 1u);
        EXPECT_EQ(edges.count({ w, v }), 0u);
      }
    for (Index v = 0; v < m.points.size(); ++v)
      EXPECT_EQ(found.count(v), rings.is_border(v) ? 1u : 0u);
  }
}

TEST(One_rings, find_vertices_that_are_not_manifold)
{
  const auto first_bad = [](std::size_t n, const std::vector<Index_triangle>& triangles) {
    return One_rings(n, triangles).first_non_manifold_vertex();
  };
  EXPECT_EQ(first_bad(5, two_umbrellas().triangles), 0u);
  EXPECT_EQ(first_bad(4, single_triangle().triangles), 3u);                                        // an isolated vertex
  EXPECT_EQ(first_bad(4, { { 0, 1, 2 }, { 1, 2, 3 } }), 1u);      // neighbors with opposite orientations
  EXPECT_EQ(first_bad(5, { { 2, 0, 1 }, { 3, 1, 0 }, { 4, 0, 1 } }), 0u);      // three triangles at an edge
  EXPECT_EQ(first_bad(7, { { 6, 0, 1 }, { 6, 1, 2 }, { 6, 2, 0 }, { 6, 3, 4 }, { 6, 4, 5 }, { 6, 5, 3 } }),
            6u);      // two closed fans
  for (const Index n : { 20u, 200u }) {   // two large fans, closed ones and open ones
    Flat_mesh m = fan(n);
    for (const Index_triangle& t : fan(n).triangles)
      m.triangles.push_back({ 0, t[1] + n, t[2] + n });
    EXPECT_EQ(first_bad(2 * n + 1, m.triangles), 0u);
    m.triangles.pop_back();
    EXPECT_EQ(first_bad(2 * n + 1, m.triangles), 0u);
    m.triangles.erase(m.triangles.begin());
    EXPECT_EQ(first_bad(2 * n + 1, m.triangles), 0u);
  }
}

TEST(One_rings, can_be_built_again)
{
  One_rings rings;
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    rings.build(m.points.size(), m.triangles, Loops());
    const One_rings fresh(m.points.size(), m.triangles);
    ASSERT_EQ(rings.number_of_slots(), fresh.number_of_slots());
    EXPECT_EQ(rings.first_non_manifold_vertex(), no_index);
    for (Index v = 0; v < m.points.size(); ++v)
      EXPECT_TRUE(rings.is_border(v) == fresh.is_border(v) && rings[v] == fresh[v]);
  }
}

} // namespace test_one_rings
