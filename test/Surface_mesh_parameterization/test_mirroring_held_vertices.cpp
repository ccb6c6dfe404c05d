// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether places that vertices are held at mirror the map.

#include "constrained_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cmath>

namespace test_mirroring_held_vertices {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using Kernel_point = test_meshes::Kernel::Point_2;
namespace np = CGAL::Surface_mesh_parameterization::parameters;

typedef test_meshes::Surface_mesh   Mesh;

template <class Method>
class Mirroring_held_vertices : public testing::Test { };

typedef testing::Types<MIPS_parameterizer_3<Mesh>, Symmetric_Dirichlet_parameterizer_3<Mesh>>   Methods;
TYPED_TEST_SUITE(Mirroring_held_vertices, Methods);

// CGAL's square runs around the map the other way than its circle.
TYPED_TEST(Mirroring_held_vertices, may_mirror_the_map)
{
  Constrained_mesh m(delaunay_patch(800, 3, wavy)), mirrored(delaunay_patch(800, 3, wavy));
  m.place_border<Square_border_uniform_parameterizer_3<Mesh>>(1);
  mirrored.place_border<Square_border_uniform_parameterizer_3<Mesh>>(1);
  for (const auto v : vertices(mirrored.mesh))
    mirrored.uvmap[v] = Kernel_point(-mirrored.uvmap[v].x(), mirrored.uvmap[v].y());
  ASSERT_EQ(m.run<TypeParam>(), OK);
  ASSERT_EQ(mirrored.run<TypeParam>(), OK);
  m.expect_places_are_held();
  mirrored.expect_places_are_held();
  EXPECT_NE(m.is_valid(), mirrored.is_valid());
  for (const auto v : vertices(m.mesh))
    EXPECT_EQ(m.uvmap[v], Kernel_point(-mirrored.uvmap[v].x(), mirrored.uvmap[v].y()));
}

// The places along a side, or in a bay, run around nothing, or the other way than the border does.
TYPED_TEST(Mirroring_held_vertices, on_a_part_of_the_border_do_not_mirror_the_map)
{
  const Flat_mesh square = grid(12, 12, flat);
  Flat_mesh half_ring = square;
  for (Point_3& p : half_ring.points) {
    const double radius = 1 + p.y(), angle = CGAL_PI * (1 - p.x());
    p = Point_3(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  for (const Flat_mesh& surface : { square, half_ring })
    for (int turn = 0; turn < 8; ++turn)
      for (const bool starts_from_map : { false, true }) {
        Constrained_mesh m(surface);
        const double c = std::cos(0.1 + turn), s = std::sin(0.1 + turn);
        for (const auto v : vertices(m.mesh)) {
          const Point_3& p = m.mesh.point(v);
          m.uvmap[v] = Kernel_point(c * p.x() - s * p.y(), s * p.x() + c * p.y());
          m.is_held[v] = square.points[v].y() == 0;
        }
        ASSERT_EQ(m.template run_with<TypeParam>(
                      parameters::vertex_is_constrained_map(m.is_held).initial_map(starts_from_map)),
                  OK);
        m.expect_places_are_held();
        EXPECT_TRUE(m.is_valid()) << turn;
      }
}

// Without a place that says so, a result is positive, whatever it starts from.
TYPED_TEST(Mirroring_held_vertices, that_are_none_do_not_mirror_the_map)
{
  for (const bool is_hierarchical : { false, true }) {
    Constrained_mesh m(grid(12, 9, wavy));
    ASSERT_EQ(m.run<TypeParam>(), OK);
    for (const auto v : vertices(m.mesh))
      m.uvmap[v] = Kernel_point(-m.uvmap[v].x(), m.uvmap[v].y());
    const auto options =
        parameters::initial_map(true).vertex_is_constrained_map(m.is_held).position_weight_map(m.weight);
    EXPECT_EQ(m.run_with<TypeParam>(options, is_hierarchical), OK);
    EXPECT_FALSE(m.quality().is_mirrored);
    EXPECT_EQ(m.quality().flips, 0u);
  }
}

// Of a start and the places of a triangle that are turned differently, these are right.
TYPED_TEST(Mirroring_held_vertices, at_a_triangle_outweigh_a_mirrored_start)
{
  Constrained_mesh m(delaunay_patch(800, 3, wavy));
  ASSERT_EQ(m.run<TypeParam>(), OK);
  for (const auto v : vertices(m.mesh))
    m.uvmap[v] = Kernel_point(-m.uvmap[v].x(), m.uvmap[v].y());
  for (const auto v : vertices_around_face(m.mesh.halfedge(Mesh::Face_index(100)), m.mesh)) {
    m.is_held[v] = true;
    m.uvmap[v] = Kernel_point(-m.uvmap[v].x(), m.uvmap[v].y());
  }
  ASSERT_EQ(m.run_with<TypeParam>(parameters::initial_map(true).vertex_is_constrained_map(m.is_held)), OK);
  m.expect_places_are_held();
  EXPECT_TRUE(m.is_valid());
}

} // namespace test_mirroring_held_vertices
