// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Vertices that are held at given places.

#include "constrained_mesh.h"
#include "generated_meshes.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Distortion_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace test_held_vertices {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using Kernel_point = test_meshes::Kernel::Point_2;
namespace np = CGAL::Surface_mesh_parameterization::parameters;

typedef test_meshes::Surface_mesh   Mesh;

std::vector<Flat_mesh> surfaces()
{
  return { grid(40, 30, wavy), delaunay_patch(800, 3, wavy), cap(12, 32, 0.5 * CGAL_PI), grid_with_holes(20) };
}

template <class Method>
class Held_vertices : public testing::Test { };

typedef testing::Types<MIPS_parameterizer_3<Mesh>, Symmetric_Dirichlet_parameterizer_3<Mesh>>   Methods;
TYPED_TEST_SUITE(Held_vertices, Methods);

TYPED_TEST(Held_vertices, keep_their_places_to_the_last_bit)
{
  for (const Flat_mesh& surface : surfaces())
    for (const std::size_t one_of : { 3, 10, 100, 400 })
      for (const bool is_hierarchical : { true, false }) {
        Constrained_mesh m(surface);
        ASSERT_EQ(m.run<TypeParam>(), OK);
        const double energy = m.summary.energy;
        m.hold_some(one_of);
        m.bend(0.05);
        ASSERT_EQ(m.run<TypeParam>(is_hierarchical), OK) << surface.triangles.size() << ' ' << one_of;
        EXPECT_TRUE(m.summary.converged && m.is_valid());
        m.expect_places_are_held();
        EXPECT_GE(m.summary.energy, energy * (1 - 1e-6));
      }
}

TYPED_TEST(Held_vertices, cost_nothing_at_the_places_of_the_minimum)
{
  for (const Flat_mesh& surface : surfaces()) {
    Constrained_mesh m(surface);
    ASSERT_EQ(m.run<TypeParam>(true, 1e-10), OK);
    const double energy = m.summary.energy;
    m.hold_some(50);
    ASSERT_EQ(m.run<TypeParam>(true, 1e-10), OK);
    m.expect_places_are_held();
    EXPECT_NEAR(m.summary.energy, energy, 1e-9 * energy);
  }
}

// One that is held moves the map, two turn and scale it as well: all that costs MIPS nothing.
TYPED_TEST(Held_vertices, may_be_one_or_two)
{
  for (const int number : { 1, 2 }) {
    Constrained_mesh m(delaunay_patch(500, 3, wavy));
    ASSERT_EQ(m.run<TypeParam>(), OK);
    const double energy = m.summary.energy;
    const bool is_scaled = number == 2 && is_mips<TypeParam>;
    m.is_held[Mesh::Vertex_index(7)] = true;
    m.is_held[Mesh::Vertex_index(300)] = number == 2;
    for (const auto v : vertices(m.mesh)) {
      const Kernel_point p = m.uvmap[v];
      const double scale = is_scaled ? 100 : 1;
      m.uvmap[v] = Kernel_point(5 - scale * p.y(), scale * p.x() - 3);
    }
    ASSERT_EQ(m.run<TypeParam>(), OK);
    m.expect_places_are_held();
    EXPECT_NEAR(m.summary.energy, energy, 1e-6 * energy);
  }
}

TYPED_TEST(Held_vertices, move_the_free_map_if_there_is_one)
{
  for (const Flat_mesh& surface : surfaces()) {
    Constrained_mesh m(surface);
    ASSERT_EQ(m.run<TypeParam>(), OK);
    const std::vector<Kernel_point> free = m.uv();
    m.is_held[Mesh::Vertex_index(7)] = true;
    const Kernel_point place(3, -2);
    m.uvmap[Mesh::Vertex_index(7)] = place;
    ASSERT_EQ(m.run<TypeParam>(), OK);
    for (const auto v : vertices(m.mesh))
      EXPECT_LT(CGAL::squared_distance(m.uvmap[v], place + (free[v.idx()] - free[7])), 1e-24);
  }
}

// Where doubles are too coarse for the free map, the vertex is held from the start.
TYPED_TEST(Held_vertices, may_be_held_far_away)
{
  Constrained_mesh m(delaunay_patch(2000, 3, wavy));
  ASSERT_EQ(m.run<TypeParam>(), OK);
  const double free_energy = m.summary.energy;
  m.is_held[Mesh::Vertex_index(7)] = true;
  for (const double far : { 1e3, 1e9, 3e13 }) {
    m.uvmap[Mesh::Vertex_index(7)] = Kernel_point(far, far);
    ASSERT_EQ(m.run<TypeParam>(), OK) << far;
    m.expect_places_are_held();
    EXPECT_TRUE(m.is_valid());
    const double measured = is_mips<TypeParam> ? m.quality().mips : m.quality().symmetric_dirichlet;
    EXPECT_NEAR(m.summary.energy, measured, 1e-3 * measured) << far;
    EXPECT_LT(m.summary.energy, (far < 1e10 ? 1.0001 : 1.1) * free_energy) << far;
  }
}

// What rounds the map to floats leaves held vertices where they are, or there is no result.
TYPED_TEST(Held_vertices, keep_their_places_in_floats)
{
  Mapped_mesh m(delaunay_patch(1000, 3, wavy));
  const auto uv = m.add_map_of_floats();
  const auto is_held = m.mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_held", false).first;
  const Float_point_2 place(1e5f, 1e5f);
  std::size_t results = 0;
  for (Mesh::size_type i = 0; i < 1000; i += 30) {
    const Mesh::Vertex_index v(i);
    is_held[v] = true;
    uv[v] = place;
    const Hierarchical_parameterizer_3<TypeParam> method(np::vertex_is_constrained_map(is_held));
    if (SMP::parameterize(m.mesh, method, longest_border(m.mesh), uv) == OK) {
      ++results;
      EXPECT_EQ(uv[v], place) << v;
    }
    is_held[v] = false;
  }
  EXPECT_GT(results, 0u);
}

// Borders are apart only as far as there is a bound. Without flips maps are in any case.
TYPED_TEST(Held_vertices, far_away_flip_no_triangle_of_a_map_that_overlaps_itself)
{
  std::size_t results = 0;
  for (const double far : { 1e3, 1e13, 1e14, 1e15 }) {
    Constrained_mesh m(ramp(300, 1.5, 8));
    m.is_held[Mesh::Vertex_index(7)] = true;
    m.uvmap[Mesh::Vertex_index(7)] = Kernel_point(far, far);
    const auto options = np::vertex_is_constrained_map(m.is_held)
                             .globally_injective(true)
                             .overlap_bound(0.)
                             .summary(std::ref(m.summary));
    if (m.run_with<TypeParam>(options) == OK) {
      ++results;
      EXPECT_EQ(m.quality().flips, 0u) << far;
      m.expect_places_are_held();
    }
  }
  EXPECT_GT(results, 0u);
}

// A surface that has a map without distortion keeps it, near and far, with one vertex held, and for MIPS with two.
TYPED_TEST(Held_vertices, leave_a_developable_surface_without_distortion)
{
  for (const int number : { 1, is_mips<TypeParam> ? 2 : 1 })
    for (const double far : { 1., 1e9 }) {
      Constrained_mesh m(helix(1000, 50));
      m.is_held[Mesh::Vertex_index(7)] = true;
      m.uvmap[Mesh::Vertex_index(7)] = Kernel_point(far, -far);
      m.is_held[Mesh::Vertex_index(1500)] = number == 2;
      m.uvmap[Mesh::Vertex_index(1500)] = Kernel_point(far, 3 * far);
      ASSERT_EQ(m.run<TypeParam>(), OK);
      m.expect_places_are_held();
      EXPECT_TRUE(m.summary.converged && m.is_valid());
      const double minimum = is_mips<TypeParam> ? 2. * num_faces(m.mesh) : 4;
      EXPECT_NEAR(m.summary.energy, minimum, 1e-6 * minimum);
    }
}

TYPED_TEST(Held_vertices, start_from_a_map_of_the_users)
{
  Constrained_mesh m(delaunay_patch(800, 3, wavy));
  ASSERT_EQ(m.run<TypeParam>(), OK);
  m.hold_some(20);
  m.bend(0.03);
  ASSERT_EQ(m.run<TypeParam>(), OK);
  const double energy = m.summary.energy;
  const auto options = np::vertex_is_constrained_map(m.is_held).initial_map(true).summary(std::ref(m.summary));
  ASSERT_EQ(m.run_with<TypeParam>(options), OK);
  ASSERT_EQ(m.summary.levels.size(), 1u);
  EXPECT_LE(m.summary.levels[0].iterations, 2u);
  EXPECT_LE(m.summary.energy, energy * (1 + 1e-12));
  m.expect_places_are_held();
}

// Sees that the iterations on a level go on from those before them, and that energies are known.
struct Watching_visitor : Hierarchy_visitor_3
{
  Parameterization_progress last;

  bool progressed(const Parameterization_progress& progress)
  {
    if (progress.number_of_levels > 0) {
      EXPECT_GT(progress.energy, 0);
      if (progress.level == last.level) {
        EXPECT_GE(progress.iterations, last.iterations);
      }
    }
    last = progress;
    return true;
  }
};

TYPED_TEST(Held_vertices, let_a_visitor_follow_the_way_to_their_places)
{
  Constrained_mesh m(delaunay_patch(800, 3, wavy));
  ASSERT_EQ(m.run<TypeParam>(), OK);
  m.hold_some(20);
  m.bend(0.3);
  m.places = m.uv();
  ASSERT_EQ(m.parameterize(Hierarchical_parameterizer_3<TypeParam>(
                np::vertex_is_constrained_map(m.is_held).visitor(Watching_visitor()))),
            OK);
  m.expect_places_are_held();
}

TYPED_TEST(Held_vertices, keep_borders_from_meeting)
{
  const auto surface = ramp(60, 1.5);
  Constrained_mesh m(surface);
  ASSERT_EQ(m.run<TypeParam>(true, 1e-6, true), OK);
  m.hold_some(100);
  ASSERT_EQ(m.run<TypeParam>(true, 1e-6, true), OK);
  m.expect_places_are_held();
  EXPECT_TRUE(m.is_valid());
  EXPECT_TRUE(Hierarchical_parameterizer_3<TypeParam>().is_one_to_one_mapping(m.mesh, longest_border(m.mesh), m.uvmap));
}

TYPED_TEST(Held_vertices, scale_with_the_units)
{
  Constrained_mesh m(delaunay_patch(500, 3, wavy)), large(delaunay_patch(500, 3, wavy));
  ASSERT_EQ(m.run<TypeParam>(), OK);
  m.hold_some(20);
  m.bend(0.03);
  for (const auto v : vertices(m.mesh)) {
    const auto& p = m.mesh.point(v);
    large.mesh.point(v) = test_meshes::Kernel::Point_3(1024 * p.x(), 1024 * p.y(), 1024 * p.z());
    large.uvmap[v] = Kernel_point(1024 * m.uvmap[v].x(), 1024 * m.uvmap[v].y());
    large.is_held[v] = m.is_held[v];
  }
  ASSERT_EQ(m.run<TypeParam>(), OK);
  ASSERT_EQ(large.run<TypeParam>(), OK);
  for (const auto v : vertices(m.mesh))
    EXPECT_EQ(large.uvmap[v], Kernel_point(1024 * m.uvmap[v].x(), 1024 * m.uvmap[v].y()));
}

// A texture may have other units than the surface.
TYPED_TEST(Held_vertices, may_be_held_at_another_scale)
{
  for (const double scale : { 1e-2, 10., 1e3 })
    for (const std::size_t one_of : { 100, 10 }) {
      Constrained_mesh m(delaunay_patch(300, 3, wavy));
      ASSERT_EQ(m.run<TypeParam>(), OK);
      for (const auto v : vertices(m.mesh))
        m.uvmap[v] = Kernel_point(scale * m.uvmap[v].x(), scale * m.uvmap[v].y());
      m.hold_some(one_of);
      EXPECT_EQ(m.run<TypeParam>(), OK) << scale << ' ' << one_of;
      EXPECT_TRUE(m.is_valid());
      for (const auto v : vertices(m.mesh)) {
        if (m.is_held[v]) {
          EXPECT_EQ(m.uvmap[v], m.places[v.idx()]);
        }
      }
    }
}

// It grows so fast that the symmetric Dirichlet energy is lowered at first.
struct Steep_energy
{
  static constexpr double minimum = 2.718281828459045;
  static constexpr bool is_scale_invariant = true;
  static constexpr bool is_flip_free = true;
  const Steep_energy& of_area(double) const { return *this; }
  static double value(double f, double d) { return std::exp(0.25 * (f / d) * (f / d)); }
  static Distortion_derivatives_2 derivatives(double f, double d)
  {
    // exp(g) with g = f^2 / (4 d^2)
    const double e = value(f, d), gf = 0.5 * f / (d * d), gd = -0.5 * f * f / (d * d * d);
    const double gff = 0.5 / (d * d), gfd = -f / (d * d * d), gdd = 1.5 * f * f / (d * d * d * d);
    return { e, e * gf, e * gd, e * (gff + gf * gf), e * (gfd + gf * gd), e * (gdd + gd * gd) };
  }
};

TEST(Held_vertices_of_own_energy, cost_nothing_if_there_are_two_and_scales_do_not_matter)
{
  typedef Distortion_parameterizer_3<Mesh, Steep_energy> Method;
  Constrained_mesh m(cap(20, 32, 0.8 * CGAL_PI));
  ASSERT_EQ(m.run<Method>(), OK);
  const double energy = m.summary.energy;
  const auto a = Mesh::Vertex_index(3), b = Mesh::Vertex_index(400);
  m.is_held[a] = m.is_held[b] = true;
  for (const double scale : { 1e-6, 1., 1e80 }) {
    m.uvmap[a] = Kernel_point(0, 0);
    m.uvmap[b] = Kernel_point(scale, 0);
    ASSERT_EQ(m.run<Method>(), OK);
    m.expect_places_are_held();
    EXPECT_NEAR(m.summary.energy, energy, 1e-6 * energy) << scale;
  }
}

} // namespace test_held_vertices
