// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Atlases in the unit square: margins, and what is packed.

#include "closed_meshes.h"
#include "mesh_conversions.h"
#include "surface_with_corner_map.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace test_packed_atlases {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::Surface_mesh_parameterization::parameters;

double distance(const internal::Triangle_2& s, const internal::Triangle_2& t)
{
  double least = (std::numeric_limits<double>::infinity)();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      least = (std::min)(least, CGAL::squared_distance(s[i], Kernel::Segment_2(t[j], t[(j + 1) % 3])));
      least = (std::min)(least, CGAL::squared_distance(t[i], Kernel::Segment_2(s[j], s[(j + 1) % 3])));
    }
  return std::sqrt(least);
}

TEST(Packing, keeps_the_margin)
{
  for (const double margin : { 0., 1. / 64, 1. / 16 }) {
    SCOPED_TRACE(margin);
    Flat_mesh m = sphere(4, 6);
    for (int i = 1; i < 12; ++i)
      m = with_component(m, i % 2 == 0 ? tetrahedron() : grid(Index(i), 1, flat), 1. / i, 10. * i);
    Surface surface(m);
    ASSERT_TRUE(atlas_parameterization(surface.mesh, surface.uv, parameters::margin(margin)).is_ok());
    const auto charts = surface.charts();
    double least = 1;
    for (std::size_t i = 0; i < charts.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (const internal::Triangle_2& s : charts[i])
          for (const internal::Triangle_2& t : charts[j])
            least = (std::min)(least, distance(s, t));
    EXPECT_GT(least, margin);
  }
}

// 150 charts have no room for the margin.
TEST(Packing, ends_where_the_margins_would_fill_the_square)
{
  Flat_mesh m = single_triangle();
  for (int i = 1; i < 150; ++i)
    m = with_component(m, single_triangle(), 1, 10. * i);
  Surface surface(m);
  ASSERT_TRUE(atlas_parameterization(surface.mesh, surface.uv, parameters::margin(0.1)).is_ok());
  expect_one_to_one(surface);
  const auto charts = surface.charts();
  double least = 1;
  for (std::size_t i = 0; i < charts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      least = (std::min)(least, distance(charts[i][0], charts[j][0]));
  EXPECT_GT(least, 0.25 / std::sqrt(150.));
}

// Finer margins than the grid are kept, too, in no more time.
TEST(Packing, keeps_fine_margins)
{
  for (const double margin : { 1. / 16384, 1e-9, 1e-300 }) {
    Surface surface(with_component(single_triangle(), single_triangle(), 1, 10));
    ASSERT_TRUE(atlas_parameterization(surface.mesh, surface.uv, parameters::margin(margin)).is_ok());
    expect_one_to_one(surface);
    const auto charts = surface.charts();
    ASSERT_EQ(charts.size(), 2u);
    EXPECT_GT(distance(charts[0][0], charts[1][0]), margin);
  }
}

// A hundred pieces of several sizes: squares fit side by side, triangles and other shapes leave more room between them.
TEST(Packing, fills_the_square)
{
  const auto used_part = [](const Flat_mesh& piece) {
    Flat_mesh m = piece;
    for (int i = 1; i < 100; ++i)
      m = with_component(m, piece, 1 + 0.3 * std::sin(i), 10 * i);
    Surface surface(m);
    const Atlas_summary summary = atlas_parameterization(surface.mesh, surface.uv, parameters::margin(0.));
    EXPECT_TRUE(summary.is_ok());
    return summary.used_part;
  };
  EXPECT_GT(used_part(grid(1, 1, flat)), 0.8);
  EXPECT_GT(used_part(single_triangle()), 0.6);
  EXPECT_GT(used_part(tetrahedron()), 0.65);
}

TEST(Packing, packs_a_map_from_elsewhere_and_refuses_what_is_none)
{
  Surface surface(with_component(grid(4, 4, flat), grid(3, 3, flat), 2, 0));
  for (const auto h : surface.mesh.halfedges())
    if (!surface.mesh.is_border(h))
      surface.uv[h] = Kernel::Point_2(surface.mesh.point(surface.mesh.target(h)).x(),
                                      surface.mesh.point(surface.mesh.target(h)).y());
  const std::vector<Kernel::Point_2> before = surface.corners();
  EXPECT_EQ(pack_charts(surface.mesh, surface.uv, parameters::margin(0.5)), ERROR_WRONG_PARAMETER);
  EXPECT_EQ(surface.corners(), before);
  EXPECT_EQ(pack_charts(surface.mesh, surface.uv), OK);
  expect_one_to_one(surface);
  EXPECT_EQ(surface.charts().size(), 2u);

  const auto h = surface.mesh.halfedge(*surface.mesh.faces().begin());
  surface.uv[h] = Kernel::Point_2((std::numeric_limits<double>::infinity)(), 0);
  EXPECT_EQ(pack_charts(surface.mesh, surface.uv), ERROR_WRONG_PARAMETER);
}

TEST(Packing, refuses_what_is_no_surface_of_triangles)
{
  Surface empty{ Flat_mesh() };
  EXPECT_EQ(pack_charts(empty.mesh, empty.uv), ERROR_EMPTY_MESH);

  Surface square(grid(1, 1, flat));
  const auto inner = std::find_if(square.mesh.halfedges_begin(), square.mesh.halfedges_end(),
                                  [&](auto h) { return !square.mesh.is_border(square.mesh.edge(h)); });
  CGAL::Euler::join_face(*inner, square.mesh);
  EXPECT_EQ(pack_charts(square.mesh, square.uv), ERROR_NON_TRIANGULAR_MESH);
  for (const auto h : square.mesh.halfedges())
    EXPECT_EQ(square.uv[h], untouched());
}

TEST(Packing, keeps_sizes_and_begins_at_the_origin_where_it_is_not_for_the_unit_square)
{
  Surface surface(with_component(grid(4, 4, flat), grid(3, 2, flat), 20, 0));
  for (const auto h : surface.mesh.halfedges()) {
    const Kernel::Point_3& p = surface.mesh.point(surface.mesh.target(h));
    surface.uv[h] = Kernel::Point_2(p.x() - 50, p.y() + 70);
  }
  const auto areas = [&] {
    std::vector<double> result;
    for (const auto& chart : surface.charts()) {
      result.push_back(0);
      for (const internal::Triangle_2& t : chart)
        result.back() += 0.5 * internal::cross(t[1] - t[0], t[2] - t[0]);
    }
    return result;
  };
  const std::vector<double> before = areas();
  ASSERT_EQ(before.size(), 2u);
  ASSERT_EQ(pack_charts(surface.mesh, surface.uv, parameters::unit_square(false)), OK);
  const std::vector<double> after = areas();
  ASSERT_EQ(after.size(), 2u);
  EXPECT_NEAR(after[0], before[0], 1e-9 * before[0]);
  EXPECT_NEAR(after[1], before[1], 1e-9 * before[1]);
  const std::vector<Kernel::Point_2> corners = surface.corners();
  const CGAL::Bbox_2 box = CGAL::bbox_2(corners.begin(), corners.end());
  const double side = (std::max)(box.xmax(), box.ymax());
  for (const double least : { box.xmin(), box.ymin() }) {
    EXPECT_GE(least, 0);
    EXPECT_LT(least, 0.02 * side);
  }
}

} // namespace test_packed_atlases
