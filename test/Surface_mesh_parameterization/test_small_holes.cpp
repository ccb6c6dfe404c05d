// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Small holes, which atlases treat as parts of the surface, and runs on one chart, where there are many, at first.

#include "cracked_meshes.h"
#include "distortion_runs.h"
#include "one_to_one_maps.h"
#include "surface_with_corner_map.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/fill_small_holes.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/read_corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace test_small_holes {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::Surface_mesh_parameterization::parameters;
using internal::Corner_mesh;

// Without every `distance`-th triangle.
Flat_mesh with_pinholes(Flat_mesh m, std::size_t distance)
{
  std::vector<Index_triangle> triangles;
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    if (i % distance != distance / 2)
      triangles.push_back(m.triangles[i]);
  m.triangles = triangles;
  return m;
}

Flat_mesh grid_with_pinholes() { return with_pinholes(grid(20, 20, wavy), 93); }

Corner_mesh corner_mesh_of(const Surface& surface)
{
  Corner_mesh result;
  EXPECT_EQ(internal::read_corner_mesh(surface.mesh, surface.seams, result).code, OK);
  return result;
}

std::vector<internal::Filled_holes> fill(const Surface& surface, double bound, Corner_mesh& mesh)
{
  return internal::fill_small_holes(mesh, internal::is_at_hole(surface.mesh), bound);
}

// Neighbors agree in their edges, and every vertex has one fan of triangles.
void expect_consistent(Corner_mesh mesh, std::size_t borders)
{
  for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if (!mesh.is_border(h)) {
      EXPECT_EQ(mesh.opposite[mesh.opposite[h]], h);
      EXPECT_EQ(mesh.source(mesh.opposite[h]), mesh.target(h));
      EXPECT_EQ(mesh.target(mesh.opposite[h]), mesh.source(h));
    }
  EXPECT_EQ(internal::borders(mesh).size(), borders);
  const std::vector<Index> vertex = mesh.vertex;
  internal::split_vertices(mesh);
  EXPECT_EQ(mesh.vertex, vertex);
}

// The surface is there as it was.
void expect_filled(const Corner_mesh& before, const Corner_mesh& after, std::size_t borders)
{
  expect_consistent(after, borders);
  EXPECT_TRUE(std::equal(before.vertex.begin(), before.vertex.end(), after.vertex.begin()));
  EXPECT_TRUE(std::equal(before.points.begin(), before.points.end(), after.points.begin()));
}

TEST(Filled_holes, close_all_borders_but_the_longest)
{
  for (const Flat_mesh& m : { grid_with_pinholes(), with_pinholes(sphere(16, 20), 50) }) {
    const Surface surface(m);
    const Corner_mesh before = corner_mesh_of(surface);
    const std::size_t borders = internal::borders(before).size();
    ASSERT_GT(borders, 5u);
    Corner_mesh after = before;
    const std::vector<internal::Filled_holes> filled = fill(surface, 0.5, after);
    ASSERT_EQ(filled.size(), 1u);
    EXPECT_EQ(filled[0].borders, borders);
    EXPECT_EQ(filled[0].faces, after.number_of_faces() - before.number_of_faces());
    EXPECT_EQ(after.number_of_vertices(), before.number_of_vertices() + borders - 1);
    expect_filled(before, after, 1);
  }
}

// By the length of their borders, a part of the root of the area, which is 1.
TEST(Filled_holes, are_the_small_ones)
{
  const Surface surface(with_pinholes(grid(20, 20, flat), 93));
  const double length = (2 + std::sqrt(2.)) / 20;      // of the border of one triangle
  const std::size_t borders = internal::borders(corner_mesh_of(surface)).size();
  for (const double part : { 0.9, 1.1 }) {
    Corner_mesh mesh = corner_mesh_of(surface);
    fill(surface, part * length, mesh);
    EXPECT_EQ(internal::borders(mesh).size(), part < 1 ? borders : 1u);
  }
}

TEST(Filled_holes, join_the_sides_of_cracks)
{
  for (const std::size_t branches : { 2, 3, 5 }) {
    const Surface surface(grid_with_cracks(12, 4, branches)), whole(grid(12, 12, wavy));
    Corner_mesh mesh = corner_mesh_of(surface);
    const std::size_t borders = internal::borders(mesh).size();
    ASSERT_GT(borders, 3u);
    const auto components = fill(surface, 2, mesh);
    ASSERT_EQ(components.size(), 1u);
    EXPECT_EQ(components[0].borders, borders);
    EXPECT_EQ(components[0].faces, 0u);
    expect_consistent(mesh, 1);
    const Corner_mesh expected = corner_mesh_of(whole);
    EXPECT_EQ(mesh.vertex, expected.vertex);
    EXPECT_EQ(mesh.opposite, expected.opposite);
    EXPECT_EQ(mesh.points, expected.points);
  }
}

// A vertex on one side of an edge has none to be joined with.
TEST(Filled_holes, have_an_area_above_cracks_whose_sides_do_not_meet)
{
  const Surface surface(with_T_junctions(grid(12, 12, wavy), 38));
  Corner_mesh mesh = corner_mesh_of(surface);
  const Corner_mesh before = mesh;
  const std::size_t borders = internal::borders(mesh).size();
  ASSERT_GT(borders, 3u);
  const auto components = fill(surface, 1, mesh);
  ASSERT_EQ(components.size(), 1u);
  EXPECT_EQ(components[0].borders, borders);
  EXPECT_EQ(components[0].faces, 3 * (borders - 1));
  expect_filled(before, mesh, 1);
  for (Index f = before.number_of_faces(); f < mesh.number_of_faces(); ++f)
    EXPECT_GT(internal::area_of_face(mesh, f), 1e-4);
}

// A seam of the user's looks like a crack, but has a surface on both sides.
TEST(Filled_holes, are_no_seams)
{
  constexpr Index n = 12, row = n + 1, begin = 6 * row + 4;
  Surface surface(grid(n, n, wavy));
  for (const auto e : surface.mesh.edges()) {
    const Index v = surface.mesh.vertex(e, 0), w = surface.mesh.vertex(e, 1);
    surface.seams[e] = (std::min)(v, w) >= begin && (std::max)(v, w) <= begin + 3;
  }
  Corner_mesh mesh = corner_mesh_of(surface);
  const Corner_mesh before = mesh;
  ASSERT_EQ(internal::borders(mesh).size(), 2u);
  fill(surface, 1, mesh);
  EXPECT_EQ(mesh.opposite, before.opposite);
}

std::size_t number_of_seams(const Surface& surface)
{
  std::size_t result = 0;
  for (const auto e : surface.mesh.edges()) {
    const auto h = surface.mesh.halfedge(e), o = surface.mesh.opposite(h);
    result += !surface.mesh.is_border(e) &&
              (surface.uv[h] != surface.uv[surface.mesh.prev(o)] || surface.uv[o] != surface.uv[surface.mesh.prev(h)]);
  }
  return result;
}

template <template <class...> class Method>
void expect_atlas_of_surface(const Flat_mesh& m, double least_used_part)
{
  Surface surface(m);
  const std::size_t borders = internal::borders(corner_mesh_of(surface)).size();
  const Atlas_summary summary = atlas_parameterization<Method>(
      surface.mesh, surface.uv, parameters::hole_bound(1).least_used_part(least_used_part));
  ASSERT_TRUE(summary.is_ok());
  expect_one_to_one(surface);
  ASSERT_EQ(summary.cut.components.size(), 1u);
  EXPECT_EQ(summary.cut.components[0].borders, borders);
  EXPECT_EQ(summary.cut.components[0].faces, surface.mesh.number_of_faces());
  EXPECT_EQ(summary.cut.seam_edges, number_of_seams(surface));
  EXPECT_EQ(summary.chart_of_face.size(), surface.mesh.number_of_faces());
  std::vector<std::size_t> faces(summary.charts.size(), 0);
  for (const std::size_t chart : summary.chart_of_face)
    ++faces.at(chart);
  for (std::size_t i = 0; i < faces.size(); ++i)
    EXPECT_EQ(summary.charts[i].faces, faces[i]);
  double area = 0;
  const auto charts = surface.charts();
  for (const auto& chart : charts)
    for (const internal::Triangle_2& t : chart)
      area += 0.5 * internal::doubled_area(t[0], t[1], t[2]);
  EXPECT_NEAR(summary.used_part, area, 1e-9);
  EXPECT_EQ(summary.charts.size(), charts.size());
}

// What an atlas tells is of the user's faces and edges only.
TEST(Atlas_with_small_holes, counts_no_virtual_faces)
{
  expect_atlas_of_surface<MIPS_parameterizer_3>(with_pinholes(sphere(24, 30), 80), 0);
  for (const double least_used_part : { 0., 0.9 })
    expect_atlas_of_surface<Symmetric_Dirichlet_parameterizer_3>(with_pinholes(grid(60, 6, wavy), 7), least_used_part);
}

template <class NamedParameters>
std::vector<Kernel::Point_2> corners(const Flat_mesh& m, const NamedParameters& np)
{
  Surface surface(m);
  EXPECT_TRUE(atlas_parameterization(surface.mesh, surface.uv, np).is_ok());
  return surface.corners();
}

TEST(Atlas_with_small_holes, has_other_places_only_where_holes_are_filled)
{
  const auto with_bound = [](const Flat_mesh& m, double bound) { return corners(m, parameters::hole_bound(bound)); };
  const Flat_mesh m = grid_with_pinholes();
  EXPECT_NE(with_bound(m, 1), with_bound(m, 0));
  EXPECT_EQ(with_bound(m, 1e-3), with_bound(m, 0));
  EXPECT_EQ(with_bound(m, 0.1), corners(m, parameters::hole_bound(std::optional<double>())));
  EXPECT_EQ(with_bound(m, 0.1), corners(m, parameters::default_values()));
  EXPECT_EQ(corners(m, parameters::join_borders(true)), corners(m, parameters::join_borders(true).hole_bound(0)));
}

// The same atlas as that of the surface without cracks: both sides of a crack have the same places.
TEST(Atlas_of_cracks, is_that_of_the_whole_surface)
{
  for (const Flat_mesh& m : { cap(24, 30, 3), grid(40, 40, wavy) }) {
    EXPECT_EQ(corners(with_cracks(m, 68), parameters::hole_bound(1)), corners(m, parameters::hole_bound(1)));
    EXPECT_NE(corners(with_cracks(m, 68), parameters::hole_bound(0)), corners(m, parameters::hole_bound(0)));
  }
}

TEST(Atlas_of_cracks, counts_edges_and_charts_of_the_cracked_surface)
{
  expect_atlas_of_surface<MIPS_parameterizer_3>(with_cracks(sphere(24, 30), 68), 0);
  for (const double least_used_part : { 0., 0.9 }) {
    expect_atlas_of_surface<Symmetric_Dirichlet_parameterizer_3>(with_cracks(grid(60, 6, wavy), 9), least_used_part);
    expect_atlas_of_surface<Symmetric_Dirichlet_parameterizer_3>(with_T_junctions(sphere(24, 30), 68), least_used_part);
  }
}

// A seam of the user's that runs through a hole divides the surface, as if the hole were none.
TEST(Atlas_with_small_holes, keeps_a_seam_through_a_hole)
{
  constexpr Index n = 12, row = n + 1;
  Flat_mesh m = grid(n, n, wavy);
  const auto begin = m.triangles.begin() + 2 * (n * 6 + 6);      // above the line y = 0.5, in its middle
  m.triangles.erase(begin, begin + 2);
  Surface surface(m);
  const auto on_line = [](Surface_mesh::Vertex_index v) { return Index(v) / row == 6; };
  for (const auto e : surface.mesh.edges())
    surface.seams[e] =
        !surface.mesh.is_border(e) && on_line(surface.mesh.vertex(e, 0)) && on_line(surface.mesh.vertex(e, 1));
  const Atlas_summary summary = atlas_parameterization(
      surface.mesh, surface.uv, parameters::hole_bound(1).edge_is_constrained_map(surface.seams));
  ASSERT_TRUE(summary.is_ok());
  EXPECT_EQ(summary.charts.size(), 2u);
  EXPECT_EQ(surface.charts().size(), 2u);
}

TEST(Hole_bound, is_from_0_to_1)
{
  Surface surface(grid_with_pinholes());
  for (const double bound : { -0.1, 1.1, std::numeric_limits<double>::quiet_NaN() })
    EXPECT_EQ(atlas_parameterization(surface.mesh, surface.uv, parameters::hole_bound(bound)).error.code,
              ERROR_WRONG_PARAMETER);
}

// ---- one chart ----

template <class Method>
class One_chart_with_small_holes : public testing::Test
{
protected:
  template <class NamedParameters>
  static void run(Mapped_mesh& m, const NamedParameters& np)
  {
    ASSERT_EQ(m.parameterize(Hierarchical_parameterizer_3<Method>(np.summary(std::ref(m.summary)))), OK);
  }
};

typedef testing::Types<MIPS_parameterizer_3<Surface_mesh>, Symmetric_Dirichlet_parameterizer_3<Surface_mesh>> Methods;
TYPED_TEST_SUITE(One_chart_with_small_holes, Methods, );

// Without a triangle in every sixth cell of every sixth row of a grid with n cells in a row.
Flat_mesh with_hole_in_every_sixth_cell(Flat_mesh m, std::size_t n)
{
  std::vector<Index_triangle> triangles;
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    if (i % 2 != 0 || i / 2 % n % 6 != 3 || i / 2 / n % 6 != 3)
      triangles.push_back(m.triangles[i]);
  m.triangles = triangles;
  return m;
}

// The run goes on from there with the surface alone, whose energy the last steps lower.
TYPED_TEST(One_chart_with_small_holes, starts_from_the_map_with_its_holes_filled)
{
  const Flat_mesh m = with_hole_in_every_sixth_cell(grid(80, 80, wavy), 80);
  Mapped_mesh filled(m), open(m);
  this->run(filled, parameters::fill_holes(true));
  this->run(open, parameters::fill_holes(false));
  ASSERT_EQ(open.summary.levels.size(), 1u);
  const Level_summary& finest = open.summary.levels.back();
  typedef std::conditional_t<is_mips<TypeParam>, MIPS_energy_2, Symmetric_Dirichlet_energy_2>   Energy;
  EXPECT_NEAR(finest.energy_start / finest.energy_end, energy<Energy>(filled) / energy<Energy>(open), 1e-9);
  EXPECT_LT(finest.energy_end, finest.energy_start);
  EXPECT_TRUE(open.is_valid());
}

// A hole or two, or large ones, coarse levels have room for.
TYPED_TEST(One_chart_with_small_holes, starts_on_the_coarsest_level_where_small_holes_are_few)
{
  for (const Flat_mesh& surface : { with_pinholes(grid(80, 80, wavy), 900), grid_with_holes(60) }) {
    Mapped_mesh m(surface);
    this->run(m, parameters::fill_holes(false));
    EXPECT_GT(m.summary.levels.size(), 1u);
  }
}

TYPED_TEST(One_chart_with_small_holes, keeps_its_borders_apart)
{
  one_to_one::Mapped_mesh_with_border m(with_hole_in_every_sixth_cell(ramp(320, 1.2, 12), 320));
  this->run(m, parameters::globally_injective(false));
  EXPECT_GT(m.quality().overlaps, 0u);
  this->run(m, parameters::globally_injective(true));
  EXPECT_EQ(m.summary.levels.size(), 1u);
  EXPECT_EQ(m.quality().flips, 0u);
  EXPECT_EQ(m.quality().overlaps, 0u);
  EXPECT_EQ(one_to_one::pairs_by_counting(m), 0u);
}

} // namespace test_small_holes
