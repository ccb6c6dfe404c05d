// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Cracks: where a mesh came apart because vertices at one place were not merged. Runs close small ones at first.

#include "distortion_runs.h"
#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/cracks.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace test_cracks {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using internal::close_cracks;
using internal::open_cracks;

constexpr double any_length = std::numeric_limits<double>::infinity();

// Gives the triangles around a vertex, in so many parts of about the same size, a vertex each.
void split_vertex(Flat_mesh& m, const One_rings& rings, Index v, std::size_t parts)
{
  const std::size_t n = rings.number_of_triangles(v);
  std::vector<Index> copies{ v };
  for (std::size_t i = 1; i < parts; ++i) {
    copies.push_back(Index(m.points.size()));
    m.points.push_back(Point_3(m.points[v]));
  }
  rings.for_each_triangle(v, [&](Index a, Index b, std::size_t i) {
    for (Index_triangle& t : m.triangles)
      if (contains(t, v) && contains(t, a) && contains(t, b))
        for (Index& w : t)
          if (w == v)
            w = copies[i * parts / n];
  });
}

// Cracks of that many branches at every so manieth vertex of a grid of n times n cells.
Flat_mesh grid_with_cracks(Index n, Index distance, std::size_t branches = 2)
{
  Flat_mesh m = grid(n, n, wavy);
  const One_rings rings(m.points.size(), m.triangles);
  for (Index j = distance / 2; j < n; j += distance)
    for (Index i = distance / 2; i < n; i += distance)
      split_vertex(m, rings, j * (n + 1) + i, branches);
  return m;
}

// A crack along a row of the grid.
Flat_mesh grid_with_long_crack(Index n, Index row, Index begin, Index end)
{
  Flat_mesh m = grid(n, n, wavy);
  for (Index i = begin + 1; i < end; ++i) {
    const Index v = row * (n + 1) + i, copy = Index(m.points.size());
    m.points.push_back(Point_3(m.points[v]));
    for (std::size_t t = 2 * n * row; t < m.triangles.size(); ++t)
      for (Index& w : m.triangles[t])
        if (w == v)
          w = copy;
  }
  return m;
}

struct Cracked_grid
{
  Index n;
  Flat_mesh mesh;
};

std::vector<Cracked_grid> cracked_grids()
{
  return { { 12, grid_with_cracks(12, 4) },
           { 12, grid_with_cracks(12, 4, 3) },
           { 12, grid_with_cracks(12, 4, 6) },
           { 12, grid_with_long_crack(12, 5, 2, 9) },
           { 12, grid_with_long_crack(12, 5, 1, 11) } };
}

TEST(Close_cracks, makes_one_what_was_one)
{
  for (const auto& [n, mesh] : cracked_grids()) {
    const Flat_mesh whole = grid(n, n, wavy);
    Triangulated_surface_3 s = surface(mesh);
    const std::vector<Index> closed = close_cracks(s, any_length);
    ASSERT_EQ(s.points.size(), whole.points.size());
    ASSERT_EQ(closed.size(), mesh.points.size());
    for (Index v = 0; v < closed.size(); ++v)
      EXPECT_EQ(s.points[closed[v]], mesh.points[v]);
    for (std::size_t i = 0; i < whole.triangles.size(); ++i)
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(s.triangles[i][k], closed[whole.triangles[i][k]]);
    for (const Index v : s.outer_border)
      EXPECT_TRUE(One_rings(s.points.size(), s.triangles).is_border(v));
  }
}

TEST(Close_cracks, leaves_alone_what_is_none)
{
  for (const Flat_mesh& mesh : { grid(9, 9, wavy), grid_with_holes(20), disk_with_hole(), annulus(20) }) {
    Triangulated_surface_3 s = surface(mesh);
    EXPECT_EQ(close_cracks(s, any_length).size(), mesh.points.size());
    EXPECT_EQ(s.points, mesh.points);
    EXPECT_EQ(s.triangles, mesh.triangles);
  }
}

TEST(Close_cracks, leaves_alone_what_is_longer)
{
  const Flat_mesh mesh = grid_with_long_crack(12, 5, 2, 9);
  Triangulated_surface_3 s = surface(mesh);
  close_cracks(s, 14. / 12);      // in the plane the border would be as long
  EXPECT_EQ(s.points.size(), mesh.points.size());
  close_cracks(s, 16. / 12);
  EXPECT_LT(s.points.size(), mesh.points.size());
}

// Vertices whose places are given, each with its own, stay apart, and so does what is beyond them.
TEST(Close_cracks, keeps_vertices_with_places)
{
  const Flat_mesh mesh = grid_with_cracks(8, 8);
  const Index v = 4 * 9 + 4, copy = Index(mesh.points.size() - 1);
  Triangulated_surface_3 one = surface(mesh), both = one;
  one.fixed_vertices = { { copy, Point_2(1, 2) } };
  both.fixed_vertices = { { copy, Point_2(1, 2) } };
  both.springs = { { v, Point_2(1, 1), 3. } };
  const std::vector<Index> closed = close_cracks(one, any_length);
  EXPECT_EQ(one.points.size(), mesh.points.size() - 1);
  EXPECT_EQ(one.fixed_vertices.front().vertex, closed[copy]);
  close_cracks(both, any_length);
  EXPECT_EQ(both.points.size(), mesh.points.size());
}

// p and q, at the tip t of a hole, are both joined to x: an edge would have four triangles.
//
//    e   t   p,q   c,d   x        with a above, and b below
//
TEST(Close_cracks, leaves_a_manifold)
{
  enum : Index { t, p, q, c, d, x, a, b, e };
  const Flat_mesh mesh = { { Point_3(0, 0, 0), Point_3(1, 0.02, 0), Point_3(1, -0.02, 0), Point_3(1.5, 0.005, 0),
                             Point_3(1.5, -0.005, 0), Point_3(3, 0, 0), Point_3(1, 2, 0), Point_3(1, -2, 0),
                             Point_3(-1, 0, 0) },
                           { { c, x, p }, { d, x, c }, { q, x, d }, { p, a, t }, { x, a, p }, { t, b, q }, { q, b, x },
                             { a, e, t }, { e, b, t } } };
  Triangulated_surface_3 s = { mesh.points, mesh.triangles, { e, b, x, a } };
  ASSERT_EQ(One_rings(s.points.size(), s.triangles).first_non_manifold_vertex(), internal::no_index);
  close_cracks(s, any_length);
  EXPECT_EQ(One_rings(s.points.size(), s.triangles).first_non_manifold_vertex(), internal::no_index);
  EXPECT_EQ(s.points.size(), mesh.points.size());
}

TEST(Open_cracks, makes_gaps_in_a_valid_map)
{
  for (const auto& [n, mesh] : cracked_grids()) {
    Triangulated_surface_3 open = surface(mesh), s = open;
    const std::vector<Index> closed = close_cracks(s, any_length);
    std::vector<Point_2> closed_map;
    for (const Point_3& p : s.points)
      closed_map.emplace_back(p.x(), p.y());
    const std::vector<Point_2> uv = open_cracks(open, closed, closed_map);
    ASSERT_EQ(uv.size(), mesh.points.size());
    const One_rings rings(mesh.points.size(), mesh.triangles);
    EXPECT_TRUE(is_map_valid(rings, uv));
    for (Index v = 0; v < uv.size(); ++v)
      EXPECT_FALSE(rings.is_border(v) && internal::leaves_no_room(rings, uv, v));
    std::vector<std::size_t> copies(s.points.size(), 0);
    for (const Index v : closed)
      ++copies[v];
    for (Index v = 0; v < uv.size(); ++v)
      EXPECT_EQ(uv[v] == closed_map[closed[v]], copies[closed[v]] == 1);
  }
}

template <class Energy>
class Cracked_surface : public testing::Test
{ };

typedef testing::Types<MIPS_energy_2, Symmetric_Dirichlet_energy_2> Energies;
TYPED_TEST_SUITE(Cracked_surface, Energies, );

// A crack adds freedom and nothing else: the least energy is not greater than that of the surface without it.
TYPED_TEST(Cracked_surface, has_no_more_energy_and_takes_few_steps)
{
  constexpr Index n = 80;
  Mapped_mesh whole(grid(n, n, wavy));
  ASSERT_EQ(minimize<TypeParam>(whole, false), OK);
  for (const Index distance : { 40, 16, 4 }) {
    Mapped_mesh cracked(grid_with_cracks(n, distance));
    ASSERT_EQ(minimize<TypeParam>(cracked, false), OK);
    EXPECT_TRUE(cracked.is_valid());
    EXPECT_TRUE(cracked.summary.converged);
    EXPECT_LE(energy<TypeParam>(cracked), energy<TypeParam>(whole) * (1 + 1e-7));
    ASSERT_EQ(cracked.summary.levels.size(), 1u);      // it starts from the map of the closed surface
    EXPECT_LE(cracked.summary.levels.back().iterations, 25u);
  }
}

TYPED_TEST(Cracked_surface, may_be_kept_from_lying_over_itself)
{
  Mapped_mesh cracked(grid_with_cracks(40, 8));
  ASSERT_EQ(minimize<TypeParam>(cracked, true), OK);
  EXPECT_TRUE(cracked.is_valid());
  EXPECT_EQ(cracked.quality().overlaps, 0u);
}

} // namespace test_cracks
