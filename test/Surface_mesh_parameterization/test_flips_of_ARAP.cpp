// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips in as-rigid-as-possible maps: they are kept, repaired, or make way for a map that has none.

#include "ARAP_maps.h"
#include "generated_meshes.h"
#include "mesh_conversions.h"
#include "test_meshes.h"
#include "visitors.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>

namespace test_flips_of_ARAP {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace ARAP_maps;
namespace parameters = CGAL::parameters;

// Rounding to the user's numbers is all that happens to a map with flips that is to be kept.
TEST(As_rigid_as_possible, keeps_flips_in_floats)
{
  const auto map_in = [](auto& mapped, auto uvmap) {
    return SMP::parameterize(mapped.mesh, Hierarchical_method(parameters::flip_policy(Flip_policy::KEEP)),
                             longest_border(mapped.mesh), uvmap);
  };
  Mesh_with_ARAP_map mapped(crumpled_grid(14, 1));
  const auto floats = mapped.add_map_of_floats();
  ASSERT_EQ(map_in(mapped, mapped.uvmap), OK);
  ASSERT_GT(mapped.quality().flips, 0u);
  ASSERT_EQ(map_in(mapped, floats), OK);
  for (const auto v : vertices(mapped.mesh)) {
    EXPECT_EQ(floats[v].x(), float(mapped.uvmap[v].x()));
    EXPECT_EQ(floats[v].y(), float(mapped.uvmap[v].y()));
  }
}

// The map that takes the place of one that a repair would spoil is a minimum, too: another run gains nothing.
TEST(As_rigid_as_possible, replaces_a_map_by_one_that_has_converged)
{
  std::size_t replaced = 0;
  for (const Flat_mesh& m : { deep_cap(), tube(20, 12, 12), cap(20, 24, 0.97 * CGAL_PI) }) {
    Mesh_with_ARAP_map mapped(m);
    EXPECT_EQ(mapped.parameterize(Hierarchical_method(Method(), parameters::summary(std::ref(mapped.summary)))), OK);
    if (!mapped.summary.is_replaced)
      continue;
    ++replaced;
    const Parameterization_summary before = mapped.summary;
    EXPECT_EQ(mapped.parameterize(Method(parameters::initial_map(true).summary(std::ref(mapped.summary)))), OK);
    EXPECT_TRUE(mapped.summary.is_replaced);
    EXPECT_NEAR(mapped.summary.energy, before.energy, 1e-4 * before.energy);
    EXPECT_TRUE(before.converged);
  }
  EXPECT_GT(replaced, 0u);
}

// What comes of flips, by a repair or without them, is not better than the start if that was valid and had less energy.
TEST(As_rigid_as_possible, does_not_end_above_a_valid_start)
{
  for (unsigned int seed = 0; seed < 20; ++seed) {
    Random random(seed);
    Mesh_with_ARAP_map mapped(tents(8, 4, 2, random));
    const auto run = [&](bool is_restart) {
      const auto options = parameters::initial_map(is_restart).summary(std::ref(mapped.summary));
      EXPECT_EQ(mapped.parameterize(Hierarchical_method(Method(), options)), OK);
      return mapped.summary.energy;
    };
    const double energy = run(false);
    EXPECT_LE(run(true), energy * (1 + 1e-6)) << seed;
  }
}

// After a repair, too. A map that the repair would spoil is replaced: its energy is little above that of the map with
// flips, and never above that of the symmetric Dirichlet map.
TEST(As_rigid_as_possible, energy_is_that_of_the_result)
{
  std::size_t repaired = 0, replaced = 0;
  for (const Flat_mesh& m : { deep_cap(), tube(20, 12, 12), crumpled_grid(12, 1), cap(20, 24, 0.97 * CGAL_PI) })
    for (const double lambda : { 1., 1000. }) {
      Mesh_with_ARAP_map mapped(m), with_flips(m), without_flips(m);
      EXPECT_EQ(mapped.parameterize(Hierarchical_method(
                    Method(parameters::lambda(lambda)), parameters::summary(std::ref(mapped.summary)))),
                OK);
      EXPECT_EQ(mapped.quality().flips, 0u);
      EXPECT_NEAR(mapped.summary.energy, mapped.energy(lambda), 1e-6 * mapped.summary.energy);
      repaired += mapped.summary.moved_vertices > 0;
      replaced += mapped.summary.is_replaced;
      typedef Symmetric_Dirichlet_parameterizer_3<Surface_mesh>   Flip_free;
      EXPECT_EQ(without_flips.parameterize(Hierarchical_parameterizer_3<Flip_free>()), OK);
      EXPECT_LE(mapped.summary.energy, without_flips.energy(lambda));
      const auto keeping_flips = parameters::lambda(lambda).flip_policy(Flip_policy::KEEP);
      EXPECT_EQ(with_flips.parameterize(Hierarchical_method(keeping_flips)), OK);
      EXPECT_LE(mapped.summary.energy, 1.3 * with_flips.energy(lambda));
    }
  EXPECT_GT(repaired, 0u);
  EXPECT_GT(replaced, 0u);
}

// With lambda = 0 a map without flips from the start has another scale. It does not take the place of one that a repair
// of large folds, which the method may give up, leaves near the minimum.
TEST(As_rigid_as_possible, repairs_large_folds_where_that_costs_little)
{
  Random random(3);
  const Flat_mesh surface = tents(30, 10, 3, random);
  for (const double lambda : { 0., 1e-6 })
    for (const bool is_hierarchical : { true, false }) {
      Mesh_with_ARAP_map mapped(surface), with_flips(surface);
      const auto run = [&](Mesh_with_ARAP_map& m, Flip_policy policy) {
        const auto options = parameters::lambda(lambda).flip_policy(policy).summary(std::ref(m.summary));
        return is_hierarchical ? m.parameterize(Hierarchical_method(options)) : m.parameterize(Method(options));
      };
      ASSERT_EQ(run(mapped, Flip_policy::REPAIR), OK);
      ASSERT_EQ(run(with_flips, Flip_policy::KEEP), OK);
      EXPECT_EQ(mapped.quality().flips, 0u);
      EXPECT_FALSE(mapped.summary.is_replaced);
      EXPECT_LT(mapped.summary.energy, 10 * with_flips.summary.energy);
    }
}

// The repair moves two vertices: the tips of ears that are a fifth of the area.
TEST(As_rigid_as_possible, compares_a_repair_that_costs_energy_with_a_map_without_flips)
{
  Mesh_with_ARAP_map mapped(square_with_ears(10, 1000));
  EXPECT_EQ(mapped.parameterize(Hierarchical_method(Method(), parameters::summary(std::ref(mapped.summary)))), OK);
  EXPECT_GT(mapped.summary.flips, 0u);
  EXPECT_TRUE(mapped.summary.is_replaced);
  EXPECT_EQ(mapped.quality().flips, 0u);
  EXPECT_LT(mapped.summary.energy, 1e-3);      // the area is about 500
}

// Without flips on all levels but the finest.
TEST(As_rigid_as_possible, takes_every_mesh)
{
  const On_level visitor([](const Level& level, const Level::Uv& uv) {
    EXPECT_TRUE(level.is_finest() || SMP::internal::is_map_valid(level.rings(), uv)) << "level " << level.index();
    return true;
  });
  for (const auto& [name, m] : named_meshes())
    for (const double lambda : { 0., 1000., infinity })
      for (const Optimizer optimizer : { Optimizer::NEWTON, Optimizer::SWEEPS, Optimizer::RANDOM_VERTICES }) {
        SCOPED_TRACE(name + ", lambda " + std::to_string(lambda) + ", optimizer " + std::to_string(int(optimizer)));
        Mesh_with_ARAP_map mapped(m);
        const Method method(parameters::lambda(lambda).optimizer(optimizer).number_of_iterations(20));
        EXPECT_EQ(mapped.parameterize(Hierarchical_method(method, parameters::coarsest_size(20)
                                                                      .flip_policy(Flip_policy::KEEP)
                                                                      .summary(std::ref(mapped.summary))
                                                                      .visitor(visitor))),
                  OK);
        EXPECT_TRUE(std::isfinite(mapped.summary.energy));
        EXPECT_LE(mapped.summary.levels.back().energy_end, mapped.summary.levels.back().energy_start + 1e-15);
        for (const Kernel::Point_2& p : mapped.uv())
          EXPECT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y()));
      }
}

} // namespace test_flips_of_ARAP
