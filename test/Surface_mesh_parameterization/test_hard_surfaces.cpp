// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// On surfaces of hard kinds: there is a result wherever Tutte's map is valid, and it is not worse than a map at hand.

#include "distortion_runs.h"
#include "energy_archetype.h"
#include "generated_meshes.h"
#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Distortion_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace test_hard_surfaces {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

std::vector<std::pair<std::string, Flat_mesh>> hard_surfaces()
{
  return { { "hyperbolic disk, valence 7", hyperbolic_disk(7, 5) },
           { "hyperbolic disk, valence 12", hyperbolic_disk(12, 3) },
           { "comb of long teeth", flat_comb(2, 1e4, 20) },
           { "comb of many teeth", flat_comb(20, 100, 10) },
           { "steep spike", spike(300, 1e-3) },
           { "spike", spike(100, 0.1) },
           { "apollonian disk of 7", apollonian_disk(7, 7) },
           { "apollonian disk of 101", apollonian_disk(101, 3) },
           { "fan", ruffled_fan(1000) } };
}

template <class Energy>
class Hard_surfaces : public testing::Test { };

typedef testing::Types<MIPS_energy_2, Symmetric_Dirichlet_energy_2> Energies;
TYPED_TEST_SUITE(Hard_surfaces, Energies, );

TYPED_TEST(Hard_surfaces, have_maps_no_worse_than_Tuttes)
{
  for (const auto& [name, surface] : hard_surfaces()) {
    Mapped_mesh m(surface);
    ASSERT_TRUE(has_Tutte_map(m)) << name;
    const double tutte = energy<TypeParam>(m);
    for (const bool globally_injective : { false, true }) {
      ASSERT_EQ(minimize<TypeParam>(m, globally_injective), OK) << name;
      EXPECT_TRUE(m.is_valid()) << name;
      EXPECT_LE(energy<TypeParam>(m), tutte * (1 + 1e-9)) << name;
      EXPECT_TRUE(!globally_injective || m.quality().overlaps == 0) << name;
    }
  }
}

TYPED_TEST(Hard_surfaces, keep_a_map_that_is_one_to_one_of_itself)
{
  int maps = 0;
  for (const auto& [name, surface] : hard_surfaces()) {
    Mapped_mesh m(surface);
    ASSERT_EQ(minimize<TypeParam>(m, false), OK) << name;
    if (m.quality().overlaps > 0)
      continue;
    ++maps;
    const auto free = m.uv();
    ASSERT_EQ(minimize<TypeParam>(m, true), OK) << name;
    EXPECT_EQ(m.uv(), free) << name;
  }
  EXPECT_GE(maps, 7);
}

// Coarse levels may lead to where no run arrives: a small surface tries it from a first map, too.
TEST(Hard_surfaces, with_long_ears_have_about_the_least_energy)
{
  typedef MIPS_parameterizer_3<Surface_mesh>   Method;
  const Flat_mesh surface = square_with_ears(10, 1000);
  Mapped_mesh flat(surface);
  ASSERT_EQ(flat.parameterize(Method()), OK);
  for (const unsigned int seed : { 0u, 1u, 2u, 3u, 4u }) {
    Mapped_mesh m(surface);
    ASSERT_EQ(m.parameterize(Hierarchical_parameterizer_3<Method>(Method(), parameters::random_seed(seed))), OK);
    EXPECT_LT(energy<MIPS_energy_2>(m), 1.01 * energy<MIPS_energy_2>(flat)) << seed;
  }
}

// They cost little energy: coarse levels are those of the surface around them.
TYPED_TEST(Hard_surfaces, may_have_parts_that_are_points)
{
  Mapped_mesh without(grid(48, 48, wavy));
  ASSERT_EQ(minimize<TypeParam>(without, false), OK);
  for (const Index size : { 1, 2, 5 }) {
    Mapped_mesh m(grid_with_points(48, 12, size));
    ASSERT_EQ(minimize<TypeParam>(m, false), OK) << size;
    EXPECT_TRUE(m.is_valid()) << size;
    EXPECT_LT(energy<TypeParam>(m), 1.02 * energy<TypeParam>(without)) << size;
  }
}

TEST(Hard_surfaces, of_combs_are_laid_out_flat)
{
  for (const Flat_mesh& comb : { flat_comb(2, 1e4, 20), flat_comb(20, 100, 10) }) {
    Mapped_mesh m(comb);
    typedef Symmetric_Dirichlet_parameterizer_3<Surface_mesh>   Method;
    ASSERT_EQ(m.parameterize(Hierarchical_parameterizer_3<Method>(Method(parameters::globally_injective(true)))), OK);
    EXPECT_NEAR(m.quality().symmetric_dirichlet, 4, 1e-4);
  }
}

TEST(Hard_surfaces, are_not_mirrored_by_a_repair)
{
  typedef As_rigid_as_possible_parameterizer_3<Surface_mesh>   Method;
  int maps = 0;
  for (unsigned int seed = 0; seed < 50; ++seed) {
    Mapped_mesh m(apollonian_disk(7 + 2 * (seed % 5), seed));
    if (m.parameterize(Hierarchical_parameterizer_3<Method>(Method(), parameters::flip_policy(Flip_policy::REPAIR))) ==
        OK) {
      EXPECT_TRUE(m.is_valid()) << seed;
      ++maps;
    }
  }
  EXPECT_GT(maps, 40);
}

// exp(f / d): exceeds all doubles where a triangle is stretched by more than about 700 times.
struct Exponential_energy_2
{
  static constexpr double minimum = 7.38905609893065;
  static constexpr bool is_scale_invariant = true;
  static constexpr bool is_flip_free = true;
  const Exponential_energy_2& of_area(double) const { return *this; }
  static double value(double f, double d) { return std::exp(f / d); }
  static Distortion_derivatives_2 derivatives(double f, double d)
  {
    const double e = value(f, d), r = f / d, d2 = d * d;
    return { e, e / d, -e * r / d, e / d2, -e * (r + 1) / d2, e * r * (r + 2) / d2 };
  }
};

TEST(Energy_that_overflows, ends_finite)
{
  typedef Distortion_parameterizer_3<Surface_mesh, Exponential_energy_2>   Method;
  for (const Flat_mesh& surface : { deep_cap(), flat_comb(2, 1e4, 20), tube(200, 12, 30) }) {
    Mapped_mesh m(surface);
    ASSERT_TRUE(has_Tutte_map(m));
    ASSERT_EQ(m.parameterize(Hierarchical_parameterizer_3<Method>(Method(), parameters::summary(std::ref(m.summary)))),
              OK);
    EXPECT_TRUE(m.is_valid());
    EXPECT_TRUE(std::isfinite(m.summary.energy));
  }
}

TEST(Huge_coordinates, are_mapped_or_refused)
{
  typedef Hierarchical_parameterizer_3<Symmetric_Dirichlet_parameterizer_3<Surface_mesh>>   Parameterizer;
  for (const double scale : { 1e300, 1e307, 8e307, 1.7e308 }) {
    Flat_mesh surface = tube(30, 12, 1.);
    for (Point_3& p : surface.points)
      p = Point_3(scale * p.x(), scale * p.y(), scale * p.z());
    Mapped_mesh m(surface);
    const Error_code status = m.parameterize(Parameterizer());
    EXPECT_TRUE(status == OK || (status == ERROR_WRONG_PARAMETER && scale > 1e307)) << scale;
    EXPECT_TRUE(status == OK || m.is_untouched());
    for (const auto& p : m.uv())
      EXPECT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y())) << scale;
  }
}

} // namespace test_hard_surfaces
