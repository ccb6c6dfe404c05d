// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's parameterizers in Hierarchical_parameterizer_3: the same maps as without it.

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "numbers_of_threads.h"
#include "seam_meshes.h"
#include "test_meshes.h"
#include "wrapped_maps.h"

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Fixed_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test_wrapped_parameterizers {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace wrapped_maps;
namespace parameters = CGAL::parameters;

typedef CGAL::Exact_predicates_inexact_constructions_kernel    Epick;
typedef CGAL::Surface_mesh<Epick::Point_3>                     Epick_surface_mesh;
typedef CGAL::Polyhedron_3<Epick>                              Polyhedron;

// ---- the methods ----

std::vector<std::pair<std::string, Flat_mesh>> meshes()
{
  return { { "grid", grid(20, 16, wavy) },
           { "hemisphere", hemisphere() },
           { "disk with a hole", disk_with_hole() },
           { "fan", fan(7) },
           { "several grids", cap(40, 80, 0.5 * CGAL_PI) } };
}

template <class Parameterizer>
class Wrapped : public testing::Test { };
typedef testing::Types<Barycentric_mapping_parameterizer_3<Surface_mesh>,
                       Mean_value_coordinates_parameterizer_3<Surface_mesh>,
                       Discrete_conformal_map_parameterizer_3<Surface_mesh>,
                       Discrete_authalic_parameterizer_3<Surface_mesh>, LSCM_by_multigrid<Surface_mesh>>
    Parameterizers;
TYPED_TEST_SUITE(Wrapped, Parameterizers, );

TYPED_TEST(Wrapped, gives_the_map_of_CGAL)
{
  for (const auto& [name, m] : meshes()) {
    SCOPED_TRACE(name);
    Surface_mesh mesh = make<Surface_mesh>(m);
    check<TypeParam>(mesh);
  }
}

#ifdef CGAL_LINKED_WITH_TBB
// On grids that threads share by parts.
TYPED_TEST(Wrapped, is_the_same_for_every_number_of_threads)
{
  Surface_mesh mesh = make<Surface_mesh>(grid(120, 110, wavy));
  Wrapped_map<Surface_mesh> expected(mesh);
  EXPECT_EQ(expected.parameterize(Hierarchical_parameterizer_3<TypeParam>(), longest_border(mesh)), OK);
  numbers_of_threads::for_each_number_of_threads([&] {
    Wrapped_map<Surface_mesh> found(mesh);
    EXPECT_EQ(found.parameterize(Hierarchical_parameterizer_3<TypeParam, CGAL::Parallel_tag>(), longest_border(mesh)),
              OK);
    found.expect_same(expected);
  });
}
#endif

// A subclass of CGAL's with weights of its own.
template <class Mesh, class Border = CGAL::Default, class Solver = CGAL::Default>
struct Chordal : Fixed_border_parameterizer_3<Mesh, Border, Solver>
{
private:
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor   Vertex;

  double compute_w_ij(const Mesh& mesh, Vertex v, CGAL::Vertex_around_target_circulator<Mesh> w) const override
  {
    const auto points = get(CGAL::vertex_point, mesh);
    return 1 / CGAL::sqrt(CGAL::squared_distance(get(points, v), get(points, *w)));
  }
};

// One that does more than solve.
template <class Mesh, class Border = CGAL::Default, class Solver = CGAL::Default>
struct Mirrored_chordal : Chordal<Mesh, Border, Solver>
{
  template <class UVMap, class IndexMap, class PlacedMap>
  Error_code parameterize(Mesh& mesh, Halfedge<Mesh> bhd, UVMap uvmap, IndexMap vimap, PlacedMap vpmap)
  {
    const Error_code code = Chordal<Mesh, Border, Solver>::parameterize(mesh, bhd, uvmap, vimap, vpmap);
    for (const auto v : vertices(mesh))
      put(uvmap, v, Kernel::Point_2(-get(uvmap, v).x(), get(uvmap, v).y()));
    return code;
  }
};

TEST(Wrapped_subclass, gives_the_map_of_its_own_weights)
{
  Surface_mesh mesh = make<Surface_mesh>(disk_with_hole());
  check<Chordal<Surface_mesh>>(mesh);
  check<Mirrored_chordal<Surface_mesh>>(mesh);
}

TYPED_TEST(Wrapped, leaves_other_components_alone)
{
  Surface_mesh mesh = make<Surface_mesh>(sphere(4, 6));
  const std::size_t others = num_vertices(mesh);
  append(grid(9, 8, wavy), mesh);
  append(torus_with_hole(6), mesh);
  const auto bhd = longest_border(mesh);
  Wrapped_map<Surface_mesh> expected(mesh), found(mesh);
  EXPECT_EQ(SMP::parameterize(mesh, TypeParam(), bhd, expected.uvmap), OK);
  EXPECT_EQ(SMP::parameterize(mesh, Hierarchical_parameterizer_3<TypeParam>(), bhd, found.uvmap), OK);
  found.expect_equal(expected, tolerance);
  for (const auto v : vertices(mesh))
    EXPECT_EQ(get(found.uvmap, v) == untouched(), std::size_t(v) < others || std::size_t(v) >= others + 90);
}

TYPED_TEST(Wrapped, leaves_the_maps_untouched_on_errors)
{
  const auto expect_error = [](Surface_mesh& mesh, Surface_mesh::Halfedge_index bhd, Error_code code,
                               Parameterization_error::Place place, std::size_t index) {
    Wrapped_map<Surface_mesh> mapped(mesh);
    Parameterization_summary summary;
    EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<TypeParam>(parameters::summary(std::ref(summary))), bhd),
              code);
    EXPECT_EQ(summary.error.code, code);
    EXPECT_EQ(summary.error.place, place);
    EXPECT_EQ(summary.error.index, index);
    EXPECT_EQ(summary.linear_solver.setups, 0u);
    EXPECT_FALSE(summary.converged);
    EXPECT_TRUE(mapped.is_untouched());
  };
  Surface_mesh empty, closed = make<Surface_mesh>(sphere(4, 6)), open = make<Surface_mesh>(grid(5, 5, wavy)),
                      torus = make<Surface_mesh>(torus_with_hole(6));
  expect_error(empty, Surface_mesh::null_halfedge(), ERROR_EMPTY_MESH, Parameterization_error::NOWHERE, 0);
  expect_error(closed, *closed.halfedges().begin(), ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0);
  expect_error(open, open.opposite(longest_border(open)), ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0);
  expect_error(torus, longest_border(torus), ERROR_NO_TOPOLOGICAL_DISC, Parameterization_error::NOWHERE, 0);
  open.point(Surface_mesh::Vertex_index(9)) = Kernel::Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  expect_error(open, longest_border(open), ERROR_WRONG_PARAMETER, Parameterization_error::VERTEX, 9);
}

// ---- the models of a mesh ----

template <class TriangleMesh>
struct Model
{
  TriangleMesh mesh = make<TriangleMesh>(delaunay_patch(1200, 3, wavy));
};

template <>
struct Model<Seam_mesh> : Cut_sphere { };

template <class TriangleMesh>
class Wrapped_on_FaceGraph : public testing::Test { };
typedef testing::Types<Epick_surface_mesh, Polyhedron, Seam_mesh> Meshes;
TYPED_TEST_SUITE(Wrapped_on_FaceGraph, Meshes, );

TYPED_TEST(Wrapped_on_FaceGraph, has_the_maps_of_CGAL)
{
  Model<TypeParam> model;
  check<Mean_value_coordinates_parameterizer_3<TypeParam>>(model.mesh);
  check<LSCM_by_multigrid<TypeParam>>(model.mesh);
}

// ---- borders ----

TEST(Wrapped_borders, are_those_of_CGAL)
{
  Surface_mesh mesh = make<Surface_mesh>(grid(20, 16, wavy));
  check<Mean_value<Circular_border_uniform_parameterizer_3<Surface_mesh>>>(mesh);
  check<Mean_value<Square_border_uniform_parameterizer_3<Surface_mesh>>>(mesh);
  typedef Square_border_arc_length_parameterizer_3<Surface_mesh> Square;
  check<Mean_value<Square>>(mesh);

  const auto corner = [](std::size_t i) { return Surface_mesh::Vertex_index(i); };
  const Square square(corner(0), corner(20), corner(21 * 17 - 1), corner(21 * 16));
  check<Mean_value<Square>>(mesh, square);
  Wrapped_map<Surface_mesh> mapped(mesh);
  EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Mean_value<Square>>(square), longest_border(mesh)), OK);
  EXPECT_NEAR(CGAL::squared_distance(get(mapped.uvmap, corner(0)), get(mapped.uvmap, corner(21 * 17 - 1))), 2, 1e-12);
}

// Ears of the grid, triangles with two edges on its border, are flat on a side of the square. Each is opened by one
// vertex of it, which moves into the square, and corners are where they were.
TEST(Wrapped_borders, stay_on_the_square_when_ears_are_opened)
{
  typedef Square_border_arc_length_parameterizer_3<Surface_mesh> Square;
  Surface_mesh mesh = make<Surface_mesh>(grid(20, 16, wavy));
  const auto at = [](std::size_t column, std::size_t row) { return Surface_mesh::Vertex_index(21 * row + column); };
  for (const std::size_t shift : { 1, 5, 9 }) {
    const Surface_mesh::Vertex_index corners[] = { at(shift, 0), at(20, shift), at(20 - shift, 16), at(0, 16 - shift) };
    Wrapped_map<Surface_mesh> mapped(mesh);
    Parameterization_summary summary;
    EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Mean_value<Square>>(
                                      Square(corners[0], corners[1], corners[2], corners[3]),
                                      parameters::summary(std::ref(summary))),
                                  longest_border(mesh)), OK);
    EXPECT_EQ(summary.flips, 2u);
    EXPECT_EQ(summary.moved_vertices, 2u);
    EXPECT_EQ(parameterization_quality(mesh, mapped.uvmap).flips, 0u);
    for (const auto v : vertices(mesh)) {
      const auto p = get(mapped.uvmap, v);
      EXPECT_TRUE(0 <= p.x() && p.x() <= 1 && 0 <= p.y() && p.y() <= 1) << p;
      const bool is_corner = std::find(std::begin(corners), std::end(corners), v) != std::end(corners);
      EXPECT_TRUE(!is_corner || ((p.x() == 0 || p.x() == 1) && (p.y() == 0 || p.y() == 1))) << p;
    }
  }
}

// A circle whose center is so far away from the origin.
template <class TriangleMesh>
struct Far_circle : Circular_border_arc_length_parameterizer_3<TriangleMesh>
{
  double distance = 0;

  template <class UVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code parameterize(const TriangleMesh& mesh, Halfedge<TriangleMesh> bhd, UVMap uvmap, VertexIndexMap vimap,
                          VertexParameterizedMap vpmap)
  {
    const Error_code status =
        Circular_border_arc_length_parameterizer_3<TriangleMesh>::parameterize(mesh, bhd, uvmap, vimap, vpmap);
    for (const auto v : vertices_around_face(bhd, mesh))
      put(uvmap, v, Kernel::Point_2(get(uvmap, v).x() + distance, get(uvmap, v).y() - distance));
    return status;
  }
};

TEST(Wrapped_borders, may_be_far_away)
{
  constexpr double rounding = 1e-16, growth = 1000;
  Surface_mesh mesh = make<Surface_mesh>(cap(40, 80, 0.5 * CGAL_PI));
  const auto run = [&](double distance) {
    Far_circle<Surface_mesh> circle;
    circle.distance = distance;
    Wrapped_map<Surface_mesh> mapped(mesh);
    Parameterization_summary summary;
    typedef Hierarchical_parameterizer_3<Mean_value<Far_circle<Surface_mesh>>>   Method;
    EXPECT_EQ(mapped.parameterize(Method(circle, parameters::summary(std::ref(summary))), longest_border(mesh)), OK);
    EXPECT_EQ(summary.linear_solver.direct_solutions, 0u);
    for (const auto v : vertices(mesh))
      put(mapped.uvmap, v, Kernel::Point_2(get(mapped.uvmap, v).x() - distance, get(mapped.uvmap, v).y() + distance));
    return mapped;
  };
  const Wrapped_map<Surface_mesh> near = run(0);
  for (const double distance : { 1e3, 1e6, 1e9 })
    run(distance).expect_equal(near, growth * rounding * distance + 1e-9);
}

TEST(Wrapped_borders, have_finite_places)
{
  Surface_mesh mesh = make<Surface_mesh>(grid(12, 12, wavy));
  for (const double distance : { std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() }) {
    Far_circle<Surface_mesh> circle;
    circle.distance = distance;
    Parameterization_summary summary;
    const auto expect_refused = [&](auto method) {
      Wrapped_map<Surface_mesh> mapped(mesh);
      EXPECT_EQ(mapped.parameterize(method, longest_border(mesh)), ERROR_WRONG_PARAMETER);
      EXPECT_STREQ(summary.error.cause, "the border parameterizer gave a vertex uv coordinates that are not finite");
      EXPECT_TRUE(mapped.is_untouched());
    };
    const auto np = parameters::summary(std::ref(summary));
    expect_refused(Hierarchical_parameterizer_3<Mean_value<Far_circle<Surface_mesh>>>(circle, np));
    typedef Edge_energy_parameterizer_3<Surface_mesh, Uniform_edge_weights_3, Far_circle<Surface_mesh>>   Edge_energy;
    expect_refused(Hierarchical_parameterizer_3<Edge_energy>(Edge_energy(circle), np));
  }
}

TEST(Wrapped_borders, that_cannot_be_placed_are_errors_as_in_CGAL)
{
  typedef Mean_value<Square_border_arc_length_parameterizer_3<Surface_mesh>> Parameterizer;
  Surface_mesh mesh = make<Surface_mesh>(single_triangle());
  Wrapped_map<Surface_mesh> expected(mesh), found(mesh);
  const Error_code status = expected.parameterize(Parameterizer(), longest_border(mesh));
  Parameterization_summary summary;
  EXPECT_NE(status, OK);
  EXPECT_EQ(found.parameterize(Hierarchical_parameterizer_3<Parameterizer>(parameters::summary(std::ref(summary))),
                               longest_border(mesh)),
            status);
  EXPECT_EQ(summary.error.code, status);
  EXPECT_TRUE(found.is_untouched());
}

} // namespace test_wrapped_parameterizers
