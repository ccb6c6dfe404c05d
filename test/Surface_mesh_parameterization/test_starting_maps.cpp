// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The first map of a level: of the coarsest one, its scale, and with the new vertices of a finer one.

#include "hierarchies.h"
#include "level_maps.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/insert_new_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/first_maps.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/unfolding.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace test_starting_maps {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

// ---- Tutte's map ----

TEST(Tutte_embedding, is_valid)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    const Finest_level f(m);
    Level::Uv uv;
    ASSERT_EQ(compute_Tutte_embedding(f.level, uv), OK);
    EXPECT_TRUE(is_map_valid(f.level.rings(), uv));
    for (Index v = 0; v < f.level.number_of_vertices(); ++v) {
      const double radius2 = (uv[v] - CGAL::ORIGIN).squared_length();
      if (f.hierarchy.is_on_outer_border(v))
        EXPECT_NEAR(radius2, 1, 1e-14);
      else
        EXPECT_LT(radius2, 1);
    }
  }
}

TEST(Tutte_embedding, puts_interior_vertices_into_the_middle_of_their_neighbors)
{
  const Finest_level f(grid_with_holes(20));
  Level::Uv uv;
  ASSERT_EQ(compute_Tutte_embedding(f.level, uv), OK);
  for (Index v = 0; v < f.level.number_of_vertices(); ++v)
    if (!f.level.is_border(v)) {
      Vector_2 sum(0, 0);
      for (const Index w : f.level.one_ring(v))
        sum = sum + (uv[w] - uv[v]);
      EXPECT_NEAR(sum.squared_length(), 0, 1e-24);
    }
}

// ---- unfolding ----

void expect_isometry(const Level& level, const Level::Uv& uv)
{
  constexpr double rounding = 1e-14;      // of places, in surfaces of about size 1
  for (Index v = 0; v < level.number_of_vertices(); ++v)
    for (const Index w : level.one_ring(v)) {
      const double length = std::sqrt(CGAL::squared_distance(level.point(v), level.point(w)));
      EXPECT_NEAR(std::sqrt(CGAL::squared_distance(uv[v], uv[w])), length, 1e-9 * length + rounding);
    }
}

Flat_mesh thin_ribbon() { return affine_image(grid(500, 4, flat), 1000, 0, 0, 0.1); }

Flat_mesh rolled_needles()
{
  Flat_mesh m = grid(40, 40, rolled);
  for (Point_3& p : m.points)
    p = Point_3(p.x(), 1e-4 * p.y(), p.z());
  return m;
}

TEST(Unfolding, of_a_developable_surface_is_an_isometry)
{
  for (const auto& [name, m] :
       { std::pair("one triangle", single_triangle()), std::pair("ears", three_ears()), std::pair("strip", strip(60)),
         std::pair("rolled", grid(20, 20, rolled)),
         std::pair("flat needles", affine_image(grid(40, 40, flat), 1e-4, 0, 0, 1)),
         std::pair("rolled needles", rolled_needles()),
         std::pair("flat, with holes", affine_image(grid_with_holes(20), 1, 0.3, 0, 1)),
         std::pair("ribbon", thin_ribbon()) }) {
    SCOPED_TRACE(name);
    const Finest_level f(m);
    Level::Uv uv;
    ASSERT_TRUE(unfold(f.level, uv));
    expect_isometry(f.level, uv);
  }
}

TEST(Unfolding, is_no_map_where_the_surface_is_curved_much)
{
  for (const Flat_mesh& m : { deep_cap(), crumpled_grid(12, 1), folded_fan() }) {
    const Finest_level f(m);
    Level::Uv uv;
    EXPECT_FALSE(unfold(f.level, uv));
  }
}

TEST(First_map, is_not_worse_than_that_of_Tutte)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    const Finest_level f(m);
    const Level_energy_of<Symmetric_Dirichlet_energy_2> energy(f.level, Triangle_weight::AREA);
    Level::Uv uv;
    ASSERT_EQ(choose_first_map(energy, Refinement_options(), uv), OK);
    EXPECT_TRUE(is_map_valid(f.level.rings(), uv));
    EXPECT_LE(energy(uv), energy(first_map(f.level)));
  }
}

// Tutte's map of this ribbon is 1e7 times worse.
TEST(First_map, is_the_minimum_on_a_ribbon)
{
  const Finest_level f(thin_ribbon());
  const Level_energy_of<Symmetric_Dirichlet_energy_2> energy(f.level, Triangle_weight::AREA);
  Level::Uv uv;
  ASSERT_EQ(choose_first_map(energy, Refinement_options(), uv), OK);
  EXPECT_NEAR(energy(uv) / energy.unit(), 4, 1e-9);
}

TEST(First_map, does_not_overlap_where_it_must_not)
{
  const Finest_level f(ramp(100, 1.5));
  const Level_energy_of<Symmetric_Dirichlet_energy_2> energy(f.level, Triangle_weight::AREA);
  Refinement_options options;
  Level::Uv uv;
  for (const bool must_not : { false, true }) {
    options.is_globally_injective = must_not;
    ASSERT_EQ(choose_first_map(energy, options, uv), OK);
    EXPECT_NE(has_crossings(border_edges(f.level.rings()), uv), must_not);
  }
}

// ---- scale ----

double area_in_space(const Level& level)
{
  double area = 0;
  for (const Index_triangle& t : level.triangles())
    area += std::sqrt(CGAL::squared_area(level.point(t[0]), level.point(t[1]), level.point(t[2])));
  return area;
}

double area_in_plane(const Level& level, const Level::Uv& uv)
{
  double area = 0;
  for (const Index_triangle& t : level.triangles())
    area += CGAL::area(uv[t[0]], uv[t[1]], uv[t[2]]);
  return area;
}

TEST(Scale_to_area, makes_the_areas_equal)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    const Finest_level f(m);
    for (const double scale : { 1e-5, 1., 1e5 }) {
      Level::Uv uv = first_map(f.level);
      for (Point_2& p : uv)
        p = Point_2(scale * p.x(), scale * p.y());
      scale_to_area(f.level, false, uv);
      EXPECT_NEAR(area_in_plane(f.level, uv) / area_in_space(f.level), 1, 1e-9);
      EXPECT_TRUE(is_map_valid(f.level.rings(), uv));
    }
  }
}

TEST(Scale_to_area, leaves_the_map_of_a_surface_without_area)
{
  Flat_mesh m = fan(5);
  std::fill(m.points.begin(), m.points.end(), Point_3(0, 0, 0));
  const Finest_level f(m);
  Level::Uv uv;
  ASSERT_EQ(compute_Tutte_embedding(f.level, uv), OK);
  const Level::Uv before = uv;
  scale_to_area(f.level, false, uv);
  EXPECT_EQ(uv, before);
}

// By a factor that rounds, a triangle this thin can lose its area.
TEST(Scale_to_area, keeps_an_energy_finite)
{
  Flat_mesh m;
  m.points = { Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0) };
  m.triangles = { { 0, 1, 2 } };
  const Finest_level f(m);
  const Level_energy_of<MIPS_energy_2> energy(f.level, Triangle_weight::ONE);
  Random random(1);
  std::size_t spoilt = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x = random(0.5, 1), y = random(0.5, 1), part = random(0.1, 0.9);
    const Level::Uv uv = { Point_2(0, 0), Point_2(x, y), Point_2(part * x, std::nextafter(part * y, 1.)) };
    if (!std::isfinite(energy(uv)))
      continue;
    Level::Uv rounded = uv, result = uv;
    const double scale = std::sqrt(area_in_space(f.level) / area_in_plane(f.level, uv));
    for (Point_2& p : rounded)
      p = Point_2(scale * p.x(), scale * p.y());
    spoilt += is_map_valid(f.level.rings(), rounded) && !std::isfinite(energy(rounded));
    const double value = scale_to_area(energy, false, result);
    EXPECT_TRUE(std::isfinite(value));
    EXPECT_EQ(value, energy(result));
  }
  EXPECT_GT(spoilt, 0u);
}

// ---- up the levels ----

TEST(Insert_new_vertices, keeps_every_level_valid)
{
  Refinement_options options;
  options.optimizer = Optimizer::SWEEPS;
  options.number_of_iterations = 20;
  for (const auto& [name, m] : named_meshes())
    for (unsigned int seed = 0; seed < 10; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      const Collapse_hierarchy_3 hierarchy(surface(m), parameters::coarsest_size(3).random_seed(seed));
      Level level(hierarchy);
      Level::Uv uv;
      for (std::size_t i = 0; i < hierarchy.number_of_levels(); ++i) {
        level.go_to(i);
        if (i == 0)
          uv = first_map(level);
        else {
          const Level::Uv before = uv;
          ASSERT_EQ(insert_new_vertices(level, uv), no_index);
          EXPECT_TRUE(std::equal(before.begin(), before.end(), uv.begin()));
        }
        ASSERT_EQ(uv.size(), level.number_of_vertices());
        ASSERT_TRUE(is_map_valid(level.rings(), uv));
        Level_summary summary;
        refine<MIPS_energy_2>(level, uv, options, summary);
        ASSERT_TRUE(is_map_valid(level.rings(), uv));
      }
    }
}

// The exponential map of an interior vertex of a planar mesh is an isometry, and the best place is where the vertex
// was.
TEST(Insert_new_vertices, of_a_planar_mesh_puts_interior_vertices_back)
{
  for (const Flat_mesh& m : { grid(15, 15, flat), delaunay_patch(400, 2, flat) }) {
    const Finest_level f(m, parameters::coarsest_size(60));
    std::size_t levels = 0;
    for (std::size_t i = 1; i < f.hierarchy.number_of_levels(); ++i) {
      Level level(f.hierarchy, i - 1);
      Level::Uv uv = identity_map(level);
      if (!is_map_valid(level.rings(), uv))
        continue;     // a coarse level of a convex patch can have a flat ear
      ++levels;
      level.go_to(i);
      const Level::Uv expected = identity_map(level);
      ASSERT_EQ(insert_new_vertices(level, uv), no_index);
      for (Index v = 0; v < level.number_of_vertices(); ++v)
        EXPECT_TRUE(level.is_border(v) || CGAL::squared_distance(uv[v], expected[v]) < 1e-20);
    }
    EXPECT_GT(levels, 1u);
  }
}

// An ear goes where its triangle is similar to the one in space.
TEST(Insert_new_vertices, puts_ears_back_in_shape)
{
  const Flat_mesh m = { { Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.5, 0.8, 0), Point_3(0.5, -0.5, 0),
                          Point_3(1.2, 0.8, 0), Point_3(-0.2, 0.8, 0) },
                        { { 0, 1, 2 }, { 1, 0, 3 }, { 2, 1, 4 }, { 0, 2, 5 } } };
  int ears = 0;
  for (unsigned int seed = 0; seed < 10; ++seed) {
    const Finest_level f(m, parameters::coarsest_size(5).random_seed(seed));
    ASSERT_EQ(f.hierarchy.number_of_levels(), 2u);
    const Level::Uv expected = identity_map(f.level);
    Level::Uv uv(expected.begin(), expected.begin() + f.hierarchy.number_of_vertices(0));
    if (!is_map_valid(Level(f.hierarchy).rings(), uv))
      continue;
    ASSERT_EQ(insert_new_vertices(f.level, uv), no_index);
    for (Index v = Index(f.level.first_new_vertex()); v < 6; ++v)
      if (f.level.rings().number_of_triangles(v) == 1) {
        EXPECT_NEAR(std::sqrt(CGAL::squared_distance(uv[v], expected[v])), 0, 1e-12);
        ++ears;
      }
  }
  EXPECT_GT(ears, 3);
}

} // namespace test_starting_maps
