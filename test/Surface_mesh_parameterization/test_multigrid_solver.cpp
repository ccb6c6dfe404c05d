// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Multigrid_solver_traits as a user has it.

#include "mesh_conversions.h"
#include "multigrid_systems.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace test_multigrid_solver {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace test_systems;
namespace parameters = CGAL::parameters;

typedef boost::graph_traits<Surface_mesh>::halfedge_descriptor   Halfedge;

// ---- solutions ----

TEST(Multigrid_solver_traits, solves_what_sits_on_a_mesh)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    Solver_on_mesh on(m);
    for (const bool is_symmetric : { true, false }) {
      Sparse_matrix matrix =
          is_symmetric ? edge_matrix(m, Uniform_edge_weights_3()) : edge_matrix(m, Mean_value_edge_weights_3());
      const Known_system system(std::move(matrix));
      Vector x;
      double d = 0;
      EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
      EXPECT_EQ(d, 1);
      EXPECT_LT(system.error(x), 1e-4);       // of degenerate triangles the matrix is nearly singular
    }
    EXPECT_EQ(on.solver.error().code, OK);
    EXPECT_EQ(on.solver.summary().right_sides, 2u);
    EXPECT_EQ(on.solver.summary().setups, 2u);
    EXPECT_EQ(on.solver.summary().direct_solutions, 0u);
    EXPECT_LE(on.solver.summary().residual, 1e-10);
  }
}

TEST(Multigrid_solver_traits, solution_may_replace_the_right_side)
{
  const Flat_mesh m = grid(20, 20, wavy);
  const Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
  for (const std::size_t most_iterations : { 300, 0 }) {      // and by the direct solver
    Solver_on_mesh on(m, parameters::number_of_iterations(most_iterations));
    Vector x = system.right_side;
    double d;
    EXPECT_TRUE(on.solver.linear_solver(system.matrix, x, x, d));
    EXPECT_LT(system.error(x), 1e-8);
  }
}

// With one more vertex in the middle of each triangle.
Flat_mesh with_centers(const Flat_mesh& m)
{
  Flat_mesh result{ m.points, {} };
  for (const auto& t : m.triangles) {
    const Index center = Index(result.points.size());
    result.points.push_back(CGAL::centroid(m.points[t[0]], m.points[t[1]], m.points[t[2]]));
    for (int i = 0; i < 3; ++i)
      result.triangles.push_back({ t[i], t[(i + 1) % 3], center });
  }
  return result;
}

// Whose coarse levels, all or the first one, have no vertex that is not on the border.
TEST(Multigrid_solver_traits, solves_where_coarse_levels_have_no_unknown)
{
  for (const Flat_mesh& m :
       { grid(1500, 2, wavy), grid(700, 3, wavy), grid_with_holes(60), with_centers(strip(800)) }) {
    Solver_on_mesh on(m, parameters::coarsest_size(5));
    const Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
    expect_solved(on.solver, system, 1e-6);
    EXPECT_EQ(on.solver.summary().direct_solutions, 0u);
  }
}

// Not even one whose squares a double cannot hold.
TEST(Multigrid_solver_traits, feels_no_scale)
{
  const Flat_mesh m = grid(20, 20, wavy);
  const Sparse_matrix matrix = edge_matrix(m, Mean_value_edge_weights_3());
  const auto rows = matrix.rows();
  for (const auto& [scale_of_matrix, scale_of_solution] :
       { std::make_pair(1., 1e-170),
         { 1., 1e-304 },
         { 1., 1e170 },
         { 1e-200, 1. },
         { 1e200, 1. },
         { 1e200, 1e-200 } }) {
    SCOPED_TRACE(std::to_string(std::log10(scale_of_matrix)) + " " + std::to_string(std::log10(scale_of_solution)));
    Sparse_matrix scaled(matrix.row_dimension());
    for (Index i = 0; i < rows->number_of_rows(); ++i)
      for (Index k = rows->first[i]; k < rows->first[i + 1]; ++k)
        scaled.set_coef(i, rows->columns[k], scale_of_matrix * rows->values[k], true);
    Known_system system(std::move(scaled));
    for (int i = 0; i < matrix.row_dimension(); ++i)
      system.right_side[i] *= scale_of_solution;
    Solver_on_mesh on(m);
    Vector x;
    double d;
    EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] /= scale_of_solution;
    EXPECT_LT(system.error(x), 1e-8);
    EXPECT_EQ(on.solver.summary().direct_solutions, 0u);
  }
}

// Which many assemble from a Laplacian matrix.
TEST(Multigrid_solver_traits, solves_the_negative_of_a_system_in_the_same_way)
{
  const Flat_mesh m = grid(30, 30, wavy);
  for (Sparse_matrix matrix :
       { edge_matrix(m, Uniform_edge_weights_3()), edge_matrix(m, Mean_value_edge_weights_3()) }) {
    const Known_system system(std::move(matrix)), negated = negative(system);
    Solver_on_mesh on(m), on_negated(m);
    Vector x, x_of_negated;
    double d;
    EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
    EXPECT_TRUE(on_negated.solver.linear_solver(negated.matrix, negated.right_side, x_of_negated, d));
    EXPECT_EQ(x.values(), x_of_negated.values());
    EXPECT_EQ(on.solver.summary().iterations, on_negated.solver.summary().iterations);
    EXPECT_EQ(on_negated.solver.summary().direct_solutions, 0u);
  }
}

TEST(Multigrid_solver_traits, factor_keeps_the_matrix_for_several_right_sides)
{
  const Flat_mesh m = grid(20, 20, wavy);
  Solver_on_mesh on(m);
  const Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
  Vector never_solved;
  EXPECT_FALSE(on.solver.linear_solver(system.right_side, never_solved)) << "nothing has been factored";
  double d = 0;
  EXPECT_TRUE(on.solver.factor(system.matrix, d));
  EXPECT_EQ(d, 1);
  for (int i = 0; i < 3; ++i) {
    Vector x;
    EXPECT_TRUE(on.solver.linear_solver(system.right_side, x));
    EXPECT_LT(system.error(x), 1e-8);
  }
  Vector x;
  EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
  EXPECT_EQ(on.solver.summary().setups, 1u);
  EXPECT_EQ(on.solver.summary().right_sides, 4u);
}

TEST(Multigrid_solver_traits, notices_that_a_matrix_has_changed_in_its_place)
{
  const Flat_mesh m = grid(20, 20, wavy);
  Solver_on_mesh on(m);
  Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
  Vector x;
  double d;
  EXPECT_TRUE(on.solver.linear_solver(system.matrix, system.right_side, x, d));
  system.matrix.set_coef(200, 200, 100 + system.matrix.get_coef(200, 200));
  const Known_system changed(system.matrix);
  EXPECT_TRUE(on.solver.linear_solver(system.matrix, changed.right_side, x, d));
  EXPECT_LT(changed.error(x), 1e-8);
  EXPECT_EQ(on.solver.summary().setups, 2u);
}

TEST(Multigrid_solver_traits, copies_share_what_was_set_up)
{
  const Flat_mesh m = grid(20, 20, wavy);
  Solver_on_mesh on(m);
  Multigrid_solver_traits copy = on.solver;
  const Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
  Vector x;
  double d;
  EXPECT_TRUE(copy.factor(system.matrix, d));
  EXPECT_TRUE(on.solver.linear_solver(system.right_side, x));
  EXPECT_EQ(copy.summary().right_sides, 1u);
}

TEST(Multigrid_solver_traits, default_constructed_takes_the_solver_of_the_innermost_scope)
{
  const auto solves = [](const Flat_mesh& m) {
    const Known_system system(edge_matrix(m, Uniform_edge_weights_3()));
    Vector x;
    double d = 0;
    const bool result = Multigrid_solver_traits().linear_solver(system.matrix, system.right_side, x, d);
    EXPECT_EQ(Multigrid_solver_traits().factor(system.matrix, d), result);
    return result && system.error(x) < 1e-8;
  };
  const Flat_mesh outer_mesh = grid(9, 9, wavy), inner_mesh = fan(17);
  Solver_on_mesh outer(outer_mesh), inner(inner_mesh);
  EXPECT_FALSE(solves(outer_mesh));
  {
    const Multigrid_solver_traits::Scope outer_scope(outer.solver);
    EXPECT_TRUE(solves(outer_mesh));
    EXPECT_FALSE(solves(inner_mesh));
    {
      const Multigrid_solver_traits::Scope inner_scope(inner.solver);
      EXPECT_FALSE(solves(outer_mesh));
      EXPECT_TRUE(solves(inner_mesh));
    }
    EXPECT_TRUE(solves(outer_mesh));
    const Multigrid_solver_traits::Scope empty_scope{ Multigrid_solver_traits(nullptr) };
    EXPECT_FALSE(solves(outer_mesh));
  }
  EXPECT_FALSE(solves(outer_mesh));
  EXPECT_EQ(Multigrid_solver_traits().summary().setups, 0u);
}

// ---- users ----

// The vertices in the system may be some of the mesh's, in any order, with several unknowns each.
TEST(Multigrid_solver_traits, follows_the_vertex_index_map)
{
  const Flat_mesh m = delaunay_patch(6000, 1, wavy);
  const One_rings rings(m.points.size(), m.triangles);
  Surface_mesh mesh = make<Surface_mesh>(m);
  auto index = mesh.add_property_map<Surface_mesh::Vertex_index, int>("v:index", -1).first;
  std::vector<Index> inner;
  for (Index v = 0; v < m.points.size(); ++v)
    if (!rings.is_border(v))
      inner.push_back(v);
  Random random(4);
  for (std::size_t i = inner.size(); i > 1; --i)
    std::swap(inner[i - 1], inner[random.below(i)]);
  for (std::size_t i = 0; i < inner.size(); ++i)
    index[Surface_mesh::Vertex_index(inner[i])] = int(10 * i);     // gaps do not matter

  for (const std::size_t components : { 1, 2 }) {
    Sparse_matrix matrix(components * inner.size());
    for (std::size_t i = 0; i < inner.size(); ++i)
      for (std::size_t c = 0; c < components; ++c)
        for (const Index w : rings[inner[i]]) {
          matrix.add_coef(components * i + c, components * i + c, 1);
          const int j = index[Surface_mesh::Vertex_index(w)];
          if (j >= 0)
            matrix.add_coef(components * i + c, components * (j / 10) + c, -1);
        }
    Multigrid_solver_traits solver(mesh, longest_border(mesh), index);
    const Known_system system(std::move(matrix));
    expect_solved(solver, system);
    EXPECT_EQ(solver.summary().direct_solutions, 0u);
    EXPECT_LE(solver.summary().iterations, 12u);      // which wrong places of the unknowns would not allow
  }
}

// As those of smooth surfaces, which couple each vertex with neighbors of its neighbors.
TEST(Multigrid_solver_traits, iterates_with_wide_stencils)
{
  const Flat_mesh m = delaunay_patch(3000, 1, wavy);
  const auto rows = edge_matrix(m, Uniform_edge_weights_3()).rows();
  Sparse_matrix square(rows->number_of_rows());
  for (Index i = 0; i < rows->number_of_rows(); ++i)
    for (Index k = rows->first[i]; k < rows->first[i + 1]; ++k)
      for (Index l = rows->first[rows->columns[k]]; l < rows->first[rows->columns[k] + 1]; ++l)
        square.add_coef(i, rows->columns[l], rows->values[k] * rows->values[l]);
  const Known_system system(std::move(square));
  Solver_on_mesh on(m);
  expect_solved(on.solver, system, 1e-5);
  EXPECT_GT(on.solver.summary().iterations, 0u);
}

TEST(Multigrid_linear_solver, goes_on_below_the_tolerance_to_its_aim)
{
  const Flat_mesh m = delaunay_patch(2000, 1, wavy);
  const internal::Hierarchy_interpolation interpolation(surface(m), internal::Hierarchy_options());
  for (const bool is_symmetric : { true, false }) {
    const Known_system system(is_symmetric ? edge_matrix(m, Uniform_edge_weights_3())
                                           : edge_matrix(m, Mean_value_edge_weights_3()));
    const auto solver = internal::make_multigrid_linear_solver<1>(
        &interpolation, system.matrix.rows(), internal::Mesh_unknowns(interpolation.ranks()).in_order(m.points.size()),
        {}, internal::Loops());
    Vector x(system.right_side.size());
    double last_residual = 1;
    for (const double aim : { 1., 1e-4, 1e-8, 1e-300 }) {
      internal::Linear_solver_options options;
      options.tolerance = 1e-4;
      options.aim = aim;
      const auto result = solver->solve({ system.right_side.values().data() }, { x.values().data() }, options);
      EXPECT_TRUE(result.is_solved);
      EXPECT_FALSE(result.is_direct) << "the tolerance is reached";
      EXPECT_LT(result.residual, (std::max)(1e-13, 1e-4 * aim));
      EXPECT_LE(result.residual, (std::max)(1e-13, last_residual));
      EXPECT_LT(result.iterations, 60u) << "nor does it try what rounding forbids for ever";
      last_residual = result.residual;
    }
  }
}

TEST(Multigrid_solver_traits, solves_for_a_parameterizer_of_CGAL)
{
  typedef Square_border_arc_length_parameterizer_3<Surface_mesh>                                          Border;
  typedef Mean_value_coordinates_parameterizer_3<Surface_mesh, Border>                                    Direct;
  typedef Mean_value_coordinates_parameterizer_3<Surface_mesh, Border, Multigrid_solver_traits>           Multigrid;
  const Flat_mesh m = grid(30, 30, wavy);
  Surface_mesh mesh = make<Surface_mesh>(m);
  const Halfedge bhd = longest_border(mesh);
  const auto vimap = get(CGAL::vertex_index, mesh);
  const auto parameterize = [&](auto&& parameterizer) {
    const auto uvmap = get(CGAL::dynamic_vertex_property_t<Kernel::Point_2>(), mesh);
    const auto vpmap = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
    EXPECT_EQ(parameterizer.parameterize(mesh, bhd, uvmap, vimap, vpmap), OK);
    return uvmap;
  };
  Multigrid_solver_traits solver(mesh, bhd, vimap, parameters::tolerance(1e-12));
  const auto expected = parameterize(Direct()), by_object = parameterize(Multigrid(Border(), solver));
  const Multigrid_solver_traits::Scope scope(solver);
  const auto by_scope = parameterize(Multigrid());
  for (const auto v : vertices(mesh)) {
    EXPECT_LT(CGAL::squared_distance(get(expected, v), get(by_object, v)), 1e-18);
    EXPECT_EQ(get(by_object, v), get(by_scope, v));
  }
  EXPECT_EQ(solver.summary().right_sides, 4u);
  EXPECT_EQ(solver.summary().setups, 2u);
}

} // namespace test_multigrid_solver
