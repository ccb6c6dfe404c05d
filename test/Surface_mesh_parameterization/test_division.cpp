// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Charts that are divided, so that they fill the square better.

#include "closed_meshes.h"
#include "mesh_conversions.h"
#include "surface_with_corner_map.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test_division {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::Surface_mesh_parameterization::parameters;

struct Seams
{
  std::size_t edges = 0;
  double length = 0;                                  // in space
  explicit Seams(const Surface& surface)
  {
    for (const auto e : surface.mesh.edges()) {
      const auto h = surface.mesh.halfedge(e), o = surface.mesh.opposite(h);
      if (surface.mesh.is_border(e) || (surface.uv[h] == surface.uv[surface.mesh.prev(o)] &&
                                        surface.uv[o] == surface.uv[surface.mesh.prev(h)]))
        continue;
      ++edges;
      length += std::sqrt(CGAL::squared_distance(surface.mesh.point(surface.mesh.source(h)),
                                                 surface.mesh.point(surface.mesh.target(h))));
    }
  }
};

double area(const std::vector<internal::Triangle_2>& chart)
{
  double sum = 0;
  for (const internal::Triangle_2& t : chart)
    sum += 0.5 * internal::cross(t[1] - t[0], t[2] - t[0]);
  return sum;
}

// The summary tells what the map is: the pieces, their faces, the seams and the part of the square.
void expect_told(const Surface& surface, const Atlas_summary& summary)
{
  const auto charts = surface.charts();
  ASSERT_EQ(summary.charts.size(), charts.size());
  double used_part = 0;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    EXPECT_EQ(summary.charts[i].faces, charts[i].size());
    EXPECT_EQ(std::size_t(std::count(summary.chart_of_face.begin(), summary.chart_of_face.end(), i)), charts[i].size());
    used_part += area(charts[i]);
  }
  EXPECT_NEAR(summary.used_part, used_part, 1e-9);
  const Seams seams(surface);
  EXPECT_EQ(summary.cut.seam_edges, seams.edges);
  EXPECT_NEAR(summary.cut.seam_length, seams.length, 1e-9 * seams.length);
}

// Three legs and a hole, which fill less than half of the square around them.
Flat_mesh legs()
{
  Flat_mesh m = grid(30, 30, wavy);
  const auto is_outside = [&](const Index_triangle& t) {
    const Point_3& p = m.points[t[0]];
    return (p.y() > 0.2 && std::sin(5 * CGAL_PI * p.x()) < 0) ||
           (std::abs(p.x() - 0.5) < 0.05 && p.y() > 0.05 && p.y() < 0.1);
  };
  m.triangles.erase(std::remove_if(m.triangles.begin(), m.triangles.end(), is_outside), m.triangles.end());
  return m;
}

Flat_mesh strip()
{
  Flat_mesh m = grid(40, 5, flat);
  for (Point_3& p : m.points)
    p = Point_3(10 * p.x(), p.y(), 0);
  return m;
}

TEST(Division, fills_the_square)
{
  for (const Flat_mesh& m :
       { legs(), plate_with_holes(3, 4), strip(), with_component(legs(), plate_with_holes(1, 4), 0.5, 9) }) {
    Surface whole(m), divided(m);
    const Atlas_summary before = atlas_parameterization(whole.mesh, whole.uv, parameters::least_used_part(0.));
    ASSERT_TRUE(before.is_ok());
    ASSERT_LT(before.used_part, 0.7);
    EXPECT_EQ(before.divisions, 0u);
    const Atlas_summary summary = atlas_parameterization(divided.mesh, divided.uv, parameters::least_used_part(0.7));
    ASSERT_TRUE(summary.is_ok());
    EXPECT_GE(summary.used_part, 0.7);
    EXPECT_GT(summary.divisions, 0u);
    EXPECT_GE(summary.charts.size(), before.charts.size() + summary.divisions);
    expect_one_to_one(divided);
    expect_told(whole, before);
    expect_told(divided, summary);
  }
}

// The square around a U or a frame becomes smaller only when several sides are cut off.
TEST(Division, cuts_frames)
{
  const Flat_mesh u = part(frame(40, 0.05), [](const Point_3& p) { return p.y() < 0.95; });
  for (const Flat_mesh& m : { u, frame(40, 0.05) }) {
    Surface whole(m), divided(m);
    const Atlas_summary before = atlas_parameterization(whole.mesh, whole.uv, parameters::least_used_part(0.));
    ASSERT_LT(before.used_part, 0.2);
    const Atlas_summary summary = atlas_parameterization(divided.mesh, divided.uv, parameters::least_used_part(0.7));
    ASSERT_TRUE(summary.is_ok());
    EXPECT_GE(summary.used_part, 0.7);
    EXPECT_LT(summary.cut.seam_length, 1);
    expect_one_to_one(divided);
    expect_told(divided, summary);
  }
}

// A slender surface would leave nearly all of the square empty, so it is divided without being asked for. Others are
// not.
TEST(Division, is_of_slender_surfaces_by_default)
{
  Surface slender(strip()), wide(legs());
  const Atlas_summary divided = atlas_parameterization(slender.mesh, slender.uv),
                      whole = atlas_parameterization(wide.mesh, wide.uv);
  ASSERT_TRUE(divided.is_ok() && whole.is_ok());
  EXPECT_GE(divided.used_part, 0.25);
  EXPECT_GT(divided.divisions, 0u);
  expect_one_to_one(slender);
  EXPECT_GE(whole.used_part, 0.25);
  EXPECT_EQ(whole.divisions, 0u);
}

// What the repair of a chart did is told once, whatever becomes of the chart.
TEST(Division, does_not_multiply_what_was_repaired)
{
  Flat_mesh m = grid(80, 5, flat);
  Random random(1);
  for (Point_3& p : m.points)
    p = Point_3(20 * p.x(), p.y(), random(0, 0.4));
  Surface whole(m), divided(m);
  const auto sums = [](const Atlas_summary& summary) {
    EXPECT_TRUE(summary.is_ok());
    std::pair<std::size_t, std::size_t> result;
    for (const Atlas_summary::Chart& chart : summary.charts) {
      result.first += chart.summary.flips;
      result.second += chart.summary.moved_vertices;
    }
    return result;
  };
  const Atlas_summary before =
      atlas_parameterization<LSCM_parameterizer_3>(whole.mesh, whole.uv, parameters::least_used_part(0.));
  const Atlas_summary summary =
      atlas_parameterization<LSCM_parameterizer_3>(divided.mesh, divided.uv, parameters::least_used_part(0.7));
  EXPECT_GT(summary.divisions, 0u);
  EXPECT_EQ(summary.charts.size(), before.charts.size() + summary.divisions);
  EXPECT_GT(sums(before).second, 0u);
  EXPECT_EQ(sums(summary), sums(before));
}

// Each part has its area in space, at the same scale.
TEST(Division, keeps_one_scale)
{
  Surface surface(legs());
  const Atlas_summary summary = atlas_parameterization(
      surface.mesh, surface.uv, parameters::least_used_part(0.7).unit_square(false));
  ASSERT_TRUE(summary.is_ok());
  ASSERT_GT(summary.charts.size(), 1u);
  std::vector<double> in_space(summary.charts.size(), 0.), in_plane(summary.charts.size(), 0.);
  for (const auto f : surface.mesh.faces()) {
    std::vector<Kernel::Point_3> p;
    internal::Triangle_2 t;
    for (const auto h : CGAL::halfedges_around_face(surface.mesh.halfedge(f), surface.mesh)) {
      t[p.size()] = surface.uv[h];
      p.push_back(surface.mesh.point(surface.mesh.target(h)));
    }
    in_space[summary.chart_of_face[f]] += std::sqrt(CGAL::squared_area(p[0], p[1], p[2]));
    in_plane[summary.chart_of_face[f]] += area({ t });
  }
  for (std::size_t i = 0; i < in_space.size(); ++i)
    EXPECT_NEAR(in_plane[i], in_space[i], 1e-9 * in_space[i]);
}

TEST(Division, leaves_what_fills_the_square)
{
  Surface surface(grid(10, 10, flat)), same(grid(10, 10, flat));
  ASSERT_TRUE(atlas_parameterization(surface.mesh, surface.uv).is_ok());
  const Atlas_summary summary = atlas_parameterization(same.mesh, same.uv, parameters::least_used_part(0.7));
  EXPECT_EQ(summary.divisions, 0u);
  EXPECT_EQ(summary.charts.size(), 1u);
  EXPECT_EQ(surface.corners(), same.corners());
}

// Margins that the user wants wide are no reason to divide: more charts have more of them.
TEST(Division, leaves_what_would_fill_the_square_with_narrow_margins)
{
  const Flat_mesh corner = part(grid(6, 6, flat), [](const Point_3& p) { return p.x() < 0.16 || p.y() < 0.16; });
  Flat_mesh m = corner;
  for (Index i = 1; i < 60; ++i)
    m = with_component(m, corner);
  Surface wide(m), narrow(m);
  const Atlas_summary summary = atlas_parameterization(wide.mesh, wide.uv, parameters::margin(0.1)),
                      expected = atlas_parameterization(narrow.mesh, narrow.uv);
  ASSERT_TRUE(summary.is_ok() && expected.is_ok());
  EXPECT_LT(summary.used_part, 0.25);
  EXPECT_GE(expected.used_part, 0.25);
  EXPECT_EQ(summary.divisions, 0u);
}

// What cannot be had costs no more than what can: the best division is taken, and never one that uses less.
TEST(Division, does_its_best_for_all_of_the_square)
{
  for (const Flat_mesh& m : { single_triangle(), tetrahedron(), legs() }) {
    Surface whole(m), divided(m);
    const Atlas_summary before = atlas_parameterization(whole.mesh, whole.uv, parameters::least_used_part(0.)),
                        after = atlas_parameterization(divided.mesh, divided.uv, parameters::least_used_part(1.));
    ASSERT_TRUE(before.is_ok() && after.is_ok());
    EXPECT_GE(after.used_part, before.used_part);
    expect_one_to_one(divided);
    expect_told(divided, after);
  }
}

TEST(Division, refuses_parts_that_are_none)
{
  Surface surface(legs());
  for (const double part : { -0.1, 1.1, std::numeric_limits<double>::quiet_NaN() }) {
    const Atlas_summary summary =
        atlas_parameterization(surface.mesh, surface.uv, parameters::least_used_part(part));
    EXPECT_EQ(summary.error.code, ERROR_WRONG_PARAMETER);
    EXPECT_NE(error_message(summary.error).find("least_used_part"), std::string::npos);
    for (const Kernel::Point_2& p : surface.corners())
      EXPECT_EQ(p, untouched());
  }
}

} // namespace test_division
