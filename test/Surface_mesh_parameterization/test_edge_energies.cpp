// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The method that minimizes an edge energy: one check for all weights.

#include "edge_energy_maps.h"
#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "numbers_of_threads.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Chordal_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Shape_preserving_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace test_edge_energies {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace edge_energy_maps;
namespace parameters = CGAL::parameters;

template <class EdgeWeights>
Method<EdgeWeights> method_of_tolerance(double tolerance)
{
  return Method<EdgeWeights>({}, EdgeWeights(), parameters::tolerance(tolerance));
}

std::vector<Flat_mesh> disks()
{
  return { grid(16, 12, wavy),           hemisphere(),         deep_cap(),
           delaunay_patch(400, 1, wavy), crumpled_grid(14, 1), disk_with_hole() };
}

template <class EdgeWeights>
class Edge_energy_parameterizer : public testing::Test { };
typedef testing::Types<Uniform_edge_weights_3, Chordal_edge_weights_3, Harmonic_edge_weights_3,
                       Mean_value_edge_weights_3, Shape_preserving_edge_weights_3> Weights;
TYPED_TEST_SUITE(Edge_energy_parameterizer, Weights, );

// Computes the relative residual of the finest level by its definition.
template <class EdgeWeights>
struct Residual_visitor : Hierarchy_visitor_3
{
  double* residual;
  explicit Residual_visitor(double& residual) : residual(&residual) { }

  bool level_parameterized(const Level& level, const Level::Uv& uv, const Level_summary&)
  {
    const double scale = std::ldexp(1., level.scale_exponent());
    double found = 0, reference = 0;
    for (Index v = 0; v < level.number_of_vertices(); ++v) {
      if (level.is_fixed(v))
        continue;
      std::vector<Point_3> ring;
      for (Index w : level.one_ring(v))
        ring.push_back(level.point(w));
      std::vector<double> weights;
      EdgeWeights()(level.point(v), ring, !level.is_border(v), weights);
      Vector_2 r(0, 0), r0(0, 0);
      for (std::size_t i = 0; i < weights.size(); ++i) {
        const Index w = level.one_ring(v)[Index(i)];
        r = r + weights[i] / sum(weights) * (uv[w] - uv[v]);
        if (level.is_fixed(w))
          r0 = r0 + weights[i] / sum(weights) *
                        (level.fixed_place(w) - Point_2(0.5 * scale, 0.5 * scale));      // the middle of the circle
      }
      found += r.squared_length();
      reference += r0.squared_length();
    }
    *residual = std::sqrt(found / reference);
    return true;
  }
};

TYPED_TEST(Edge_energy_parameterizer, solves_the_system_to_the_tolerance)
{
  for (const double tolerance : { 1e-4, 1e-9 }) {
    Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(800, 1, wavy));
    double residual = -1;
    Parameterization_summary s;
    map_of(mesh, Hierarchical_parameterizer_3<Method<TypeParam>>(
                     method_of_tolerance<TypeParam>(tolerance),
                     parameters::summary(std::ref(s)).visitor(Residual_visitor<TypeParam>(residual))));
    EXPECT_TRUE(s.converged);
    EXPECT_TRUE(residual > 0 && residual < 1.05 * tolerance)
        << residual;      // the border's box is not quite the circle's
  }
}

TYPED_TEST(Edge_energy_parameterizer, hierarchical_and_flat_maps_are_the_same)
{
  for (const Flat_mesh& m : disks()) {
    Surface_mesh mesh = make<Surface_mesh>(m);
    EXPECT_LT(greatest_distance(map_of(mesh, hierarchical(method_of_tolerance<TypeParam>(1e-11))),
                                map_of(mesh, keeping_flips<Method<TypeParam>>())),
              1e-8);
  }
}

template <class EdgeWeights>
class Positive_edge_weights : public testing::Test { };
typedef testing::Types<Uniform_edge_weights_3, Chordal_edge_weights_3, Mean_value_edge_weights_3,
                       Shape_preserving_edge_weights_3> Positive_weights;
TYPED_TEST_SUITE(Positive_edge_weights, Positive_weights, );

TYPED_TEST(Positive_edge_weights, give_a_one_to_one_map)
{
  for (const Flat_mesh& surface : disks()) {
    Mapped_mesh m(surface);
    EXPECT_EQ(m.parameterize(Hierarchical_parameterizer_3<Method<TypeParam>>(Method<TypeParam>(),
                                                                             parameters::coarsest_size(20))),
              OK);
    EXPECT_EQ(m.quality().flips, 0u);
  }
}

TYPED_TEST(Edge_energy_parameterizer, is_finite_on_any_mesh)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    Surface_mesh mesh = make<Surface_mesh>(m);
    for (const Kernel::Point_2& p : map_of(mesh, hierarchical(Method<TypeParam>())))
      EXPECT_TRUE(p.x() >= -1 && p.x() <= 2 && p.y() >= -1 &&
                  p.y() <= 2);      // about the circle, which holds all if weights are positive
  }
}

TYPED_TEST(Edge_energy_parameterizer, border_is_where_the_border_parameterizer_puts_it)
{
  for (const double scale : { 1e-100, 0.3, 1e100 }) {
    Flat_mesh m = grid(16, 12, wavy);
    for (Point_3& p : m.points)
      p = Point_3(scale * p.x(), scale * p.y(), scale * p.z());
    Surface_mesh mesh = make<Surface_mesh>(m);
    const std::vector<Kernel::Point_2> uv = map_of(mesh, hierarchical(Method<TypeParam>()));
    std::map<Surface_mesh::Vertex_index, Kernel::Point_2> border;
    std::map<Surface_mesh::Vertex_index, bool> is_placed;
    Circular_border_arc_length_parameterizer_3<Surface_mesh>().parameterize(mesh, longest_border(mesh),
                                                                            boost::make_assoc_property_map(border),
                                                                            get(CGAL::vertex_index, mesh),
                                                                            boost::make_assoc_property_map(is_placed));
    EXPECT_EQ(border.size(), 2u * (16 + 12));
    for (const auto& [v, place] : border)
      EXPECT_EQ(uv[v], place);
  }
}

TYPED_TEST(Edge_energy_parameterizer, does_not_depend_on_units)
{
  Flat_mesh m = grid(16, 12, wavy);
  Surface_mesh mesh = make<Surface_mesh>(m);
  typedef Edge_energy_parameterizer_3<Surface_mesh, TypeParam, Circular_border_uniform_parameterizer_3<Surface_mesh>>
      Method;       // whose border needs no lengths
  Parameterization_summary summary;
  const auto method = hierarchical(Method({}, TypeParam(), parameters::tolerance(1e-11)), summary);
  const std::vector<Kernel::Point_2> expected = map_of(mesh, method);
  const double energy = summary.energy;
  for (const int exponent : { -900, -515, -300, -2, 300, 538, 900 }) {
    for (const auto v : vertices(mesh)) {
      const Point_3& p = m.points[v];
      mesh.point(v) = Kernel::Point_3(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                                      std::ldexp(p.z(), exponent));
    }
    EXPECT_EQ(map_of(mesh, method), expected) << exponent;
    EXPECT_TRUE(summary.converged) << exponent;
    EXPECT_EQ(summary.energy, energy) << exponent;
  }
}

TYPED_TEST(Edge_energy_parameterizer, needs_few_iterations_on_any_number_of_vertices)
{
  for (const std::size_t vertices : { 2000, 20000 }) {
    Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(vertices, 1, wavy));
    Parameterization_summary s;
    map_of(mesh, Hierarchical_parameterizer_3<Method<TypeParam>>(Method<TypeParam>(),
                                                                 parameters::summary(std::ref(s))));
    EXPECT_TRUE(s.converged);
    EXPECT_GT(s.levels.size(), 1u);
    for (const Level_summary& level : s.levels)
      EXPECT_LE(level.iterations, 12u);
  }
}

TEST(Edge_energy, never_rises_with_symmetric_weights)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(800, 1, wavy));
  typedef Method<Harmonic_edge_weights_3> Harmonic;
  Parameterization_summary s, flat;
  map_of(mesh, Hierarchical_parameterizer_3<Harmonic>(Harmonic(), parameters::coarsest_size(20).summary(std::ref(s))));
  EXPECT_GT(s.levels.size(), 1u);
  for (const Level_summary& level : s.levels)
    EXPECT_LE(level.energy_end, level.energy_start * (1 + 1e-12));
  map_of(mesh, Harmonic({}, {}, parameters::summary(std::ref(flat))));
  EXPECT_NEAR(s.energy / flat.energy, 1, 1e-10);
}

TEST(Edge_energy, energy_is_in_the_units_of_the_plane)
{
  // The planar mesh is mapped onto itself: Dirichlet's energy is its area, in any units.
  typedef Edge_energy_parameterizer_3<Surface_mesh, Harmonic_edge_weights_3, Planar_border_parameterizer> Planar_method;
  for (const double scale : { 1e-3, 1., 7e5 }) {
    Flat_mesh m = grid(9, 9, flat);
    for (Point_3& p : m.points)
      p = Point_3(scale * p.x(), scale * p.y(), 0);
    Surface_mesh mesh = make<Surface_mesh>(m);
    Parameterization_summary s;
    map_of(mesh, Planar_method({}, {}, parameters::summary(std::ref(s))));
    EXPECT_NEAR(s.energy / (scale * scale), 1, 1e-9);
  }
}

#ifdef CGAL_LINKED_WITH_TBB
TYPED_TEST(Edge_energy_parameterizer, is_the_same_for_every_number_of_threads)
{
  typedef Edge_energy_parameterizer_3<Surface_mesh, TypeParam,
                                      Circular_border_arc_length_parameterizer_3<Surface_mesh>, CGAL::Parallel_tag>
    Parallel_method;
  Surface_mesh mesh = make<Surface_mesh>(grid(120, 110, wavy));     // groups of several blocks
  const auto np = parameters::tolerance(1e-4);
  const std::vector<Kernel::Point_2> expected = map_of(mesh, hierarchical(Method<TypeParam>({}, TypeParam(), np)));
  numbers_of_threads::for_each_number_of_threads([&] {
    EXPECT_EQ(map_of(mesh, hierarchical(Parallel_method({}, TypeParam(), np))), expected);
  });
}
#endif

} // namespace test_edge_energies
