// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Systems of both coordinates of vertices that are complex ones, as those of least squares conformal maps.

#include "hierarchies.h"
#include "mesh_conversions.h"
#include "multigrid_systems.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Complex.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Krylov_methods.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Scalar_multigrid.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/complex_rows.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace test_complex_systems {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace test_systems;
using internal::Complex;
using internal::complex_rows;
using internal::Mesh_unknown;
using internal::Scalar_multigrid;
using internal::Sparse_rows;

// The square of how far a map of a mesh is from a conformal one, less the rows of its first and last vertex: the
// coordinates of the others in turn are the unknowns.
Sparse_matrix conformal_matrix(const Flat_mesh& m)
{
  const Index last = Index(m.points.size()) - 1;
  Sparse_matrix result(2 * (last - 1));
  for (const auto& t : m.triangles) {
    const auto a = m.points[t[1]] - m.points[t[0]], b = m.points[t[2]] - m.points[t[0]];
    const double length = std::sqrt(a.squared_length()), x = a * b / length;
    const std::complex<double> p(length, 0), q(x, std::sqrt(b.squared_length() - x * x));
    const std::array<std::complex<double>, 3> weights = { q - p, -q, p };
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) {
        if (t[i] == 0 || t[k] == 0 || t[i] == last || t[k] == last)
          continue;
        const std::complex<double> value = std::conj(weights[i]) * weights[k];
        const int row = 2 * (int(t[i]) - 1), column = 2 * (int(t[k]) - 1);
        result.add_coef(row, column, value.real());
        result.add_coef(row + 1, column + 1, value.real());
        result.add_coef(row, column + 1, -value.imag());
        result.add_coef(row + 1, column, value.imag());
      }
  }
  return result;
}

// ---- numbers ----

TEST(Complex_numbers, quotients_are_right_at_any_size)
{
  for (const float size : { 1e-30f, 1.f, 1e30f }) {
    const Complex<float> a(3, -2), b(size, -0.5f * size), c = a / b * b;
    EXPECT_NEAR(c.re, a.re, 1e-5);
    EXPECT_NEAR(c.im, a.im, 1e-5);
  }
}

// ---- rows ----

TEST(Complex_rows, multiply_as_the_real_ones)
{
  const Sparse_rows<double> rows = *conformal_matrix(delaunay_patch(300, 2, wavy)).rows();
  const auto found = complex_rows(rows);
  ASSERT_TRUE(found);
  const Index n = found->number_of_rows();
  ASSERT_EQ(2 * n, rows.number_of_rows());
  EXPECT_LE(4 * found->values.size(), rows.values.size() + 2 * n);

  Random random(7);
  internal::Value_vector<double, 1> parts;
  internal::Value_vector<Complex<double>, 1> x;
  for (Index i = 0; i < n; ++i) {
    const Complex<double> value(random(-1, 1), random(-1, 1));
    x.push_back({ { value } });
    parts.push_back({ { value.re } });
    parts.push_back({ { value.im } });
  }
  for (Index i = 0; i < n; ++i) {
    const Complex<double> product = found->row_times(i, x)[0];
    EXPECT_NEAR(product.re, rows.row_times(2 * i, parts)[0], 1e-12);
    EXPECT_NEAR(product.im, rows.row_times(2 * i + 1, parts)[0], 1e-12);
  }
}

TEST(Complex_rows, there_are_none_where_the_plane_must_not_be_turned)
{
  const Flat_mesh m = delaunay_patch(300, 2, wavy);
  const Sparse_rows<double> right = *conformal_matrix(m).rows();
  const Index in_the_middle = right.first[right.number_of_rows() / 2];
  for (const Index entry : { in_the_middle, in_the_middle + 1 })
    for (const double change : { 1e-9, 1., -1e300, std::nan("") }) {
      Sparse_rows<double> wrong = right;
      wrong.values[entry] += change;
      EXPECT_FALSE(complex_rows(wrong)) << change;
    }
  EXPECT_FALSE(complex_rows(*edge_matrix(m, Uniform_edge_weights_3()).rows()));      // one unknown at a vertex
  EXPECT_FALSE(complex_rows(*edge_matrix(grid(4, 4, wavy), Uniform_edge_weights_3()).rows()));    // an odd number
  EXPECT_FALSE(complex_rows(Sparse_rows<double>()));
}

// ---- solvers ----

void expect_solution(const Sparse_rows<double>& rows)
{
  const std::size_t n = rows.number_of_rows();
  const auto solver = internal::factorize_as_complex(rows);
  ASSERT_TRUE(solver);
  Random random(5);
  std::vector<double> expected, b, x(2 * n);
  for (std::size_t i = 0; i < 2 * n; ++i)
    expected.push_back(random(-1, 1));
  for (std::size_t c : { 0, 1 })      // two right sides
    for (Index i = 0; i < n; ++i) {
      double sum = 0;
      rows.for_each_entry(i, [&](Index column, double value) { sum += value * expected[c * n + column]; });
      b.push_back(sum);
    }
  solver->solve(b.data(), x.data(), 2);
  for (std::size_t i = 0; i < 2 * n; ++i)
    EXPECT_NEAR(x[i], expected[i], 1e-8);
}

TEST(Hermitian_factorization, solves_for_parts_in_turn_at_any_scale)
{
  for (const double scale : { 1e-300, 1., 1e290 }) {
    SCOPED_TRACE(scale);
    Sparse_rows<double> rows = *conformal_matrix(delaunay_patch(300, 2, wavy)).rows();
    for (double& value : rows.values)
      value *= scale;
    expect_solution(rows);
  }
}

TEST(Hermitian_factorization, takes_symmetric_matrices_that_are_not_complex)
{
  const std::size_t n = 20;
  Sparse_matrix second_differences(n);
  for (std::size_t i = 0; i < n; ++i) {
    second_differences.set_coef(i, i, 2);
    if (i > 0) {
      second_differences.set_coef(i, i - 1, -1);
      second_differences.set_coef(i - 1, i, -1);
    }
  }
  const Sparse_rows<double> rows = *second_differences.rows();
  ASSERT_FALSE(complex_rows(rows));
  const auto solver = internal::factorize_as_complex(rows);
  ASSERT_TRUE(solver);
  const std::vector<double> b(n, 1);
  std::vector<double> x(n);
  solver->solve(b.data(), x.data(), 1);
  for (Index i = 0; i < n; ++i) {
    double sum = 0;
    rows.for_each_entry(i, [&](Index column, double value) { sum += value * x[column]; });
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

// As a preconditioner of conjugate gradients must be, and linear for complex factors.
// One for each row of complex_rows() of its matrix.
std::vector<Mesh_unknown> unknowns_of(const Flat_mesh& m, const Collapse_hierarchy_3& hierarchy)
{
  std::vector<Index> rank_of(m.points.size());
  for (Index rank = 0; rank < m.points.size(); ++rank)
    rank_of[hierarchy.input_vertex(rank)] = rank;
  std::vector<Mesh_unknown> result;
  for (Index v = 1; v + 1 < m.points.size(); ++v)
    result.push_back({ rank_of[v], 0 });
  return result;
}

// With default options, this many unknowns are the coarsest grid, and enough for parts of their own.
TEST(Complex_multigrid, solves_the_coarsest_grid)
{
  typedef internal::Value_vector<Complex<double>, 1>    Vector;
  const Flat_mesh m = grid(60, 60, wavy);
  const Collapse_hierarchy_3 hierarchy = hierarchy_of(m);
  const std::vector<Mesh_unknown> unknowns = unknowns_of(m, hierarchy);
  ASSERT_GT(unknowns.size(), internal::Row_parts_options().least_rows);
  const auto rows = complex_rows(*conformal_matrix(m).rows());
  ASSERT_TRUE(rows);
  const Scalar_multigrid<Complex<double>> multigrid(hierarchy, unknowns, *rows, {},
                                                    internal::complex_multigrid_options());
  ASSERT_TRUE(multigrid.is_ready());
  Scalar_multigrid<Complex<double>>::Space<1> space(multigrid);
  ASSERT_TRUE(space.is_coarsest(0));
  Random random(9);
  Vector b;
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    b.push_back({ { { random(-1, 1), random(-1, 1) } } });
  space.right_side(0) = b;
  multigrid.cycle(space);
  double error = 0;
  for (Index k = 0; k < unknowns.size(); ++k) {
    const Complex<double> expected = b[k][0], found = rows->row_times(k, space.solution(0))[0];
    error = (std::max)({ error, std::abs(found.re - expected.re), std::abs(found.im - expected.im) });
  }
  EXPECT_LT(error, 1e-9);
}

TEST(Complex_multigrid, cycle_is_hermitian_positive_and_complex_linear)
{
  typedef internal::Values<Complex<double>, 1>          Value;
  typedef internal::Value_vector<Complex<double>, 1>    Vector;
  const Flat_mesh m = delaunay_patch(3000, 2, wavy);
  const Collapse_hierarchy_3 hierarchy = hierarchy_of(m);
  const std::vector<Mesh_unknown> unknowns = unknowns_of(m, hierarchy);
  internal::Scalar_multigrid_options options = internal::complex_multigrid_options();
  options.coarsest_size = 300;
  auto rows = complex_rows(*conformal_matrix(m).rows());
  ASSERT_TRUE(rows);
  const Scalar_multigrid<Complex<double>> multigrid(hierarchy, unknowns, std::move(*rows), {}, options);
  ASSERT_TRUE(multigrid.is_ready());

  Scalar_multigrid<Complex<double>>::Space<1> space(multigrid);
  ASSERT_FALSE(space.is_coarsest(1));
  const auto cycle = [&](const Vector& b) {
    space.right_side(0) = b;
    multigrid.cycle(space);
    return space.solution(0);
  };
  const auto product = [](const Vector& a, const Vector& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += inner_product(a[i][0], b[i][0]);
    return sum;
  };
  Random random(3);
  Vector x, y, turned;
  const Complex<double> i(0, 1);
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    x.push_back({ { { random(-1, 1), random(-1, 1) } } });
    y.push_back({ { { random(-1, 1), random(-1, 1) } } });
    turned.push_back(Value::all(i * x.back()[0]));
  }
  const Vector cycle_x = cycle(x), cycle_y = cycle(y), cycle_turned = cycle(turned);
  const double xx = product(cycle_x, x), yy = product(cycle_y, y);
  EXPECT_GT(xx, 0);
  EXPECT_GT(yy, 0);
  EXPECT_NEAR(product(cycle_x, y), product(x, cycle_y), 1e-11 * std::sqrt(xx * yy));
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const Complex<double> expected = i * cycle_x[k][0];
    EXPECT_NEAR(cycle_turned[k][0].re, expected.re, 1e-9 * std::sqrt(xx));
    EXPECT_NEAR(cycle_turned[k][0].im, expected.im, 1e-9 * std::sqrt(xx));
  }
}

} // namespace test_complex_systems
