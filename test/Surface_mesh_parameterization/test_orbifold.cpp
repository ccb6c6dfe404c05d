// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Orbifold embeddings of closed surfaces: the elimination of the seam's constraints, and CGAL's map by multigrid.

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Orbifold_Tutte_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Constraint_elimination.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <Eigen/Core>
#include <Eigen/LU>

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

namespace {

using namespace CGAL::Surface_mesh_parameterization;
namespace parameters = CGAL::parameters;

typedef CGAL::Simple_cartesian<double>                                    Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                               Surface_mesh;
typedef Surface_mesh::Property_map<Surface_mesh::Edge_index, bool>        Seam_edge_map;
typedef Surface_mesh::Property_map<Surface_mesh::Vertex_index, bool>      Seam_vertex_map;
typedef CGAL::Seam_mesh<Surface_mesh, Seam_edge_map, Seam_vertex_map>     Seam_mesh;
typedef boost::graph_traits<Seam_mesh>::vertex_descriptor                 Vertex;
typedef boost::graph_traits<Seam_mesh>::halfedge_descriptor               Halfedge;
typedef std::unordered_map<Vertex, Cone_type>                             Cone_map;
typedef Orbifold_Tutte_parameterizer_3<Seam_mesh>                         Flat;
typedef Hierarchical_parameterizer_3<Flat>                                Hierarchical;
typedef std::complex<double>                                              Complex;

const Kernel::Point_2 untouched(123, 456);

// ---- elimination ----

using internal::Constraint_elimination;
using internal::Index;
using internal::Sparse_matrix;

// A system of points with constraints: the matrix, symmetric beside L, and the right side.
struct Constrained_system
{
  Constrained_system(std::size_t points, std::size_t constraints)
    : next_row(2 * points), matrix(2 * (points + constraints)), right_side(Eigen::VectorXd::Zero(2 * (points + constraints)))
  {
    for (std::size_t i = 0; i < next_row; ++i) {
      matrix.set_coef(i, i, -4. - double(i / 2));
      matrix.set_coef(i, (i + 2) % next_row, 1.5);
      matrix.set_coef(i, (i + next_row - 2) % next_row, 0.5);      // not symmetric
    }
  }

  // The sum of the coefficients times their points is `value`.
  void constrain(const std::vector<std::pair<Index, Complex>>& terms, Complex value)
  {
    for (const auto& [point, c] : terms) {
      const double block[2][2] = { { c.real(), -c.imag() }, { c.imag(), c.real() } };
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          if (block[i][j] != 0) {
            matrix.set_coef(next_row + i, 2 * point + j, block[i][j]);
            matrix.set_coef(2 * point + j, next_row + i, block[i][j]);
          }
    }
    right_side[next_row] = value.real();
    right_side[next_row + 1] = value.imag();
    next_row += 2;
  }

  Eigen::MatrixXd dense() const { return dense(matrix); }

  static Eigen::MatrixXd dense(const Sparse_matrix& m)
  {
    Eigen::MatrixXd result(m.row_dimension(), m.column_dimension());
    for (Eigen::Index i = 0; i < result.rows(); ++i)
      for (Eigen::Index j = 0; j < result.cols(); ++j)
        result(i, j) = m.get_coef(i, j);
    return result;
  }

  std::size_t next_row;
  Sparse_matrix matrix;
  Eigen::VectorXd right_side;
};

// Points 0 and 4 have places; 1 and 2 are turned into each other about 0, and 3 and 5 about 4, whose place is told after that.
Constrained_system two_rotations()
{
  const Complex third = std::polar(1., 2 * CGAL_PI / 3), sixth = std::polar(1., CGAL_PI / 3);
  Constrained_system system(7, 4);
  system.constrain({ { 0, 1 } }, Complex(-1, 2));
  system.constrain({ { 1, third }, { 2, -1 }, { 0, 1. - third } }, 0);
  system.constrain({ { 3, sixth }, { 5, -1 }, { 4, 1. - sixth } }, 0);
  system.constrain({ { 4, 1 } }, Complex(3, 0.5));
  return system;
}

TEST(Constraint_elimination, gives_the_solution_of_the_whole_system)
{
  Constrained_system system = two_rotations();
  for (int i = 0; i < 14; ++i)
    system.right_side[i] = std::sin(i);
  const std::vector<Index> ranks{ 0, 5, 2, 1, 3, 4, 6 };
  const auto rows = system.matrix.rows();
  const Constraint_elimination elimination(*rows, system.right_side, ranks);
  ASSERT_TRUE(elimination.is_complete());
  ASSERT_EQ(elimination.number_of_unknowns(), 6u);
  const Eigen::VectorXd y = Constrained_system::dense(elimination.reduced_matrix()).partialPivLu().solve(elimination.reduced_right_side());
  const Eigen::VectorXd x = system.dense().fullPivLu().solve(system.right_side).head(14);
  EXPECT_LT((elimination.expand(y) - x).norm(), 1e-12 * x.norm());
}

TEST(Constraint_elimination, keeps_the_point_of_lower_rank)
{
  const Constrained_system system = two_rotations();
  const std::vector<Index> ranks{ 0, 5, 2, 1, 3, 4, 6 };
  const auto rows = system.matrix.rows();
  const Constraint_elimination elimination(*rows, system.right_side, ranks);
  for (const Index point : { 2, 3, 6 })
    EXPECT_TRUE(elimination.is_free(point)) << point;
  for (const Index point : { 1, 5 })
    EXPECT_TRUE(elimination.is_tied(point) && !elimination.is_free(point)) << point;
  for (const Index point : { 0, 4 })
    EXPECT_TRUE(!elimination.is_tied(point) && !elimination.is_free(point)) << point;
}

TEST(Constraint_elimination, satisfies_the_constraints_whatever_the_free_points)
{
  const Constrained_system system = two_rotations();
  const std::vector<Index> ranks{ 0, 1, 2, 3, 4, 5, 6 };
  const auto rows = system.matrix.rows();
  const Constraint_elimination elimination(*rows, system.right_side, ranks);
  Eigen::VectorXd y(6), x = Eigen::VectorXd::Zero(22);
  y << 1, -2, 3, 0.25, -5, 6;
  x.head(14) = elimination.expand(y);
  EXPECT_LT((system.dense() * x - system.right_side).tail(8).norm(), 1e-13);
}

TEST(Constraint_elimination, of_a_symmetric_matrix_is_symmetric_and_of_a_negative_one_positive)
{
  Constrained_system system = two_rotations();
  for (std::size_t i = 0; i < 14; ++i) {
    system.matrix.set_coef(i, (i + 2) % 14, 1);
    system.matrix.set_coef(i, (i + 12) % 14, 1);
  }
  const std::vector<Index> ranks{ 0, 1, 2, 3, 4, 5, 6 };
  const auto rows = system.matrix.rows();
  const Eigen::MatrixXd reduced = Constrained_system::dense(Constraint_elimination(*rows, system.right_side, ranks).reduced_matrix());
  EXPECT_LT((reduced - reduced.transpose()).norm(), 1e-13);
  EXPECT_EQ(reduced.llt().info(), Eigen::Success);
}

TEST(Constraint_elimination, tells_when_a_constraint_cannot_be_solved_for_a_point)
{
  const std::vector<Index> ranks{ 0, 1, 2, 3 };
  Constrained_system redundant(4, 2), wide(4, 1);
  redundant.constrain({ { 0, 1 } }, 1);
  redundant.constrain({ { 0, 1 } }, 2);
  wide.constrain({ { 0, 1 }, { 1, 1 }, { 2, 1 } }, 0);
  for (const Constrained_system& system : { redundant, wide }) {
    const auto rows = system.matrix.rows();
    EXPECT_FALSE(Constraint_elimination(*rows, system.right_side, ranks).is_complete());
  }
}

// ---- orbifolds ----

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
      put(uv, v, untouched);
    return uv;
  }

  bool is_untouched(const UV_map& uv) const
  {
    const auto range = vertices(mesh);
    return std::all_of(range.begin(), range.end(), [&uv](Vertex v) { return get(uv, v) == untouched; });
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
  for (const Kernel::Vector_3& direction : { Kernel::Vector_3(1, 0.2, 0), Kernel::Vector_3(0, 1, 0.3), Kernel::Vector_3(-1, 0.1, 0.2),
                                             Kernel::Vector_3(0.1, -1, 0) }) {
    const auto height = [&](Surface_mesh::Vertex_index v) { return (surface.point(v) - CGAL::ORIGIN) * direction; };
    const auto range = vertices(surface);
    cone_vertices.push_back(*std::max_element(range.begin(), range.end(), [&](auto v, auto w) { return height(v) < height(w); }));
  }
  cone_vertices.resize(cones);
  return Cut_surface(std::move(surface), cone_vertices);
}

typedef std::pair<Orbifold_type, Weight_type>   Kind;

class Orbifold : public testing::TestWithParam<Kind> { };

INSTANTIATE_TEST_SUITE_P(All_kinds, Orbifold,
                         testing::Values(Kind(Square, Cotangent), Kind(Diamond, Cotangent), Kind(Triangle, Cotangent), Kind(Parallelogram, Cotangent),
                                         Kind(Square, Mean_value), Kind(Diamond, Mean_value), Kind(Triangle, Mean_value), Kind(Parallelogram, Mean_value)),
                         [](const auto& kind) {
                           return std::string(get_orbifold_type(kind.param.first)) + (kind.param.second == Cotangent ? "_cotangent" : "_mean_value");
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
    EXPECT_LT(std::min(std::abs(edge / twin_edge - std::polar(1., angles[segment])), std::abs(edge / twin_edge - std::polar(1., -angles[segment]))), 1e-9);
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
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(0, 1, 0), Kernel::Point_3(0, 0, 1), surface);
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
  const Hierarchical impatient(Triangle, Cotangent, parameters::summary(std::ref(summary)).number_of_iterations(1));
  ASSERT_EQ(impatient.parameterize(cut.mesh, cut.bhd, cut.cone_map, uv, cut.index), OK);
  ASSERT_EQ(Flat(Triangle, Cotangent).parameterize(cut.mesh, cut.bhd, cut.cone_map, flat_uv, cut.index), OK);
  EXPECT_EQ(summary.linear_solver.direct_solutions, 1u);
  EXPECT_LT(cut.greatest_distance(uv, flat_uv), 1e-9);
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
  EXPECT_EQ(square.parameterize(cut.mesh, opposite(cut.bhd, cut.mesh), cut.cone_map, uv, cut.index), ERROR_WRONG_PARAMETER);
  EXPECT_TRUE(cut.is_untouched(uv));
}

struct Stopping_visitor : Hierarchy_visitor_3
{
  bool hierarchy_built(const Collapse_hierarchy_3&) { return false; }
};

TEST(Orbifolds, leave_the_map_untouched_if_a_visitor_stops_the_run)
{
  Cut_surface cut = ball(2, 3);
  const Cut_surface::UV_map uv = cut.untouched_map();
  Parameterization_summary summary;
  const Hierarchical stopped(Square, Cotangent, parameters::summary(std::ref(summary)).visitor(Stopping_visitor()));
  EXPECT_NE(stopped.parameterize(cut.mesh, cut.bhd, cut.cone_map, uv, cut.index), OK);
  EXPECT_TRUE(summary.stopped);
  EXPECT_FALSE(summary.converged);
  EXPECT_TRUE(cut.is_untouched(uv));
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

} // namespace
