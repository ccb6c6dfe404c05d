// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The repair of maps with flips: how little it moves, and what it makes of maps that are hardly any.

#include "one_to_one_maps.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>
#include <CGAL/Surface_mesh_parameterization/settle_flips.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace test_settle_flips {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using one_to_one::Mapped_mesh_with_border;
using one_to_one::Mesh;
namespace parameters = CGAL::parameters;

std::size_t number_of_changes_since(const Points& before, const Mapped_mesh& m)
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
