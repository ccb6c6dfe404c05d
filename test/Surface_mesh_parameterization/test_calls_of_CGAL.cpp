// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The adaptor has the types and the calls of CGAL's parameterizers, so that it can take their place.

#include "mesh_conversions.h"
#include "test_meshes.h"
#include "wrapped_maps.h"

#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

namespace test_calls_of_CGAL {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace wrapped_maps;
namespace parameters = CGAL::parameters;

typedef CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>    Polyhedron;

// ---- types ----

template <class P, class Q>
constexpr bool have_the_same_border = std::is_same<typename P::Border_parameterizer,
                                                   typename Q::Border_parameterizer>::value;

template <class P, class Q>
constexpr bool have_the_same_mesh = std::is_same<typename P::Triangle_mesh, typename Q::Triangle_mesh>::value &&
                                    std::is_same<typename P::TriangleMesh, typename Q::TriangleMesh>::value &&
                                    std::is_same<typename P::halfedge_descriptor,
                                                 Halfedge<typename Q::Triangle_mesh>>::value;

template <class P>
constexpr bool takes_the_place = have_the_same_mesh<Hierarchical_parameterizer_3<P>, P> &&
                                 have_the_same_border<Hierarchical_parameterizer_3<P>, P>;

typedef wrapped_maps::Mean_value<Square_border_arc_length_parameterizer_3<Surface_mesh>>   Mean_value_on_square;
static_assert(takes_the_place<Barycentric_mapping_parameterizer_3<Surface_mesh>>);
static_assert(takes_the_place<Mean_value_on_square>);
static_assert(takes_the_place<Mean_value_coordinates_parameterizer_3<Polyhedron>>);
static_assert(takes_the_place<Iterative_authalic_parameterizer_3<Surface_mesh>>);
static_assert(takes_the_place<LSCM_parameterizer_3<Polyhedron>>);
static_assert(takes_the_place<ARAP_parameterizer_3<Surface_mesh>>);
static_assert(have_the_same_mesh<Hierarchical_parameterizer_3<MIPS_parameterizer_3<Polyhedron>>,
                                 MIPS_parameterizer_3<Polyhedron>>);
static_assert(std::is_same<Hierarchical_parameterizer_3<Mean_value_on_square>::Solver_traits,
                           Multigrid_solver_traits>::value);
static_assert(std::is_same<Hierarchical_parameterizer_3<Mean_value_on_square>::vertex_descriptor,
                           Mean_value_on_square::vertex_descriptor>::value);

// ---- is_one_to_one_mapping() ----

// A band of 12 squares in a row, and maps of it.
struct Band_map
{
  const char* name;
  bool is_one_to_one;
  std::function<Point_2(std::size_t, const Point_3&)> place;
};

const Flat_mesh band = grid(12, 2, wavy);
const std::size_t inner_vertex = 13 + 5;

// Around the origin, the ends `turns` turns apart.
Point_2 bent(double turns, const Point_3& p)
{
  const double radius = 3 - p.y(), phi = 2 * CGAL_PI * turns * p.x();
  return Point_2(radius * std::cos(phi), radius * std::sin(phi));
}

std::vector<Band_map> band_maps()
{
  return { { "from above", true, [](std::size_t, const Point_3& p) { return Point_2(p.x(), p.y()); } },
           { "mirror image", true, [](std::size_t, const Point_3& p) { return Point_2(-p.x(), p.y()); } },
           { "a vertex out of its star", false,
             [](std::size_t i, const Point_3& p) { return Point_2(p.x(), p.y() + (i == inner_vertex ? 2 : 0)); } },
           { "less than a turn", true, [](std::size_t, const Point_3& p) { return bent(0.9, p); } },
           { "less than a turn, mirrored", true, [](std::size_t, const Point_3& p) { return bent(-0.9, p); } },
           { "more than a turn", false, [](std::size_t, const Point_3& p) { return bent(1.2, p); } },
           { "a turn, whose ends touch", false,
             [](std::size_t i, const Point_3& p) { return bent(1, i % 13 == 12 ? Point_3(0, p.y(), 0) : p); } } };
}

template <class TriangleMesh>
class Map_of_band : public testing::Test
{
protected:
  typedef typename Wrapped_map<TriangleMesh>::Point_2   Point;

  TriangleMesh mesh = make<TriangleMesh>(band);
  Wrapped_map<TriangleMesh> mapped{ mesh };
  Halfedge<TriangleMesh> bhd = longest_border(mesh);

  void lay_out(const Band_map& map)
  {
    std::size_t i = 0;
    for (const auto v : vertices(mesh)) {
      const Point_2 p = map.place(i, band.points[i]);
      put(mapped.uvmap, v, Point(p.x(), p.y()));
      ++i;
    }
  }
};
typedef testing::Types<Surface_mesh, Polyhedron> Meshes;
TYPED_TEST_SUITE(Map_of_band, Meshes, );

TYPED_TEST(Map_of_band, is_one_to_one_where_CGAL_says_so)
{
  typedef LSCM_parameterizer_3<TypeParam>   LSCM;
  typedef ARAP_parameterizer_3<TypeParam>   ARAP;
  for (const Band_map& map : band_maps()) {
    SCOPED_TRACE(map.name);
    this->lay_out(map);
    const auto& [mesh, uvmap, vimap, vpmap] = this->mapped;
    EXPECT_EQ(LSCM().is_one_to_one_mapping(mesh, this->bhd, uvmap), map.is_one_to_one);
    EXPECT_EQ(ARAP().is_one_to_one_mapping(mesh, faces(mesh), uvmap), map.is_one_to_one);
    EXPECT_EQ(Hierarchical_parameterizer_3<LSCM>().is_one_to_one_mapping(mesh, this->bhd, uvmap), map.is_one_to_one);
    EXPECT_EQ(Hierarchical_parameterizer_3<ARAP>().is_one_to_one_mapping(mesh, faces(mesh), uvmap), map.is_one_to_one);
    EXPECT_EQ(Hierarchical_parameterizer_3<MIPS_parameterizer_3<TypeParam>>().is_one_to_one_mapping(mesh, this->bhd,
                                                                                                    uvmap),
              map.is_one_to_one);
  }
}

// CGAL's barycentric class has this function, too, but it does not compile.
TYPED_TEST(Map_of_band, is_looked_at_though_the_border_is_to_be_convex)
{
  const Hierarchical_parameterizer_3<Barycentric_mapping_parameterizer_3<TypeParam>> barycentric;
  for (const Band_map& map : band_maps()) {
    this->lay_out(map);
    EXPECT_EQ(barycentric.is_one_to_one_mapping(this->mesh, this->bhd, this->mapped.uvmap), map.is_one_to_one)
        << map.name;
  }
}

TYPED_TEST(Map_of_band, is_not_one_to_one_with_a_triangle_without_area_or_a_place_that_is_not_finite)
{
  const Hierarchical_parameterizer_3<MIPS_parameterizer_3<TypeParam>> mips;
  const Point_2 on_opposite_edge(6. / 12, 1.5 / 12);
  for (const Point_2& place : { on_opposite_edge, Point_2(std::numeric_limits<double>::infinity(), 0),
                                Point_2(0, std::numeric_limits<double>::quiet_NaN()) }) {
    this->lay_out({ "", false, [&](std::size_t i, const Point_3& p) {
                     return i == inner_vertex ? place : Point_2(p.x(), p.y());
                   } });
    EXPECT_FALSE(mips.is_one_to_one_mapping(this->mesh, this->bhd, this->mapped.uvmap));
  }
}

// A ring and a triangle: beside it, in its hole, over it, and across its border.
TYPED_TEST(Map_of_band, is_one_to_one_with_other_faces_if_they_do_not_overlap)
{
  typedef typename Wrapped_map<TypeParam>::Point_2   Point;
  const Hierarchical_parameterizer_3<MIPS_parameterizer_3<TypeParam>> mips;
  TypeParam mesh = make<TypeParam>(annulus(8));
  const std::size_t size = num_vertices(mesh);
  append(single_triangle(), mesh);
  Wrapped_map<TypeParam> mapped(mesh);
  const auto are_one_to_one = [&](double x, double y, double scale) {
    std::size_t i = 0;
    for (const auto v : vertices(mesh)) {
      const auto p = get(get(CGAL::vertex_point, mesh), v);
      const bool is_moved = i++ >= size;
      put(mapped.uvmap, v, is_moved ? Point(x + scale * p.x(), y + scale * p.y()) : Point(p.x(), p.y()));
    }
    return mips.is_one_to_one_mapping(mesh, faces(mesh), mapped.uvmap);
  };
  EXPECT_TRUE(are_one_to_one(9, 0, 1));
  EXPECT_TRUE(are_one_to_one(0, 0, 0.01));
  EXPECT_FALSE(are_one_to_one(-9, -9, 30));
  const auto on_border = get(get(CGAL::vertex_point, mesh), *vertices(mesh).begin());
  EXPECT_FALSE(are_one_to_one(on_border.x() - 0.003, on_border.y() - 0.003, 0.01));
}

// ---- short calls of parameterize() ----

template <class Parameterizer>
class Short_calls : public testing::Test { };
typedef testing::Types<Mean_value_coordinates_parameterizer_3<Surface_mesh>, Mean_value_on_square,
                       Mean_value_coordinates_parameterizer_3<Polyhedron>, LSCM_parameterizer_3<Surface_mesh>,
                       ARAP_parameterizer_3<Surface_mesh>, MIPS_parameterizer_3<Surface_mesh>,
                       MIPS_parameterizer_3<Polyhedron>, Iterative_authalic_parameterizer_3<Surface_mesh>>
    Parameterizers;
TYPED_TEST_SUITE(Short_calls, Parameterizers, );

TYPED_TEST(Short_calls, give_the_map_of_the_long_one)
{
  typedef typename TypeParam::Triangle_mesh   TriangleMesh;
  TriangleMesh mesh = make<TriangleMesh>(grid(9, 8, wavy));
  append(annulus(40), mesh);
  const auto bhd = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  Hierarchical_parameterizer_3<TypeParam> parameterizer;
  Wrapped_map<TriangleMesh> expected(mesh), with_border(mesh), without(mesh);
  EXPECT_EQ(expected.parameterize(parameterizer, bhd), OK);
  EXPECT_EQ(parameterizer.parameterize(mesh, bhd, with_border.uvmap), OK);
  EXPECT_EQ(parameterizer.parameterize(mesh, without.uvmap), OK);
  for (const auto v : vertices(mesh)) {
    ASSERT_EQ(get(with_border.uvmap, v), get(expected.uvmap, v));
    ASSERT_EQ(get(without.uvmap, v), get(expected.uvmap, v));
  }
}

TYPED_TEST(Short_calls, tell_errors)
{
  typedef typename TypeParam::Triangle_mesh   TriangleMesh;
  TriangleMesh closed = make<TriangleMesh>(sphere(4, 6));
  Wrapped_map<TriangleMesh> mapped(closed);
  Parameterization_summary summary;
  Hierarchical_parameterizer_3<TypeParam> parameterizer(parameters::summary(std::ref(summary)));
  EXPECT_EQ(parameterizer.parameterize(closed, mapped.uvmap), ERROR_WRONG_PARAMETER);
  EXPECT_EQ(summary.error.code, ERROR_WRONG_PARAMETER);
  EXPECT_TRUE(mapped.is_untouched());
}

TEST(Short_calls_of_iterative_authalic, take_a_number_of_iterations)
{
  typedef Iterative_authalic_parameterizer_3<Surface_mesh>   Parameterizer;
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(300, 3, wavy));
  const auto bhd = longest_border(mesh);
  Wrapped_map<Surface_mesh> expected(mesh), with_border(mesh), without(mesh);
  Parameterization_summary summary;
  Hierarchical_parameterizer_3<Parameterizer> parameterizer(parameters::summary(std::ref(summary)));
  const auto expect_iterations = [&summary](std::size_t number) { EXPECT_EQ(summary.linear_solver.setups, number); };
  EXPECT_EQ(Parameterizer().parameterize(mesh, bhd, expected.uvmap, 4), OK);
  EXPECT_EQ(parameterizer.parameterize(mesh, bhd, with_border.uvmap, 4), OK);
  expect_iterations(4);
  EXPECT_EQ(parameterizer.parameterize(mesh, without.uvmap, 4), OK);
  expect_iterations(4);
  with_border.expect_equal(expected, tolerance);
  without.expect_equal(expected, tolerance);
  EXPECT_EQ(parameterizer.parameterize(mesh, without.uvmap, 2), OK);
  expect_iterations(2);

  // CGAL's own would read what is not there.
  Wrapped_map<Surface_mesh> none(mesh);
  EXPECT_EQ(parameterizer.parameterize(mesh, none.uvmap, 0), ERROR_WRONG_PARAMETER);
  EXPECT_EQ(none.parameterize(parameterizer, bhd, 0u), ERROR_WRONG_PARAMETER);
  EXPECT_STREQ(summary.error.cause, "the number of iterations is 0");
  EXPECT_TRUE(none.is_untouched());
}

} // namespace test_calls_of_CGAL
