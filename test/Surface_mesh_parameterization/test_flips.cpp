// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips of maps, found and repaired.

#include "numbers_of_threads.h"
#include "one_to_one_maps.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Patch_unfolder.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <vector>

namespace test_flips {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using internal::Patch_unfolder;
using internal::Patch_unfolder_options;
using internal::is_map_valid;
using one_to_one::Mapped_mesh_with_border;
using one_to_one::Mesh;
namespace parameters = CGAL::parameters;

// ---- policies ----

typedef Circular_border_arc_length_parameterizer_3<Mesh>                 Circle;
typedef Hierarchical_parameterizer_3<LSCM_parameterizer_3<Mesh>>         LSCM;
typedef Hierarchical_parameterizer_3<Discrete_conformal_map_parameterizer_3<Mesh, Circle>>   Conformal;

template <class Parameterizer>
class Flip_policies : public testing::Test { };
typedef testing::Types<LSCM, Conformal> Methods_with_flips;
TYPED_TEST_SUITE(Flip_policies, Methods_with_flips, );

TYPED_TEST(Flip_policies, are_kept)
{
  Mapped_mesh_with_border m(crumpled_grid(14, 1));    // obtuse angles all over
  const auto run = [&](Flip_policy policy) {
    return m.parameterize(TypeParam(parameters::flip_policy(policy).summary(std::ref(m.summary))));
  };

  EXPECT_EQ(run(Flip_policy::FAIL), ERROR_NO_1_TO_1_MAPPING);
  EXPECT_EQ(m.summary.error.code, ERROR_NO_1_TO_1_MAPPING);
  EXPECT_GT(m.summary.flips, 0u);
  EXPECT_FALSE(m.summary.converged);
  EXPECT_TRUE(m.is_untouched());

  EXPECT_EQ(run(Flip_policy::KEEP), OK);
  EXPECT_FALSE(m.is_locally_one_to_one());
  EXPECT_GT(m.quality().flips, 0u);

  EXPECT_EQ(run(Flip_policy::REPAIR), OK);
  EXPECT_TRUE(m.is_locally_one_to_one());
  EXPECT_EQ(m.quality().flips, 0u);
  EXPECT_GT(m.summary.flips, 0u);
  EXPECT_GT(m.summary.moved_vertices, 0u);

  const auto repaired = m.uv();
  EXPECT_EQ(m.parameterize(TypeParam()), OK);     // the default
  EXPECT_EQ(m.uv(), repaired);
}

// Where a map is the one of least energy, its repair costs energy, and that is what the summary has.
TEST(Flip_policies_of_edge_energies, tell_the_energy_of_the_repaired_map)
{
  typedef Edge_energy_parameterizer_3<Mesh, Harmonic_edge_weights_3> Harmonic;
  Mapped_mesh_with_border m(crumpled_grid(14, 1));
  const auto run = [&](Flip_policy policy) {
    return m.parameterize(
        Hierarchical_parameterizer_3<Harmonic>(parameters::flip_policy(policy).summary(std::ref(m.summary))));
  };
  EXPECT_EQ(run(Flip_policy::KEEP), OK);
  const double least = m.summary.energy;
  EXPECT_EQ(run(Flip_policy::REPAIR), OK);
  EXPECT_GT(m.summary.moved_vertices, 0u);
  EXPECT_NEAR(m.summary.levels.back().energy_end / least, 1, 1e-12);
  EXPECT_GT(m.summary.energy / least, 1.0001);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Flip_policies, repair_the_same_for_every_number_of_threads)
{
  typedef Discrete_conformal_map_parameterizer_3<Mesh, Circle>   Method;
  Mapped_mesh_with_border m(crumpled_grid(80, 1));
  EXPECT_EQ(m.parameterize(Hierarchical_parameterizer_3<Method>(parameters::summary(std::ref(m.summary)))), OK);
  EXPECT_GT(20 * m.summary.moved_vertices, num_vertices(m.mesh));      // by hierarchies, not by patches
  const auto expected = m.uv();
  numbers_of_threads::for_each_number_of_threads([&] {
    EXPECT_EQ(m.parameterize(Hierarchical_parameterizer_3<Method, CGAL::Parallel_tag>()), OK);
    EXPECT_EQ(m.uv(), expected);
  });
}
#endif

// ---- patches ----

// A flat grid, its places in the plane by a function of x and y, and what lies inside.
struct Patch
{
  Flat_mesh mesh = grid(24, 12, flat);
  One_rings rings = One_rings(mesh.points.size(), mesh.triangles);
  std::vector<Point_2> uv;
  std::vector<Index> interior;

  template <class Function>
  explicit Patch(const Function& place)
  {
    for (Index v = 0; v < mesh.points.size(); ++v) {
      uv.push_back(place(mesh.points[v].x(), mesh.points[v].y()));
      if (!rings.is_border(v))
        interior.push_back(v);
    }
  }

  bool unfold(const Patch_unfolder_options& options = Patch_unfolder_options())
  {
    return Patch_unfolder(rings, mesh.points, uv, options).run(interior);
  }
};

TEST(Patch_unfolder, fills_what_is_not_convex)
{
  // Three quarters of a ring: Tutte's embedding leaves it.
  Patch patch([](double x, double y) {
    const double radius = 1 + 2 * y, angle = -1.5 * CGAL_PI * x;
    return Point_2(radius * std::cos(angle), radius * std::sin(angle));
  });
  ASSERT_TRUE(is_map_valid(patch.rings, patch.uv));
  Random random(5);
  for (const Index v : patch.interior)
    patch.uv[v] = Point_2(random(-2, 2), random(-2, 2));
  ASSERT_FALSE(is_map_valid(patch.rings, patch.uv));
  const std::vector<Point_2> before = patch.uv;

  Patch_unfolder_options no_steps;
  no_steps.most_steps = 0;
  EXPECT_FALSE(patch.unfold(no_steps));
  EXPECT_EQ(patch.uv, before);

  EXPECT_TRUE(patch.unfold());
  EXPECT_TRUE(is_map_valid(patch.rings, patch.uv));
  for (Index v = 0; v < patch.uv.size(); ++v)
    EXPECT_TRUE(patch.uv[v] == before[v] || !patch.rings.is_border(v));
}

TEST(Patch_unfolder, changes_nothing_where_there_are_no_valid_places)
{
  // The border goes around twice, or to the right, or is one point, or is nowhere.
  const auto double_turn = [](double x, double y) {
    const double u = x - 0.49, v = y - 0.26;
    return Point_2(u * u - v * v, 2 * u * v);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (Patch patch : { Patch(double_turn), Patch([](double x, double y) { return Point_2(-x, y); }),
                       Patch([](double, double) { return Point_2(1, 1); }),
                       Patch([nan](double, double) { return Point_2(0, nan); }) }) {
    const std::vector<Point_2> before = patch.uv;
    EXPECT_FALSE(patch.unfold());
    for (Index v = 0; v < before.size(); ++v)
      EXPECT_TRUE(patch.uv[v] == before[v] || std::isnan(before[v].y()));
  }
}

} // namespace test_flips
