// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Atlases in numbers that round: no flips, no overlaps, and an error where numbers overflow.

#include "closed_meshes.h"
#include "mesh_conversions.h"
#include "surface_with_corner_map.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/read_corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas.h>
#include <CGAL/Surface_mesh_parameterization/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace test_rounded_atlases {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::Surface_mesh_parameterization::parameters;

// Of a chart without area; by a factor that rounds, a triangle this thin can be turned over.
TEST(Scale_to_size_in_space, flips_no_triangle)
{
  Flat_mesh m;
  m.points = { Point_3(0, 0, 0), Point_3(0.3, 0, 0), Point_3(0.7, 0, 0) };
  m.triangles = { { 0, 1, 2 } };
  internal::Corner_mesh chart;
  ASSERT_EQ(internal::read_corner_mesh(make<Surface_mesh>(m), chart).code, OK);
  const auto is_positive = [](const std::vector<internal::Point_2>& uv) {
    return internal::is_left_turn(uv[0], uv[1], uv[2]);
  };
  Random random(1);
  std::size_t spoilt = 0;
  for (int i = 0; i < 200; ++i) {
    const double x = random(0.5, 1), y = random(0.5, 1);
    std::vector<internal::Point_2> uv = { { 0, 0 }, { x, y }, { 2 * x, std::nextafter(2 * y, 3.) } };
    ASSERT_TRUE(is_positive(uv));
    spoilt += !is_positive(internal::scaled(uv, 1. / 3));
    internal::scale_to_size_in_space(chart, uv);
    EXPECT_TRUE(is_positive(uv));
  }
  EXPECT_GT(spoilt, 0u);
}

// A row of squares that winds back to its first one, whose corner it meets but for a gap; if that is negative, the
// squares overlap.
internal::Flat_chart almost_closed_ring(double gap)
{
  const int path[][2] = { { 0, 0 },  { 0, -1 }, { 1, -1 }, { 2, -1 }, { 3, -1 },
                          { 3, 0 }, { 3, 1 },  { 2, 1 },  { 1, 1 } };
  internal::Flat_chart chart;
  std::map<std::pair<int, int>, Index> vertices;
  const auto vertex = [&](int x, int y) {
    const auto [place, is_new] = vertices.try_emplace({ x, y }, Index(chart.points.size()));
    if (is_new)
      chart.points.emplace_back(x, y);
    return place->second;
  };
  for (const auto& [x, y] : path) {
    chart.triangles.push_back({ vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1) });
    chart.triangles.push_back({ vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1) });
    if (x == 0 && y == 0) {
      chart.points[vertices[{ 1, 1 }]] = internal::Point_2(1 - gap, 1 - gap);
      vertices.erase({ 1, 1 });      // the last square has its own
    }
  }
  return chart;
}

TEST(Packing, parts_borders_that_rounding_lets_meet)
{
  const auto overlaps = [](const internal::Flat_chart& chart) {
    std::vector<internal::Triangle_2> triangles;
    for (const internal::Index_triangle& t : chart.triangles)
      triangles.push_back({ chart.points[t[0]], chart.points[t[1]], chart.points[t[2]] });
    return internal::number_of_overlapping_pairs(triangles);
  };
  const internal::Flat_chart apart = almost_closed_ring(1e-15), meeting = almost_closed_ring(-1e-15);
  ASSERT_EQ(overlaps(apart), 0u);
  ASSERT_GT(overlaps(meeting), 0u);
  internal::Flat_chart parted = meeting;
  EXPECT_TRUE(internal::part_borders(parted, apart.points, internal::Rounding()));
  EXPECT_EQ(overlaps(parted), 0u);
  EXPECT_TRUE(internal::is_positive(parted));
  for (std::size_t i = 0; i < parted.points.size(); ++i)
    EXPECT_LT((parted.points[i] - meeting.points[i]).squared_length(), 1e-15);
  // Borders that met before are not rounding's.
  internal::Flat_chart left = meeting;
  EXPECT_TRUE(internal::part_borders(left, meeting.points, internal::Rounding()));
  EXPECT_EQ(left.points, meeting.points);
}

// A chart that becomes a segment when it is turned does not spoil the others.
TEST(Packing, holds_out_with_slivers)
{
  Surface surface(with_component(single_triangle(), single_triangle(), 1, 10));
  const double x = 0.76142843599823706, y = 0.30333063602585919;
  const Kernel::Point_2 places[] = { { 0, 0 }, { x, x }, { y, 0.30333063602585925 }, { 0, 0 }, { 1, 0 }, { 0, 1 } };
  for (const bool is_mirrored : { false, true }) {
    for (const auto f : surface.mesh.faces()) {
      std::size_t i = 3 * f;
      for (const auto h : surface.mesh.halfedges_around_face(surface.mesh.halfedge(f))) {
        const Kernel::Point_2& p = places[i++];
        surface.uv[h] = is_mirrored ? Kernel::Point_2(p.y(), p.x()) : p;
      }
    }
    EXPECT_EQ(pack_charts(surface.mesh, surface.uv), OK);
    for (const Kernel::Point_2& p : surface.corners())
      EXPECT_TRUE(p.x() > 0 && p.x() < 1 && p.y() > 0 && p.y() < 1) << p;
  }
}

void expect_one_to_one_in_floats(const Flat_mesh& m)
{
  Surface surface(m);
  const auto uv = surface.mesh.add_property_map<Surface_mesh::Halfedge_index, Float_point_2>("h:float_uv").first;
  ASSERT_TRUE(atlas_parameterization(surface.mesh, uv).is_ok());
  for (const auto h : surface.mesh.halfedges())
    if (!surface.mesh.is_border(h))
      surface.uv[h] = Kernel::Point_2(double(uv[h].x()), double(uv[h].y()));
  expect_one_to_one(surface);
}

// Specks that are smaller than a float's steps are scaled up, and stay where they have room.
TEST(Packing, keeps_specks_apart_in_floats)
{
  for (const double size : { 1e-6, 1e-8, 1e-11 }) {
    Flat_mesh m = grid(8, 8, wavy);
    for (int i = 1; i <= 5; ++i)
      m = with_component(m, tetrahedron(), size, 10. * i);
    expect_one_to_one_in_floats(m);
  }
}

// Each chart fits into the user's numbers, but not all of them beside each other.
TEST(Packing, is_not_written_where_the_users_numbers_overflow)
{
  constexpr double size = 1e308;
  Flat_mesh m = grid(3, 3, flat);
  for (int i = 1; i < 9; ++i)
    m = with_component(m, grid(3, 3, flat), 1, 0);
  Surface surface(affine_image(m, size, 0, 0, size));
  const std::vector<Kernel::Point_2> untouched = surface.corners();
  const Atlas_summary summary = atlas_parameterization(surface.mesh, surface.uv, parameters::unit_square(false));
  EXPECT_FALSE(summary.is_ok());
  EXPECT_EQ(surface.corners(), untouched);

  for (const auto h : surface.mesh.halfedges()) {
    const Kernel::Point_3& p = surface.mesh.point(surface.mesh.target(h));
    surface.uv[h] = Kernel::Point_2(p.x(), p.y());
  }
  const std::vector<Kernel::Point_2> before = surface.corners();
  EXPECT_EQ(pack_charts(surface.mesh, surface.uv, parameters::unit_square(false)), ERROR_WRONG_PARAMETER);
  EXPECT_EQ(surface.corners(), before);
  EXPECT_EQ(pack_charts(surface.mesh, surface.uv), OK);
}

// Of such numbers, an error tells that they are too small, and not that a chart finds no room among them.
TEST(Packing, is_told_to_overflow_floats)
{
  constexpr double size = 1e39;
  Surface surface(affine_image(grid(3, 3, flat), size, 0, 0, size));
  const Float_point_2 untouched(7, 8);
  const auto uv = surface.mesh.add_property_map<Surface_mesh::Halfedge_index>("h:float_uv", untouched).first;
  const Atlas_summary summary = atlas_parameterization(surface.mesh, uv, parameters::unit_square(false));
  EXPECT_EQ(summary.error.code, ERROR_WRONG_PARAMETER);
  EXPECT_STREQ(summary.error.cause,
               "a coordinate of the map is too large for the numbers of uvmap, or is not a number");
  for (const auto h : surface.mesh.halfedges())
    EXPECT_EQ(uv[h], untouched);
  EXPECT_TRUE(atlas_parameterization(surface.mesh, uv).is_ok());
}

// Nothing is written then, also if some charts, beside the origin, could be.
TEST(Packing, of_several_charts_is_told_to_overflow_floats)
{
  constexpr double size = 2.2e38;
  Flat_mesh m = grid(3, 3, flat);
  for (int i = 1; i < 4; ++i)
    m = with_component(m, grid(3, 3, flat), 1, 0);
  Surface surface(affine_image(m, size, 0, 0, size));
  const Float_point_2 untouched(7, 8);
  const auto uv = surface.mesh.add_property_map<Surface_mesh::Halfedge_index>("h:float_uv", untouched).first;
  const Atlas_summary summary = atlas_parameterization(surface.mesh, uv, parameters::unit_square(false));
  EXPECT_EQ(summary.error.code, ERROR_WRONG_PARAMETER);
  for (const auto h : surface.mesh.halfedges())
    EXPECT_EQ(uv[h], untouched);

  for (const auto h : surface.mesh.halfedges())
    uv[h] = Float_point_2(float(surface.mesh.point(surface.mesh.target(h)).x()),
                          float(surface.mesh.point(surface.mesh.target(h)).y()));
  const std::vector<Float_point_2> before(uv.begin(), uv.end());
  EXPECT_EQ(pack_charts(surface.mesh, uv, parameters::unit_square(false)), ERROR_WRONG_PARAMETER);
  EXPECT_EQ(std::vector<Float_point_2>(uv.begin(), uv.end()), before);
  EXPECT_EQ(pack_charts(surface.mesh, uv), OK);
}

// A chart without flips may be mirrored, as in maps of other programs. Without moves, a speck that is a few steps of
// floats wide has flat triangles.
TEST(Packing, keeps_mirrored_charts_without_flips_in_floats)
{
  const auto flat_triangles = [](double factor) {
    Surface surface(with_component(grid(1, 1, flat), grid(30, 30, flat), 3e-8, 0));
    const auto uv = surface.mesh.add_property_map<Surface_mesh::Halfedge_index, Float_point_2>("h:float_uv").first;
    for (const auto h : surface.mesh.halfedges()) {
      const Kernel::Point_3& p = surface.mesh.point(surface.mesh.target(h));
      uv[h] = Float_point_2(float(factor * p.x()), float(p.y()));
    }
    EXPECT_EQ(pack_charts(surface.mesh, uv), OK);
    std::size_t result = 0;
    for (const auto f : surface.mesh.faces()) {
      std::vector<internal::Point_2> t;
      for (const auto h : CGAL::halfedges_around_face(surface.mesh.halfedge(f), surface.mesh))
        t.emplace_back(factor * double(uv[h].x()), double(uv[h].y()));
      result += !internal::is_left_turn(t[0], t[1], t[2]);
    }
    return result;
  };
  EXPECT_EQ(flat_triangles(1), 0u);
  EXPECT_EQ(flat_triangles(-1), 0u);
}

// Rounding to the user's numbers makes no flips, not even in a chart whose triangles are a few of their steps wide.
TEST(Packing, keeps_triangles_positive_in_floats)
{
  expect_one_to_one_in_floats(with_component(grid(4, 4, wavy), crumpled_grid(12, 1), 4e-9));
}

// On a lattice most triangles of a fine surface have no area, and in the map next to none: scales round them.
TEST(Packing, keeps_triangles_positive_that_have_no_area_in_space)
{
  for (Flat_mesh m : { grid(40, 40, wavy), delaunay_patch(1600, 3, wavy) }) {
    constexpr double cells = 10;
    for (Point_3& p : m.points)
      p = Point_3(std::round(cells * p.x()), std::round(cells * p.y()), std::round(cells * p.z()));
    Surface surface(m);
    ASSERT_TRUE(atlas_parameterization(surface.mesh, surface.uv).is_ok());
    expect_one_to_one(surface);
  }
}

} // namespace test_rounded_atlases
