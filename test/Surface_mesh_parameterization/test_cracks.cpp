// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Cracks: where a mesh came apart because vertices at one place were not merged. Runs close small ones at first.

#include "cracked_meshes.h"
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

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace test_cracks {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using internal::Closed_surface;
using internal::close_cracks;
using internal::open_cracks;

constexpr double any_length = std::numeric_limits<double>::infinity();

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
    const auto [s, closed] = close_cracks(surface(mesh), any_length);
    ASSERT_EQ(s.points.size(), whole.points.size());
    ASSERT_EQ(s.triangles.size(), whole.triangles.size());
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
    const Closed_surface closed = close_cracks(surface(mesh), any_length);
    EXPECT_TRUE(closed.vertices.empty());
    EXPECT_EQ(closed.surface.points, mesh.points);
    EXPECT_EQ(closed.surface.triangles, mesh.triangles);
  }
}

TEST(Close_cracks, leaves_alone_what_is_longer)
{
  const Flat_mesh mesh = grid_with_long_crack(12, 5, 2, 9);
  const double length = 14. / 12;      // of the border, if the surface were flat
  EXPECT_TRUE(close_cracks(surface(mesh), length).vertices.empty());
  EXPECT_FALSE(close_cracks(surface(mesh), 1.2 * length).vertices.empty());
}

// Vertices whose places are given, each with its own, stay apart: the crack is filled.
TEST(Close_cracks, keeps_vertices_with_places)
{
  const Flat_mesh mesh = grid_with_cracks(8, 8);
  const Index v = 4 * 9 + 4, copy = Index(mesh.points.size() - 1);
  Triangulated_surface_3 one = surface(mesh), both = one;
  one.fixed_vertices = { { copy, Point_2(1, 2) } };
  both.fixed_vertices = { { copy, Point_2(1, 2) } };
  both.springs = { { v, Point_2(1, 1), 3. } };
  const Closed_surface of_one = close_cracks(one, any_length), of_both = close_cracks(both, any_length);
  EXPECT_EQ(of_one.vertices[v], of_one.vertices[copy]);
  EXPECT_EQ(of_one.surface.fixed_vertices.front().vertex, of_one.vertices[copy]);
  EXPECT_EQ(of_one.surface.points.size(), mesh.points.size() - 1);
  EXPECT_NE(of_both.vertices[v], of_both.vertices[copy]);
  EXPECT_EQ(of_both.surface.springs.front().vertex, of_both.vertices[v]);
  EXPECT_EQ(of_both.surface.points.size(), mesh.points.size() + 1);
}

TEST(Close_cracks, fills_what_does_not_meet_by_triangles_with_an_area)
{
  const Flat_mesh mesh = with_T_junctions(grid(12, 12, wavy), 38);
  const Closed_surface closed = close_cracks(surface(mesh), any_length);
  const std::size_t virtual_vertices = closed.surface.points.size() - mesh.points.size();
  EXPECT_EQ(virtual_vertices, mesh.points.size() - 13 * 13);
  ASSERT_GT(virtual_vertices, 0u);
  EXPECT_EQ(closed.surface.triangles.size(), mesh.triangles.size() + 3 * virtual_vertices);
  const One_rings rings(closed.surface.points.size(), closed.surface.triangles);
  EXPECT_EQ(rings.first_non_manifold_vertex(), internal::no_index);
  EXPECT_EQ(rings.borders().size(), 1u);
  for (std::size_t i = mesh.triangles.size(); i < closed.surface.triangles.size(); ++i) {
    const auto [a, b, c] = closed.surface.triangles[i];
    EXPECT_GT(CGAL::squared_area(closed.surface.points[a], closed.surface.points[b], closed.surface.points[c]),
              CGAL::square(0.02 / (12 * 12)));
  }
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
  const Triangulated_surface_3 s = { mesh.points, mesh.triangles, { e, b, x, a } };
  ASSERT_EQ(One_rings(s.points.size(), s.triangles).first_non_manifold_vertex(), internal::no_index);
  const auto [closed, vertices] = close_cracks(s, any_length);
  EXPECT_EQ(One_rings(closed.points.size(), closed.triangles).first_non_manifold_vertex(), internal::no_index);
  EXPECT_NE(vertices[p], vertices[q]);
}

TEST(Open_cracks, makes_gaps_in_a_valid_map)
{
  for (const auto& [n, mesh] : cracked_grids()) {
    const Closed_surface closed = close_cracks(surface(mesh), any_length);
    std::vector<Point_2> closed_map;
    for (const Point_3& p : closed.surface.points)
      closed_map.emplace_back(p.x(), p.y());
    const std::vector<Point_2> uv = open_cracks(surface(mesh), closed, closed_map);
    ASSERT_EQ(uv.size(), mesh.points.size());
    const One_rings rings(mesh.points.size(), mesh.triangles);
    EXPECT_TRUE(is_map_valid(rings, uv));
    for (Index v = 0; v < uv.size(); ++v)
      EXPECT_FALSE(rings.is_border(v) && internal::leaves_no_room(rings, uv, v));
    std::vector<std::size_t> copies(closed_map.size(), 0);
    for (const Index v : closed.vertices)
      ++copies[v];
    for (Index v = 0; v < uv.size(); ++v)
      EXPECT_EQ(uv[v] == closed_map[closed.vertices[v]], copies[closed.vertices[v]] == 1);
  }
}

// Where triangles are so flat that doubles leave no room, there is no map.
TEST(Open_cracks, makes_no_invalid_map)
{
  for (const auto& [n, mesh] : cracked_grids())
    for (const double height : { 1e-4, 1e-8, 1e-12, 1e-14, 1e-15 }) {
      const Closed_surface closed = close_cracks(surface(mesh), any_length);
      std::vector<Point_2> closed_map;
      for (const Point_3& p : closed.surface.points)
        closed_map.emplace_back(p.x(), 1 + height * p.y());
      const std::vector<Point_2> uv = open_cracks(surface(mesh), closed, closed_map);
      EXPECT_TRUE(uv.empty() || is_map_valid(One_rings(mesh.points.size(), mesh.triangles), uv));
      EXPECT_TRUE(!uv.empty() || height < 1e-8);
    }
}

// A run that starts from the map of the closed surface.
void expect_few_steps(const Mapped_mesh& m)
{
  EXPECT_TRUE(m.is_valid());
  EXPECT_TRUE(m.summary.converged);
  ASSERT_EQ(m.summary.levels.size(), 1u);
  EXPECT_LE(m.summary.levels.back().iterations, 25u);
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
    expect_few_steps(cracked);
    EXPECT_LE(energy<TypeParam>(cracked), energy<TypeParam>(whole) * (1 + 1e-7));
  }
}

TYPED_TEST(Cracked_surface, may_have_vertices_that_do_not_meet)
{
  for (const std::size_t distance : { 2000, 31 }) {
    Mapped_mesh cracked(with_T_junctions(grid(80, 80, wavy), distance));
    ASSERT_EQ(minimize<TypeParam>(cracked, false), OK);
    expect_few_steps(cracked);
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
