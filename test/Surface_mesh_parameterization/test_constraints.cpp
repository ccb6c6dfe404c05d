// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Vertices that are held at given places, and fixed borders.

#include "constrained_mesh.h"
#include "exact_kernel.h"
#include "generated_meshes.h"
#include "mesh_conversions.h"
#include "one_to_one_maps.h"
#include "real_meshes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Distortion_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace test_constraints {

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
  typedef CGAL::Simple_cartesian<float>::Point_2 Float_point;
  const auto uv = m.mesh.add_property_map<Mesh::Vertex_index, Float_point>("v:float_uv").first;
  const auto is_held = m.mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_held", false).first;
  const Float_point place(1e5f, 1e5f);
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

// How far apart the maps of a hierarchical run and of a flat one are, with the border on a circle; relative to its box.
template <class Method>
double distance_from_flat_run(const Flat_mesh& surface)
{
  Constrained_mesh m(surface), flat(surface);
  for (Constrained_mesh* const one : { &m, &flat }) {
    one->place_border<Circular_border_arc_length_parameterizer_3<Mesh>>(1);
    EXPECT_EQ(one->run<Method>(one == &m, 1e-14), OK);
    one->expect_places_are_held();
    EXPECT_TRUE(one->summary.converged && one->is_valid());
  }
  return greatest_distance(m.uv(), flat.uv()) / std::sqrt(2);
}

// To the last digits, which the energies of two maps do not tell.
TYPED_TEST(Held_vertices, fix_a_border_for_the_hierarchical_run_as_for_the_flat_one)
{
  for (const Flat_mesh& surface :
       { grid(40, 30, wavy), delaunay_patch(800, 3, wavy), cap(12, 32, 0.5 * CGAL_PI) })
    EXPECT_LT(distance_from_flat_run<TypeParam>(surface), 1e-9) << surface.triangles.size();
}

TYPED_TEST(Held_vertices, fix_a_border_for_the_hierarchical_run_on_real_meshes)
{
  for (const char* name : { "face_1042.off", "lion_head.off", "camelhead.off" }) {
    Flat_mesh real;
    if (!read_off(name, real))
      GTEST_SKIP() << "no " << name << " in " << data_folder();
    EXPECT_LT(distance_from_flat_run<TypeParam>(real), 1e-9) << name;
  }
}

// Symmetric Dirichlet energy turns corners of the holes by up to a full turn. There the barrier leaves a little.
TYPED_TEST(Held_vertices, fix_a_border_of_a_surface_with_holes)
{
  EXPECT_LT(distance_from_flat_run<TypeParam>(grid_with_holes(20)), 1e-5);
}

// CGAL's square runs around the map the other way than its circle.
TYPED_TEST(Held_vertices, may_mirror_the_map)
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
TYPED_TEST(Held_vertices, on_a_part_of_the_border_do_not_mirror_the_map)
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

TYPED_TEST(Held_vertices, lead_around_a_border_that_is_far_from_convex)
{
  for (const std::size_t n : { 300, 3000 }) {
    Constrained_mesh m(delaunay_patch(n, 5, flat));
    m.place_border<Circular_border_arc_length_parameterizer_3<Mesh>>(1);
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

TYPED_TEST(Held_vertices, that_contradict_each_other_are_an_error)
{
  Constrained_mesh m(grid(10, 10, wavy));
  const auto corners_of = [&](Mesh::Face_index f) {
    std::vector<Mesh::Vertex_index> result;
    for (const auto v : vertices_around_face(m.mesh.halfedge(f), m.mesh))
      result.push_back(v);
    return result;
  };
  const Mesh::Face_index face(70);
  const std::vector<Mesh::Vertex_index> corners = corners_of(face), others = corners_of(Mesh::Face_index(190));
  const Kernel_point positive[] = { Kernel_point(10, 0), Kernel_point(11, 0), Kernel_point(10, 1) };
  for (int i = 0; i < 3; ++i) {      // so that the map cannot be mirrored as a whole
    m.is_held[others[i]] = true;
    m.uvmap[others[i]] = positive[i];
  }
  const std::vector<std::vector<Kernel_point>> contradictions = {
    { Kernel_point(0, 0), Kernel_point(0, 1), Kernel_point(1, 0) },       // negative
    { Kernel_point(0, 0), Kernel_point(1, 1), Kernel_point(2, 2) },       // degenerate
  };
  for (const auto& contradiction : contradictions) {
    for (int i = 0; i < 3; ++i) {
      m.is_held[corners[i]] = true;
      m.uvmap[corners[i]] = contradiction[i];
    }
    EXPECT_EQ(m.run<TypeParam>(), ERROR_NO_1_TO_1_MAPPING);
    EXPECT_EQ(m.summary.error.place, Parameterization_error::FACE);
    EXPECT_EQ(m.summary.error.index, std::size_t(face));
    EXPECT_EQ(m.uv(), m.places);
  }
  // Two neighbors at one place.
  m.is_held[corners[2]] = false;
  m.uvmap[corners[1]] = m.uvmap[corners[0]];
  EXPECT_EQ(m.run<TypeParam>(), ERROR_NO_1_TO_1_MAPPING);
  EXPECT_EQ(m.summary.error.place, Parameterization_error::FACE);
  const std::vector<Mesh::Vertex_index> told = corners_of(Mesh::Face_index(m.summary.error.index));
  EXPECT_TRUE(std::count(told.begin(), told.end(), corners[0]) && std::count(told.begin(), told.end(), corners[1]));
}

TYPED_TEST(Held_vertices, that_cannot_be_reached_are_an_error_that_names_them)
{
  Constrained_mesh m(grid(16, 16, wavy));
  m.place_border<Circular_border_arc_length_parameterizer_3<Mesh>>(1);
  Mesh::Vertex_index inside;
  for (const auto v : vertices(m.mesh))
    if (!m.mesh.is_border(v))
      inside = v;
  m.is_held[inside] = true;
  m.uvmap[inside] = Kernel_point(3, 3);
  EXPECT_EQ(m.run<TypeParam>(), ERROR_NO_1_TO_1_MAPPING);
  EXPECT_EQ(m.summary.error.place, Parameterization_error::VERTEX);
  EXPECT_EQ(m.summary.error.index, std::size_t(inside));
  EXPECT_EQ(m.uv(), m.places);
}

TYPED_TEST(Held_vertices, at_no_place_are_an_error)
{
  Constrained_mesh m(grid(10, 10, wavy));
  const Mesh::Vertex_index v(17);
  m.is_held[v] = true;
  m.uvmap[v] = Kernel_point(0, std::numeric_limits<double>::infinity());
  EXPECT_EQ(m.run<TypeParam>(), ERROR_WRONG_PARAMETER);
  EXPECT_EQ(error_message(m.summary.error), "a given place is not finite (vertex 17)");
  EXPECT_EQ(m.summary.error.place, Parameterization_error::VERTEX);
  EXPECT_EQ(m.summary.error.index, std::size_t(v));
  m.is_held[v] = false;
  EXPECT_EQ(m.run<TypeParam>(), OK);

  for (const double weight :
       { -1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() }) {
    m.weight[v] = weight;
    EXPECT_EQ(m.run<TypeParam>(), ERROR_WRONG_PARAMETER);
    EXPECT_NE(error_message(m.summary.error).find("weight"), std::string::npos);
    EXPECT_EQ(m.summary.error.index, std::size_t(v));
  }
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

// Without a place that says so, a result is positive, whatever it starts from.
TYPED_TEST(Held_vertices, that_are_none_do_not_mirror_the_map)
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
TYPED_TEST(Held_vertices, at_a_triangle_outweigh_a_mirrored_start)
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

} // namespace test_constraints
