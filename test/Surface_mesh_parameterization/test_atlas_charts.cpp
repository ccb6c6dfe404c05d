// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The charts of an atlas: their meshes, their maps, and what becomes of those without a map.

#include "closed_meshes.h"
#include "mesh_conversions.h"
#include "surface_with_corner_map.h"
#include "test_meshes.h"
#include "visitors.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/read_corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Chart_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace test_atlas_charts {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::Surface_mesh_parameterization::parameters;

internal::Corner_mesh corner_mesh_of(const Flat_mesh& surface)
{
  internal::Corner_mesh result;
  EXPECT_EQ(internal::read_corner_mesh(make<Surface_mesh>(surface), result).code, OK);
  return result;
}

// Parameterizers walk around vertices from their halfedges, so that all indices matter.
TEST(Chart_mesh, is_the_mesh_of_its_faces_added_one_by_one)
{
  std::vector<Flat_mesh> all = { grid_with_holes(20), fan(500), open_fan(60), delaunay_patch(800, 3, wavy) };
  for (const Uncut_surface& s : uncut_surfaces())
    all.push_back(s.mesh);
  for (const Flat_mesh& surface : all) {
    const internal::Corner_mesh chart = corner_mesh_of(surface);
    internal::Chart_mesh mesh, expected;
    ASSERT_TRUE(internal::make_chart_mesh(chart, mesh));
    for (const Point_3& p : chart.points)
      expected.add_vertex(internal::times_power_of_two(p, -chart.scale_exponent));
    typedef internal::Chart_mesh::Vertex_index Vertex;
    for (std::size_t h = 0; h < chart.vertex.size(); h += 3)
      expected.add_face(Vertex(chart.vertex[h]), Vertex(chart.vertex[h + 1]), Vertex(chart.vertex[h + 2]));
    EXPECT_TRUE(mesh.is_valid(false));
    ASSERT_EQ(mesh.number_of_halfedges(), expected.number_of_halfedges());
    ASSERT_EQ(mesh.number_of_faces(), expected.number_of_faces());
    for (const auto h : mesh.halfedges()) {
      ASSERT_EQ(mesh.target(h), expected.target(h));
      ASSERT_EQ(mesh.face(h), expected.face(h));
      ASSERT_EQ(mesh.next(h), expected.next(h));
      ASSERT_EQ(mesh.prev(h), expected.prev(h));
    }
    ASSERT_EQ(mesh.number_of_vertices(), surface.points.size());
    for (const auto v : mesh.vertices()) {
      ASSERT_EQ(mesh.halfedge(v), expected.halfedge(v));
      ASSERT_EQ(mesh.point(v), expected.point(v));
    }
    for (const auto f : mesh.faces())
      ASSERT_EQ(mesh.halfedge(f), expected.halfedge(f));
  }
}

TEST(Chart_mesh, has_no_two_edges_with_the_same_ends)
{
  internal::Corner_mesh chart = corner_mesh_of(grid(8, 8, wavy));
  Index h = 0;
  while (chart.is_border(h))
    ++h;
  chart.sever(h);
  internal::Chart_mesh mesh;
  EXPECT_FALSE(internal::make_chart_mesh(chart, mesh));
}

TEST(Options_of_charts, are_checked_before_the_surface_is_cut)
{
  Surface closed(sphere(12, 16));
  const auto expect_refused = [&](const Atlas_summary& summary, const std::string& option) {
    EXPECT_EQ(summary.error.code, ERROR_WRONG_PARAMETER);
    EXPECT_EQ(summary.error.place, Parameterization_error::NOWHERE);
    EXPECT_NE(error_message(summary.error).find(option), std::string::npos);
    EXPECT_EQ(summary.cut.seam_edges, 0u);
  };
  const auto none = parameters::default_values();
  expect_refused(atlas_parameterization(closed.mesh, closed.uv, none, parameters::tolerance(-1.)), "tolerance");
  expect_refused(atlas_parameterization<LSCM_parameterizer_3>(closed.mesh, closed.uv, none,
                                                              parameters::number_of_iterations(-1)),
                 "number_of_iterations");
  EXPECT_EQ(atlas_parameterization(closed.mesh, closed.uv, none, parameters::tolerance(1e-3)).error.code, OK);
}

// A method that some charts do not suit.
template <class TriangleMesh>
struct Picky_parameterizer_3
{
  typedef TriangleMesh           Triangle_mesh;
  typedef CGAL::Sequential_tag   Concurrency_tag;
  static constexpr bool is_flip_free = true;

  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Picky_parameterizer_3(const NamedParameters& np = parameters::default_values()) : m_method(np) { }

  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv)
  {
    return m_method.parameterize_coarsest(level, uv);
  }
  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary)
  {
    return level.number_of_vertices() > 50 ? ERROR_NO_1_TO_1_MAPPING : m_method.refine(level, uv, summary);
  }

private:
  Symmetric_Dirichlet_parameterizer_3<TriangleMesh> m_method;
};

TEST(Atlas, tells_of_charts_without_a_map)
{
  Surface surface(with_component(sphere(9, 12), grid(4, 4, wavy)));
  const Atlas_summary summary = atlas_parameterization<Picky_parameterizer_3>(surface.mesh, surface.uv);
  EXPECT_EQ(summary.error.code, ERROR_NO_1_TO_1_MAPPING);
  ASSERT_EQ(summary.charts.size(), 2u);
  EXPECT_FALSE(summary.charts[0].summary.is_ok());
  EXPECT_TRUE(summary.charts[1].summary.is_ok());
  std::size_t untouched_corners = 0;
  for (const Kernel::Point_2& p : surface.corners())
    untouched_corners += p == untouched();
  EXPECT_EQ(untouched_corners, 3 * summary.charts[0].faces);
}

// Weighted means put a triangle on a line whose corner has no neighbors but the other two.
TEST(Atlas, has_no_flips_with_methods_for_which_they_are_errors)
{
  const Flat_mesh surface = part(grid(12, 12, wavy), [](const Point_3& p) {
    return std::abs(p.x() - 0.5) > 0.3 || std::abs(p.y() - 0.5) > 0.3 || p.x() + 0.5 * p.y() < 0.4;
  });
  Surface repaired(surface), failed(surface);
  const Atlas_summary summary =
      atlas_parameterization<Mean_value_coordinates_parameterizer_3>(repaired.mesh, repaired.uv);
  ASSERT_TRUE(summary.is_ok());
  ASSERT_FALSE(summary.charts.empty());
  EXPECT_GT(summary.charts[0].summary.flips, 0u);
  for (const auto& chart : repaired.charts())
    for (const internal::Triangle_2& t : chart)
      EXPECT_TRUE(turns_left(t[0], t[1], t[2]));
  const Parameterization_error error =
      atlas_parameterization<Mean_value_coordinates_parameterizer_3>(
          failed.mesh, failed.uv, parameters::default_values(), parameters::flip_policy(Flip_policy::FAIL)).error;
  EXPECT_EQ(error.code, ERROR_NO_1_TO_1_MAPPING);
  EXPECT_EQ(error.index, 0u);
  EXPECT_NE(error.cause, nullptr);
}

TEST(Atlas, is_not_made_if_a_visitor_stops_a_chart)
{
  std::size_t all_calls = 0;
  const std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();
  for (const std::size_t most_calls : { unlimited, std::size_t(1), std::size_t(8) }) {
    Surface surface(with_component(sphere(9, 12), grid(4, 4, wavy)));
    std::size_t calls = 0;
    const On_progress visitor([&](const Parameterization_progress&) { return ++calls < most_calls; });
    const Atlas_summary summary = atlas_parameterization(surface.mesh, surface.uv, parameters::default_values(),
                                                         parameters::visitor(visitor));
    if (most_calls == unlimited) {
      EXPECT_TRUE(summary.is_ok());
      all_calls = calls;
      continue;
    }
    EXPECT_EQ(summary.error.code, ERROR_STOPPED);
    EXPECT_LT(most_calls, all_calls);
    EXPECT_EQ(calls, most_calls);
    for (const Atlas_summary::Chart& chart : summary.charts)
      EXPECT_TRUE(chart.faces > 0 && (!chart.summary.is_ok() || &chart == &summary.charts.front()));
    for (const Kernel::Point_2& p : surface.corners())
      EXPECT_EQ(p, untouched());
  }
}

TEST(Atlas, tells_the_chart_of_each_face)
{
  Surface surface(with_component(sphere(9, 12), grid(4, 4, wavy)));
  const Atlas_summary summary = atlas_parameterization(surface.mesh, surface.uv);
  ASSERT_EQ(summary.chart_of_face.size(), surface.mesh.number_of_faces());
  for (std::size_t i = 0; i < summary.charts.size(); ++i)
    EXPECT_EQ(std::size_t(std::count(summary.chart_of_face.begin(), summary.chart_of_face.end(), i)),
              summary.charts[i].faces);
  for (const auto h : surface.mesh.halfedges()) {
    const auto o = surface.mesh.opposite(h);
    if (!surface.mesh.is_border(h) && !surface.mesh.is_border(o) && surface.uv[h] == surface.uv[surface.mesh.prev(o)]) {
      EXPECT_EQ(summary.chart_of_face[surface.mesh.face(h)], summary.chart_of_face[surface.mesh.face(o)]);
    }
  }
}

// The map that LSCM finds of such a needle is mirrored.
TEST(Atlas, has_no_mirrored_chart)
{
  const double thickness = 8.828180325246348e-44;
  Flat_mesh m = single_triangle();
  m.points.insert(m.points.end(), { { 0, -thickness, thickness }, { 107374592, 8.688e-44, -8.968e-44 },
                                    { thickness, 0, -thickness } });
  m.triangles.push_back({ 3, 4, 5 });
  Surface surface(m);
  const auto np_of_charts = parameters::flip_policy(Flip_policy::FAIL);
  const Atlas_summary summary = atlas_parameterization<LSCM_parameterizer_3>(
      surface.mesh, surface.uv, parameters::default_values(), np_of_charts);
  EXPECT_TRUE(summary.is_ok());
  expect_one_to_one(surface);
}

#ifdef CGAL_LINKED_WITH_TBB
template <template <class...> class Method>
void expect_same_with_several_threads(const Flat_mesh& m)
{
  Surface one(m), several(m);
  ASSERT_TRUE(atlas_parameterization<Method>(one.mesh, one.uv).is_ok());
  ASSERT_TRUE((atlas_parameterization<Method, CGAL::Parallel_tag>(several.mesh, several.uv).is_ok()));
  EXPECT_EQ(one.corners(), several.corners());
}

// A chart may be large enough for threads of its own, or one of many.
TEST(Atlas, is_the_same_with_several_threads)
{
  expect_same_with_several_threads<Symmetric_Dirichlet_parameterizer_3>(uncut_surfaces().back().mesh);
  expect_same_with_several_threads<LSCM_parameterizer_3>(uncut_surfaces().back().mesh);
  expect_same_with_several_threads<Symmetric_Dirichlet_parameterizer_3>(grid(60, 60, wavy));
  expect_same_with_several_threads<LSCM_parameterizer_3>(grid(60, 60, wavy));
}

struct Users_exception { };

// The charts that other threads lay out meanwhile go on to their ends.
TEST(Atlas, ends_by_an_exception_of_a_visitor_in_several_threads)
{
  const Flat_mesh part = cap(30, 80, 0.8 * CGAL_PI);
  Flat_mesh m = part;
  for (int i = 1; i < 4; ++i)
    m = with_component(m, part, 1 + i, 20 * i);
  for (int calls = 3; calls < 40; calls += 9) {
    Surface surface(m);
    std::atomic<int> calls_left(calls);
    const On_level visitor([&](const Level&, const Level::Uv&) {
      return --calls_left == 0 ? throw Users_exception() : true;
    });
    typedef CGAL::Parallel_tag   Tag;
    EXPECT_THROW((atlas_parameterization<Symmetric_Dirichlet_parameterizer_3, Tag>(
                     surface.mesh, surface.uv, parameters::distortion_bound(1e9),
                     parameters::visitor(visitor))),
                 Users_exception)
        << calls;
  }
}
#endif

} // namespace test_atlas_charts
