// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The systems of edge energies: weights that are hard to solve with, CGAL's solutions, and what has none.

#include "edge_energy_maps.h"
#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_edge_energy_systems {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace edge_energy_maps;
namespace parameters = CGAL::parameters;

typedef CGAL::Polyhedron_3<Kernel>   Polyhedron;

// ---- weights that are hard to solve with ----

template <bool is_said_to_be_symmetric>
struct Weights_of_both_signs
{
  static constexpr bool is_symmetric = is_said_to_be_symmetric;

  void operator()(const Point_3& p, const std::vector<Point_3>& ring, bool, std::vector<double>& weights) const
  {
    weights.clear();
    for (const Point_3& q : ring)
      weights.push_back(std::sin(1e4 * (p.x() + q.x())) > 0 ? 1 : -1);
  }
};

// Uniform weights take the place of rows whose sums are not positive: the matrix is not symmetric then.
TEST(Edge_energy, replaced_rows_are_part_of_the_matrix)
{
  for (const Flat_mesh& m : { grid(16, 12, wavy), delaunay_patch(400, 1, wavy) }) {
    Surface_mesh mesh = make<Surface_mesh>(m);
    const std::vector<Kernel::Point_2> expected = map_of(mesh, keeping_flips<Method<Weights_of_both_signs<false>>>());
    EXPECT_LT(greatest_distance(map_of(mesh, keeping_flips<Method<Weights_of_both_signs<true>>>()), expected), 1e-7);
  }
}

struct Weights_times
{
  static constexpr bool is_symmetric = true;
  double factor = 1;

  void operator()(const Point_3&, const std::vector<Point_3>& ring, bool, std::vector<double>& weights) const
  {
    weights.assign(ring.size(), factor);
  }
};

TEST(Edge_energy, a_factor_of_all_weights_does_not_matter)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(400, 1, wavy));
  const auto map_with = [&](double factor) {
    return map_of(mesh, hierarchical(Method<Weights_times>({}, Weights_times{ factor }, parameters::tolerance(1e-11))));
  };
  const std::vector<Kernel::Point_2> expected = map_with(1);
  for (const double factor : { 1e-310, 1e-200, 1e200, 1e306 })
    EXPECT_LT(greatest_distance(map_with(factor), expected), 1e-8) << factor;
}

// The rows of uniform weights, times numbers that are not related.
struct Weights_of_any_size
{
  static constexpr bool is_symmetric = false;
  int greatest_exponent = 0, exponent_at_border = 0;

  void operator()(const Point_3& p, const std::vector<Point_3>& ring, bool is_closed,
                  std::vector<double>& weights) const
  {
    const double part = is_closed ? std::sin(1e4 * p.x() + 2e4 * p.y()) : 0;
    weights.assign(ring.size(), std::ldexp(1., int(part * greatest_exponent) + (is_closed ? 0 : exponent_at_border)));
  }
};

// Those of fixed vertices do not count at all.
TEST(Edge_energy, a_factor_of_each_row_does_not_matter)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(400, 1, wavy));
  const std::vector<Kernel::Point_2> expected = map_of(mesh, keeping_flips<Method<Uniform_edge_weights_3>>());
  for (const auto& [exponent, exponent_at_border] :
       { std::make_pair(30, 0), { 120, 0 }, { 300, 0 }, { 1000, 0 }, { 0, 1000 }, { 0, -1000 } }) {
    SCOPED_TRACE(std::to_string(exponent) + " " + std::to_string(exponent_at_border));
    const Weights_of_any_size weights{ exponent, exponent_at_border };
    typedef Method<Weights_of_any_size>   Method;
    Parameterization_summary summary;
    const auto np = parameters::tolerance(1e-11).flip_policy(Flip_policy::KEEP).summary(std::ref(summary));
    EXPECT_LT(greatest_distance(map_of(mesh, Method({}, weights, np)), expected), 1e-8);
    EXPECT_TRUE(summary.converged);
    EXPECT_LT(greatest_distance(map_of(mesh, hierarchical(Method({}, weights, np), summary)), expected), 1e-8);
    EXPECT_TRUE(summary.converged);
  }
}

// ---- CGAL's methods for the same maps ----

template <class TriangleMesh, class Border>
void compare_with_CGAL(const Flat_mesh& m)
{
  TriangleMesh mesh = make<TriangleMesh>(m);
  const auto compare = [&](const auto& weights, const auto& parameterizer) {
    typedef Edge_energy_parameterizer_3<TriangleMesh, std::decay_t<decltype(weights)>, Border> Method;
    const std::vector<Kernel::Point_2> expected = map_of(mesh, parameterizer);
    EXPECT_LT(greatest_distance(map_of(mesh, keeping_flips<Method>()), expected), 1e-7);
    EXPECT_LT(
        greatest_distance(map_of(mesh, hierarchical(Method({}, weights, parameters::tolerance(1e-11)))), expected),
        1e-7);
  };
  compare(Uniform_edge_weights_3(), Barycentric_mapping_parameterizer_3<TriangleMesh, Border>());
  compare(Mean_value_edge_weights_3(), Mean_value_coordinates_parameterizer_3<TriangleMesh, Border>());
  compare(Harmonic_edge_weights_3(), Discrete_conformal_map_parameterizer_3<TriangleMesh, Border>());
}

TEST(Edge_energy_beside_CGAL, finds_the_same_maps)
{
  for (const Flat_mesh& m : { grid(16, 12, wavy), hemisphere(), deep_cap(), delaunay_patch(200, 1, wavy) }) {
    compare_with_CGAL<Surface_mesh, Circular_border_arc_length_parameterizer_3<Surface_mesh>>(m);
    compare_with_CGAL<Surface_mesh, Circular_border_uniform_parameterizer_3<Surface_mesh>>(m);
    compare_with_CGAL<Surface_mesh, Square_border_arc_length_parameterizer_3<Surface_mesh>>(m);
    compare_with_CGAL<Polyhedron, Circular_border_arc_length_parameterizer_3<Polyhedron>>(m);
    compare_with_CGAL<Polyhedron, Square_border_uniform_parameterizer_3<Polyhedron>>(m);
  }
}

// CGAL's square runs around clockwise: all triangles are negative, whatever becomes of flips.
TEST(Edge_energy_beside_CGAL, finds_the_same_map_with_given_corners)
{
  typedef Square_border_arc_length_parameterizer_3<Surface_mesh> Border;
  typedef Edge_energy_parameterizer_3<Surface_mesh, Uniform_edge_weights_3, Border> Square_method;
  Surface_mesh mesh = make<Surface_mesh>(grid(16, 16, wavy));
  const auto corner = [](std::size_t v) { return Surface_mesh::Vertex_index(Surface_mesh::size_type(v)); };
  const Border border(corner(0), corner(16), corner(16 * 17), corner(17 * 17 - 1));
  const std::vector<Kernel::Point_2> expected =
      map_of(mesh, Barycentric_mapping_parameterizer_3<Surface_mesh, Border>(border));
  for (const Flip_policy policy : { Flip_policy::KEEP, Flip_policy::REPAIR, Flip_policy::FAIL }) {
    const auto np = parameters::coarsest_size(20).flip_policy(policy);
    const Hierarchical_parameterizer_3<Square_method> square(Square_method(border), np);
    EXPECT_LT(greatest_distance(map_of(mesh, square), expected), 1e-6) << int(policy);
  }
}

// ---- iterations and errors ----

TEST(Edge_energy, number_of_iterations_is_the_most_before_a_direct_solver_takes_over)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(2000, 1, wavy));
  typedef Method<Mean_value_edge_weights_3> Mean_value;
  const std::vector<Kernel::Point_2> expected = map_of(mesh, keeping_flips<Mean_value>());
  for (const std::size_t iterations : { 0, 1 }) {
    Parameterization_summary s;
    const Mean_value method({}, {}, parameters::tolerance(1e-12).number_of_iterations(iterations));
    const auto np = parameters::coarsest_size(20).flip_policy(Flip_policy::KEEP).summary(std::ref(s));
    EXPECT_LT(greatest_distance(map_of(mesh, Hierarchical_parameterizer_3<Mean_value>(method, np)), expected), 1e-10);
    EXPECT_TRUE(s.converged);
    EXPECT_GT(s.levels.size(), 1u);
    for (std::size_t i = 1; i < s.levels.size(); ++i)
      EXPECT_LE(s.levels[i].iterations, iterations);
  }
}

TEST(Edge_energy, errors_leave_the_maps_untouched)
{
  typedef Method<Uniform_edge_weights_3> Uniform;
  Flat_mesh point = fan(5);
  for (Point_3& p : point.points)
    p = Point_3(1, 2, 3);
  Surface_mesh no_length = make<Surface_mesh>(point);
  map_of(no_length, Uniform(), ERROR_BORDER_TOO_SHORT);
  map_of(no_length, hierarchical(Uniform()), ERROR_BORDER_TOO_SHORT);

  typedef Edge_energy_parameterizer_3<Surface_mesh, Uniform_edge_weights_3,
                                      Square_border_uniform_parameterizer_3<Surface_mesh>> Square_method;
  Surface_mesh triangle = make<Surface_mesh>(single_triangle());
  map_of(triangle, hierarchical(Square_method()), ERROR_BORDER_TOO_SHORT);
}

// Fixes no vertex.
struct No_border_parameterizer
{
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code parameterize(const Surface_mesh&, Surface_mesh::Halfedge_index, VertexUVMap, VertexIndexMap,
                          VertexParameterizedMap)
  {
    return OK;
  }
};

TEST(Edge_energy, needs_a_fixed_vertex)
{
  Surface_mesh mesh = make<Surface_mesh>(grid(5, 5, wavy));
  map_of(mesh,
         hierarchical(Edge_energy_parameterizer_3<Surface_mesh, Uniform_edge_weights_3, No_border_parameterizer>()),
         ERROR_CANNOT_SOLVE_LINEAR_SYSTEM);
}

} // namespace test_edge_energy_systems
