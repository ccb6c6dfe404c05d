// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Vertices that are held where it is known that there is a map: by Tutte's theorem, or since it was there before.

#include "constrained_mesh.h"
#include "generated_meshes.h"
#include "mesh_conversions.h"
#include "real_meshes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace test_held_borders {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using Kernel_point = test_meshes::Kernel::Point_2;

typedef test_meshes::Surface_mesh                                    Mesh;
typedef Circular_border_arc_length_parameterizer_3<Mesh>             Circle;
typedef std::vector<std::pair<std::string, Flat_mesh>>               Named_meshes;

template <class Method>
Error_code run(Constrained_mesh& m, bool is_hierarchical = true)
{
  return m.run_with<Method>(SMP::parameters::vertex_is_constrained_map(m.is_held).summary(std::ref(m.summary)),
                            is_hierarchical);
}

template <class Method>
class Held_border : public testing::Test { };

typedef testing::Types<MIPS_parameterizer_3<Mesh>, Symmetric_Dirichlet_parameterizer_3<Mesh>,
                       As_rigid_as_possible_parameterizer_3<Mesh>>   Methods;
TYPED_TEST_SUITE(Held_border, Methods);

template <class Method>
class Held_parts_of_a_map : public testing::Test { };
TYPED_TEST_SUITE(Held_parts_of_a_map, Methods);

// Bent, slender, or with much of their area far from the border.
Named_meshes surfaces()
{
  Random random(1);
  return { { "cap", cap(14, 32, 0.8 * CGAL_PI) },
           { "tents", tents(14, 4, 3, random) },
           { "terrain", random_terrain(20, 0.5, random) },
           { "helix", helix(20, 2) },
           { "meander", meander(6, 4) },
           { "comb", flat_comb(4, 3, 2) },
           { "star", star(8, 40, 5) } };
}

// Holds the border on an ellipse whose axes have a ratio, about as large as the surface.
void hold_on_ellipse(Constrained_mesh& m, double ratio)
{
  m.place_border<Circle>(std::sqrt(m.area() / CGAL_PI));
  for (const auto v : vertices(m.mesh))
    m.uvmap[v] = Kernel_point(m.uvmap[v].x() * std::sqrt(ratio), m.uvmap[v].y() / std::sqrt(ratio));
}

template <class Method>
void expect_held_places(Constrained_mesh& m, bool is_hierarchical)
{
  EXPECT_EQ(run<Method>(m, is_hierarchical), OK);
  m.expect_places_are_held();
  EXPECT_TRUE(m.is_valid());
}

// By Tutte's theorem there is a map.
TYPED_TEST(Held_border, on_a_convex_curve_is_reached)
{
  for (const auto& [name, surface] : surfaces())
    for (const double ratio : { 1, 100 })
      for (const bool is_hierarchical : { true, false }) {
        SCOPED_TRACE(name + ' ' + std::to_string(ratio) + (is_hierarchical ? "" : " flat"));
        Constrained_mesh m(surface);
        hold_on_ellipse(m, ratio);
        expect_held_places<TypeParam>(m, is_hierarchical);
      }
}

// Squares of lengths are close to the least and the greatest doubles, and products of areas are no doubles.
TYPED_TEST(Held_border, is_held_at_any_scale)
{
  for (const double scale : { 1e-150, 1e150 })
    for (const bool is_hierarchical : { true, false }) {
      SCOPED_TRACE(std::to_string(std::log10(scale)) + (is_hierarchical ? "" : " flat"));
      Constrained_mesh m(delaunay_patch(300, 3, wavy));
      hold_on_ellipse(m, 2);
      for (const auto v : vertices(m.mesh)) {
        const test_meshes::Kernel::Point_3& p = m.mesh.point(v);
        m.mesh.point(v) = test_meshes::Kernel::Point_3(scale * p.x(), scale * p.y(), scale * p.z());
        m.uvmap[v] = Kernel_point(scale * m.uvmap[v].x(), scale * m.uvmap[v].y());
      }
      expect_held_places<TypeParam>(m, is_hierarchical);
    }
}

TYPED_TEST(Held_border, on_a_convex_curve_is_reached_by_real_meshes)
{
  Flat_mesh real;
  if (!read_off("three_peaks.off", real))
    GTEST_SKIP() << "no three_peaks.off in " << data_folder();
  for (const double ratio : { 8, 16 })
    for (const bool is_hierarchical : { true, false }) {
      SCOPED_TRACE(std::to_string(ratio) + (is_hierarchical ? "" : " flat"));
      Constrained_mesh m(real);
      hold_on_ellipse(m, ratio);
      expect_held_places<TypeParam>(m, is_hierarchical);
    }
}

// Of a strip all vertices are on the border.
TYPED_TEST(Held_border, may_be_all_of_the_surface)
{
  for (const Flat_mesh& surface : { helix(13, 2), strip(20) })
    for (const bool is_hierarchical : { true, false }) {
      Constrained_mesh m(surface);
      m.place_border<Circle>(1);
      expect_held_places<TypeParam>(m, is_hierarchical);
    }
}

// Vertices held where a free map has them, turned, or where its mirror image does, leave that map as it was.
template <class Method>
void expect_free_map(const Constrained_mesh& free, const Flat_mesh& surface, const std::vector<Index>& held,
                     bool is_hierarchical = true)
{
  for (const bool is_mirrored : { false, true }) {
    SCOPED_TRACE(is_mirrored ? "mirrored" : "turned");
    Constrained_mesh m(surface);
    for (const auto v : vertices(m.mesh))
      m.uvmap[v] = Kernel_point((is_mirrored ? 1 : -1) * free.uvmap[v].y(), free.uvmap[v].x());
    for (const Index v : held)
      m.is_held[Mesh::Vertex_index(v)] = true;
    EXPECT_EQ(run<Method>(m, is_hierarchical), OK);
    m.expect_places_are_held();
    const Parameterization_quality quality = m.quality();
    EXPECT_EQ(quality.flips, 0u);
    EXPECT_EQ(quality.is_mirrored, is_mirrored);
    EXPECT_NEAR(m.summary.energy, free.summary.energy, 0.01 * (free.summary.energy + 1));
  }
}

// Of a surface that turns around more than once, some vertices on the border do not tell how it runs: triangles do.
TYPED_TEST(Held_parts_of_a_map, tell_by_triangles_whether_it_is_mirrored)
{
  const Flat_mesh surface = ramp(16, 1.4);
  Constrained_mesh free(surface);
  ASSERT_EQ(run<TypeParam>(free), OK);
  for (Index first = 0; first < 20; ++first) {
    SCOPED_TRACE(first);
    std::vector<Index> held;
    for (Index f = first; f < surface.triangles.size(); f += 20)
      held.insert(held.end(), surface.triangles[f].begin(), surface.triangles[f].end());
    expect_free_map<TypeParam>(free, surface, held);
  }
}

// So do a few vertices of a surface that is bent or has many bays.
TYPED_TEST(Held_parts_of_a_map, tell_by_few_vertices_whether_it_is_mirrored)
{
  Random random(1);
  for (const auto& [name, surface] : Named_meshes{ { "cap", cap(7, 16, 0.7 * CGAL_PI) },
                                                   { "tents", tents(14, 4, 3, random) },
                                                   { "terrain", random_terrain(12, 0.5, random) },
                                                   { "star", star(6, 24, 3) },
                                                   { "ramp", ramp(16, 1.4) } }) {
    Constrained_mesh free(surface);
    ASSERT_EQ(run<TypeParam>(free), OK);
    for (const int number : { 3, 8 })
      for (const bool is_hierarchical : { true, false }) {
        SCOPED_TRACE(name + ' ' + std::to_string(number) + (is_hierarchical ? "" : " flat"));
        std::vector<Index> held;
        for (int i = 0; i < number; ++i)
          held.push_back(Index(random.below(surface.points.size())));
        expect_free_map<TypeParam>(free, surface, held, is_hierarchical);
      }
  }
}

// ---- methods without flips ----

template <class Method>
class Held_vertices_of_border : public testing::Test { };

typedef testing::Types<MIPS_parameterizer_3<Mesh>, Symmetric_Dirichlet_parameterizer_3<Mesh>>   Flip_free_methods;
TYPED_TEST_SUITE(Held_vertices_of_border, Flip_free_methods);

// How far apart the maps of a hierarchical run and of a flat one are, with the border on a circle; relative to its box.
template <class Method>
double distance_from_flat_run(const Flat_mesh& surface)
{
  Constrained_mesh m(surface), flat(surface);
  for (Constrained_mesh* const one : { &m, &flat }) {
    one->place_border<Circle>(1);
    EXPECT_EQ(one->run<Method>(one == &m, 1e-14), OK);
    one->expect_places_are_held();
    EXPECT_TRUE(one->summary.converged && one->is_valid());
  }
  return greatest_distance(m.uv(), flat.uv()) / std::sqrt(2);
}

// To the last digits, which the energies of two maps do not tell.
TYPED_TEST(Held_vertices_of_border, fix_a_border_for_the_hierarchical_run_as_for_the_flat_one)
{
  for (const Flat_mesh& surface :
       { grid(40, 30, wavy), delaunay_patch(800, 3, wavy), cap(12, 32, 0.5 * CGAL_PI) })
    EXPECT_LT(distance_from_flat_run<TypeParam>(surface), 1e-9) << surface.triangles.size();
}

TYPED_TEST(Held_vertices_of_border, fix_a_border_for_the_hierarchical_run_on_real_meshes)
{
  std::size_t found = 0;
  for (const char* name : { "face_1042.off", "lion_head.off", "camelhead.off" }) {
    Flat_mesh real;
    if (!read_off(name, real))
      continue;
    ++found;
    EXPECT_LT(distance_from_flat_run<TypeParam>(real), 1e-9) << name;
  }
  if (found == 0)
    GTEST_SKIP() << "no mesh in " << data_folder();
}

// Symmetric Dirichlet energy turns corners of the holes by up to a full turn. There the barrier leaves a little.
TYPED_TEST(Held_vertices_of_border, fix_a_border_of_a_surface_with_holes)
{
  EXPECT_LT(distance_from_flat_run<TypeParam>(grid_with_holes(20)), 1e-5);
}

TYPED_TEST(Held_vertices_of_border, lead_around_a_border_that_is_far_from_convex)
{
  for (const std::size_t n : { 300, 3000 }) {
    Constrained_mesh m(delaunay_patch(n, 5, flat));
    m.place_border<Circle>(1);
    for (const auto v : vertices(m.mesh))
      if (m.is_held[v]) {
        const double x = m.uvmap[v].x() - 0.5, y = m.uvmap[v].y() - 0.5,
                     scale = 1 + 0.4 * std::cos(3 * std::atan2(y, x));
        m.uvmap[v] = Kernel_point(scale * x, scale * y);
      }
    ASSERT_EQ(m.run<TypeParam>(), OK);
    m.expect_places_are_held();
    EXPECT_TRUE(m.summary.converged && m.is_valid());
  }
}

} // namespace test_held_borders
