// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Orbifold embeddings of closed surfaces: CGAL's map by multigrid.

#include "mesh_conversions.h"
#include "seam_meshes.h"
#include "visitors.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Orbifold_Tutte_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/subdivision_method_3.h>

#include <boost/graph/graph_traits.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace test_orbifold {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef boost::graph_traits<Seam_mesh>::vertex_descriptor      Vertex;
typedef boost::graph_traits<Seam_mesh>::halfedge_descriptor    Halfedge;
typedef std::unordered_map<Vertex, Cone_type>                  Cone_map;
typedef Orbifold_Tutte_parameterizer_3<Seam_mesh>              Flat;
typedef Hierarchical_parameterizer_3<Flat>                     Hierarchical;
typedef std::complex<double>                                   Complex;

// A closed surface, cut along a path through its cones.
struct Cut_surface
{
  typedef boost::property_map<Seam_mesh, CGAL::dynamic_vertex_property_t<int>>::const_type               Index_map;
  typedef boost::property_map<Seam_mesh, CGAL::dynamic_vertex_property_t<Kernel::Point_2>>::const_type   UV_map;

  Cut_surface(Surface_mesh closed_surface, const std::vector<Surface_mesh::Vertex_index>& cones)
    : surface(std::move(closed_surface)),
      mesh(surface, surface.add_property_map<Surface_mesh::Edge_index, bool>("e:seam", false).first,
           surface.add_property_map<Surface_mesh::Vertex_index, bool>("v:seam", false).first)
  {
    std::vector<Surface_mesh::Edge_index> seam;
    compute_shortest_paths_between_cones(surface, cones.begin(), cones.end(), seam);
    for (const Surface_mesh::Edge_index e : seam)
      mesh.add_seam(source(e, surface), target(e, surface));
    EXPECT_TRUE(locate_cones(mesh, cones.begin(), cones.end(), cone_map));
    for (const auto& [v, type] : cone_map)
      if (type == First_unique_cone)
        bhd = opposite(halfedge(v, mesh), mesh);
    index = get(CGAL::dynamic_vertex_property_t<int>(), std::as_const(mesh));
    int n = 0;
    for (const Vertex v : vertices(mesh))
      put(index, v, n++);
  }

  Cut_surface(const Cut_surface&) = delete;     // the seam mesh refers to the surface

  UV_map untouched_map() const
  {
    const UV_map uv = get(CGAL::dynamic_vertex_property_t<Kernel::Point_2>(), mesh);
    for (const Vertex v : vertices(mesh))
      put(uv, v, untouched());
    return uv;
  }

  bool is_untouched(const UV_map& uv) const
  {
    const auto range = vertices(mesh);
    return std::all_of(range.begin(), range.end(), [&uv](Vertex v) { return get(uv, v) == untouched(); });
  }

  double greatest_distance(const UV_map& a, const UV_map& b) const
  {
    double result = 0;
    for (const Vertex v : vertices(mesh))
      result = (std::max)(result, std::sqrt(CGAL::squared_distance(get(a, v), get(b, v))));
    return result;
  }

  Surface_mesh surface;
  Seam_mesh mesh;
  Cone_map cone_map;
  Halfedge bhd;
  Index_map index;
};

std::size_t number_of_cones(Orbifold_type type) { return type == Parallelogram ? 4 : 3; }

// A bumpy ball of 20 * 4^subdivisions triangles.
Cut_surface ball(int subdivisions, std::size_t cones)
{
  Surface_mesh surface;
  CGAL::make_icosahedron(surface, Kernel::Point_3(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(surface, parameters::number_of_iterations(subdivisions));
  for (const Surface_mesh::Vertex_index v : vertices(surface)) {
    Kernel::Point_3& p = surface.point(v);
    const double s = 1 + 0.3 * std::sin(4 * p.x() + 1) * std::cos(3 * p.y()) + 0.02 * std::sin(31 * p.z());
    p = Kernel::Point_3(s * p.x(), 1.4 * s * p.y(), 0.8 * s * p.z() + 0.1 * p.x() * p.x());
  }
  // Around the equator: the path from one to the next meets no third.
  std::vector<Surface_mesh::Vertex_index> cone_vertices;
  for (const Kernel::Vector_3& direction : { Kernel::Vector_3(1, 0.2, 0), Kernel::Vector_3(0, 1, 0.3),
                                             Kernel::Vector_3(-1, 0.1, 0.2), Kernel::Vector_3(0.1, -1, 0) }) {
    const auto height = [&](Surface_mesh::Vertex_index v) { return (surface.point(v) - CGAL::ORIGIN) * direction; };
    const auto range = vertices(surface);
    cone_vertices.push_back(
        *std::max_element(range.begin(), range.end(), [&](auto v, auto w) { return height(v) < height(w); }));
  }
  cone_vertices.resize(cones);
  return Cut_surface(std::move(surface), cone_vertices);
}

typedef std::pair<Orbifold_type, Weight_type>   Kind;

class Orbifold : public testing::TestWithParam<Kind> { };

INSTANTIATE_TEST_SUITE_P(All_kinds, Orbifold,
                         testing::Values(Kind(Square, Cotangent), Kind(Diamond, Cotangent), Kind(Triangle, Cotangent),
                                         Kind(Parallelogram, Cotangent), Kind(Square, Mean_value),
                                         Kind(Diamond, Mean_value), Kind(Triangle, Mean_value),
                                         Kind(Parallelogram, Mean_value)),
                         [](const auto& kind) {
                           return std::string(get_orbifold_type(kind.param.first)) +
                                  (kind.param.second == Cotangent ? "_cotangent" : "_mean_value");
                         });

TEST_P(Orbifold, is_that_of_the_flat_parameterizer)
{
  const auto [type, weight] = GetParam();
  Cut_surface cut = ball(4, number_of_cones(type));
  const Cut_surface::UV_map uv = cut.untouched_map(), flat_uv = cut.untouched_map();
  Parameterization_summary summary;
  const Hierarchical hierarchical(type, weight, parameters::summary(std::ref(summary)));
  ASSERT_EQ(hierarchical.parameterize(cut.mesh, cut.bhd, cut.cone_map, uv, cut.index), OK);
  ASSERT_EQ(Flat(type, weight).parameterize(cut.mesh, cut.bhd, cut.cone_map, flat_uv, cut.index), OK);
  EXPECT_LT(cut.greatest_distance(uv, flat_uv), 1e-6);
  EXPECT_TRUE(summary.converged);
  EXPECT_EQ(summary.linear_solver.direct_solutions, 0u);
  EXPECT_LE(summary.linear_solver.residual, 1e-10);
}

// Corresponding edges on the two sides of the seam are turned into each other, from cone to cone by the same angle.
TEST_P(Orbifold, sides_of_the_seam_are_turned_into_each_other)
{
  const auto [type, weight] = GetParam();
  const std::vector<double> angles = type == Square ? std::vector<double>{ CGAL_PI / 2, CGAL_PI / 2 }
                                   : type == Diamond ? std::vector<double>{ 2 * CGAL_PI / 3, 2 * CGAL_PI / 3 }
                                   : type == Triangle ? std::vector<double>{ CGAL_PI / 3, CGAL_PI }
                                   : std::vector<double>{ CGAL_PI, 0, CGAL_PI };
  Cut_surface cut = ball(3, number_of_cones(type));
  const Cut_surface::UV_map uv = cut.untouched_map();
  ASSERT_EQ(Hierarchical(type, weight).parameterize(cut.mesh, cut.bhd, cut.cone_map, uv, cut.index), OK);
  const auto place = [&](Vertex v) { return Complex(get(uv, v).x(), get(uv, v).y()); };

  std::size_t segment = 0;
  Halfedge h = cut.bhd;
  for (bool is_at_end = false; !is_at_end; h = next(h, cut.mesh)) {
    const Halfedge twin(h, false);
    const Complex edge = place(target(h, cut.mesh)) - place(source(h, cut.mesh));
    const Complex twin_edge = place(target(twin, cut.mesh)) - place(source(twin, cut.mesh));
    EXPECT_NEAR(std::abs(edge), std::abs(twin_edge), 1e-12);
    EXPECT_LT(std::min(std::abs(edge / twin_edge - std::polar(1., angles[segment])),
                       std::abs(edge / twin_edge - std::polar(1., -angles[segment]))),
              1e-9);
    if (const auto cone = cut.cone_map.find(target(h, cut.mesh)); cone != cut.cone_map.end()) {
      ++segment;
      is_at_end = cone->second == Second_unique_cone;
    }
  }
  EXPECT_EQ(segment, angles.size());
}

TEST_P(Orbifold, ends_of_the_seam_are_where_the_type_has_them)
{
  const auto [type, weight] = GetParam();
  const std::pair<Kernel::Point_2, Kernel::Point_2> places =
    type == Square ? std::make_pair(Kernel::Point_2(-1, -1), Kernel::Point_2(1, 1)) :
    type == Parallelogram ? std::make_pair(Kernel::Point_2(0, -0.5), Kernel::Point_2(0, 0.5)) :
    std::make_pair(Kernel::Point_2(-1, 1), Kernel::Point_2(-1, -1));
  Cut_surface cut = ball(2, number_of_cones(type));
  const Cut_surface::UV_map uv = cut.untouched_map();
  ASSERT_EQ(Hierarchical(type, weight).parameterize(cut.mesh, cut.bhd, cut.cone_map, uv, cut.index), OK);
  for (const auto& [v, cone_type] : cut.cone_map)
    if (cone_type != Duplicated_cone) {
      EXPECT_EQ(get(uv, v), cone_type == First_unique_cone ? places.first : places.second);
    }
}

TEST_P(Orbifold, iterations_do_not_grow_with_the_mesh)
{
  const auto [type, weight] = GetParam();
  for (int subdivisions = 4; subdivisions <= 6; ++subdivisions) {
    Cut_surface cut = ball(subdivisions, number_of_cones(type));
    Parameterization_summary summary;
    const Hierarchical hierarchical(type, weight, parameters::summary(std::ref(summary)));
    ASSERT_EQ(hierarchical.parameterize(cut.mesh, cut.bhd, cut.cone_map, cut.untouched_map(), cut.index), OK);
    EXPECT_LE(summary.linear_solver.iterations, 13u) << subdivisions;
    EXPECT_EQ(summary.linear_solver.direct_solutions, 0u);
  }
}

TEST(Orbifolds, that_a_tetrahedron_wraps_have_no_unknowns)
{
  Surface_mesh surface;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(0, 1, 0),
                         Kernel::Point_3(0, 0, 1), surface);
  const auto range = vertices(surface);
  const std::vector<Surface_mesh::Vertex_index> cones(range.begin(), range.end());
  Cut_surface cut(std::move(surface), cones);
  const Cut_surface::UV_map uv = cut.untouched_map(), flat_uv = cut.untouched_map();
  ASSERT_EQ(Hierarchical(Parallelogram).parameterize(cut.mesh, cut.bhd, cut.cone_map, uv, cut.index), OK);
  ASSERT_EQ(Flat(Parallelogram).parameterize(cut.mesh, cut.bhd, cut.cone_map, flat_uv, cut.index), OK);
  EXPECT_LT(cut.greatest_distance(uv, flat_uv), 1e-12);
}

TEST(Orbifolds, fall_back_on_a_direct_solution)
{
  Cut_surface cut = ball(3, 3);
  const Cut_surface::UV_map uv = cut.untouched_map(), flat_uv = cut.untouched_map();
  Parameterization_summary summary;
  const Hierarchical impatient(Triangle, Mean_value, parameters::summary(std::ref(summary)).number_of_iterations(1));
  ASSERT_EQ(impatient.parameterize(cut.mesh, cut.bhd, cut.cone_map, uv, cut.index), OK);
  ASSERT_EQ(Flat(Triangle, Mean_value).parameterize(cut.mesh, cut.bhd, cut.cone_map, flat_uv, cut.index), OK);
  EXPECT_EQ(summary.linear_solver.direct_solutions, 1u);
  EXPECT_LT(cut.greatest_distance(uv, flat_uv), 1e-9);
}

TEST(Orbifolds, tell_whether_a_map_is_one_to_one)
{
  Cut_surface cut = ball(3, number_of_cones(Square));
  const Hierarchical hierarchical(Square, Mean_value);
  const Cut_surface::UV_map uv = cut.untouched_map();
  EXPECT_FALSE(hierarchical.is_one_to_one_mapping(cut.mesh, cut.bhd, uv));
  ASSERT_EQ(hierarchical.parameterize(cut.mesh, cut.bhd, cut.cone_map, uv, cut.index), OK);
  EXPECT_TRUE(hierarchical.is_one_to_one_mapping(cut.mesh, cut.bhd, uv));
}

TEST(Orbifolds, leave_the_map_untouched_on_an_error)
{
  Cut_surface cut = ball(2, 3);
  const Cut_surface::UV_map uv = cut.untouched_map();
  Parameterization_summary summary;
  const Hierarchical square(Square, Cotangent, parameters::summary(std::ref(summary)));
  const Hierarchical parallelogram(Parallelogram, Cotangent, parameters::summary(std::ref(summary)));
  testing::internal::CaptureStderr();        // CGAL tells the number of cones there
  EXPECT_EQ(parallelogram.parameterize(cut.mesh, cut.bhd, cut.cone_map, uv, cut.index), ERROR_WRONG_PARAMETER);
  testing::internal::GetCapturedStderr();
  EXPECT_EQ(summary.error.code, ERROR_WRONG_PARAMETER);
  EXPECT_FALSE(summary.converged);
  EXPECT_EQ(square.parameterize(cut.mesh, opposite(cut.bhd, cut.mesh), cut.cone_map, uv, cut.index),
            ERROR_WRONG_PARAMETER);
  EXPECT_TRUE(cut.is_untouched(uv));
}

// CGAL reads beyond the end of its angles there.
TEST(Orbifolds, refuse_cones_that_do_not_fit_the_seam)
{
  Cut_surface cut = ball(2, 3);
  const Cut_surface::UV_map uv = cut.untouched_map();
  const auto inside = *std::find_if(vertices(cut.mesh).begin(), vertices(cut.mesh).end(),
                                    [&](const auto& v) { return !is_border(v, cut.mesh); });
  const auto is_refused = [&](const Cone_map& cones) {
    return Hierarchical(Square).parameterize(cut.mesh, cut.bhd, cones, uv, cut.index) == ERROR_WRONG_PARAMETER;
  };
  Vertex first_cone;
  for (const auto& [v, type] : cut.cone_map)
    if (type == First_unique_cone)
      first_cone = v;
  for (const auto& [v, type] : cut.cone_map) {
    Cone_map cones = cut.cone_map;
    cones.erase(v);
    cones.emplace(inside, type);
    EXPECT_TRUE(is_refused(cones));
    cones.erase(inside);
    cones.emplace(v, type == Duplicated_cone ? First_unique_cone : Duplicated_cone);
    EXPECT_TRUE(is_refused(cones));
    if (type == Duplicated_cone) {
      cones[first_cone] = Duplicated_cone;      // exchanged
      EXPECT_TRUE(is_refused(cones));
      cones = cut.cone_map;
      cones.erase(v);
      for (const auto h : halfedges_around_face(cut.bhd, cut.mesh))
        if (cut.cone_map.count(target(h, cut.mesh)) == 0) {
          cones.emplace(target(h, cut.mesh), Duplicated_cone);      // on one side of the seam
          break;
        }
      EXPECT_TRUE(is_refused(cones));
    }
  }
  EXPECT_TRUE(cut.is_untouched(uv));
}

TEST(Orbifolds, leave_the_map_untouched_if_a_visitor_stops_the_run)
{
  Cut_surface cut = ball(2, 3);
  for (const double part : { 0., 0.3, 1. }) {
    const Cut_surface::UV_map uv = cut.untouched_map();
    Parameterization_summary summary;
    const On_progress visitor([&](const Parameterization_progress& progress) { return progress.part_done < part; });
    const auto np = parameters::summary(std::ref(summary)).visitor(visitor);
    EXPECT_EQ(Hierarchical(Square, Cotangent, np).parameterize(cut.mesh, cut.bhd, cut.cone_map, uv, cut.index),
              ERROR_STOPPED);
    EXPECT_EQ(summary.error.code, ERROR_STOPPED);
    EXPECT_TRUE(cut.is_untouched(uv));
  }
}

TEST(Orbifolds, refuse_a_point_that_is_not_finite)
{
  Cut_surface cut = ball(2, 3);
  Kernel::Point_3& p = cut.surface.point(*vertices(cut.surface).begin());
  p = Kernel::Point_3(std::nan(""), p.y(), p.z());
  const Cut_surface::UV_map uv = cut.untouched_map();
  EXPECT_EQ(Hierarchical(Square).parameterize(cut.mesh, cut.bhd, cut.cone_map, uv, cut.index), ERROR_WRONG_PARAMETER);
  EXPECT_TRUE(cut.is_untouched(uv));
}

} // namespace test_orbifold
