// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The defaults of named parameters are those of the manual: a run that is told one has the map of a run that is not,
// and with other values the map is another one.

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace test_defaults {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace np = CGAL::Surface_mesh_parameterization::parameters;

typedef MIPS_parameterizer_3<Surface_mesh>                                   MIPS;
typedef Symmetric_Dirichlet_parameterizer_3<Surface_mesh>                    Symmetric_Dirichlet;
typedef As_rigid_as_possible_parameterizer_3<Surface_mesh>                   ARAP;
typedef Edge_energy_parameterizer_3<Surface_mesh, Harmonic_edge_weights_3>   Harmonic;
typedef Barycentric_mapping_parameterizer_3<Surface_mesh>                    Barycentric;
typedef Mean_value_coordinates_parameterizer_3<Surface_mesh>                 Mean_value;
typedef LSCM_parameterizer_3<Surface_mesh>                                   LSCM;

// The map that the method makes of a projection; that itself if it is an error.
template <class Method, class NamedParameters>
Points map_with(const Flat_mesh& surface, const NamedParameters& options)
{
  Mapped_mesh m(surface);
  m.project();
  const Points before = m.uv();
  const Error_code status = m.parameterize(Hierarchical_parameterizer_3<Method>(options));
  EXPECT_EQ(m.uv() == before, status != OK);
  return m.uv();
}

// Checks that a value is the default: set(options, value) are the options of a run with it.
template <class Method, class NamedParameters, class Set, class Value>
void expect_default(const Flat_mesh& surface, const NamedParameters& options, const Set& set, const Value& value,
                    const std::vector<Value>& others)
{
  const Points expected = map_with<Method>(surface, options);
  EXPECT_TRUE(map_with<Method>(surface, set(options, value)) == expected);
  for (const Value& other : others)
    EXPECT_FALSE(map_with<Method>(surface, set(options, other)) == expected) << testing::PrintToString(other);
}

// ---- accuracy ----

const auto tolerance = [](const auto& options, double x) { return options.tolerance(x); };
const auto number_of_iterations = [](const auto& options, int x) { return options.number_of_iterations(x); };

template <class Method>
class Default_of_energies : public testing::Test { };

typedef testing::Types<MIPS, Symmetric_Dirichlet, ARAP>   Energies;
TYPED_TEST_SUITE(Default_of_energies, Energies, );

// Newton's method converges so fast that values of the same order lead to the same map; sweeps tell them apart.
TYPED_TEST(Default_of_energies, accuracy)
{
  const Flat_mesh surface = delaunay_patch(300, 3, wavy);
  const auto sweeps = np::optimizer(Optimizer::SWEEPS);
  expect_default<TypeParam>(surface, sweeps, tolerance, 1e-6, { 5e-7, 2e-6 });
  expect_default<TypeParam>(tube(60, 12, 20), sweeps.tolerance(1e-15), number_of_iterations, 200, { 199, 201 });
}

TYPED_TEST(Default_of_energies, optimizer)
{
  const Flat_mesh surface = delaunay_patch(300, 3, wavy);
  expect_default<TypeParam>(
      surface, np::random_seed(0), [](const auto& options, Optimizer x) { return options.optimizer(x); },
      Optimizer::NEWTON, { Optimizer::SWEEPS, Optimizer::RANDOM_VERTICES });
  expect_default<TypeParam>(
      surface, np::random_seed(0), [](const auto& options, int x) { return options.number_of_local_steps(x); }, 0,
      { 100 });
}

TEST(Default_of_linear_methods, accuracy)
{
  const Flat_mesh surface = delaunay_patch(1200, 3, wavy);
  expect_default<Harmonic>(surface, np::random_seed(0), tolerance, 1e-8, { 1e-9, 1e-7 });
  expect_default<Mean_value>(surface, np::random_seed(0), tolerance, 1e-10, { 1e-11, 1e-9 });
  expect_default<Harmonic>(surface, np::random_seed(0), number_of_iterations, 300, { 1 });
  expect_default<Mean_value>(surface, np::random_seed(0), number_of_iterations, 300, { 1 });
}

// ---- what is minimized ----

TEST(Default, triangle_weight)
{
  const auto weight = [](const auto& options, Triangle_weight x) { return options.triangle_weight(x); };
  const Flat_mesh surface = delaunay_patch(300, 3, wavy);
  expect_default<MIPS>(surface, np::random_seed(0), weight, Triangle_weight::ONE, { Triangle_weight::AREA });
  expect_default<Symmetric_Dirichlet>(surface, np::random_seed(0), weight, Triangle_weight::AREA,
                                      { Triangle_weight::ONE });
}

TEST(Default, lambda)
{
  expect_default<ARAP>(delaunay_patch(300, 3, wavy), np::random_seed(0),
                       [](const auto& options, double x) { return options.lambda(x); }, 1000., { 999., 1001. });
}

// Of a ramp of more than a turn much would lie over itself.
TEST(Default, globally_injective)
{
  const Flat_mesh surface = ramp(60, 1.5);
  expect_default<MIPS>(surface, np::random_seed(0),
                       [](const auto& options, bool x) { return options.globally_injective(x); }, false, { true });
  expect_default<MIPS>(surface, np::globally_injective(true),
                       [](const auto& options, double x) { return options.overlap_bound(x); }, 1., { 0.1 });
}

// ---- given maps and vertices ----

TYPED_TEST(Default_of_energies, given_maps)
{
  typedef Surface_mesh::Vertex_index   Vertex;
  const Flat_mesh surface = delaunay_patch(300, 3, wavy);
  expect_default<TypeParam>(surface, np::tolerance(1e-3),
                            [](const auto& options, bool x) { return options.initial_map(x); }, false, { true });
  expect_default<TypeParam>(
      surface, np::initial_map(true),
      [](const auto& options, double x) {
        return options.position_weight_map(CGAL::Constant_property_map<Vertex, double>(x));
      },
      0., { 1. });
  expect_default<TypeParam>(
      surface, np::tolerance(1e-6),
      [](const auto& options, unsigned int x) {
        const auto is_held = [x](Vertex v) { return std::size_t(v) % 10 < x; };
        return options.vertex_is_constrained_map(boost::make_function_property_map<Vertex>(is_held));
      },
      0u, { 1u });
}

// ---- flips and holes ----

const auto flip_policy = [](const auto& options, Flip_policy x) { return options.flip_policy(x); };

TEST(Default, flip_policy)
{
  const std::vector<Flip_policy> others = { Flip_policy::KEEP, Flip_policy::FAIL };
  expect_default<ARAP>(deep_cap(), np::random_seed(0), flip_policy, Flip_policy::REPAIR, others);
  expect_default<Harmonic>(crumpled_grid(14, 1), np::random_seed(0), flip_policy, Flip_policy::REPAIR, others);
  expect_default<LSCM>(deep_cap(), np::random_seed(0), flip_policy, Flip_policy::REPAIR, others);
}

// Where border points coincide, they do so on the circle.
TEST(Default, flip_policy_of_convex_maps)
{
  const std::vector<Flip_policy> others = { Flip_policy::KEEP, Flip_policy::REPAIR };
  Flat_mesh surface = grid(8, 8, wavy);
  surface.points[3] = surface.points[4];
  expect_default<Barycentric>(surface, np::random_seed(0), flip_policy, Flip_policy::FAIL, others);
  expect_default<Mean_value>(surface, np::random_seed(0), flip_policy, Flip_policy::FAIL, others);
}

TEST(Default, fill_holes)
{
  const auto fill_holes = [](const auto& options, bool x) { return options.fill_holes(x); };
  const Flat_mesh surface = grid_with_holes(20);
  expect_default<MIPS>(surface, np::random_seed(0), fill_holes, false, { true });
  expect_default<ARAP>(surface, np::random_seed(0), fill_holes, false, { true });
  expect_default<Harmonic>(surface, np::random_seed(0), fill_holes, false, { true });
  expect_default<Mean_value>(surface, np::random_seed(0), fill_holes, false, { true });
}

// ---- hierarchy ----

template <class Method>
class Default_of_hierarchies : public testing::Test { };

typedef testing::Types<MIPS, ARAP, Harmonic, Barycentric, Mean_value>   All_methods;
TYPED_TEST_SUITE(Default_of_hierarchies, All_methods, );

TYPED_TEST(Default_of_hierarchies, levels)
{
  const Flat_mesh surface = delaunay_patch(1200, 3, wavy);
  // CGAL's methods solve directly on a grid of some hundred vertices.
  const bool is_of_CGAL = std::is_same_v<TypeParam, Barycentric> || std::is_same_v<TypeParam, Mean_value>;
  const std::vector<int> other_sizes = is_of_CGAL ? std::vector<int>{ 1000 } : std::vector<int>{ 50, 200 };
  expect_default<TypeParam>(surface, np::flip_policy(Flip_policy::KEEP),
                            [](const auto& options, int x) { return options.coarsest_size(x); }, 100, other_sizes);
  expect_default<TypeParam>(surface, np::flip_policy(Flip_policy::KEEP),
                            [](const auto& options, unsigned int x) { return options.random_seed(x); }, 0u, { 1u });
  constexpr bool is_barycentric = std::is_same_v<TypeParam, Barycentric>;
  expect_default<TypeParam>(surface, np::flip_policy(Flip_policy::KEEP),
                            [](const auto& options, bool x) { return options.unit_edges(x); }, is_barycentric,
                            { !is_barycentric });
}

} // namespace test_defaults
