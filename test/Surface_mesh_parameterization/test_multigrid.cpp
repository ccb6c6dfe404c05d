// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Multigrid for systems that others assemble: from grid to grid, and the cycle.

#include "dense_matrices.h"
#include "hierarchies.h"
#include "mesh_conversions.h"
#include "multigrid_systems.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Pruned_prolongation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Grid_transfer.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Incomplete_LU.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Krylov_methods.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Scalar_multigrid.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace test_multigrid {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace test_systems;
using internal::Grid_transfer;
using internal::Incomplete_LU;
using internal::Loops;
using internal::Mesh_unknown;
using internal::Pruned_prolongation;
using internal::Scalar_multigrid;
using internal::Scalar_multigrid_options;

// ---- from grid to grid ----

// Two unknowns at each vertex of a level, but for some whose values are known.
std::vector<Mesh_unknown> some_unknowns(const Collapse_hierarchy_3& hierarchy, std::size_t level)
{
  std::vector<Mesh_unknown> result;
  for (Index v = 0; v < hierarchy.number_of_vertices(level); ++v)
    for (const Index component : { 0, 1 })
      if ((hierarchy.input_vertex(v) + component) % 7 != 0)
        result.push_back({ v, component });
  std::sort(result.begin(), result.end(), [&](const Mesh_unknown& a, const Mesh_unknown& b) {
    return std::make_pair(hierarchy.input_vertex(a.vertex), a.component) <
           std::make_pair(hierarchy.input_vertex(b.vertex), b.component);
  });
  return result;
}

Eigen::MatrixXd prolongation_of(const Grid_transfer& transfer, std::size_t fine_size)
{
  return matrix_of(transfer.coarse_unknowns().size(), [&](const Values& coarse) {
    Values x(fine_size, Value::zero());
    transfer.add_prolongation(coarse, x);
    return x;
  });
}

TEST(Grid_transfer, restriction_is_the_transpose_and_the_Galerkin_product_as_defined)
{
  const Collapse_hierarchy_3 hierarchy = hierarchy_of(delaunay_patch(120, 3, wavy));
  const std::size_t fine = hierarchy.number_of_levels() - 1, coarse = fine - 3;
  const std::vector<Mesh_unknown> unknowns = some_unknowns(hierarchy, fine);
  const std::size_t n = unknowns.size();
  const Grid_transfer transfer(Pruned_prolongation(hierarchy, coarse, fine, Loops()), unknowns);
  const Eigen::MatrixXd p = prolongation_of(transfer, n);
  EXPECT_EQ(transfer.coarse_unknowns().size(), some_unknowns(hierarchy, coarse).size());

  const Eigen::MatrixXd transpose = matrix_of(n, [&](const Values& b) {
    Values result(p.cols());
    transfer.restrict([&](Index i) { return b[i]; }, result);
    return result;
  });
  EXPECT_EQ(transpose, p.transpose());

  Random random(1);
  const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(n, n, [&](Eigen::Index i, Eigen::Index j) {
    return i == j || random(0, 1) < 0.05 ? random(-1, 1) : 0;
  });
  const Sparse_rows<double> product = transfer.galerkin_product<double>(Incomplete_LU<double>(sparse(a), enlargement));
  EXPECT_NEAR((dense(product, p.cols()) - p.transpose() * a * p).norm(), 0, 1e-12 * a.norm());
}

// A restriction that several threads share reaches every coarse unknown once more.
TEST(Grid_transfer, restriction_in_parts_is_the_transpose)
{
  const Collapse_hierarchy_3 hierarchy = hierarchy_of(grid(70, 60, wavy));
  const std::size_t fine = hierarchy.number_of_levels() - 1;
  const std::vector<Mesh_unknown> unknowns = some_unknowns(hierarchy, fine);
  ASSERT_GT(internal::number_of_parts(unknowns.size()), 1u);
  const Grid_transfer transfer(Pruned_prolongation(hierarchy, fine - 3, fine, Loops()), unknowns);
  Random random(2);
  const auto random_values = [&](std::size_t n) {
    Values result(n);
    for (Value& v : result)
      v[0] = random(-1, 1);
    return result;
  };
  const std::size_t n = transfer.coarse_unknowns().size();
  const Values coarse = random_values(n), b = random_values(unknowns.size());
  Values x(b.size(), Value::zero()), restricted(n);
  transfer.add_prolongation(coarse, x);
  transfer.restrict([&](Index i) { return b[i]; }, restricted);
  double product = 0, product_of_restricted = 0;
  for (std::size_t i = 0; i < b.size(); ++i)
    product += x[i][0] * b[i][0];
  for (std::size_t i = 0; i < n; ++i)
    product_of_restricted += coarse[i][0] * restricted[i][0];
  EXPECT_NEAR(product_of_restricted, product, 1e-10);
}

TEST(Grid_transfer, may_have_no_coarse_unknowns)
{
  const Collapse_hierarchy_3 hierarchy = hierarchy_of(grid(120, 110, wavy));
  const std::size_t fine = hierarchy.number_of_levels() - 1, coarse = fine - 4;
  std::vector<Mesh_unknown> unknowns;
  for (const Mesh_unknown& u : some_unknowns(hierarchy, fine))
    if (u.vertex >= hierarchy.number_of_vertices(coarse))
      unknowns.push_back(u);
  ASSERT_GT(internal::number_of_parts(unknowns.size()), 1u);
  const Grid_transfer transfer(Pruned_prolongation(hierarchy, coarse, fine, Loops()), unknowns);
  EXPECT_TRUE(transfer.coarse_unknowns().empty());
}

TEST(Grid_transfer, prolongs_components_apart_and_keeps_constants)
{
  const Collapse_hierarchy_3 hierarchy = hierarchy_of(disk_with_hole());
  std::vector<Mesh_unknown> unknowns;
  for (Index v = 0; v < hierarchy.number_of_vertices(); ++v)
    for (const Index component : { 0, 1 })
      unknowns.push_back({ v, component });
  const Grid_transfer transfer(Pruned_prolongation(hierarchy, 0, hierarchy.number_of_levels() - 1, Loops()), unknowns);
  Values coarse, x(unknowns.size(), Value::zero());
  for (const Mesh_unknown& u : transfer.coarse_unknowns())
    coarse.push_back(Value::all(u.component == 0 ? 3 : -5));
  transfer.add_prolongation(coarse, x);
  for (std::size_t i = 0; i < x.size(); ++i)
    EXPECT_NEAR(x[i][0], unknowns[i].component == 0 ? 3 : -5, 1e-5);
}

// ---- the cycle ----

// The vertices that are not on the border, and the rows and columns of the matrix above that belong to them.
struct Inner_system
{
  std::vector<Mesh_unknown> unknowns;
  Sparse_rows<double> rows;

  Inner_system(const Flat_mesh& m, const Collapse_hierarchy_3& hierarchy)
  {
    const One_rings rings(m.points.size(), m.triangles);
    std::vector<Index> rank_of(m.points.size()), number(m.points.size(), SMP::internal::no_index);
    for (Index rank = 0; rank < m.points.size(); ++rank)
      rank_of[hierarchy.input_vertex(rank)] = rank;
    for (Index v = 0; v < m.points.size(); ++v)
      if (!rings.is_border(v)) {
        number[v] = Index(unknowns.size());
        unknowns.push_back({ rank_of[v], 0 });
      }
    const auto all = edge_matrix(m, Harmonic_edge_weights_3()).rows();
    Sparse_matrix inner(unknowns.size());
    for (Index v = 0; v < m.points.size(); ++v)
      for (Index k = all->first[v]; k < all->first[v + 1]; ++k)
        if (number[v] != SMP::internal::no_index && number[all->columns[k]] != SMP::internal::no_index)
          inner.set_coef(number[v], number[all->columns[k]], all->values[k], true);
    rows = *inner.rows();
  }
};

TEST(Multigrid_preconditioner, cycle_of_a_symmetric_matrix_is_symmetric_and_positive)
{
  const Flat_mesh m = delaunay_patch(3000, 2, wavy);
  const Collapse_hierarchy_3 hierarchy = hierarchy_of(m);
  const Inner_system system(m, hierarchy);
  const std::size_t n = system.unknowns.size();
  ASSERT_GT(n, 4 * Scalar_multigrid_options().coarsest_size);
  const Scalar_multigrid<double> multigrid(hierarchy, system.unknowns, system.rows);
  ASSERT_TRUE(multigrid.is_ready());
  Scalar_multigrid<double>::Space<1> space(multigrid);
  const auto cycle = [&](const Values& b) {
    space.right_side(0) = b;
    multigrid.cycle(space);
    return space.solution(0);
  };
  Random random(3);
  Values x(n), y(n);
  for (int i = 0; i < 5; ++i) {
    for (Values* vector : { &x, &y })
      for (Value& value : *vector)
        value = Value::all(random(-1, 1));
    const Values cycle_x = cycle(x), cycle_y = cycle(y);
    const double xy = SMP::internal::inner_product(Loops(), cycle_x, y)[0],
                 yx = SMP::internal::inner_product(Loops(), x, cycle_y)[0];
    const double xx = SMP::internal::inner_product(Loops(), cycle_x, x)[0],
                 yy = SMP::internal::inner_product(Loops(), cycle_y, y)[0];
    EXPECT_GT(xx, 0);
    EXPECT_NEAR(xy, yx, 1e-12 * std::sqrt(xx * yy));
  }
}

TEST(Multigrid_preconditioner, cycles_reduce_the_error_and_full_cycles_more_so)
{
  const Flat_mesh m = delaunay_patch(3000, 2, wavy);
  const Collapse_hierarchy_3 hierarchy = hierarchy_of(m);
  const Inner_system system(m, hierarchy);
  const Scalar_multigrid<double> multigrid(hierarchy, system.unknowns, system.rows);
  Scalar_multigrid<double>::Space<1> space(multigrid);

  Values expected, b(system.unknowns.size());
  for (const Mesh_unknown& u : system.unknowns)     // smooth, as a solution for a smooth right side
    expected.push_back(Value::all(std::sin(3 * hierarchy.point(u.vertex).x()) + hierarchy.point(u.vertex).y()));
  for (Index i = 0; i < b.size(); ++i)
    b[i] = system.rows.row_times(i, expected);
  const auto energy_of_error = [&] {
    Values error = expected;
    for (std::size_t i = 0; i < error.size(); ++i)
      error[i] -= space.solution(0)[i];
    double result = 0;
    for (Index i = 0; i < error.size(); ++i)
      result += error[i][0] * system.rows.row_times(i, error)[0];
    return std::sqrt(result);
  };
  space.solution(0).assign(b.size(), Value::zero());
  const double start = energy_of_error();
  space.right_side(0) = b;
  multigrid.cycle(space);
  const double by_cycle = energy_of_error();
  space.right_side(0) = b;
  multigrid.full_cycle(space);
  const double by_full_cycle = energy_of_error();
  EXPECT_LT(by_cycle, 0.5 * start);
  EXPECT_LT(by_full_cycle, 0.5 * by_cycle);
}

} // namespace test_multigrid
