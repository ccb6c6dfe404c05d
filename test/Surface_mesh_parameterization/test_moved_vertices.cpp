// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The repair of maps with flips moves few vertices.

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "one_to_one_maps.h"
#include "spoiled_maps.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>
#include <CGAL/Surface_mesh_parameterization/settle_flips.h>

#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace test_moved_vertices {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using one_to_one::Mapped_mesh_with_border;
using one_to_one::Mesh;
using one_to_one::Spoiled_map;
using one_to_one::number_of_changes_since;
namespace parameters = CGAL::parameters;

TEST(Settle_flips, moves_hardly_more_than_the_vertices_that_are_wrong)
{
  for (const auto& [is_mirrored, part_of_nan] :
       { std::pair(false, 0.2), std::pair(true, 0.2), std::pair(false, 0.), std::pair(true, 0.) }) {
    Spoiled_map m;
    Random random(4);
    std::size_t spoiled = 0;
    for (const auto v : vertices(m.mesh))
      if (random(0, 1) < 0.03 && ++spoiled)
        m.uvmap[v] = random(0, 1) < part_of_nan ? Kernel::Point_2(std::nan(""), 0)
                                                : Kernel::Point_2(random(-2, 2), random(-2, 2));
    if (is_mirrored)
      for (const auto v : vertices(m.mesh)) {
        m.uvmap[v] = Kernel::Point_2(-m.uvmap[v].x(), m.uvmap[v].y());
        m.good[v] = Kernel::Point_2(-m.good[v].x(), m.good[v].y());
      }
    const auto before = m.uv();
    const std::size_t missing = std::size_t(
        std::count_if(before.begin(), before.end(), [](const Kernel::Point_2& p) { return std::isnan(p.x()); }));
    EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::FAIL, parameters::summary(std::ref(m.summary))),
              ERROR_NO_1_TO_1_MAPPING);
    EXPECT_GE(m.summary.flips, spoiled);
    EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::REPAIR, parameters::summary(std::ref(m.summary))), OK);
    EXPECT_TRUE(m.is_locally_one_to_one());
    EXPECT_GE(m.number_of_changes() + missing, spoiled);      // one without a place may be put where it was
    EXPECT_LE(m.number_of_changes(), 3 * spoiled);
    EXPECT_EQ(m.summary.moved_vertices, number_of_changes_since(before, m));
  }
}

// By edges, from the nearest of some vertices.
std::vector<int> distances_from(const Mesh& mesh, const std::vector<Mesh::Vertex_index>& sources)
{
  std::vector<int> distance(mesh.number_of_vertices(), -1);
  std::vector<Mesh::Vertex_index> list = sources;
  for (const auto v : list)
    distance[v] = 0;
  for (std::size_t i = 0; i < list.size(); ++i)
    for (const auto w : vertices_around_target(list[i], mesh))
      if (distance[w] < 0) {
        distance[w] = distance[list[i]] + 1;
        list.push_back(w);
      }
  return distance;
}

// Lays a flat grid along a logarithmic spiral, where scales go from 1 to e^12; a sign of -1 mirrors it.
void lay_along_spiral(Mapped_mesh& m, double sign)
{
  constexpr double stretch = 12;
  for (const auto v : vertices(m.mesh)) {
    const Kernel::Point_3& p = m.mesh.point(v);
    const double radius = std::exp(stretch * p.x()), angle = stretch * p.y();
    m.uvmap[v] = Kernel::Point_2(sign * radius * std::cos(angle), radius * std::sin(angle));
  }
}

TEST(Settle_flips, moves_vertices_near_flips_only)
{
  constexpr int farthest = 3;
  for (const double sign : { 1., -1. }) {
    Mapped_mesh_with_border m(grid(30, 24, flat));
    std::vector<Mesh::Vertex_index> spoiled;
    lay_along_spiral(m, sign);
    for (const auto v : vertices(m.mesh))
      if (const std::size_t i = v; i % 31 % 10 == 5 && i / 31 % 8 == 4)
        spoiled.push_back(v);
    ASSERT_TRUE(m.is_locally_one_to_one());
    const auto good = m.uv();
    for (const auto v : spoiled) {
      const auto w = target(m.mesh.halfedge(v), m.mesh) == v ? source(m.mesh.halfedge(v), m.mesh) : v;
      m.uvmap[v] = good[w] + 0.5 * (good[w] - good[v]);      // beyond a neighbor
    }
    ASSERT_FALSE(m.is_locally_one_to_one());
    const auto before = m.uv();
    EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::REPAIR, parameters::summary(std::ref(m.summary))), OK);
    EXPECT_TRUE(m.is_locally_one_to_one());
    const std::vector<int> distance = distances_from(m.mesh, spoiled);
    for (const auto v : vertices(m.mesh))
      EXPECT_TRUE(m.uvmap[v] == before[v] || (distance[v] <= farthest && !m.mesh.is_border(v))) << v;
  }
}

TEST(Settle_flips, moves_few_vertices_for_one_that_is_far_away_or_inside)
{
  const Index middle = 25 * 10 + 12, border = 12, corner_of_ear = 24, corner = 0;
  int repaired = 0;
  for (const Index index : { middle, border, corner_of_ear, corner })
    for (const double place : { 0.4, 1e3, 1e20, 1e160 })
      for (const double sign : { 1., -1. }) {
        Spoiled_map m;
        for (const auto v : vertices(m.mesh))
          m.uvmap[v] = Kernel::Point_2(sign * m.good[v].x(), m.good[v].y());
        const Mesh::Vertex_index v(index);
        m.uvmap[v] = Kernel::Point_2(sign * 0.5, place);
        if (m.is_locally_one_to_one())
          continue;
        EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::REPAIR, parameters::summary(std::ref(m.summary))),
                  OK);
        EXPECT_TRUE(m.is_locally_one_to_one());
        EXPECT_LE(m.summary.moved_vertices, 60u) << index << ' ' << place << ' ' << sign;
        ++repaired;
      }
  EXPECT_GE(repaired, 30);
}

// Where scales differ much, a hierarchy would not bring the others back.
TEST(Settle_flips, moves_no_vertex_but_those_without_a_place)
{
  Mapped_mesh_with_border m(grid(40, 32, flat));
  lay_along_spiral(m, 1);
  const auto good = m.uv();
  std::size_t missing = 0;
  for (const auto v : vertices(m.mesh))
    if (v % 11 == 4 && v / 41 % 3 == 1) {
      ++missing;
      m.uvmap[v] = Kernel::Point_2(std::nan(""), std::nan(""));
    }
  ASSERT_GT(missing, 30u);
  EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::REPAIR, parameters::summary(std::ref(m.summary))), OK);
  EXPECT_TRUE(m.is_locally_one_to_one());
  EXPECT_EQ(m.summary.moved_vertices, missing);
  EXPECT_EQ(number_of_changes_since(good, m), missing);
}

TEST(Settle_flips, keeps_as_much_of_a_map_that_is_far_away)
{
  const auto moved_at = [](double offset) {
    Spoiled_map m;
    Random random(4);
    for (const auto v : vertices(m.mesh)) {
      const bool is_spoiled = random(0, 1) < 0.2;      // too many for patches
      const Kernel::Point_2 p = is_spoiled ? Kernel::Point_2(random(0, 1), random(0, 1)) : m.good[v];
      m.uvmap[v] = Kernel::Point_2(p.x() + offset, p.y() - offset);
    }
    EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::REPAIR, parameters::summary(std::ref(m.summary))), OK);
    EXPECT_TRUE(m.is_locally_one_to_one());
    return double(m.summary.moved_vertices);
  };
  const double moved = moved_at(0);
  EXPECT_LT(moved, 0.5 * 25 * 21);
  for (const double offset : { 1e4, 1e8 })
    EXPECT_NEAR(moved_at(offset) / moved, 1, 0.2) << offset;
}

Flat_mesh cap_without_pole()
{
  return part(cap(9, 60, 1.2), [](const Point_3& centroid) { return centroid.z() < 0.99; });
}

// Flips at one of two borders do not turn the map: it is turned as most triangles are.
TEST(Settle_flips, moves_few_vertices_of_a_ring_whose_borders_cross)
{
  int repaired[] = { 0, 0 };
  for (const double sign : { 1., -1. })
    for (const bool is_at_hole : { false, true })
      for (const double factor : { -0.7, -3., -1e6, 1e6 }) {
        Mapped_mesh_with_border m(cap_without_pole());
        Mesh::Vertex_index on_border;
        for (const auto v : vertices(m.mesh)) {
          const Kernel::Point_3& p = m.mesh.point(v);
          m.uvmap[v] = Kernel::Point_2(sign * p.x(), p.y());
          if (m.mesh.is_border(v) && (p.z() > 0.9) == is_at_hole)
            on_border = v;
        }
        ASSERT_TRUE(m.is_locally_one_to_one());
        const bool is_mirrored = m.quality().is_mirrored;
        Kernel::Point_2& p = m.uvmap[on_border];
        p = Kernel::Point_2(factor * p.x(), factor * p.y());
        if (m.is_locally_one_to_one())      // where a border vertex may be far away
          continue;
        EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::REPAIR, parameters::summary(std::ref(m.summary))),
                  OK);
        EXPECT_TRUE(m.is_locally_one_to_one());
        EXPECT_EQ(m.quality().is_mirrored, is_mirrored);
        EXPECT_LE(m.summary.moved_vertices, 10u) << sign << ' ' << is_at_hole << ' ' << factor;
        ++repaired[is_at_hole];
      }
  EXPECT_GE(repaired[false], 4);
  EXPECT_GE(repaired[true], 2);
}

} // namespace test_moved_vertices
