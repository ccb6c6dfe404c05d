// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Seams, atlases and their packing: any surface in, every corner in the plane.

#include "closed_meshes.h"
#include "mesh_conversions.h"
#include "seam_meshes.h"
#include "surface_with_corner_map.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/cut_to_disk.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas.h>
#include <CGAL/Surface_mesh_parameterization/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace test_atlas {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::Surface_mesh_parameterization::parameters;

TEST(Cut_to_disk, leaves_disks_that_a_seam_mesh_takes)
{
  for (const Uncut_surface& s : uncut_surfaces()) {
    SCOPED_TRACE(s.name);
    Surface surface(s.mesh);
    const Cut_summary summary = cut_to_disk(surface.mesh, surface.seams);
    ASSERT_TRUE(summary.is_ok());
    ASSERT_EQ(summary.components.size(), s.genus.size());
    for (std::size_t i = 0; i < s.genus.size(); ++i)
      EXPECT_EQ(summary.components[i].genus, s.genus[i]);

    const auto is_seam_vertex = surface.mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:seam", false).first;
    std::size_t seam_edges = 0;
    double seam_length = 0;
    for (const auto e : surface.mesh.edges())
      if (surface.seams[e]) {
        const auto v = surface.mesh.vertex(e, 0), w = surface.mesh.vertex(e, 1);
        EXPECT_FALSE(surface.mesh.is_border(e));
        is_seam_vertex[v] = is_seam_vertex[w] = true;
        ++seam_edges;
        seam_length += std::sqrt(CGAL::squared_distance(surface.mesh.point(v), surface.mesh.point(w)));
      }
    EXPECT_EQ(summary.seam_edges, seam_edges);
    EXPECT_NEAR(summary.seam_length, seam_length, 1e-12 * seam_length);
    const Seam_mesh seam_mesh(surface.mesh, surface.seams, is_seam_vertex);
    std::size_t borders = 0;
    for (const auto h : halfedges(seam_mesh))
      if (is_border(h, seam_mesh) && borders++ % 20 == 0) {
        EXPECT_EQ(Mesh_component<Seam_mesh>(seam_mesh, h).error().code, OK) << borders;
      }
    EXPECT_GT(borders, 0u);
  }
}

// A loop around a handle and one through it cannot be much shorter than this; a seam that were one of these too long
// would show.
TEST(Cut_to_disk, cuts_a_torus_along_two_short_loops)
{
  Surface surface(plate_with_holes(1, 8));
  const Cut_summary summary = cut_to_disk(surface.mesh, surface.seams,
                                          parameters::distortion_bound((std::numeric_limits<double>::infinity)()));
  EXPECT_EQ(summary.components[0].branches, 0u);
  EXPECT_GE(summary.seam_length, 4 + 4);         // around a bar of the plate, and around its hole
  EXPECT_LE(summary.seam_length, 2 * (4 + 4));
}

TEST(Cut_to_disk, bounds_the_distortion_by_branches)
{
  for (const Flat_mesh& m : { sphere(30, 40), plate_with_holes(2, 5), deep_cap() }) {
    double last_length = -1;
    for (const double bound : { 20., 4.4, 4.15 }) {
      SCOPED_TRACE(bound);
      Surface surface(m);
      const Cut_summary cut = cut_to_disk(surface.mesh, surface.seams, parameters::distortion_bound(bound));
      EXPECT_LE(cut.components[0].distortion, bound);
      EXPECT_GE(cut.seam_length, last_length);
      last_length = cut.seam_length;

      const Atlas_summary atlas =
          atlas_parameterization(surface.mesh, surface.uv, parameters::distortion_bound(bound));
      ASSERT_EQ(atlas.charts.size(), 1u);
      EXPECT_LE(atlas.charts[0].summary.energy, 1.02 * bound);       // the bound is that of a coarse level
    }
  }
}

// After the first cut, every vertex that is left lies next to the border.
TEST(Cut_to_disk, bounds_the_distortion_of_surfaces_of_few_triangles)
{
  constexpr double bound = 4.5;
  for (const Flat_mesh& m : { tetrahedron(), box(1, 1, 1), box(1, 1, 10), box(1, 2, 3) }) {
    Surface surface(m);
    const Cut_summary cut = cut_to_disk(surface.mesh, surface.seams, parameters::distortion_bound(bound));
    EXPECT_LE(cut.components[0].distortion, bound);
    EXPECT_GT(cut.components[0].branches, 0u);
  }
}

TEST(Cut_to_disk, cuts_disks_only_where_it_is_asked_to)
{
  Surface disk(grid_with_holes(20));
  EXPECT_EQ(cut_to_disk(disk.mesh, disk.seams).seam_edges, 0u);
  const Cut_summary joined = cut_to_disk(disk.mesh, disk.seams, parameters::join_borders(true));
  EXPECT_GT(joined.components[0].borders, 1u);
  EXPECT_GT(joined.seam_edges, 0u);
  // What was a seam is one, and divides components.
  const Cut_summary again = cut_to_disk(disk.mesh, disk.seams);
  EXPECT_EQ(again.components[0].borders, 1u);
  EXPECT_EQ(again.seam_edges, 0u);
}

TEST(Cut_to_disk, names_what_it_cannot_read)
{
  Surface_mesh empty;
  EXPECT_EQ(cut_to_disk(empty, CGAL::Static_boolean_property_map<Surface_mesh::Edge_index, false>()).error.code,
            ERROR_EMPTY_MESH);

  Surface not_finite(tetrahedron());
  not_finite.mesh.point(Surface_mesh::Vertex_index(2)) =
      Kernel::Point_3(0, (std::numeric_limits<double>::quiet_NaN)(), 0);
  const Cut_summary summary = cut_to_disk(not_finite.mesh, not_finite.seams);
  EXPECT_EQ(summary.error.code, ERROR_WRONG_PARAMETER);
  EXPECT_EQ(summary.error.index, 2u);

  Surface ball(sphere(5, 8));
  for (const double bound : { 3.9, (std::numeric_limits<double>::quiet_NaN)() }) {
    const Cut_summary refused = cut_to_disk(ball.mesh, ball.seams, parameters::distortion_bound(bound));
    EXPECT_EQ(refused.error.code, ERROR_WRONG_PARAMETER);
    EXPECT_NE(error_message(refused.error).find("distortion_bound"), std::string::npos);
  }

  Surface square(two_ears());
  CGAL::Euler::join_face(*std::find_if(square.mesh.halfedges().begin(), square.mesh.halfedges().end(), [&](auto h) {
    return !square.mesh.is_border(square.mesh.edge(h));
  }), square.mesh);
  square.mesh.collect_garbage();
  EXPECT_EQ(cut_to_disk(square.mesh, square.seams).error.code, ERROR_NON_TRIANGULAR_MESH);
  EXPECT_EQ(atlas_parameterization(square.mesh, square.uv).error.code, ERROR_NON_TRIANGULAR_MESH);
  for (const Kernel::Point_2& p : square.corners())
    EXPECT_EQ(p, untouched);
}

template <template <class...> class Method>
void expect_atlases_of_all_surfaces()
{
  for (const Uncut_surface& s : uncut_surfaces()) {
    SCOPED_TRACE(s.name);
    Surface surface(s.mesh);
    const Atlas_summary summary = atlas_parameterization<Method>(surface.mesh, surface.uv);
    EXPECT_TRUE(summary.is_ok());
    EXPECT_EQ(summary.charts.size(), s.genus.size() + summary.divisions);
    EXPECT_EQ(number_of_faces(surface.charts()), surface.mesh.number_of_faces());
    EXPECT_EQ(surface.charts().size(), summary.charts.size());      // places differ on seams only
    expect_one_to_one(surface);
  }
}

TEST(Atlas, has_every_corner_once_with_symmetric_Dirichlet)
{
  expect_atlases_of_all_surfaces<Symmetric_Dirichlet_parameterizer_3>();
}

TEST(Atlas, has_every_corner_once_with_MIPS)
{
  expect_atlases_of_all_surfaces<MIPS_parameterizer_3>();
}

TEST(Atlas, has_one_scale)
{
  Surface surface(uncut_surfaces().back().mesh);
  ASSERT_TRUE(atlas_parameterization(surface.mesh, surface.uv).is_ok());
  Surface in_space(uncut_surfaces().back().mesh);
  ASSERT_TRUE(atlas_parameterization(in_space.mesh, in_space.uv, parameters::unit_square(false)).is_ok());
  const auto area = [](const std::vector<internal::Triangle_2>& chart) {
    double sum = 0;
    for (const internal::Triangle_2& t : chart)
      sum += 0.5 * internal::cross(t[1] - t[0], t[2] - t[0]);
    return sum;
  };
  const auto charts = surface.charts(), charts_in_space = in_space.charts();
  const double scale = area(charts[0]) / area(charts_in_space[0]);
  double area_in_space = 0, total = 0;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    EXPECT_NEAR(area(charts[i]) / area(charts_in_space[i]), scale, 1e-9 * scale);
    total += area(charts_in_space[i]);
  }
  for (const auto f : in_space.mesh.faces()) {
    std::vector<Kernel::Point_3> p;
    for (const auto v : in_space.mesh.vertices_around_face(in_space.mesh.halfedge(f)))
      p.push_back(in_space.mesh.point(v));
    area_in_space += std::sqrt(CGAL::squared_area(p[0], p[1], p[2]));
  }
  EXPECT_NEAR(total, area_in_space, 1e-9 * area_in_space);
}

TEST(Atlas, goes_along_the_seams_of_the_user)
{
  Surface surface(grid(10, 10, wavy));
  for (const auto e : surface.mesh.edges()) {
    const auto h = surface.mesh.halfedge(e);
    surface.seams[e] = surface.mesh.point(surface.mesh.source(h)).x() == 0.5 &&
                       surface.mesh.point(surface.mesh.target(h)).x() == 0.5;
  }
  const Atlas_summary summary = atlas_parameterization(surface.mesh, surface.uv,
                                                       parameters::edge_is_constrained_map(surface.seams));
  EXPECT_TRUE(summary.is_ok());
  EXPECT_EQ(summary.charts.size(), 2u);
  EXPECT_EQ(surface.charts().size(), 2u);
  expect_one_to_one(surface);
}

// A seam of one edge leaves a border of two edges with the same ends; so does a sphere whose points all coincide.
TEST(Atlas, opens_seams_of_one_edge)
{
  Flat_mesh point = tetrahedron();
  for (Point_3& p : point.points)
    p = Point_3(5, 5, 5);
  for (const Flat_mesh& m : { sphere(9, 12), with_component(sphere(9, 12), point) }) {
    Surface surface(m);
    surface.seams[surface.mesh.edge(surface.mesh.halfedge(Surface_mesh::Vertex_index(0)))] = true;
    for (const double bound : { 100., 4.5 }) {
      const Atlas_summary summary =
          atlas_parameterization(surface.mesh, surface.uv,
                                 parameters::edge_is_constrained_map(surface.seams).distortion_bound(bound));
      EXPECT_TRUE(summary.charts[0].summary.is_ok());
      EXPECT_GE(summary.cut.seam_edges, 1u);
      EXPECT_NE(summary.charts.back().summary.error.code, ERROR_NO_TOPOLOGICAL_DISC);
    }
    EXPECT_EQ(surface.charts()[0].size(), sphere(9, 12).triangles.size());
  }
}

// Seams of one edge each that do not meet part nothing, nor does what opens them.
TEST(Atlas, stays_whole_with_scattered_seams)
{
  Surface surface(sphere(20, 30));
  Random random(4);
  std::set<Surface_mesh::Vertex_index> ends;
  for (const auto e : surface.mesh.edges()) {
    const auto v = surface.mesh.vertex(e, 0), w = surface.mesh.vertex(e, 1);
    if (random(0, 1) < 0.5 && !ends.count(v) && !ends.count(w)) {
      surface.seams[e] = true;
      ends.insert({ v, w });
    }
  }
  ASSERT_GT(ends.size(), surface.mesh.number_of_vertices() / 2);
  const Atlas_summary summary = atlas_parameterization(
      surface.mesh, surface.uv,
      parameters::edge_is_constrained_map(surface.seams).overlap_bound(1.).least_used_part(0.));
  EXPECT_TRUE(summary.is_ok());
  EXPECT_EQ(summary.charts.size(), 1u);
  expect_one_to_one(surface);
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
    untouched_corners += p == untouched;
  EXPECT_EQ(untouched_corners, 3 * summary.charts[0].faces);
}

struct Stopping_visitor : Hierarchy_visitor_3
{
  std::size_t* calls;
  std::size_t most_calls;

  bool progressed(const Parameterization_progress&) { return ++*calls < most_calls; }
};

TEST(Atlas, is_not_made_if_a_visitor_stops_a_chart)
{
  std::size_t all_calls = 0;
  const std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();
  for (const std::size_t most_calls : { unlimited, std::size_t(1), std::size_t(8) }) {
    Surface surface(with_component(sphere(9, 12), grid(4, 4, wavy)));
    std::size_t calls = 0;
    Stopping_visitor visitor;
    visitor.calls = &calls;
    visitor.most_calls = most_calls;
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
      EXPECT_EQ(p, untouched);
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
#endif

TEST(Atlas, is_made_of_any_FaceGraph)
{
  typedef CGAL::Polyhedron_3<Kernel>                              Polyhedron;
  typedef boost::graph_traits<Polyhedron>::halfedge_descriptor    Polyhedron_halfedge;
  const Flat_mesh m = plate_with_holes(2, 3);
  const auto polyhedron = make<Polyhedron>(m);
  std::map<Polyhedron_halfedge, Kernel::Point_2> places;
  ASSERT_TRUE(atlas_parameterization(polyhedron, boost::make_assoc_property_map(places)).is_ok());
  Surface surface(m);
  ASSERT_TRUE(atlas_parameterization(surface.mesh, surface.uv).is_ok());
  EXPECT_EQ(places.size(), 3 * surface.mesh.number_of_faces());
}

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

// So many charts have no room for the margin.
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
    EXPECT_GT(distance(surface.charts()[0][0], surface.charts()[1][0]), margin);
  }
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
  EXPECT_TRUE(internal::part_borders(parted, apart.points, nullptr));
  EXPECT_EQ(overlaps(parted), 0u);
  EXPECT_TRUE(internal::is_positive(parted));
  for (std::size_t i = 0; i < parted.points.size(); ++i)
    EXPECT_LT((parted.points[i] - meeting.points[i]).squared_length(), 1e-15);
  // Borders that met before are not rounding's.
  internal::Flat_chart left = meeting;
  EXPECT_TRUE(internal::part_borders(left, meeting.points, nullptr));
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
    const Error_code code = pack_charts(surface.mesh, surface.uv);
    for (const Kernel::Point_2& p : surface.corners()) {
      EXPECT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y()));
      if (code == OK) {
        EXPECT_TRUE(p.x() > 0 && p.x() < 1 && p.y() > 0 && p.y() < 1) << p;
      }
    }
  }
}

void expect_one_to_one_in_floats(const Flat_mesh& m)
{
  Surface surface(m);
  const auto uv = surface.mesh
                      .add_property_map<Surface_mesh::Halfedge_index, CGAL::Simple_cartesian<float>::Point_2>("h:float")
                      .first;
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

} // namespace test_atlas
