// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Seams that make disks of any surface.

#include "closed_meshes.h"
#include "mesh_conversions.h"
#include "seam_meshes.h"
#include "surface_with_corner_map.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/cut_to_disk.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/read_corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>

namespace test_cut_to_disk {

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
    std::set<Surface_mesh::Face_index> faces;      // of the components that were seen
    std::size_t components = 0;
    for (const auto h : halfedges(seam_mesh))
      if (is_border(h, seam_mesh) && faces.count(face(opposite(h, seam_mesh), seam_mesh)) == 0) {
        const Mesh_component<Seam_mesh> component(seam_mesh, h);
        ASSERT_EQ(component.error().code, OK) << components;
        faces.insert(component.faces_of_component().begin(), component.faces_of_component().end());
        ++components;
      }
    EXPECT_EQ(components, s.genus.size());
    EXPECT_EQ(faces.size(), num_faces(surface.mesh));
  }
}

// A loop around a handle and one through it cannot be much shorter than this; a seam that were one of these too long
// would show.
TEST(Cut_to_disk, cuts_a_torus_along_two_short_loops)
{
  Surface surface(plate_with_holes(1, 8));
  const Cut_summary summary = cut_to_disk(surface.mesh, surface.seams,
                                          parameters::distortion_bound((std::numeric_limits<double>::infinity)()));
  ASSERT_FALSE(summary.components.empty());
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
      ASSERT_FALSE(cut.components.empty());
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
    ASSERT_FALSE(cut.components.empty());
    EXPECT_LE(cut.components[0].distortion, bound);
    EXPECT_GT(cut.components[0].branches, 0u);
  }
}

TEST(Cut_to_disk, cuts_disks_only_where_it_is_asked_to)
{
  Surface disk(grid_with_holes(20));
  EXPECT_EQ(cut_to_disk(disk.mesh, disk.seams).seam_edges, 0u);
  const Cut_summary joined = cut_to_disk(disk.mesh, disk.seams, parameters::join_borders(true));
  ASSERT_FALSE(joined.components.empty());
  EXPECT_GT(joined.components[0].borders, 1u);
  EXPECT_GT(joined.seam_edges, 0u);
  // What was a seam is one, and divides components.
  const Cut_summary again = cut_to_disk(disk.mesh, disk.seams);
  ASSERT_FALSE(again.components.empty());
  EXPECT_EQ(again.components[0].borders, 1u);
  EXPECT_EQ(again.seam_edges, 0u);
}

// Two pyramids with a common base, whose apexes become joined by several edges.
Surface_mesh with_double_edges(Index sides, Index edges_of_apexes)
{
  Flat_mesh m;
  m.points = { Point_3(0, 0, 1), Point_3(0, 0, -1) };
  for (Index i = 0; i < sides; ++i) {
    const double angle = 2 * CGAL_PI * i / sides;
    m.points.emplace_back(std::cos(angle), std::sin(angle), 0);
    const Index v = 2 + i, next = 2 + (i + 1) % sides;
    m.triangles.push_back({ 0, v, next });
    m.triangles.push_back({ 1, next, v });
  }
  Surface_mesh result = make<Surface_mesh>(m);
  for (Index i = 0; i < edges_of_apexes; ++i) {
    const Index j = i * (sides / edges_of_apexes);
    const Surface_mesh::Vertex_index v(2 + j), next(2 + (j + 1) % sides);
    CGAL::Euler::flip_edge(result.halfedge(v, next), result);
  }
  return result;
}

// What tells triangles by their vertices cannot tell these.
TEST(Cut_to_disk, severs_edges_with_the_same_ends)
{
  for (const Index edges_of_apexes : { 2, 3 })
    for (const Index sides : { 3, 4, 6, 9 }) {
      Surface surface{ Flat_mesh() };
      surface.mesh.join(with_double_edges(sides, edges_of_apexes));
      ASSERT_TRUE(CGAL::is_closed(surface.mesh));
      const Cut_summary summary = cut_to_disk(surface.mesh, surface.seams);
      ASSERT_TRUE(summary.is_ok());
      EXPECT_EQ(summary.components.size(), edges_of_apexes);
      EXPECT_EQ(summary.seam_edges, std::size_t(std::count(surface.seams.begin(), surface.seams.end(), true)));
      internal::Corner_mesh corners;
      ASSERT_EQ(internal::read_corner_mesh(surface.mesh, surface.seams, corners).code, OK);
      std::map<std::set<Index>, std::set<Index>> edges;     // by ends
      for (Index h = 0; h < corners.number_of_halfedges(); ++h)
        edges[{ corners.source(h), corners.target(h) }].insert(
            corners.is_border(h) ? h : (std::min)(h, corners.opposite[h]));
      for (const auto& [ends, edges_between] : edges) {
        EXPECT_EQ(ends.size(), 2u);
        EXPECT_EQ(edges_between.size(), 1u);
      }
      EXPECT_TRUE(atlas_parameterization(surface.mesh, surface.uv).is_ok());
      expect_one_to_one(surface);
    }
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
    EXPECT_EQ(p, untouched());
}

} // namespace test_cut_to_disk
