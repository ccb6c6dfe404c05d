// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Atlases: any surface in, every corner in the plane.

#include "closed_meshes.h"
#include "mesh_conversions.h"
#include "surface_with_corner_map.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace test_atlas {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::Surface_mesh_parameterization::parameters;

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
  ASSERT_FALSE(charts.empty());
  ASSERT_EQ(charts.size(), charts_in_space.size());
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

// Times a power of two, which rounds no coordinate: up to some 1e270, or down to that part of 1.
Flat_mesh times_power_of_two(Flat_mesh m, int exponent)
{
  for (Kernel::Point_3& p : m.points)
    p = Kernel::Point_3(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent));
  return m;
}

std::vector<Kernel::Point_2> times_power_of_two(std::vector<Kernel::Point_2> corners, int exponent)
{
  for (Kernel::Point_2& p : corners)
    p = Kernel::Point_2(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent));
  return corners;
}

Flat_mesh grid_without_three_triangles()
{
  Flat_mesh m = grid(20, 10, wavy);
  for (const std::ptrdiff_t f : { 333, 222, 111 })
    m.triangles.erase(m.triangles.begin() + f);
  return m;
}

// Cut, closed at holes, divided and packed: the same whatever the unit of length is.
TEST(Atlas, is_the_same_at_all_scales)
{
  std::vector<Uncut_surface> surfaces = uncut_surfaces();
  surfaces.push_back({ "grid_without_three_triangles", grid_without_three_triangles(), {} });
  for (const Uncut_surface& s : surfaces)
    for (const bool is_square : { true, false }) {
      SCOPED_TRACE(s.name);
      const auto np = parameters::least_used_part(0.6).hole_bound(1.).unit_square(is_square);
      Surface surface(s.mesh);
      const Atlas_summary summary = atlas_parameterization(surface.mesh, surface.uv, np);
      ASSERT_TRUE(summary.is_ok());
      for (const int exponent : is_square ? std::vector<int>{ -900, 70 } : std::vector<int>{ -90, 900 }) {
        SCOPED_TRACE(exponent);
        Surface other(times_power_of_two(s.mesh, exponent));
        const Atlas_summary other_summary = atlas_parameterization(other.mesh, other.uv, np);
        ASSERT_TRUE(other_summary.is_ok());
        EXPECT_EQ(other_summary.chart_of_face, summary.chart_of_face);
        EXPECT_EQ(other_summary.used_part, summary.used_part);
        EXPECT_EQ(other_summary.cut.seam_length, std::ldexp(summary.cut.seam_length, exponent));
        EXPECT_EQ(other.corners(), times_power_of_two(surface.corners(), is_square ? 0 : exponent));
      }
    }
}

// A component on a line, or at one place, is as large in the atlas as in space, and takes no room from others.
TEST(Atlas, has_components_without_area)
{
  const auto used_part = [](double length, double scale) {
    Flat_mesh line = grid(6, 6, flat);
    for (Kernel::Point_3& p : line.points)
      p = Kernel::Point_3(length * p.x(), 0, 0);
    Surface surface(with_component(grid(8, 8, wavy), line, 1, 9));
    for (const auto v : surface.mesh.vertices())
      surface.mesh.point(v) = CGAL::ORIGIN + scale * (surface.mesh.point(v) - CGAL::ORIGIN);
    const Atlas_summary summary = atlas_parameterization(surface.mesh, surface.uv);
    EXPECT_TRUE(summary.is_ok());
    EXPECT_EQ(summary.charts.size(), 2u);
    expect_one_to_one(surface);
    return summary.used_part;
  };
  for (const double scale : { 1., 100., 0.001 }) {
    EXPECT_GT(used_part(0.01, scale), 0.8);
    EXPECT_GT(used_part(0, scale), 0.8);
  }
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
      ASSERT_FALSE(summary.charts.empty());
      EXPECT_TRUE(summary.charts[0].summary.is_ok());
      EXPECT_GE(summary.cut.seam_edges, 1u);
      EXPECT_NE(summary.charts.back().summary.error.code, ERROR_NO_TOPOLOGICAL_DISC);
    }
    const auto charts = surface.charts();
    ASSERT_FALSE(charts.empty());
    EXPECT_EQ(charts[0].size(), sphere(9, 12).triangles.size());
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

} // namespace test_atlas
