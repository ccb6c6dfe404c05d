// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The repair of maps with flips: what it makes of maps that are hardly any.

#include "mesh_conversions.h"
#include "one_to_one_maps.h"
#include "spoiled_maps.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>
#include <CGAL/Surface_mesh_parameterization/settle_flips.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <vector>

namespace test_settle_flips {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using one_to_one::Mapped_mesh_with_border;
using one_to_one::Mesh;
using one_to_one::Spoiled_map;
namespace parameters = CGAL::parameters;

// A map without flips is turned as its border runs, however few triangles are.
TEST(Settle_flips, turns_triangles_as_the_border_runs)
{
  for (const double sign : { 1., -1. }) {
    Spoiled_map m;
    for (const auto v : vertices(m.mesh)) {
      const Kernel::Point_2& p = m.good[v];
      m.uvmap[v] = Kernel::Point_2(sign * (m.mesh.is_border(v) ? p.x() : 1 - p.x()), p.y());
    }
    const auto before = m.uv();
    ASSERT_EQ(m.quality().is_mirrored, sign > 0);
    EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::REPAIR, parameters::summary(std::ref(m.summary))), OK);
    EXPECT_TRUE(m.is_locally_one_to_one());
    EXPECT_EQ(m.quality().is_mirrored, sign < 0);
    EXPECT_GT(2 * m.summary.flips, num_faces(m.mesh));
    std::size_t border_vertices = 0, moved = 0;
    for (const auto v : vertices(m.mesh))
      if (m.mesh.is_border(v)) {
        ++border_vertices;
        moved += m.uvmap[v] != before[v];
      }
    EXPECT_LT(2 * moved, border_vertices);
  }
}

// Moved by some edges, one vertex at a time.
TEST(Settle_flips, leaves_no_needles_around_a_border_vertex_that_was_elsewhere)
{
  Random random(3);
  int repaired = 0;
  for (int i = 0; i < 300; ++i) {
    Spoiled_map m;
    const auto border = CGAL::halfedges_around_face(m.bhd, m.mesh);
    const auto v = target(*std::next(border.begin(), std::ptrdiff_t(random.below(border.size()))), m.mesh);
    m.uvmap[v] = Kernel::Point_2(m.uvmap[v].x() + random(-0.12, 0.12), m.uvmap[v].y() + random(-0.12, 0.12));
    if (m.is_locally_one_to_one())
      continue;
    ASSERT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::REPAIR), OK);
    EXPECT_TRUE(m.is_locally_one_to_one());
    EXPECT_LT(m.quality().mips_excess, 1e3) << i;      // of 960 triangles
    ++repaired;
  }
  EXPECT_GT(repaired, 100);
}

// A flat square with an ear behind an edge of its border: a disk of the given radius, all of whose vertices are on the
// border, cut into triangles that share a vertex or halve it again and again. The map has the ear on the line of its
// chord, as where fixed borders are convex.
struct Square_with_ear : Mapped_mesh_with_border
{
  static constexpr Index n = 20;

  Square_with_ear(Index vertices_of_ear, double radius, bool is_halved)
    : Mapped_mesh_with_border(make_surface(vertices_of_ear, radius, is_halved))
  {
    project();
    const Index first = (n + 1) * (n + 1);
    const Kernel::Point_2 a = uvmap[Mesh::Vertex_index(chord_start())], b = uvmap[Mesh::Vertex_index(chord_end())];
    for (Index i = 0; i < vertices_of_ear; ++i)
      uvmap[Mesh::Vertex_index(first + i)] = a + (i + 1.) / (vertices_of_ear + 1) * (b - a);
  }

  static Index chord_start() { return (n + 1) * 7 + n; }
  static Index chord_end() { return chord_start() + n + 1; }

  static Flat_mesh make_surface(Index vertices_of_ear, double radius, bool is_halved)
  {
    Flat_mesh m = grid(n, n, flat);
    std::vector<Index> ear = { chord_start() };
    const Point_3 middle = CGAL::midpoint(m.points[chord_start()], m.points[chord_end()]);
    for (Index i = 0; i < vertices_of_ear; ++i) {
      const double angle = CGAL_PI * (2. * (i + 1) / (vertices_of_ear + 1) - 1);
      ear.push_back(Index(m.points.size()));
      m.points.emplace_back(middle.x() + 0.2 / n + radius * (1 + std::cos(angle)),
                            middle.y() + radius * std::sin(angle), 0.);
    }
    ear.push_back(chord_end());
    add_triangles(m, ear, 0, ear.size() - 1, is_halved);
    return m;
  }

  static void add_triangles(Flat_mesh& m, const std::vector<Index>& ear, std::size_t a, std::size_t b, bool is_halved)
  {
    if (b - a < 2)
      return;
    const std::size_t c = is_halved ? (a + b) / 2 : a + 1;
    m.triangles.push_back({ ear[a], ear[c], ear[b] });
    add_triangles(m, ear, a, c, is_halved);
    add_triangles(m, ear, c, b, is_halved);
  }
};

// An ear gets about the size that it has in space, since nothing else tells how large it should be, and no triangle
// stays a needle that is positive by rounding alone.
TEST(Settle_flips, gives_ears_that_are_flat_a_shape_and_a_size)
{
  for (const bool is_halved : { false, true })
    for (Index vertices_of_ear = 2; vertices_of_ear < 24; ++vertices_of_ear)
      for (const double radius : { 0.7, 1.5, 4. }) {
        const double unit = radius / Square_with_ear::n;
        Square_with_ear m(vertices_of_ear, unit, is_halved);
        ASSERT_FALSE(m.is_locally_one_to_one());
        EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::REPAIR), OK);
        EXPECT_TRUE(m.is_locally_one_to_one());
        EXPECT_LT(m.quality().mips_excess, 1e9) << vertices_of_ear << ' ' << radius << ' ' << is_halved;
        for (const Kernel::Point_2& p : m.uv()) {
          EXPECT_LT((std::max)(std::abs(p.x() - 0.5), std::abs(p.y() - 0.5)), 0.5 + 3 * unit)
              << vertices_of_ear << ' ' << radius << ' ' << is_halved;
        }
      }
}

TEST(Settle_flips, repairs_a_map_of_any_size_the_same_way)
{
  const auto repaired_at = [](int exponent) {
    Spoiled_map m;
    const auto scale = [&](int power) {
      for (const auto v : vertices(m.mesh))
        m.uvmap[v] = Kernel::Point_2(std::ldexp(m.uvmap[v].x(), power), std::ldexp(m.uvmap[v].y(), power));
    };
    m.uvmap[Mesh::Vertex_index(25 * 10 + 12)] = Kernel::Point_2(0.3, 0.2);
    m.uvmap[Mesh::Vertex_index(25 * 14 + 3)] = Kernel::Point_2(0.7, 0.9);
    scale(exponent);
    EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::REPAIR, parameters::summary(std::ref(m.summary))), OK);
    EXPECT_TRUE(m.is_locally_one_to_one());
    EXPECT_LT(m.summary.moved_vertices, 60u);
    scale(-exponent);
    return m.uv();
  };
  const auto expected = repaired_at(0);
  for (const int exponent : { -900, -500, -100, 1, 100, 500, 900 })
    EXPECT_EQ(repaired_at(exponent), expected) << exponent;
}

TEST(Settle_flips, repairs_mirrored_maps_of_floats)
{
  for (const float sign : { 1.f, -1.f }) {
    Spoiled_map m;
    const auto map = m.add_map_of_floats();
    for (const auto v : vertices(m.mesh))
      map[v] = Float_point_2(sign * float(m.good[v].x()), float(m.good[v].y()));
    map[Mesh::Vertex_index(262)] = Float_point_2(sign * 0.9f, 0.9f);
    EXPECT_EQ(settle_flips(m.mesh, m.bhd, map, Flip_policy::REPAIR), OK);
    for (const auto v : vertices(m.mesh))
      m.uvmap[v] = Kernel::Point_2(map[v].x(), map[v].y());
    EXPECT_TRUE(m.is_locally_one_to_one());
  }
}

TEST(Settle_flips, lets_a_good_map_be_and_makes_one_of_nothing)
{
  Spoiled_map m;
  for (const Flip_policy policy : { Flip_policy::FAIL, Flip_policy::KEEP, Flip_policy::REPAIR }) {
    EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, policy, parameters::summary(std::ref(m.summary))), OK);
    EXPECT_EQ(m.summary.moved_vertices, 0u);
    EXPECT_EQ(m.number_of_changes(), 0u);
  }
  for (const double place : { 0., 1e300, std::numeric_limits<double>::infinity() }) {
    for (const auto v : vertices(m.mesh))
      m.uvmap[v] = Kernel::Point_2(place, place);
    EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::REPAIR), OK) << place;
    EXPECT_TRUE(m.is_locally_one_to_one()) << place;
  }
}

// Every triangle of the square of a disk's points is positive, but its middle is surrounded twice.
TEST(Settle_flips, counts_vertices_around_which_a_map_winds_twice)
{
  Mapped_mesh_with_border m(cap(6, 24, 0.1));
  for (const auto v : vertices(m.mesh)) {
    const Kernel::Point_3& p = m.mesh.point(v);
    m.uvmap[v] = Kernel::Point_2(p.x() * p.x() - p.y() * p.y(), 2 * p.x() * p.y());
  }
  for (const bool is_mirrored : { false, true }) {
    EXPECT_EQ(m.quality().flips, 0u);
    EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::FAIL, parameters::summary(std::ref(m.summary))),
              ERROR_NO_1_TO_1_MAPPING);
    EXPECT_EQ(m.summary.flips, 1u) << is_mirrored;
    for (const auto v : vertices(m.mesh))
      m.uvmap[v] = Kernel::Point_2(-m.uvmap[v].x(), m.uvmap[v].y());
  }
  EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::REPAIR), OK);
  EXPECT_TRUE(m.is_locally_one_to_one());
}

} // namespace test_settle_flips
