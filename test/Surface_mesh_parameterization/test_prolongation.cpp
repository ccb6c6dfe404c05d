// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Where a hierarchy puts the vertices of a level between those of a coarser one.

#include "hierarchies.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Pruned_prolongation.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>

#include <Eigen/SparseCore>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace test_prolongation {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef Eigen::SparseMatrix<double, Eigen::RowMajor>   Matrix;

TEST(Prolongation, rows_are_barycentric_coordinates)
{
  for_each_hierarchy([](const Flat_mesh&, const Collapse_hierarchy_3& h) {
    const Matrix p = h.prolongation(0, h.number_of_levels() - 1);
    ASSERT_EQ(std::size_t(p.rows()), h.number_of_vertices());
    ASSERT_EQ(std::size_t(p.cols()), h.number_of_vertices(0));
    for (int row = 0; row < p.rows(); ++row) {
      double sum = 0;
      for (Matrix::InnerIterator entry(p, row); entry; ++entry) {
        EXPECT_GE(entry.value(), 0);
        sum += entry.value();
      }
      EXPECT_NEAR(sum, 1, 1e-13);
      EXPECT_TRUE(row >= p.cols() || p.coeff(row, row) == 1);
    }
  });
}

TEST(Prolongation, over_several_levels_is_the_product)
{
  for_each_hierarchy([](const Flat_mesh&, const Collapse_hierarchy_3& h) {
    const std::size_t finest = h.number_of_levels() - 1;
    Matrix product = h.prolongation(0, 0);
    for (std::size_t level = 0; level < finest; ++level)
      product = (h.prolongation(level, level + 1) * product).pruned(0., 1.);
    EXPECT_NEAR((product - h.prolongation(0, finest)).norm(), 0, 1e-13);
  });
}

TEST(Prolongation, from_a_level_to_itself_is_the_identity)
{
  const Collapse_hierarchy_3 h = small_hierarchy(grid(12, 9, wavy));
  for (std::size_t level = 0; level < h.number_of_levels(); ++level) {
    Matrix identity(int(h.number_of_vertices(level)), int(h.number_of_vertices(level)));
    identity.setIdentity();
    EXPECT_EQ((h.prolongation(level, level) - identity).norm(), 0);
  }
}

// The exponential map of an interior vertex of a planar mesh is an isometry: the vertex is the barycentric combination
// of its parents.
TEST(Prolongation, of_a_planar_mesh_reproduces_linear_functions_inside)
{
  for (const Flat_mesh& m : { grid(15, 15, flat), delaunay_patch(500, 3, flat) }) {
    const Collapse_hierarchy_3 h = small_hierarchy(m);
    const One_rings input(m.points.size(), m.triangles);
    std::size_t interior = 0;
    for (Index v = Index(h.number_of_vertices(0)); v < h.number_of_vertices(); ++v) {
      if (input.is_border(h.input_vertex(v)))
        continue;
      ++interior;
      const Index_triangle& parent = h.parent_triangle(v);
      const std::array<double, 3> c = h.barycentric_coordinates(v);
      const Point_3 combination =
          CGAL::barycenter(h.point(parent[0]), c[0], h.point(parent[1]), c[1], h.point(parent[2]), c[2]);
      EXPECT_NEAR(std::sqrt(CGAL::squared_distance(combination, h.point(v))), 0, 1e-12);
    }
    EXPECT_GT(interior, 150u);
  }
}

TEST(Prolongation, along_the_border_is_by_arc_length)
{
  const Flat_mesh m = grid(15, 15, wavy);
  const Collapse_hierarchy_3 h = small_hierarchy(m);
  const One_rings input(m.points.size(), m.triangles);
  for (std::size_t level = 1; level < h.number_of_levels(); ++level) {
    const One_rings rings(h.number_of_vertices(level), triangles_of_level(h, level));
    for (Index v = Index(h.number_of_vertices(level - 1)); v < h.number_of_vertices(level); ++v)
      if (rings.is_border(v)) {
        const Index kept = h.kept_vertex(v), other = rings[v].front() == kept ? rings[v].back() : rings[v].front();
        const double to_kept = std::sqrt(CGAL::squared_distance(h.point(v), h.point(kept)));
        const double to_other = std::sqrt(CGAL::squared_distance(h.point(v), h.point(other)));
        EXPECT_NEAR(h.barycentric_coordinates(v)[0], to_other / (to_kept + to_other), 1e-12);
      }
  }
}

// ---- what solvers keep of it ----

// The solver works with the interpolation alone: it must put every vertex where the hierarchy does, to single
// precision.
TEST(Hierarchy_interpolation, has_the_levels_and_the_prolongation_of_its_hierarchy)
{
  const Collapse_hierarchy_3 hierarchy = hierarchy_of(delaunay_patch(300, 5, wavy));
  const Hierarchy_interpolation interpolation(hierarchy);
  ASSERT_GT(hierarchy.number_of_levels(), 4u);
  ASSERT_EQ(interpolation.number_of_levels(), hierarchy.number_of_levels());
  for (std::size_t level = 0; level < hierarchy.number_of_levels(); ++level)
    EXPECT_EQ(interpolation.number_of_vertices(level), hierarchy.number_of_vertices(level));
  EXPECT_EQ(interpolation.number_of_vertices(), hierarchy.number_of_vertices());
  for (Index v = 0; v < hierarchy.number_of_vertices(); ++v) {
    EXPECT_EQ(interpolation.input_vertex(v), hierarchy.input_vertex(v));
    if (v < hierarchy.number_of_vertices(0))
      continue;
    EXPECT_EQ(interpolation.parent_triangle(v), hierarchy.parent_triangle(v));
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(interpolation.barycentric_coordinates(v)[k], hierarchy.barycentric_coordinates(v)[k], 1e-6);
      EXPECT_GE(interpolation.barycentric_coordinates(v)[k], 0);
      sum += interpolation.barycentric_coordinates(v)[k];
    }
    EXPECT_NEAR(sum, 1, 1e-6);
  }
}

TEST(Pruned_prolongation, rows_are_weights)
{
  const Finest_level f(grid(20, 20, wavy), parameters::coarsest_size(20));
  const std::size_t finest = f.hierarchy.number_of_levels() - 1;
  for (std::size_t groups = 1; groups <= finest; ++groups) {
    const Pruned_prolongation p(f.hierarchy, finest - groups, finest, Loops());
    ASSERT_EQ(p.fine_size(), f.hierarchy.number_of_vertices());
    ASSERT_EQ(p.coarse_size(), f.hierarchy.number_of_vertices(finest - groups));
    std::size_t entries = 0;
    for (Index v = 0; v < p.coarse_size(); ++v) {
      EXPECT_EQ(p.row(v).columns[0], v);
      EXPECT_EQ(p.row(v).weights[0], 1);
    }
    for (Index v = 0; v < p.fine_size(); ++v) {
      double sum = 0;
      for (int k = 0; k < Pruned_prolongation::row_size; ++k) {
        EXPECT_GE(p.row(v).weights[k], 0);
        EXPECT_LT(p.row(v).columns[k], p.coarse_size());
        sum += p.row(v).weights[k];
        entries += p.row(v).weights[k] != 0;
      }
      EXPECT_NEAR(sum, 1, 4 * double(std::numeric_limits<std::decay_t<decltype(p.row(v).weights[0])>>::epsilon()));
    }
    const Pruned_prolongation::Transpose transpose = p.transposed();
    for (Index v = 0; v < p.coarse_size(); ++v) {
      EXPECT_EQ(transpose[v].front().row, v);
      entries -= transpose[v].size();
      for (const auto& [row, weight] : transpose[v]) {
        const Pruned_prolongation::Row r = p.row(row);
        EXPECT_EQ(weight, r.weights[std::find(r.columns.begin(), r.columns.end(), v) - r.columns.begin()]);
      }
    }
    EXPECT_EQ(entries, 0u);
  }
}

// In a plane, rows that are pruned to triangles put every vertex where the whole prolongation does; a border vertex,
// whose row has border vertices only, may have none that make a triangle.
TEST(Pruned_prolongation, in_triangles_keeps_linear_functions)
{
  const Finest_level f(delaunay_patch(2000, 3, flat), parameters::coarsest_size(20));
  const std::size_t finest = f.hierarchy.number_of_levels() - 1;
  const Hierarchy_interpolation interpolation(f.hierarchy);
  for (std::size_t groups = 2; groups <= 6; ++groups) {
    const Pruned_prolongation greatest(f.hierarchy, finest - groups, finest, Loops()),
        triangles(f.hierarchy, finest - groups, finest, Loops(), Pruning::TRIANGLE),
        rounded(interpolation, finest - groups, finest, Loops(), Pruning::TRIANGLE);
    const auto squared_error = [&](const Pruned_prolongation& p, Index v) {
      const Point_3& q = f.hierarchy.point(v);
      Vector_3 error(0, 0, 0);
      for (int k = 0; k < Pruned_prolongation::row_size; ++k)
        error = error + double(p.row(v).weights[k]) * (f.hierarchy.point(p.row(v).columns[k]) - q);
      return error.squared_length();
    };
    std::size_t kept = 0, interior = 0;
    double error_of_greatest = 0, error_of_triangles = 0;
    for (Index v = 0; v < triangles.fine_size(); ++v) {
      if (f.level.is_border(v))
        continue;
      ++interior;
      kept += squared_error(triangles, v) < 1e-12 && squared_error(rounded, v) < 1e-12;
      error_of_greatest += squared_error(greatest, v);
      error_of_triangles += squared_error(triangles, v);
    }
    EXPECT_GT(double(kept), 0.9 * double(interior));
    EXPECT_LT(error_of_triangles, 0.1 * error_of_greatest);
  }
}

} // namespace test_prolongation
