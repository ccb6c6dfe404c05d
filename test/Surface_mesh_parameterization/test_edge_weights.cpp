// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The weights of edges: one check for all models, and what each of them promises.

#include "Random.h"
#include "edge_energy_maps.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Chordal_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Shape_preserving_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_edge_weights {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace edge_energy_maps;
namespace parameters = CGAL::parameters;

// No more than the concept asks for.
struct Edge_weights_archetype
{
  static constexpr bool is_symmetric = false;

  void operator()(const Point_3&, const std::vector<Point_3>& ring, bool, std::vector<double>& weights)
  {
    weights.assign(ring.size(), 0.);
    weights.front() = 2;
    weights.back() = 1;
  }
};

typedef std::vector<std::vector<double>> Rows;

// The weights of every vertex, in the order of its ring.
template <class EdgeWeights>
Rows weights_of(const Flat_mesh& m, EdgeWeights weights = EdgeWeights())
{
  const One_rings rings(m.points.size(), m.triangles);
  Rows rows(m.points.size(), std::vector<double>(99, -77.));
  for (Index v = 0; v < m.points.size(); ++v) {
    std::vector<Point_3> ring;
    for (Index w : rings[v])
      ring.push_back(m.points[w]);
    weights(m.points[v], ring, !rings.is_border(v), rows[v]);
  }
  return rows;
}

template <class EdgeWeights>
class EdgeWeights_3 : public testing::Test { };
typedef testing::Types<Uniform_edge_weights_3, Chordal_edge_weights_3, Harmonic_edge_weights_3,
                       Mean_value_edge_weights_3, Shape_preserving_edge_weights_3, Edge_weights_archetype> All_weights;
TYPED_TEST_SUITE(EdgeWeights_3, All_weights, );

TYPED_TEST(EdgeWeights_3, keep_what_they_promise)
{
  constexpr bool may_be_negative = std::is_same<TypeParam, Harmonic_edge_weights_3>::value;
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    const One_rings rings(m.points.size(), m.triangles);
    const Rows rows = weights_of<TypeParam>(m);
    std::map<std::pair<Index, Index>, double> weight;
    for (Index v = 0; v < m.points.size(); ++v) {
      ASSERT_EQ(rows[v].size(), rings[v].size());
      EXPECT_GT(sum(rows[v]), 0);
      for (std::size_t i = 0; i < rows[v].size(); ++i) {
        EXPECT_TRUE(std::isfinite(rows[v][i]));
        EXPECT_TRUE(rows[v][i] >= 0 || may_be_negative);
        weight[{ v, rings[v][Index(i)] }] = rows[v][i];
      }
    }
    for (const auto& [edge, w] : weight)
      EXPECT_TRUE(!TypeParam::is_symmetric ||
                  std::abs(w - weight.at({ edge.second, edge.first })) < 1e-6 * (1 + std::abs(w)));
  }
}

// ---- each of them ----

TEST(Mean_value_edge_weights, are_positive_and_by_Floaters_formula)
{
  const Flat_mesh m = fan(5);
  const Rows rows = weights_of<Mean_value_edge_weights_3>(m);
  const One_rings rings(m.points.size(), m.triangles);
  const auto angle = [&](Index a, Index b) {
    return CGAL::approximate_angle(m.points[a], m.points[0], m.points[b]) * CGAL_PI / 180;
  };
  for (Index i = 0; i < 5; ++i) {
    const Index w = rings[0][i], next = rings[0][(i + 1) % 5], previous = rings[0][(i + 4) % 5];
    const double expected = (std::tan(0.5 * angle(previous, w)) + std::tan(0.5 * angle(w, next))) /
                            std::sqrt(CGAL::squared_distance(m.points[0], m.points[w]));
    EXPECT_NEAR(rows[0][i] / expected, 1, 1e-12);
  }
}

TEST(Harmonic_edge_weights, give_the_area_of_a_planar_mesh)
{
  const Flat_mesh m = delaunay_patch(200, 1, flat);
  const One_rings rings(m.points.size(), m.triangles);
  const Rows rows = weights_of<Harmonic_edge_weights_3>(m);
  double energy = 0, area = 0;
  for (Index v = 0; v < m.points.size(); ++v)
    for (std::size_t i = 0; i < rows[v].size(); ++i)
      energy += 0.25 * rows[v][i] *
                CGAL::squared_distance(m.points[v], m.points[rings[v][Index(i)]]);      // every edge is met twice
  for (const Index_triangle& t : m.triangles)
    area += std::sqrt(CGAL::squared_area(m.points[t[0]], m.points[t[1]], m.points[t[2]]));
  EXPECT_NEAR(energy / area, 1, 1e-9);
}

TEST(Shape_preserving_edge_weights, sum_to_one)
{
  for (const auto& [name, m] : named_meshes())
    for (const std::vector<double>& row : weights_of<Shape_preserving_edge_weights_3>(m))
      EXPECT_NEAR(sum(row), 1, 1e-12) << name;
}

// Where the flattened ring leaves V on the line between two neighbors, rounding puts it on either side of that.
TEST(Shape_preserving_edge_weights, between_two_neighbors_are_by_distance)
{
  Random random(1);
  const auto point = [&] { return Point_3(random(-1, 1), random(-1, 1), random(-1, 1)); };
  Shape_preserving_edge_weights_3 weights;
  for (int i = 0; i < 100; ++i) {
    const Point_3 v = point(), a = point(), b = point();
    const double to_a = std::sqrt(CGAL::squared_distance(v, a)), to_b = std::sqrt(CGAL::squared_distance(v, b));
    std::vector<double> row;
    weights(v, { a, b }, false, row);
    EXPECT_NEAR(row[0], to_b / (to_a + to_b), 1e-12);
    EXPECT_NEAR(row[1], to_a / (to_a + to_b), 1e-12);
  }
}

TEST(Chordal_edge_weights, fall_by_a_power_of_the_length)
{
  const Flat_mesh m = delaunay_patch(60, 1, wavy);
  const One_rings rings(m.points.size(), m.triangles);
  EXPECT_EQ(weights_of(m, Chordal_edge_weights_3(0)), weights_of<Uniform_edge_weights_3>(m));
  for (const double r : { 0.5, 1., 2. }) {
    const Rows rows = weights_of(m, Chordal_edge_weights_3(r));
    for (Index v = 0; v < m.points.size(); ++v)
      for (std::size_t i = 0; i < rows[v].size(); ++i)
        EXPECT_NEAR(rows[v][i] * std::pow(CGAL::squared_distance(m.points[v], m.points[rings[v][Index(i)]]), 0.5 * r),
                    1, 1e-12);
  }
}

// ---- linear precision ----

template <class EdgeWeights>
class Linear_precision : public testing::Test { };
typedef testing::Types<Harmonic_edge_weights_3, Mean_value_edge_weights_3, Shape_preserving_edge_weights_3>
  Precise_weights;
TYPED_TEST_SUITE(Linear_precision, Precise_weights, );

TYPED_TEST(Linear_precision, an_inner_vertex_of_a_planar_mesh_is_the_mean_of_its_neighbors)
{
  for (const Flat_mesh& m : { grid(9, 7, flat), delaunay_patch(300, 3, flat), fan(3), fan(500) }) {
    Flat_mesh planar = m;
    for (Point_3& p : planar.points)
      p = Point_3(p.x(), p.y(), 0);
    const One_rings rings(planar.points.size(), planar.triangles);
    const Rows rows = weights_of<TypeParam>(planar);
    for (Index v = 0; v < planar.points.size(); ++v) {
      if (rings.is_border(v))
        continue;
      Vector_3 mean(0, 0, 0);
      double longest = 0;
      for (std::size_t i = 0; i < rows[v].size(); ++i) {
        const Vector_3 edge = planar.points[rings[v][Index(i)]] - planar.points[v];
        mean = mean + rows[v][i] / sum(rows[v]) * edge;
        longest = (std::max)(longest, edge.squared_length());
      }
      EXPECT_LT(mean.squared_length(), 1e-18 * longest) << "vertex " << v;
    }
  }
}

TYPED_TEST(Linear_precision, a_planar_mesh_is_mapped_onto_itself)
{
  typedef Edge_energy_parameterizer_3<Surface_mesh, TypeParam, Planar_border_parameterizer> Planar_method;
  const auto is_kept = [](const Point_3& p) { return p.x() < 0.5 || p.y() < 0.5; };
  for (const Flat_mesh& m : { grid(15, 15, flat), delaunay_patch(400, 2, flat),
                              part(grid(16, 16, flat), is_kept) }) {      // the last one is not convex
    Surface_mesh mesh = make<Surface_mesh>(m);
    std::vector<Kernel::Point_2> expected;
    for (const Point_3& p : m.points)
      expected.push_back(Kernel::Point_2(p.x(), p.y()));
    EXPECT_LT(greatest_distance(map_of(mesh, Planar_method()), expected), 1e-9);
    EXPECT_LT(
        greatest_distance(map_of(mesh, hierarchical(Planar_method({}, {}, parameters::tolerance(1e-11)))), expected),
        1e-7);
  }
}

} // namespace test_edge_weights
