// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// All models of a mesh: one check for all.

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "seam_meshes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/cut_to_disk.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/compose_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>

namespace test_face_graphs {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef CGAL::Exact_predicates_inexact_constructions_kernel        Epick;
typedef CGAL::Surface_mesh<Epick::Point_3>                         Epick_surface_mesh;
typedef CGAL::Polyhedron_3<Kernel>                                 Polyhedron;
typedef CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
    2, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>::type       Linear_cell_complex;

template <class TriangleMesh>
struct Model
{
  TriangleMesh mesh = make<TriangleMesh>(grid(16, 12, wavy));
};

template <>
struct Model<Seam_mesh> : Cut_sphere { };

template <class TriangleMesh>
class FaceGraph : public testing::Test
{
protected:
  template <class Parameterizer>
  void check(const Parameterizer& parameterizer)
  {
    Model<TriangleMesh> model;
    TriangleMesh& mesh = model.mesh;
    const Halfedge<TriangleMesh> bhd = longest_border(mesh);
    const auto uvmap = get(CGAL::dynamic_vertex_property_t<Kernel::Point_2>(), mesh);
    EXPECT_EQ(SMP::parameterize(mesh, parameterizer, bhd, uvmap), OK);
    EXPECT_TRUE(is_valid(mesh, bhd, uvmap));
    EXPECT_EQ(parameterization_quality(mesh, uvmap).flips, 0u);
  }
};

typedef testing::Types<Surface_mesh, Epick_surface_mesh, Polyhedron, Linear_cell_complex, Seam_mesh> Meshes;
TYPED_TEST_SUITE(FaceGraph, Meshes, );

TYPED_TEST(FaceGraph, is_parameterized_flat) { this->check(MIPS_parameterizer_3<TypeParam>()); }

TYPED_TEST(FaceGraph, is_parameterized_hierarchically)
{
  typedef MIPS_parameterizer_3<TypeParam> Method;
  this->check(Hierarchical_parameterizer_3<Method>());
  this->check(
      Hierarchical_parameterizer_3<Method>(Method(), parameters::coarsest_size(10).visitor(Checking_visitor())));
}

TYPED_TEST(FaceGraph, is_parameterized_by_symmetric_Dirichlet)
{
  this->check(Hierarchical_parameterizer_3<Symmetric_Dirichlet_parameterizer_3<TypeParam>>());
}

TYPED_TEST(FaceGraph, is_parameterized_into_own_property_maps)
{
  Model<TypeParam> model;
  const TypeParam& mesh = model.mesh;     // only read
  typedef typename boost::graph_traits<TypeParam>::vertex_descriptor Vertex;
  std::map<std::size_t, Point_2> uv;
  std::map<std::size_t, bool> is_parameterized;
  const auto index_of = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  std::size_t n = 0;
  for (const Vertex v : vertices(mesh))
    put(index_of, v, n++);
  const auto by_index = [&](auto& map) {
    return boost::compose_property_map(boost::make_assoc_property_map(map), index_of);
  };

  const Halfedge<TypeParam> bhd = longest_border(mesh);
  Hierarchical_parameterizer_3<MIPS_parameterizer_3<TypeParam>> parameterizer;
  EXPECT_EQ(parameterizer.parameterize(mesh, bhd, by_index(uv), index_of, by_index(is_parameterized)), OK);
  EXPECT_EQ(uv.size(), n);
  EXPECT_EQ(is_parameterized.size(), n);
  for (const auto& entry : is_parameterized)
    EXPECT_TRUE(entry.second);
  EXPECT_TRUE(is_valid(mesh, bhd, by_index(uv)));
}

template <class TriangleMesh>
class Fillable_mesh : public testing::Test { };
typedef testing::Types<Surface_mesh, Epick_surface_mesh, Polyhedron, Linear_cell_complex> Fillable_meshes;
TYPED_TEST_SUITE(Fillable_mesh, Fillable_meshes, );

// A copy of a linear cell complex has its vertices in another order.
TYPED_TEST(Fillable_mesh, is_parameterized_in_a_copy)
{
  typedef Barycentric_mapping_parameterizer_3<TypeParam>                        Method;
  typedef typename boost::property_map<TypeParam, CGAL::vertex_point_t>::type   Point_map;
  typedef typename boost::property_traits<Point_map>::value_type                User_point_3;
  typedef typename CGAL::Kernel_traits<User_point_3>::Kernel::Point_2           User_point_2;
  TypeParam mesh = make<TypeParam>(grid_with_holes(20));
  const Halfedge<TypeParam> bhd = longest_border(mesh);
  const auto uvmap = get(CGAL::dynamic_vertex_property_t<User_point_2>(), mesh);
  const Hierarchical_parameterizer_3<Method> parameterizer(parameters::fill_holes(true).flip_policy(Flip_policy::FAIL));
  EXPECT_EQ(SMP::parameterize(mesh, parameterizer, bhd, uvmap), OK);
  EXPECT_TRUE(is_valid(mesh, bhd, uvmap));
  EXPECT_EQ(parameterization_quality(mesh, uvmap).flips, 0u);
}

// ---- maps of floats ----

// A flat ring, not closed, of radius 1: where it is some units of the last place wide, rounding alone flips triangles.
Flat_mesh narrow_ring(Index sectors, double width)
{
  Flat_mesh m = grid(sectors, 2, flat);
  for (Point_3& p : m.points) {
    const double radius = 1 + width * p.y() * sectors / 2, phi = -4 * p.x();
    p = Point_3(radius * std::cos(phi), radius * std::sin(phi), 0);
  }
  return m;
}

// What is promised holds for what is written into the user's map.
class Map_of_floats : public testing::TestWithParam<bool>
{
protected:
  // Checks a map that was found.
  Error_code run(const Flat_mesh& m)
  {
    typedef MIPS_parameterizer_3<Surface_mesh> Method;
    const Hierarchical_parameterizer_3<Method> parameterizer(Method(parameters::globally_injective(GetParam())));
    Surface_mesh mesh = make<Surface_mesh>(m);
    const auto bhd = longest_border(mesh);
    const auto uvmap = get(CGAL::dynamic_vertex_property_t<Float_point_2>(), mesh);
    const Error_code status = SMP::parameterize(mesh, parameterizer, bhd, uvmap);
    EXPECT_EQ(status == OK, is_valid(mesh, bhd, uvmap));
    return status;
  }
};

TEST_P(Map_of_floats, has_no_flips)
{
  for (const double width : { 1e-6, 3e-7 })
    EXPECT_EQ(run(narrow_ring(200, width)), OK);
}

TEST_P(Map_of_floats, is_an_error_where_floats_leave_no_room)
{
  EXPECT_EQ(run(narrow_ring(200, 1e-10)), ERROR_NO_1_TO_1_MAPPING);
}

INSTANTIATE_TEST_SUITE_P(Both, Map_of_floats, testing::Bool());

// The same of doubles so small that they have but few digits, and of some that have none for a ring.
TEST(Map_of_denormal_doubles, has_no_flips)
{
  for (const int exponent : { 1060, 1064, 1067, 1070, 1073 }) {
    Flat_mesh m = narrow_ring(40, 0.05);
    for (Point_3& p : m.points)
      p = Point_3(std::ldexp(p.x(), -exponent), std::ldexp(p.y(), -exponent), 0);
    Surface_mesh mesh = make<Surface_mesh>(m);
    const auto bhd = longest_border(mesh);
    const auto uvmap = mesh.add_property_map<Surface_mesh::Vertex_index, Point_2>("v:uv").first;
    const Error_code status =
        SMP::parameterize(mesh, Hierarchical_parameterizer_3<MIPS_parameterizer_3<Surface_mesh>>(), bhd, uvmap);
    EXPECT_EQ(status == OK, is_valid(mesh, bhd, uvmap)) << exponent;
    const Error_code expected = exponent < 1070 ? OK : ERROR_NO_1_TO_1_MAPPING;
    EXPECT_TRUE(exponent == 1070 || status == expected) << exponent;
  }
}

// The two descriptors of an edge of a Linear_cell_complex are equal, but not to a map that orders them.
TEST(Ordered_map_of_seams, has_what_is_true_of_either_descriptor)
{
  const auto mesh = make<Linear_cell_complex>(sphere(5, 8));
  typedef boost::graph_traits<Linear_cell_complex>::edge_descriptor   Edge;
  for (std::size_t i = 0; i < num_edges(mesh); ++i) {
    std::map<Edge, bool> is_seam;
    std::size_t position = 0;
    for (const Edge e : edges(mesh))
      is_seam[e] = position++ == i;
    const Cut_summary cut = cut_to_disk(mesh, boost::make_assoc_property_map(is_seam));
    ASSERT_TRUE(cut.is_ok());
    std::size_t seams = 0;
    for (const Edge e : edges(mesh))
      seams += is_seam[e];
    EXPECT_EQ(seams, cut.seam_edges + 1);
  }
}

} // namespace test_face_graphs
