// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's parameterizers in Hierarchical_parameterizer_3: the same maps as without it.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Rebind_solver.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Two_vertices_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// A user's own parameterizer, as small as can be: every vertex but those of the border goes to the mean of its neighbors.
namespace archetype {

namespace SMP = CGAL::Surface_mesh_parameterization;

template <class Mesh, class Solver>
struct Mean_parameterizer
{
  typedef Mesh Triangle_mesh;

  template <class Halfedge, class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  SMP::Error_code parameterize(Mesh& mesh, Halfedge bhd, VertexUVMap uvmap, VertexIndexMap vimap, VertexParameterizedMap vpmap)
  {
    SMP::Circular_border_arc_length_parameterizer_3<Mesh>().parameterize(mesh, bhd, uvmap, vimap, vpmap);
    const std::size_t n = num_vertices(mesh);
    typename Solver::Matrix matrix(n);
    typename Solver::Vector right_side_u(n), right_side_v(n), u(n), v(n);
    for (const auto vertex : vertices(mesh)) {
      const int i = get(vimap, vertex);
      if (get(vpmap, vertex)) {
        matrix.set_coef(i, i, 1, true);
        right_side_u.set(i, get(uvmap, vertex).x());
        right_side_v.set(i, get(uvmap, vertex).y());
      } else
        for (const auto neighbor : CGAL::vertices_around_target(vertex, mesh)) {
          matrix.add_coef(i, i, 1);
          matrix.add_coef(i, get(vimap, neighbor), -1);
        }
    }
    Solver solver;
    double d;
    if (!solver.linear_solver(matrix, right_side_u, u, d) || !solver.linear_solver(matrix, right_side_v, v, d))
      return SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    for (const auto vertex : vertices(mesh))
      put(uvmap, vertex, typename boost::property_traits<VertexUVMap>::value_type(u[get(vimap, vertex)], v[get(vimap, vertex)]));
    return SMP::OK;
  }
};

} // namespace archetype

namespace CGAL::Surface_mesh_parameterization {

template <class Mesh, class Solver, class NewSolver>
struct Rebind_solver<archetype::Mean_parameterizer<Mesh, Solver>, NewSolver>
{
  typedef archetype::Mean_parameterizer<Mesh, NewSolver>   type;
};

} // namespace CGAL::Surface_mesh_parameterization

namespace {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef CGAL::Simple_cartesian<double>                                       Kernel;
typedef CGAL::Exact_predicates_inexact_constructions_kernel                  Epick;
typedef CGAL::Surface_mesh<Kernel::Point_3>                                  Surface_mesh;
typedef CGAL::Surface_mesh<Epick::Point_3>                                   Epick_surface_mesh;
typedef CGAL::Polyhedron_3<Epick>                                            Polyhedron;
typedef Surface_mesh::Property_map<Surface_mesh::Edge_index, bool>           Seam_edge_map;
typedef Surface_mesh::Property_map<Surface_mesh::Vertex_index, bool>         Seam_vertex_map;
typedef CGAL::Seam_mesh<Surface_mesh, Seam_edge_map, Seam_vertex_map>        Seam_mesh;

template <class TriangleMesh>
using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

// ---- running ----

// A mesh with places that say "untouched" where nobody wrote.
template <class TriangleMesh>
struct Mapped
{
  typedef typename boost::property_traits<typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::type>::value_type    Point_3;
  typedef typename CGAL::Kernel_traits<Point_3>::Kernel::Point_2                                                        Point_2;

  TriangleMesh& mesh;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<Point_2>>::type uvmap;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<int>>::type vimap;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<bool>>::type vpmap;

  static Point_2 untouched() { return Point_2(-77, 77); }

  explicit Mapped(TriangleMesh& mesh)
    : mesh(mesh), uvmap(get(CGAL::dynamic_vertex_property_t<Point_2>(), mesh)), vimap(get(CGAL::dynamic_vertex_property_t<int>(), mesh)),
      vpmap(get(CGAL::dynamic_vertex_property_t<bool>(), mesh))
  {
    int n = 0;
    for (const auto v : vertices(mesh)) {
      put(uvmap, v, untouched());
      put(vimap, v, n++);
      put(vpmap, v, false);
    }
  }

  template <class Parameterizer, class... Others>
  Error_code parameterize(Parameterizer&& parameterizer, Halfedge<TriangleMesh> bhd, Others&&... others)
  {
    return parameterizer.parameterize(mesh, bhd, uvmap, vimap, vpmap, std::forward<Others>(others)...);
  }

  bool is_untouched() const
  {
    for (const auto v : vertices(mesh))
      if (get(uvmap, v) != untouched() || get(vpmap, v))
        return false;
    return true;
  }

  void expect_equal(const Mapped& other, double tolerance) const
  {
    for (const auto v : vertices(mesh)) {
      ASSERT_LT(CGAL::squared_distance(get(uvmap, v), get(other.uvmap, v)), tolerance * tolerance) << "vertex " << get(vimap, v);
      ASSERT_EQ(get(vpmap, v), get(other.vpmap, v)) << "vertex " << get(vimap, v);
    }
  }
};

constexpr double tolerance = 1e-6;

// Checks that the map of `flat` is that of `hierarchical`.
template <class TriangleMesh, class Flat, class Hierarchical>
void expect_equal_maps(TriangleMesh& mesh, Flat&& flat, Hierarchical&& hierarchical)
{
  const Halfedge<TriangleMesh> bhd = longest_border(mesh);
  Mapped<TriangleMesh> expected(mesh), found(mesh);
  ASSERT_EQ(expected.parameterize(flat, bhd), OK);
  ASSERT_EQ(found.parameterize(hierarchical, bhd), OK);
  found.expect_equal(expected, tolerance);
}

// Checks the adaptor of `Parameterizer`, whose constructor takes the arguments, and its summary.
template <class Parameterizer, class... Arguments>
void check(typename Parameterizer::Triangle_mesh& mesh, const Arguments&... arguments)
{
  Parameterization_summary summary;
  expect_equal_maps(mesh, Parameterizer(arguments...), Hierarchical_parameterizer_3<Parameterizer>(arguments..., parameters::flip_policy(Flip_policy::KEEP).summary(std::ref(summary))));
  EXPECT_EQ(summary.error.code, OK);
  EXPECT_TRUE(summary.converged);
  EXPECT_FALSE(summary.stopped);
  EXPECT_TRUE(summary.levels.empty());
  EXPECT_GE(summary.linear_solver.setups, 1u);
  EXPECT_LE(summary.linear_solver.residual, 1e-10);
  EXPECT_EQ(summary.linear_solver.direct_solutions, 0u);
  EXPECT_GE(summary.seconds_parameterize, summary.linear_solver.seconds_setup + summary.linear_solver.seconds_solve);
  EXPECT_GT(summary.seconds_hierarchy, 0);
}

std::vector<std::pair<std::string, Flat_mesh>> meshes()
{
  return { { "grid", grid(20, 16, wavy) }, { "hemisphere", hemisphere() }, { "disk with a hole", disk_with_hole() }, { "fan", fan(7) },
           { "several grids", cap(40, 80, 0.5 * CGAL_PI) } };
}

// ---- the methods ----

template <class Parameterizer>
class Wrapped : public testing::Test { };
typedef testing::Types<Barycentric_mapping_parameterizer_3<Surface_mesh>, Mean_value_coordinates_parameterizer_3<Surface_mesh>,
                       Discrete_conformal_map_parameterizer_3<Surface_mesh>, Discrete_authalic_parameterizer_3<Surface_mesh>,
                       LSCM_parameterizer_3<Surface_mesh>> Parameterizers;
TYPED_TEST_SUITE(Wrapped, Parameterizers, );

TYPED_TEST(Wrapped, gives_the_map_of_CGAL)
{
  for (const auto& [name, m] : meshes()) {
    SCOPED_TRACE(name);
    Surface_mesh mesh = make<Surface_mesh>(m);
    check<TypeParam>(mesh);
  }
}

TYPED_TEST(Wrapped, leaves_other_components_alone)
{
  Surface_mesh mesh = make<Surface_mesh>(sphere(4, 6));
  const std::size_t others = num_vertices(mesh);
  append(grid(9, 8, wavy), mesh);
  append(torus_with_hole(6), mesh);
  const auto bhd = longest_border(mesh);
  Mapped<Surface_mesh> expected(mesh), found(mesh);
  EXPECT_EQ(SMP::parameterize(mesh, TypeParam(), bhd, expected.uvmap), OK);
  EXPECT_EQ(SMP::parameterize(mesh, Hierarchical_parameterizer_3<TypeParam>(), bhd, found.uvmap), OK);
  found.expect_equal(expected, tolerance);
  for (const auto v : vertices(mesh))
    EXPECT_EQ(get(found.uvmap, v) == found.untouched(), std::size_t(v) < others || std::size_t(v) >= others + 90);
}

TYPED_TEST(Wrapped, leaves_the_maps_untouched_on_errors)
{
  const auto expect_error = [](Surface_mesh& mesh, Surface_mesh::Halfedge_index bhd, Error_code code, Parameterization_error::Place place, std::size_t index) {
    Mapped<Surface_mesh> mapped(mesh);
    Parameterization_summary summary;
    EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<TypeParam>(parameters::summary(std::ref(summary))), bhd), code);
    EXPECT_EQ(summary.error.code, code);
    EXPECT_EQ(summary.error.place, place);
    EXPECT_EQ(summary.error.index, index);
    EXPECT_EQ(summary.linear_solver.setups, 0u);
    EXPECT_FALSE(summary.converged);
    EXPECT_TRUE(mapped.is_untouched());
  };
  Surface_mesh empty, closed = make<Surface_mesh>(sphere(4, 6)), open = make<Surface_mesh>(grid(5, 5, wavy)), torus = make<Surface_mesh>(torus_with_hole(6));
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

// A sphere, cut along a meridian.
template <>
struct Model<Seam_mesh>
{
  Surface_mesh sphere = make<Surface_mesh>(test_meshes::sphere(9, 12));
  Seam_edge_map is_seam_edge = sphere.add_property_map<Surface_mesh::Edge_index, bool>("e:seam", false).first;
  Seam_vertex_map is_seam_vertex = sphere.add_property_map<Surface_mesh::Vertex_index, bool>("v:seam", false).first;
  Seam_mesh mesh{ sphere, is_seam_edge, is_seam_vertex };

  Model()
  {
    for (Index r = 0; r < 8; ++r)
      EXPECT_TRUE(mesh.add_seam(Surface_mesh::Vertex_index(r == 0 ? 0 : 1 + 12 * (r - 1)), Surface_mesh::Vertex_index(1 + 12 * r)));
  }
};

template <class TriangleMesh>
class FaceGraph : public testing::Test { };
typedef testing::Types<Epick_surface_mesh, Polyhedron, Seam_mesh> Meshes;
TYPED_TEST_SUITE(FaceGraph, Meshes, );

TYPED_TEST(FaceGraph, has_the_maps_of_CGAL)
{
  Model<TypeParam> model;
  check<Mean_value_coordinates_parameterizer_3<TypeParam>>(model.mesh);
  check<LSCM_parameterizer_3<TypeParam>>(model.mesh);
}

// ---- borders and constructors ----

template <class Border>
using Mean_value = Mean_value_coordinates_parameterizer_3<Surface_mesh, Border>;

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
  Mapped<Surface_mesh> mapped(mesh);
  EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Mean_value<Square>>(square), longest_border(mesh)), OK);
  EXPECT_NEAR(CGAL::squared_distance(get(mapped.uvmap, corner(0)), get(mapped.uvmap, corner(21 * 17 - 1))), 2, 1e-12);
}

TEST(Wrapped_borders, that_cannot_be_placed_are_errors_as_in_CGAL)
{
  typedef Mean_value<Square_border_arc_length_parameterizer_3<Surface_mesh>> Parameterizer;
  Surface_mesh mesh = make<Surface_mesh>(single_triangle());
  Mapped<Surface_mesh> expected(mesh), found(mesh);
  const Error_code status = expected.parameterize(Parameterizer(), longest_border(mesh));
  Parameterization_summary summary;
  EXPECT_NE(status, OK);
  EXPECT_EQ(found.parameterize(Hierarchical_parameterizer_3<Parameterizer>(parameters::summary(std::ref(summary))), longest_border(mesh)), status);
  EXPECT_EQ(summary.error.code, status);
  EXPECT_TRUE(found.is_untouched());
}

TEST(Wrapped_LSCM, pins_the_given_vertices)
{
  typedef Two_vertices_parameterizer_3<Surface_mesh>             Two_vertices;
  typedef LSCM_parameterizer_3<Surface_mesh, Two_vertices>       LSCM;
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  const Surface_mesh::Vertex_index v0(7), v1(800);
  check<LSCM>(mesh, Two_vertices(v0, v1));
  Mapped<Surface_mesh> mapped(mesh);
  EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<LSCM>(Two_vertices(v0, v1), parameters::flip_policy(Flip_policy::KEEP)), longest_border(mesh)), OK);
  EXPECT_EQ(get(mapped.uvmap, v0), Kernel::Point_2(0, 0.5));
  EXPECT_EQ(get(mapped.uvmap, v1), Kernel::Point_2(1, 0.5));

  // The user's map may hold further ones.
  Mapped<Surface_mesh> expected(mesh), found(mesh);
  for (auto* m : { &expected, &found }) {
    put(m->uvmap, Surface_mesh::Vertex_index(42), Kernel::Point_2(0.3, 0.9));
    put(m->vpmap, Surface_mesh::Vertex_index(42), true);
  }
  EXPECT_EQ(expected.parameterize(LSCM(Two_vertices(v0, v1)), longest_border(mesh)), OK);
  EXPECT_EQ(found.parameterize(Hierarchical_parameterizer_3<LSCM>(Two_vertices(v0, v1), parameters::flip_policy(Flip_policy::KEEP)), longest_border(mesh)), OK);
  found.expect_equal(expected, tolerance);
  EXPECT_EQ(get(found.uvmap, Surface_mesh::Vertex_index(42)), Kernel::Point_2(0.3, 0.9));
}

typedef Circular_border_arc_length_parameterizer_3<Surface_mesh>     Circle;
typedef Hierarchical_parameterizer_3<Mean_value<Circle>>             Hierarchical_mean_value;

TEST(Wrapped_constructor, takes_the_arguments_and_then_named_parameters)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  Parameterization_summary summary;
  const auto np = parameters::tolerance(1e-4).coarsest_size(7).summary(std::ref(summary)).random_seed(3).number_of_iterations(50);
  expect_equal_maps(mesh, Mean_value<Circle>(), Hierarchical_mean_value());
  expect_equal_maps(mesh, Mean_value<Circle>(), Hierarchical_mean_value(Circle()));

  const auto residual = [&](Hierarchical_mean_value parameterizer) {
    summary = Parameterization_summary();
    EXPECT_EQ(Mapped<Surface_mesh>(mesh).parameterize(parameterizer, longest_border(mesh)), OK);
    return summary.linear_solver.residual;
  };
  for (const Hierarchical_mean_value& parameterizer : { Hierarchical_mean_value(np), Hierarchical_mean_value(Circle(), np) }) {
    EXPECT_GT(residual(parameterizer), 1e-10);
    EXPECT_LE(residual(parameterizer), 1e-4);
    EXPECT_EQ(summary.linear_solver.right_sides, 2u);
    EXPECT_EQ(summary.linear_solver.setups, 1u);
    EXPECT_GE(summary.linear_solver.iterations, 1u);
  }
}

TEST(Wrapped_constructor, number_of_iterations_limits_the_iteration)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  Parameterization_summary summary;
  expect_equal_maps(mesh, Mean_value<Circle>(), Hierarchical_mean_value(parameters::summary(std::ref(summary)).number_of_iterations(1)));
  EXPECT_EQ(summary.linear_solver.direct_solutions, 2u);
  EXPECT_EQ(summary.linear_solver.iterations, 1u);
}

// Stops a run when the hierarchy is built.
struct Stopping_visitor : Hierarchy_visitor_3
{
  std::size_t* coarsest_size;
  explicit Stopping_visitor(std::size_t& size) : coarsest_size(&size) { }

  bool hierarchy_built(const Collapse_hierarchy_3& hierarchy)
  {
    *coarsest_size = hierarchy.number_of_vertices(0);
    return false;
  }
};

TEST(Wrapped_constructor, visitor_sees_the_hierarchy_and_can_stop_the_run)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  for (const std::size_t coarsest_size : { 10, 60 }) {
    std::size_t seen = 0;
    Parameterization_summary summary;
    Mapped<Surface_mesh> mapped(mesh);
    const auto np = parameters::coarsest_size(coarsest_size).summary(std::ref(summary)).visitor(Stopping_visitor(seen));
    EXPECT_NE(mapped.parameterize(Hierarchical_mean_value(np), longest_border(mesh)), OK);
    EXPECT_TRUE(summary.stopped);
    EXPECT_TRUE(mapped.is_untouched());
    EXPECT_LE(seen, coarsest_size);
    EXPECT_GT(seen, coarsest_size / 3);
  }
}

// Without a visitor the hierarchy has no faces; the map is the same to the last digit.
TEST(Wrapped_constructor, visitor_that_looks_on_changes_nothing)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  Mapped<Surface_mesh> seen(mesh), unseen(mesh);
  EXPECT_EQ(seen.parameterize(Hierarchical_mean_value(parameters::visitor(Hierarchy_visitor_3())), longest_border(mesh)), OK);
  EXPECT_EQ(unseen.parameterize(Hierarchical_mean_value(), longest_border(mesh)), OK);
  for (const auto v : vertices(mesh))
    ASSERT_EQ(get(seen.uvmap, v), get(unseen.uvmap, v));
}

// The weights are the same on a stretched mesh, and the hierarchy is as good.
TEST(Wrapped_barycentric, takes_no_more_iterations_on_stretched_triangles)
{
  Surface_mesh mesh = make<Surface_mesh>(affine_image(grid(120, 120, flat), 6, 0, 0, 1));
  const auto iterations = [&](const auto& np) {
    Parameterization_summary summary;
    EXPECT_EQ(Mapped<Surface_mesh>(mesh).parameterize(Hierarchical_parameterizer_3<Barycentric_mapping_parameterizer_3<Surface_mesh>>(np.summary(std::ref(summary))),
                                                      longest_border(mesh)), OK);
    return summary.linear_solver.iterations;
  };
  EXPECT_LT(iterations(parameters::tolerance(1e-8)), iterations(parameters::tolerance(1e-8).unit_edges(false)));
}

TEST(Wrapped_constructor, copies_give_the_same_map)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  Parameterization_summary summary;
  Hierarchical_mean_value parameterizer(Circle(), parameters::summary(std::ref(summary)));
  Hierarchical_mean_value copy(parameterizer), assigned;
  assigned = copy;
  Mapped<Surface_mesh> expected(mesh);
  EXPECT_EQ(expected.parameterize(parameterizer, longest_border(mesh)), OK);
  for (const Hierarchical_mean_value& p : { parameterizer, copy, assigned }) {
    Mapped<Surface_mesh> found(mesh);
    summary.converged = false;
    EXPECT_EQ(SMP::parameterize(mesh, p, longest_border(mesh), found.uvmap), OK);
    EXPECT_TRUE(summary.converged);
    for (const auto v : vertices(mesh))
      ASSERT_EQ(get(found.uvmap, v), get(expected.uvmap, v));
  }
}

// ---- Iterative_authalic_parameterizer_3, which has arguments of its own ----

TEST(Wrapped_iterative_authalic, iterates_as_CGAL_does)
{
  typedef Iterative_authalic_parameterizer_3<Surface_mesh> Parameterizer;
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(700, 3, wavy));
  const auto bhd = longest_border(mesh);
  Mapped<Surface_mesh> expected(mesh), found(mesh);
  Parameterization_summary summary;
  unsigned int iterations = 6, hierarchical_iterations = 6;
  double error = -1, hierarchical_error = -1;
  EXPECT_EQ(expected.parameterize(Parameterizer(), bhd, iterations, error), OK);
  EXPECT_EQ(found.parameterize(Hierarchical_parameterizer_3<Parameterizer>(parameters::summary(std::ref(summary))), bhd, hierarchical_iterations, hierarchical_error), OK);
  found.expect_equal(expected, tolerance);
  EXPECT_EQ(hierarchical_iterations, iterations);
  EXPECT_NEAR(hierarchical_error, error, 1e-6);
  EXPECT_EQ(summary.linear_solver.setups, 6u);
  EXPECT_EQ(summary.linear_solver.right_sides, 12u);

  expect_equal_maps(mesh, Parameterizer(), Hierarchical_parameterizer_3<Parameterizer>());
}

// ---- a user's own ----

TEST(Rebind_solver, opens_the_adaptor_to_a_parameterizer_of_the_user)
{
  typedef CGAL::Eigen_solver_traits<Eigen::SparseLU<CGAL::Eigen_sparse_matrix<double>::EigenType>>   Direct_solver;
  typedef archetype::Mean_parameterizer<Surface_mesh, Direct_solver>                                Parameterizer;
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  check<Parameterizer>(mesh);
  expect_equal_maps(mesh, Parameterizer(), Hierarchical_parameterizer_3<Parameterizer>());

  Parameterization_summary summary;
  Hierarchical_parameterizer_3<Parameterizer> parameterizer(parameters::summary(std::ref(summary)));
  EXPECT_EQ(Mapped<Surface_mesh>(mesh).parameterize(parameterizer, longest_border(mesh)), OK);
  EXPECT_EQ(summary.linear_solver.setups, 1u);
  EXPECT_EQ(summary.linear_solver.right_sides, 2u);
}

} // namespace
