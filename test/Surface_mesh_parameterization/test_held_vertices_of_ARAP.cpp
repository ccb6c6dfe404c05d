// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Vertices that the as-rigid-as-possible method holds at given places.

#include "constrained_mesh.h"
#include "generated_meshes.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <functional>

namespace test_held_vertices_of_ARAP {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using Kernel_point = test_meshes::Kernel::Point_2;
namespace np = CGAL::Surface_mesh_parameterization::parameters;

typedef test_meshes::Surface_mesh   Mesh;

typedef As_rigid_as_possible_parameterizer_3<Mesh>   ARAP;

TEST(Held_vertices_of_ARAP, keep_their_places)
{
  for (const double lambda : { 1000., 0. })
    for (const bool is_hierarchical : { true, false }) {
      Constrained_mesh m(delaunay_patch(800, 3, wavy));
      ASSERT_EQ(m.run<Symmetric_Dirichlet_parameterizer_3<Mesh>>(), OK);
      m.hold_some(20);
      m.bend(0.02);
      const auto options = np::vertex_is_constrained_map(m.is_held).lambda(lambda).summary(std::ref(m.summary));
      ASSERT_EQ(m.run_with<ARAP>(options, is_hierarchical), OK);
      EXPECT_TRUE(m.summary.converged && m.is_valid());
      m.expect_places_are_held();
    }
}

TEST(Held_vertices_of_ARAP, leave_a_developable_surface_without_distortion)
{
  Constrained_mesh m(helix(1000, 50));
  m.is_held[Mesh::Vertex_index(7)] = true;
  m.uvmap[Mesh::Vertex_index(7)] = Kernel_point(3, -5);
  ASSERT_EQ(m.run_with<ARAP>(np::vertex_is_constrained_map(m.is_held).summary(std::ref(m.summary))), OK);
  m.expect_places_are_held();
  EXPECT_TRUE(m.summary.converged && m.is_valid());
  EXPECT_LT(m.summary.energy, 1e-9 * m.area());
}

// With lambda = 0 and two vertices held, the energy is that of least squares conformal maps, which is quadratic: any
// two places lead to similar maps.
TEST(Held_vertices_of_ARAP, pin_a_conformal_map)
{
  Constrained_mesh m(delaunay_patch(800, 3, wavy)), turned(delaunay_patch(800, 3, wavy));
  const auto a = Mesh::Vertex_index(11), b = Mesh::Vertex_index(500);
  const auto run = [&](Constrained_mesh& one, const Kernel_point& place_of_a, const Kernel_point& place_of_b) {
    one.is_held[a] = one.is_held[b] = true;
    one.uvmap[a] = place_of_a;
    one.uvmap[b] = place_of_b;
    return one.run_with<ARAP>(np::vertex_is_constrained_map(one.is_held).lambda(0.).tolerance(1e-12).flip_policy(
        Flip_policy::KEEP));
  };
  ASSERT_EQ(run(m, Kernel_point(0, 0), Kernel_point(1, 0)), OK);
  ASSERT_EQ(run(turned, Kernel_point(1, 2), Kernel_point(1, 4)), OK);
  for (const auto v : vertices(m.mesh)) {
    EXPECT_NEAR(turned.uvmap[v].x(), 1 - 2 * m.uvmap[v].y(), 1e-5);
    EXPECT_NEAR(turned.uvmap[v].y(), 2 + 2 * m.uvmap[v].x(), 1e-5);
  }
}

} // namespace test_held_vertices_of_ARAP
