// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Springs that pull vertices to places.

#include "constrained_mesh.h"
#include "exact_kernel.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_multigrid.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Contact_pattern.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_with_springs.h>

#include <CGAL/Kernel/global_functions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace test_springs {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace np = CGAL::Surface_mesh_parameterization::parameters;

typedef test_meshes::Surface_mesh   Mesh;

template <class Method>
class Springs_of_vertices : public testing::Test { };

typedef testing::Types<MIPS_parameterizer_3<Mesh>, Symmetric_Dirichlet_parameterizer_3<Mesh>>   Methods;
TYPED_TEST_SUITE(Springs_of_vertices, Methods);

// The greater the weights, the nearer the places, and the higher the energy of the triangles alone. The sum of the
// energies is reported, divided by the area if triangles are weighted by it.
TYPED_TEST(Springs_of_vertices, pull_them_to_their_places)
{
  const Flat_mesh surface = delaunay_patch(800, 3, wavy);
  Constrained_mesh free(surface);
  ASSERT_EQ(free.run<TypeParam>(true, 1e-10), OK);
  const double unit = is_mips<TypeParam> ? 1 : free.area();
  double distance = std::numeric_limits<double>::infinity(), energy = unit * free.summary.energy;
  free.hold_some(20);
  free.bend(0.05);

  for (const double weight : { 0., 1e-2, 1., 1e2, 1e4, 1e8 }) {
    Constrained_mesh m(surface);
    for (const auto v : vertices(m.mesh)) {
      m.uvmap[v] = free.uvmap[v];
      m.weight[v] = free.is_held[v] ? weight : 0;
    }
    ASSERT_EQ(m.run<TypeParam>(true, 1e-10), OK);
    EXPECT_TRUE(m.summary.converged && m.is_valid());
    const double squares = m.squared_distance_to_places();
    const double energy_of_triangles = unit * m.summary.energy - weight * squares;
    EXPECT_GE(energy_of_triangles, energy * (1 - 1e-6)) << weight;
    energy = energy_of_triangles;
    if (weight > 0) {
      EXPECT_LT(squares, distance) << weight;
      distance = squares;
    }
  }
  EXPECT_LT(distance, 1e-9);

  // Infinite weights, as it were.
  ASSERT_EQ(free.run<TypeParam>(true, 1e-10), OK);
  EXPECT_NEAR(energy, unit * free.summary.energy, 1e-4 * energy);
}

// Springs that rest in the map of least energy leave it there, however strong they are.
template <class Method, class Predicate>
void expect_rest_where_the_energy_is_least(const Flat_mesh& surface, const Predicate& is_free)
{
  Constrained_mesh m(surface);
  ASSERT_EQ(m.run<Method>(true, 1e-9), OK);
  const double energy = m.summary.energy;
  const std::vector<Kernel::Point_2> places = m.uv();
  for (const double weight : { 1e-3, 1., 1e3, 1e6 }) {
    for (const auto v : vertices(m.mesh)) {
      m.uvmap[v] = places[v];
      m.weight[v] = is_free(std::size_t(v)) ? 0 : weight;
    }
    ASSERT_EQ(m.run<Method>(), OK);
    EXPECT_NEAR(m.summary.energy / energy, 1, 1e-5) << weight;
    EXPECT_TRUE(m.is_valid());
  }
}

// On their way from coarse levels maps of a tube get stuck: stiff springs crush triangles.
TYPED_TEST(Springs_of_vertices, rest_where_the_energy_is_least)
{
  expect_rest_where_the_energy_is_least<TypeParam>(tube(60, 16, 12), [](std::size_t) { return false; });
  for (const std::size_t period : { 2, 10 })
    expect_rest_where_the_energy_is_least<TypeParam>(tube(40, 32, 12),
                                                     [&](std::size_t v) { return v % period == period - 1; });
}

// A vertex may come with any level. Springs whose places a motion of the map meets cost no energy, however far away.
TYPED_TEST(Springs_of_vertices, take_the_map_along)
{
  Constrained_mesh m(delaunay_patch(1500, 5, wavy));
  ASSERT_EQ(m.run<TypeParam>(true, 1e-9), OK);
  const double energy = m.summary.energy;
  const std::vector<Kernel::Point_2> places = m.uv();
  const Kernel::Vector_2 move(3e6, -2e6);
  for (const std::size_t number : { 1, 3 })
    for (std::size_t first = 0; first < places.size(); first += 97) {
      for (const auto v : vertices(m.mesh)) {
        m.uvmap[v] = places[v] + move;
        m.weight[v] = std::size_t(v) >= first && std::size_t(v) < first + number ? 100 : 0;
      }
      ASSERT_EQ(m.run<TypeParam>(), OK);
      EXPECT_NEAR(m.summary.energy / energy, 1, 1e-5) << first;
      EXPECT_TRUE(m.summary.converged && m.is_valid()) << first;
    }
}

// Whatever the optimizer is.
TYPED_TEST(Springs_of_vertices, are_a_matter_of_Newtons_method)
{
  Constrained_mesh start(delaunay_patch(300, 3, wavy));
  ASSERT_EQ(start.run<TypeParam>(), OK);
  start.bend(0.05);
  const auto run = [&](const auto& options, bool is_hierarchical) {
    Constrained_mesh m(delaunay_patch(300, 3, wavy));
    for (const auto v : vertices(m.mesh)) {
      m.uvmap[v] = start.uvmap[v];
      m.weight[v] = 100;
    }
    EXPECT_EQ(m.run_with<TypeParam>(options.position_weight_map(m.weight), is_hierarchical), OK);
    return m.uv();
  };
  for (const bool is_hierarchical : { false, true }) {
    const auto expected = run(np::optimizer(Optimizer::NEWTON), is_hierarchical);
    EXPECT_EQ(run(np::optimizer(Optimizer::SWEEPS), is_hierarchical), expected);
    EXPECT_EQ(run(np::optimizer(Optimizer::RANDOM_VERTICES), is_hierarchical), expected);
    EXPECT_EQ(run(np::number_of_local_steps(100), is_hierarchical), expected);
  }
}

// The gradient of the energy with springs is the derivative of its values.
TEST(Springs, have_the_gradient_of_their_energy)
{
  const Flat_mesh surface = grid(6, 5, wavy);
  Mesh mesh = make<Mesh>(surface);
  Mesh_component<Mesh> component(mesh, longest_border(mesh));
  Triangulated_surface_3 flat = component.surface();
  flat.springs = { { 3, { 0.2, 0.1 }, 5. }, { 20, { -0.3, 0.4 }, 0.7 } };
  const Collapse_hierarchy_3 hierarchy(flat, np::coarsest_size(1000));
  const Level level(hierarchy);
  Level::Uv uv;
  for (internal::Index v = 0; v < level.number_of_vertices(); ++v)
    uv.emplace_back(level.point(v).x(), level.point(v).y());
  const internal::Level_energy_of<Symmetric_Dirichlet_energy_2> alone(level, Triangle_weight::ONE);
  const internal::Level_energy_with_springs energy(alone, internal::springs_of(level));
  double of_springs = 0;
  for (internal::Index v = 0; v < level.number_of_vertices(); ++v)
    for (const Triangulated_surface_3::Spring& s : flat.springs)
      if (hierarchy.input_vertex(v) == s.vertex)
        of_springs += 0.5 * s.stiffness * CGAL::squared_distance(uv[v], s.place);
  EXPECT_GT(of_springs, 0.01);
  EXPECT_NEAR(energy.energy_of_springs(uv), of_springs, 1e-12);
  EXPECT_NEAR(energy(uv) - alone(uv), of_springs, 1e-9);

  internal::Block_multigrid multigrid(level);
  internal::Contact_pattern pattern(level.rings());
  pattern.give_to(multigrid.matrix());
  internal::Block_vectors gradient(uv.size());
  energy.assemble(uv, 0, gradient, multigrid.matrix());
  const double h = 1e-6;
  for (internal::Index v = 0; v < uv.size(); ++v) {
    Level::Uv left = uv, right = uv;
    left[v] = internal::Point_2(uv[v].x() - h, uv[v].y());
    right[v] = internal::Point_2(uv[v].x() + h, uv[v].y());
    EXPECT_NEAR(gradient[v].x, (energy(right) - energy(left)) / (2 * h), 1e-5 * (1 + std::abs(gradient[v].x)));
    left[v] = internal::Point_2(uv[v].x(), uv[v].y() - h);
    right[v] = internal::Point_2(uv[v].x(), uv[v].y() + h);
    EXPECT_NEAR(gradient[v].y, (energy(right) - energy(left)) / (2 * h), 1e-5 * (1 + std::abs(gradient[v].y)));
  }
}

// A map can always be moved to one place, wherever springs pull it.
TYPED_TEST(Springs_of_vertices, do_not_keep_a_single_vertex_from_its_place)
{
  for (const double size : { 1., 1e3, 1e6 })
    for (const bool is_hierarchical : { true, false }) {
      SCOPED_TRACE(std::to_string(size) + (is_hierarchical ? "" : " flat"));
      Constrained_mesh m(tube(30, 20, 3));
      for (const auto v : vertices(m.mesh)) {
        m.weight[v] = v.idx() % 7 == 3;
        m.uvmap[v] = Kernel::Point_2(size * std::sin(v.idx()), size * std::cos(3. * v.idx()));
      }
      m.is_held[Mesh::Vertex_index(200)] = true;
      EXPECT_EQ(m.run<TypeParam>(is_hierarchical), OK);
      EXPECT_TRUE(m.is_valid());
      m.expect_places_are_held();
    }
}

} // namespace test_springs
