// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs that start from a map of the user's.

#include "distortion_runs.h"
#include "generated_meshes.h"
#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "one_to_one_maps.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Refinable_parameterizer_base_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/number_utils.h>
#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace test_initial_maps {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using Kernel_point = test_meshes::Kernel::Point_2;
namespace parameters = CGAL::parameters;

typedef test_meshes::Surface_mesh   Mesh;

template <class Method>
Error_code run(Mapped_mesh& m, bool is_continued)
{
  return m.parameterize(
      Hierarchical_parameterizer_3<Method>(parameters::initial_map(is_continued).summary(std::ref(m.summary))));
}

// Surfaces whose energies have one minimum that all starts lead to.
std::vector<Flat_mesh> surfaces()
{
  return { grid(40, 30, wavy), delaunay_patch(800, 3, wavy), cap(12, 32, 0.5 * CGAL_PI) };
}

template <class Method>
class Initial_map : public testing::Test { };

typedef testing::Types<MIPS_parameterizer_3<Mesh>, Symmetric_Dirichlet_parameterizer_3<Mesh>>   Methods;
TYPED_TEST_SUITE(Initial_map, Methods);

TYPED_TEST(Initial_map, is_left_where_it_is_best)
{
  for (const Flat_mesh& surface : surfaces()) {
    Mapped_mesh m(surface);
    ASSERT_EQ(run<TypeParam>(m, false), OK);
    const double energy = m.summary.energy;
    EXPECT_GT(m.summary.levels.size(), 1u);
    ASSERT_EQ(run<TypeParam>(m, true), OK);
    ASSERT_EQ(m.summary.levels.size(), 1u);
    EXPECT_LE(m.summary.levels[0].iterations, 2u);
    EXPECT_TRUE(m.summary.converged && m.is_valid());
    EXPECT_LE(m.summary.energy, energy * (1 + 1e-12));
  }
}

// A developable surface can be unfolded in any direction; that of the start is as good.
template <class Method>
void expect_turned_map_to_stay()
{
  Mapped_mesh m(helix(200, 10));
  ASSERT_EQ(run<Method>(m, false), OK);
  for (const auto v : vertices(m.mesh)) {
    const Kernel_point p = m.uvmap[v];
    m.uvmap[v] = Kernel_point(0.6 * p.x() - 0.8 * p.y(), 0.8 * p.x() + 0.6 * p.y());
  }
  const std::vector<Kernel_point> start = m.uv();
  ASSERT_EQ(run<Method>(m, true), OK);
  for (const auto v : vertices(m.mesh))
    EXPECT_LT(CGAL::squared_distance(m.uvmap[v], start[v.idx()]), 1e-8);
}

TYPED_TEST(Initial_map, of_a_developable_surface_is_not_turned)
{
  expect_turned_map_to_stay<TypeParam>();
  expect_turned_map_to_stay<As_rigid_as_possible_parameterizer_3<Mesh>>();
}

// Mirrored, of any size, folded, incomplete, none at all.
TYPED_TEST(Initial_map, leads_to_the_minimum_from_any_place)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::mt19937 random(5);
  const auto one_of_ten = [&] { return random() % 10 == 0; };
  const std::function<Kernel_point(const Kernel_point&)> changes[] = {
    [](const Kernel_point& p) { return Kernel_point(-p.x(), p.y()); },
    [](const Kernel_point& p) { return Kernel_point(1e-6 * p.x(), 3e-6 * p.y()); },
    [](const Kernel_point& p) { return Kernel_point(1e100 * p.x(), 1e100 * p.y()); },
    [&](const Kernel_point& p) { return one_of_ten() ? Kernel_point(-p.y(), p.x()) : p; },
    [&](const Kernel_point& p) { return one_of_ten() ? Kernel_point(nan, p.y()) : p; },
    [](const Kernel_point&) { return Kernel_point(0, 0); },
    [=](const Kernel_point&) { return Kernel_point(nan, nan); },
  };
  for (const Flat_mesh& surface : surfaces()) {
    Mapped_mesh best(surface);
    ASSERT_EQ(run<TypeParam>(best, false), OK);
    for (const auto& change : changes) {
      Mapped_mesh m(surface);
      for (const auto v : vertices(m.mesh))
        m.uvmap[v] = change(best.uvmap[v]);
      ASSERT_EQ(run<TypeParam>(m, true), OK);
      EXPECT_TRUE(m.summary.converged && m.is_valid());
      EXPECT_EQ(m.summary.levels.size(), 1u);
      const double minimum = is_mips<TypeParam> ? 2 * double(surface.triangles.size()) : 4;
      EXPECT_NEAR(m.summary.energy - minimum, best.summary.energy - minimum, 1e-5 * best.summary.energy)
          << surface.triangles.size() << " triangles, change " << &change - changes;
    }
  }
}

TYPED_TEST(Initial_map, serves_a_flat_run)
{
  Mapped_mesh m(grid(12, 9, wavy));
  ASSERT_EQ(m.parameterize(TypeParam(parameters::summary(std::ref(m.summary)))), OK);
  const double energy = m.summary.energy;
  ASSERT_EQ(m.parameterize(TypeParam(parameters::initial_map(true).summary(std::ref(m.summary)))), OK);
  EXPECT_LE(m.summary.levels[0].iterations, 2u);
  EXPECT_LE(m.summary.energy, energy * (1 + 1e-12));
}

// From a map that overlaps to one that does not.
template <class Method>
void expect_one_to_one_result(one_to_one::Mapped_mesh_with_border& m)
{
  ASSERT_GT(one_to_one::pairs_by_counting(m), 0u);
  ASSERT_EQ(m.parameterize(Hierarchical_parameterizer_3<Method>(Method(parameters::globally_injective(true)),
                                                                parameters::initial_map(true))),
            OK);
  EXPECT_TRUE(m.is_valid());
  EXPECT_EQ(one_to_one::pairs_by_counting(m), 0u);
}

TYPED_TEST(Initial_map, may_overlap_where_the_result_must_not)
{
  one_to_one::Mapped_mesh_with_border m(ramp(60, 1.5));
  ASSERT_EQ(m.parameterize(Hierarchical_parameterizer_3<TypeParam>()), OK);
  expect_one_to_one_result<TypeParam>(m);
}

// A small surface has one level, on which no vertex is new.
TYPED_TEST(Initial_map, may_overlap_where_there_are_no_coarse_levels)
{
  one_to_one::Mapped_mesh_with_border m(grid(29, 2, flat));
  expect_one_to_one_result<TypeParam>(one_to_one::bend(m, 1.3));
}

TYPED_TEST(Initial_map, may_lack_the_places_of_filled_holes)
{
  Mapped_mesh m(grid_with_holes(20));
  const auto run = [&](bool is_continued) {
    return m.parameterize(Hierarchical_parameterizer_3<TypeParam>(
        parameters::fill_holes(true).initial_map(is_continued).summary(std::ref(m.summary))));
  };
  ASSERT_EQ(run(false), OK);
  const double energy = m.summary.energy;
  ASSERT_EQ(run(true), OK);
  EXPECT_TRUE(m.is_valid());
  EXPECT_NEAR(m.summary.energy, energy, 1e-5 * energy);
}

TEST(Initial_map_of_another_method, leads_to_the_minimum)
{
  typedef As_rigid_as_possible_parameterizer_3<Mesh>   ARAP;
  for (const Flat_mesh& surface : surfaces()) {
    Mapped_mesh m(surface), best(surface);
    ASSERT_EQ(run<Symmetric_Dirichlet_parameterizer_3<Mesh>>(m, false), OK);
    ASSERT_EQ(run<ARAP>(best, false), OK);
    ASSERT_EQ(run<ARAP>(m, true), OK);
    EXPECT_NEAR(m.summary.energy, best.summary.energy, 1e-4 * best.summary.energy);
  }
}

// A method that leaves every map as it is, but may refuse that of a run which has not been on the coarsest level.
struct Idle_method : Refinable_parameterizer_base_3<Idle_method, Mesh>
{
  bool refuses_start, was_on_coarsest_level = false;

  explicit Idle_method(bool refuses_start = false)
    : Refinable_parameterizer_base_3<Idle_method, Mesh>(parameters::default_values()), refuses_start(refuses_start)
  { }

  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv)
  {
    was_on_coarsest_level = true;
    return internal::compute_Tutte_embedding(level, uv);
  }

  Error_code refine(const Level&, Level::Uv&, Level_summary&)
  {
    return refuses_start && !was_on_coarsest_level ? ERROR_NO_1_TO_1_MAPPING : OK;
  }
};

TEST(Initial_map_of_a_method_of_the_users, comes_to_it_as_it_is)
{
  Mapped_mesh m(delaunay_patch(300, 2, wavy));
  ASSERT_EQ(run<Symmetric_Dirichlet_parameterizer_3<Mesh>>(m, false), OK);
  const std::vector<Kernel_point> start = m.uv();
  ASSERT_EQ(run<Idle_method>(m, true), OK);
  EXPECT_EQ(m.uv(), start);
  ASSERT_EQ(run<Idle_method>(m, false), OK);
  EXPECT_NE(m.uv(), start);
}

// A map of the unit square, as of a texture, is brought to the size of the surface.
TEST(Initial_map_of_a_method_of_the_users, is_scaled_where_it_is_far_from_the_area)
{
  for (const double scale : { 1e-8, 0.4, 0.6, 1.8, 3., 1e8 }) {
    Mapped_mesh m(grid(9, 9, flat));
    m.project(scale);
    const std::vector<Kernel_point> start = m.uv();
    ASSERT_EQ(run<Idle_method>(m, true), OK);
    const bool is_near = scale > 0.5 && scale < 2;
    for (const auto v : vertices(m.mesh)) {
      const double factor = is_near ? 1 : 1 / scale;
      EXPECT_NEAR(m.uvmap[v].x(), factor * start[v.idx()].x(), 1e-12 * 9);
      EXPECT_NEAR(m.uvmap[v].y(), factor * start[v.idx()].y(), 1e-12 * 9);
    }
  }
}

TEST(Initial_map_of_a_method_of_the_users, is_given_up_where_it_leads_nowhere)
{
  Mapped_mesh m(grid(12, 9, wavy)), anew(grid(12, 9, wavy));
  ASSERT_EQ(run<Symmetric_Dirichlet_parameterizer_3<Mesh>>(m, false), OK);
  ASSERT_EQ(m.parameterize(Hierarchical_parameterizer_3<Idle_method>(
                Idle_method(true), parameters::initial_map(true).summary(std::ref(m.summary)))),
            OK);
  ASSERT_EQ(run<Idle_method>(anew, false), OK);
  EXPECT_EQ(m.uv(), anew.uv());
  EXPECT_EQ(m.summary.levels.size(), anew.summary.levels.size());
}

// A uv map that can only be written.
struct Write_only_map
{
  typedef Mesh::Vertex_index                   key_type;
  typedef Kernel_point                         value_type;
  typedef void                                 reference;
  typedef boost::writable_property_map_tag     category;

  std::size_t* writes;
  friend void put(Write_only_map map, key_type, const value_type&) { ++*map.writes; }
};

TEST(Initial_map_that_cannot_be_read, is_an_error)
{
  Mesh mesh = make<Mesh>(grid(5, 4, wavy));
  std::size_t writes = 0;
  Parameterization_summary summary;
  const auto run = [&](bool is_continued) {
    return parameterize(mesh,
                        Hierarchical_parameterizer_3<MIPS_parameterizer_3<Mesh>>(
                            parameters::initial_map(is_continued).summary(std::ref(summary))),
                        longest_border(mesh), Write_only_map{ &writes });
  };
  EXPECT_EQ(run(true), ERROR_WRONG_PARAMETER);
  EXPECT_NE(error_message(summary.error).find("uvmap cannot be read"), std::string::npos);
  EXPECT_EQ(writes, 0u);
  EXPECT_EQ(run(false), OK);
  EXPECT_EQ(writes, mesh.number_of_vertices());
}

} // namespace test_initial_maps
