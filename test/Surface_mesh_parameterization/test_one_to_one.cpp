// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps are one-to-one, or an error says that they are not: on surfaces that are hard to lay out, and on random ones.
// The number of random surfaces is the environment variable RANDOM_SURFACES.

#include "mesh_conversions.h"
#include "one_to_one_maps.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Progressive_mesh_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>

namespace test_one_to_one {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using one_to_one::Mapped_mesh_with_border;
using one_to_one::Mesh;
using one_to_one::pairs_by_counting;
namespace parameters = CGAL::parameters;

typedef MIPS_parameterizer_3<Mesh>                   MIPS;
typedef Symmetric_Dirichlet_parameterizer_3<Mesh>    Symmetric_Dirichlet;

// ---- maps without overlaps ----

template <class Method>
class Globally_injective : public testing::Test
{
protected:
  template <class NamedParameters>
  static Error_code run(Mapped_mesh_with_border& m, bool is_flat, const NamedParameters& np)
  {
    return is_flat ? m.parameterize(Method(np)) : m.parameterize(Hierarchical_parameterizer_3<Method>(Method(np)));
  }
};

typedef testing::Types<MIPS, Symmetric_Dirichlet> Flip_free_methods;
TYPED_TEST_SUITE(Globally_injective, Flip_free_methods, );

TYPED_TEST(Globally_injective, keeps_a_ramp_from_running_over_itself)
{
  for (const bool is_flat : { false, true })
    for (const double turns : { 1.2, 1.7 }) {
      Mapped_mesh_with_border m(ramp(80, turns));
      ASSERT_EQ(this->run(m, is_flat, parameters::globally_injective(false)), OK);
      EXPECT_GT(m.quality().overlaps, 0u);
      ASSERT_EQ(this->run(m, is_flat, parameters::globally_injective(true)), OK);
      EXPECT_EQ(m.quality().flips, 0u);
      EXPECT_EQ(m.quality().overlaps, 0u);
      EXPECT_EQ(pairs_by_counting(m), 0u);
    }
}

TYPED_TEST(Globally_injective, changes_nothing_where_nothing_overlaps)
{
  for (const Flat_mesh& flat_mesh : { grid(16, 12, wavy), hemisphere(), grid_with_holes(20) }) {
    Mapped_mesh_with_border m(flat_mesh);
    ASSERT_EQ(this->run(m, false, parameters::globally_injective(false)), OK);
    const Parameterization_quality free = m.quality();
    ASSERT_EQ(this->run(m, false, parameters::globally_injective(true)), OK);
    const Parameterization_quality injective = m.quality();
    EXPECT_EQ(free.overlaps, 0u);
    EXPECT_EQ(injective.overlaps, 0u);
    EXPECT_NEAR(injective.mips_excess, free.mips_excess, 0.03 * free.mips_excess);
    EXPECT_NEAR(injective.symmetric_dirichlet, free.symmetric_dirichlet, 0.03 * free.symmetric_dirichlet);
  }
}

// ---- where doubles run out ----

template <class Method>
class Deep_tube : public testing::Test { };
TYPED_TEST_SUITE(Deep_tube, Flip_free_methods, );

TYPED_TEST(Deep_tube, is_laid_out_without_a_flip)
{
  for (const double diameters : { 10, 60, 200 }) {
    Mapped_mesh_with_border m(tube(Index(12 * diameters), 8, 2 * diameters));
    for (const bool is_flat : { false, true }) {
      const Error_code status = is_flat ? m.parameterize(TypeParam(parameters::number_of_iterations(20)))
                                        : m.parameterize(Hierarchical_parameterizer_3<TypeParam>(
                                              TypeParam(parameters::number_of_iterations(20))));
      EXPECT_EQ(status, OK) << diameters;
      EXPECT_TRUE(m.is_locally_one_to_one()) << diameters;
    }
  }
}

// ---- random surfaces ----

std::size_t number_of_random_surfaces()
{
  const char* const given = std::getenv("RANDOM_SURFACES");
  return given ? std::size_t(std::atol(given)) : 1000;
}

// A Delaunay patch, collapsed by a part of its hierarchy, its points displaced; in some edges have no length, some have
// a hole, and scales differ.
Flat_mesh random_surface(unsigned int seed)
{
  Random random(seed);
  const Flat_mesh patch = delaunay_patch(20 + random.below(150), seed, wavy);
  const Collapse_hierarchy_3 hierarchy(surface(patch), parameters::coarsest_size(10).random_seed(seed));
  Progressive_mesh_3 mesh(hierarchy);
  const std::size_t coarsest = mesh.number_of_vertices(),
                    size = coarsest + random.below(hierarchy.number_of_vertices() - coarsest + 1);
  while (mesh.number_of_vertices() < size)
    mesh.split_vertex();

  const double displacement = (std::min)(1., std::pow(10, random(-6, 1))),
               scale = random(0, 1) < 0.2 ? std::pow(10, random(-140, 140)) : 1;
  Flat_mesh result;
  result.triangles = mesh.triangles();
  for (Index v = 0; v < size; ++v) {
    const Vector_3 shift(random(-1, 1), random(-1, 1), random(-1, 1));
    const Point_3 p =
        random(0, 1) < 0.02 && v > 0 ? result.points[random.below(v)] : hierarchy.point(v) + displacement * shift;
    result.points.push_back(p);
  }
  for (Point_3& p : result.points)
    p = Point_3(scale * p.x(), scale * p.y(), scale * p.z());
  const One_rings rings(size, result.triangles);
  const Index hole = Index(random.below(size));
  if (random(0, 1) < 0.2 && result.triangles.size() > 30 && !rings.is_border(hole)) {
    bool is_inside = true;
    for (const Index w : rings[hole])
      is_inside = is_inside && !rings.is_border(w);
    const auto t = std::find_if(result.triangles.begin(), result.triangles.end(),
                                [&](const Index_triangle& x) { return contains(x, hole); });
    if (is_inside)
      result.triangles.erase(t);
  }
  return result;
}

typedef Circular_border_arc_length_parameterizer_3<Mesh>                                     Circle;
typedef Hierarchical_parameterizer_3<Discrete_conformal_map_parameterizer_3<Mesh, Circle>>   Conformal;

TEST(Random_surfaces, are_laid_out_one_to_one)
{
  std::size_t conformal_maps = 0;
  for (unsigned int seed = 0; seed < number_of_random_surfaces(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mapped_mesh_with_border m(random_surface(seed));
    const auto np = parameters::number_of_iterations(10);
    EXPECT_EQ(m.parameterize(
                  Hierarchical_parameterizer_3<MIPS>(MIPS(np), parameters::coarsest_size(15).random_seed(seed))),
              OK);
    EXPECT_TRUE(m.is_locally_one_to_one());
    EXPECT_EQ(m.parameterize(Symmetric_Dirichlet(np)), OK);
    EXPECT_TRUE(m.is_locally_one_to_one());
    const Symmetric_Dirichlet injective(parameters::globally_injective(true).number_of_iterations(10));
    EXPECT_EQ(m.parameterize(Hierarchical_parameterizer_3<Symmetric_Dirichlet>(
                  injective, parameters::coarsest_size(15).random_seed(seed))),
              OK);
    EXPECT_TRUE(m.is_locally_one_to_one());
    EXPECT_EQ(m.quality().overlaps, 0u);

    // Cotangents of triangles without area, or of lengths that are too small or too great for CGAL, may not be numbers.
    const Error_code conformal = m.parameterize(Conformal(parameters::flip_policy(Flip_policy::REPAIR)));
    EXPECT_TRUE(conformal == OK || conformal == ERROR_CANNOT_SOLVE_LINEAR_SYSTEM);
    EXPECT_TRUE(m.is_locally_one_to_one());
    conformal_maps += conformal == OK;
  }
  EXPECT_GT(4 * conformal_maps, 3 * number_of_random_surfaces());
}

} // namespace test_one_to_one
