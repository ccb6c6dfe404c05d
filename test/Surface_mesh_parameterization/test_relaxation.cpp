// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of a level, and the relaxation of its vertices one by one.

#include "hierarchies.h"
#include "level_maps.h"
#include "measures.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Vertex_relaxation.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>

namespace test_relaxation {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

Singular_values singular_values_of(const Level& level, const Level::Uv& uv, const Index_triangle& t)
{
  return singular_values(level.point(t[0]), level.point(t[1]), level.point(t[2]), uv[t[0]], uv[t[1]], uv[t[2]]);
}

template <class Energy>
double energy_of(const Singular_values& s)
{
  return Energy().value(s.greatest * s.greatest + s.least * s.least, s.determinant);
}

template <class Energy>
class Energy_of_level : public testing::Test { };
typedef testing::Types<MIPS_energy_2, Symmetric_Dirichlet_energy_2> Energies;
TYPED_TEST_SUITE(Energy_of_level, Energies, );

template <class Energy>
class Relaxation_of : public testing::Test { };
TYPED_TEST_SUITE(Relaxation_of, Energies, );

// ---- the energy of a level ----

TYPED_TEST(Energy_of_level, is_the_sum_over_the_triangles)
{
  for (const Flat_mesh& m : { grid(12, 9, wavy), crumpled_grid(14, 1), delaunay_patch(400, 2, wavy),
                              grid_with_holes(20), strip(20), three_ears() }) {
    const Finest_level f(m);
    const Level::Uv uv = first_map(f.level);
    double sum = 0, weighted = 0, area = 0;
    for (const Index_triangle& t : f.level.triangles()) {
      const Singular_values s = singular_values_of(f.level, uv, t);
      sum += energy_of<TypeParam>(s);
      weighted += s.area * energy_of<TypeParam>(s);
      area += s.area;
    }
    const Level_energy_of<TypeParam> one(f.level, Triangle_weight::ONE), by_area(f.level, Triangle_weight::AREA);
    EXPECT_NEAR(one(uv) / sum, 1, 1e-9);
    EXPECT_NEAR(by_area(uv) / weighted, 1, 1e-9);
    EXPECT_DOUBLE_EQ(one.total_weight(), double(m.triangles.size()));
    EXPECT_NEAR(by_area.total_weight() / area, 1, 1e-10);
  }
}

TYPED_TEST(Energy_of_level, is_infinite_exactly_if_a_triangle_is_not_positive)
{
  const Finest_level f(grid(5, 5, wavy));
  const Level_energy_of<TypeParam> energy(f.level, Triangle_weight::ONE);
  Level::Uv uv = first_map(f.level);
  EXPECT_TRUE(std::isfinite(energy(uv)));
  std::swap(uv[0], uv[1]);
  EXPECT_EQ(energy(uv), std::numeric_limits<double>::infinity());
  std::fill(uv.begin(), uv.end(), Point_2(0, 0));
  EXPECT_EQ(energy(uv), std::numeric_limits<double>::infinity());
}

TYPED_TEST(Energy_of_level, is_least_for_an_isometry)
{
  const Finest_level f(delaunay_patch(400, 2, flat));
  const Level_energy_of<TypeParam> energy(f.level, Triangle_weight::AREA);
  const double minimum = TypeParam::minimum * energy.total_weight();
  EXPECT_NEAR(energy(identity_map(f.level)) / minimum, 1, 1e-9);
  EXPECT_GT(energy(first_map(f.level)) / minimum, 1.001);
}

// ---- vertex relaxation ----

TYPED_TEST(Relaxation_of, sweeps_lower_the_energy_by_exactly_what_they_return)
{
  for (const auto& [name, m] : named_meshes())
    for (const Triangle_weight weight : { Triangle_weight::ONE, Triangle_weight::AREA }) {
      SCOPED_TRACE(name);
      const Finest_level f(m);
      const Level_energy_of<TypeParam> energy(f.level, weight);
      Vertex_relaxation relaxation(energy, 1.5);
      Level::Uv uv = first_map(f.level);
      std::mt19937 random(0);
      double before = energy(uv);
      for (int i = 0; i < 12; ++i) {
        const auto effect = i % 4 == 3 ? relaxation.random_steps(uv, uv.size(), random) : relaxation.sweep(uv);
        const double decrease = effect.decrease, after = energy(uv);
        EXPECT_EQ(effect.visits, uv.size());
        EXPECT_GE(decrease, 0);
        EXPECT_NEAR(before - after, decrease, 1e-9 * before);
        EXPECT_TRUE(is_map_valid(f.level.rings(), uv));
        before = after;
      }
    }
}

// One vertex of a map that is almost an isometry sits close to a neighbor: a sweep moves it a part of the way back.
TYPED_TEST(Relaxation_of, follows_up_where_a_sweep_is_not_enough)
{
  const Finest_level f(grid(20, 20, flat));
  const Level_energy_of<TypeParam> energy(f.level, Triangle_weight::ONE);
  const Vertex_relaxation relaxation(energy, 1.8);
  Level::Uv start = identity_map(f.level);
  Index displaced = 0;
  while (f.level.is_border(displaced))
    ++displaced;
  const Point_2 neighbor = start[f.level.one_ring(displaced).front()];
  start[displaced] = neighbor + 1e-4 * (start[displaced] - neighbor);
  const double minimum = TypeParam::minimum * energy.total_weight(), least_decrease = 1e-6 * (energy(start) - minimum);

  Level::Uv swept = start, followed_up = start, not_followed_up = start;
  relaxation.sweep(swept);
  const auto effect = relaxation.sweep_and_follow_up(followed_up, least_decrease);
  EXPECT_FALSE(effect.active_vertices.empty());
  EXPECT_NEAR(energy(start) - energy(followed_up), effect.decrease, 1e-9 * energy(start));
  EXPECT_LT(energy(followed_up) - minimum, 0.1 * (energy(swept) - minimum));
  EXPECT_TRUE(is_map_valid(f.level.rings(), followed_up));
  EXPECT_GT(effect.visits, start.size());
  EXPECT_LE(effect.visits, start.size() + start.size() / 4);

  EXPECT_EQ(relaxation.sweep_and_follow_up(not_followed_up, energy(start)).visits, start.size());
  EXPECT_EQ(not_followed_up, swept);
}

// The same along the border: where that is kept apart from itself, its vertices are followed up, too.
TYPED_TEST(Relaxation_of, follows_up_at_borders_that_are_kept_apart)
{
  const Finest_level f(grid(60, 60, flat));
  const Level_energy_of<TypeParam> energy(f.level, Triangle_weight::ONE);
  Border_barrier barrier(f.level, 0.3 * energy.mean_weight());
  const Vertex_relaxation relaxation(energy, 1.8, &barrier);
  Level::Uv start = identity_map(f.level);
  Index displaced = 0;
  while (!f.level.is_border(displaced))
    ++displaced;
  const Point_2 neighbor = start[f.level.one_ring(displaced).front()];
  start[displaced] = neighbor + 1e-4 * (start[displaced] - neighbor);
  ASSERT_TRUE(is_map_valid(f.level.rings(), start));
  const double minimum = TypeParam::minimum * energy.total_weight(), least_decrease = 1e-6 * (energy(start) - minimum);

  Level::Uv swept = start, followed_up = start;
  relaxation.sweep(swept);
  const auto effect = relaxation.sweep_and_follow_up(followed_up, least_decrease);
  EXPECT_NEAR(energy(start) - energy(followed_up), effect.decrease, 1e-9 * energy(start));
  EXPECT_LT(energy(followed_up) - minimum, 0.15 * (energy(swept) - minimum));
  EXPECT_TRUE(is_map_valid(f.level.rings(), followed_up));
  EXPECT_LE(effect.visits, start.size() + start.size() / 4);
}

TYPED_TEST(Relaxation_of, moves_the_vertices_it_is_told_to)
{
  const Finest_level f(grid(12, 9, wavy), parameters::coarsest_size(20));
  const Level_energy_of<TypeParam> energy(f.level, Triangle_weight::ONE);
  const Vertex_relaxation relaxation(energy, 1);
  const Level::Uv start = first_map(f.level);
  for (std::size_t group = 0; group <= f.level.index(); ++group) {
    const std::size_t first = group == 0 ? 0 : f.hierarchy.number_of_vertices(group - 1),
                      last = f.hierarchy.number_of_vertices(group);
    Level::Uv uv = start;
    relaxation.sweep_group(group, uv, 1);
    for (std::size_t v = 0; v < uv.size(); ++v)
      EXPECT_EQ(uv[v] != start[v], first <= v && v < last);
  }
}

TYPED_TEST(Relaxation_of, leaves_vertices_that_are_fixed_and_moves_those_that_are_pinned)
{
  for (const bool are_fixed : { false, true }) {
    Triangulated_surface_3 grid_of_25 = surface(grid(5, 5, wavy));
    for (Index v = 0; are_fixed && v < grid_of_25.points.size(); ++v)
      grid_of_25.fixed_vertices.push_back({ v, Point_2(grid_of_25.points[v].x(), grid_of_25.points[v].y()) });
    const Collapse_hierarchy_3 hierarchy(std::move(grid_of_25),
                                         parameters::coarsest_size(1000).vertex_is_constrained_map(
                                             CGAL::Constant_property_map<std::size_t, bool>(!are_fixed)));
    const Level level(hierarchy);
    const Level_energy_of<TypeParam> energy(level, Triangle_weight::ONE);
    const Level::Uv start = first_map(level);
    Level::Uv uv = start;
    const double decrease = Vertex_relaxation(energy, 1).sweep(uv).decrease;
    EXPECT_EQ(decrease == 0, are_fixed);
    EXPECT_EQ(uv == start, are_fixed);
  }
}

} // namespace test_relaxation
