// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Floors 3 and 4: from a map of a level to a better one.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Progressive_mesh_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/insert_new_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/scale_to_area.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_refiner.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_multigrid.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Vertex_relaxation.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/corner_hessian.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <CGAL/property_map.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

// A mesh and the finest level of its hierarchy.
struct Finest_level
{
  Collapse_hierarchy_3 hierarchy;
  Progressive_mesh_3 mesh;
  Level level;

  template <class NamedParameters>
  Finest_level(const Flat_mesh& m, const NamedParameters& np)
    : hierarchy(surface(m), np), mesh(walked_up(hierarchy)), level(mesh, hierarchy.number_of_levels() - 1)
  { }

  // A hierarchy of one level.
  explicit Finest_level(const Flat_mesh& m) : Finest_level(m, parameters::coarsest_size((std::numeric_limits<std::size_t>::max)())) { }

  Finest_level(const Finest_level&) = delete;

private:
  static Progressive_mesh_3 walked_up(const Collapse_hierarchy_3& hierarchy)
  {
    Progressive_mesh_3 result(hierarchy);
    result.walk_to_level(hierarchy.number_of_levels() - 1);
    return result;
  }
};

// Tutte's map with the surface's area.
Level::Uv first_map(const Level& level)
{
  Level::Uv uv;
  EXPECT_EQ(Tutte_embedding::compute(level, uv), OK);
  scale_to_area(level, uv);
  return uv;
}

// The map of a planar mesh to itself.
Level::Uv identity_map(const Level& level)
{
  Level::Uv uv;
  for (Index v = 0; v < level.number_of_vertices(); ++v)
    uv.push_back(Point_2(level.point(v).x(), level.point(v).y()));
  return uv;
}

Singular_values singular_values_of(const Level& level, const Level::Uv& uv, const Index_triangle& t)
{
  return singular_values(level.point(t[0]), level.point(t[1]), level.point(t[2]), uv[t[0]], uv[t[1]], uv[t[2]]);
}

template <class Energy>
double energy_of(const Singular_values& s) { return Energy().value(s.greatest * s.greatest + s.least * s.least, s.determinant); }

template <class Energy>
class Energy_of_level : public testing::Test { };
typedef testing::Types<MIPS_energy_2, Symmetric_Dirichlet_energy_2> Energies;
typedef testing::Types<MIPS_energy_2, Symmetric_Dirichlet_energy_2, As_rigid_as_possible_energy_2> All_energies;     // some let triangles flip
TYPED_TEST_SUITE(Energy_of_level, Energies, );

template <class Energy>
class Relaxation_of : public testing::Test { };
TYPED_TEST_SUITE(Relaxation_of, Energies, );

template <class Energy>
class Newton_of : public testing::Test { };
TYPED_TEST_SUITE(Newton_of, All_energies, );

// ---- Tutte's map ----

TEST(Tutte_embedding, is_valid)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    const Finest_level f(m);
    Level::Uv uv;
    ASSERT_EQ(Tutte_embedding::compute(f.level, uv), OK);
    EXPECT_TRUE(is_map_valid(f.level.rings(), uv));
    for (Index v = 0; v < f.level.number_of_vertices(); ++v) {
      const double radius2 = (uv[v] - CGAL::ORIGIN).squared_length();
      if (f.hierarchy.is_on_outer_border(v))
        EXPECT_NEAR(radius2, 1, 1e-14);
      else
        EXPECT_LT(radius2, 1);
    }
  }
}

TEST(Tutte_embedding, puts_interior_vertices_into_the_middle_of_their_neighbors)
{
  const Finest_level f(grid_with_holes(20));
  Level::Uv uv;
  ASSERT_EQ(Tutte_embedding::compute(f.level, uv), OK);
  for (Index v = 0; v < f.level.number_of_vertices(); ++v)
    if (!f.level.is_border(v)) {
      Vector_2 sum(0, 0);
      for (const Index w : f.level.one_ring(v))
        sum = sum + (uv[w] - uv[v]);
      EXPECT_NEAR(sum.squared_length(), 0, 1e-24);
    }
}

// ---- the energy of a level ----

TYPED_TEST(Energy_of_level, is_the_sum_over_the_triangles)
{
  for (const Flat_mesh& m : { grid(12, 9, wavy), crumpled_grid(14, 1), delaunay_patch(400, 2, wavy), grid_with_holes(20), strip(20), three_ears() }) {
    const Finest_level f(m);
    const Level::Uv uv = first_map(f.level);
    double sum = 0, weighted = 0, area = 0;
    for (const Index_triangle& t : f.level.triangles()) {
      const Singular_values s = singular_values_of(f.level, uv, t);
      sum += energy_of<TypeParam>(s);
      weighted += s.area * energy_of<TypeParam>(s);
      area += s.area;
    }
    const Level_energy<TypeParam> one(f.level, Triangle_weight::ONE), by_area(f.level, Triangle_weight::AREA);
    EXPECT_NEAR(one(uv) / sum, 1, 1e-9);
    EXPECT_NEAR(by_area(uv) / weighted, 1, 1e-9);
    EXPECT_DOUBLE_EQ(one.total_weight(), double(m.triangles.size()));
    EXPECT_NEAR(by_area.total_weight() / area, 1, 1e-10);
  }
}

TYPED_TEST(Energy_of_level, is_infinite_exactly_if_a_triangle_is_not_positive)
{
  const Finest_level f(grid(5, 5, wavy));
  const Level_energy<TypeParam> energy(f.level, Triangle_weight::ONE);
  Level::Uv uv = first_map(f.level);
  EXPECT_TRUE(std::isfinite(energy(uv)));
  std::swap(uv[0], uv[1]);
  EXPECT_EQ(energy(uv), std::numeric_limits<double>::infinity());
  std::fill(uv.begin(), uv.end(), Point_2(0, 0));
  EXPECT_EQ(energy(uv), std::numeric_limits<double>::infinity());
}

TYPED_TEST(Energy_of_level, is_least_for_an_isometry)
{
  const Finest_level f(delaunay_patch(400, 2, flat));
  const Level_energy<TypeParam> energy(f.level, Triangle_weight::AREA);
  const double minimum = TypeParam::minimum * energy.total_weight();
  EXPECT_NEAR(energy(identity_map(f.level)) / minimum, 1, 1e-9);
  EXPECT_GT(energy(first_map(f.level)) / minimum, 1.001);
}

// ---- vertex relaxation ----

TYPED_TEST(Relaxation_of, sweeps_lower_the_energy_by_exactly_what_they_return)
{
  for (const auto& [name, m] : named_meshes())
    for (const Triangle_weight weight : { Triangle_weight::ONE, Triangle_weight::AREA }) {
      SCOPED_TRACE(name);
      const Finest_level f(m);
      const Level_energy<TypeParam> energy(f.level, weight);
      Vertex_relaxation<TypeParam> relaxation(energy, 1.5);
      Level::Uv uv = first_map(f.level);
      std::mt19937 random(0);
      double before = energy(uv);
      for (int i = 0; i < 12; ++i) {
        const double decrease = i % 4 == 3 ? relaxation.random_steps(uv, uv.size(), random) : relaxation.sweep(uv), after = energy(uv);
        EXPECT_GE(decrease, 0);
        EXPECT_NEAR(before - after, decrease, 1e-9 * before);
        EXPECT_TRUE(is_map_valid(f.level.rings(), uv));
        before = after;
      }
    }
}

// One vertex of a map that is almost an isometry sits close to a neighbor: a sweep moves it a part of the way back.
TYPED_TEST(Relaxation_of, follows_up_where_a_sweep_is_not_enough)
{
  const Finest_level f(grid(20, 20, flat));
  const Level_energy<TypeParam> energy(f.level, Triangle_weight::ONE);
  const Vertex_relaxation<TypeParam> relaxation(energy, 1.8);
  Level::Uv start = identity_map(f.level);
  Index displaced = 0;
  while (f.level.is_border(displaced))
    ++displaced;
  const Point_2 neighbor = start[f.level.one_ring(displaced).front()];
  start[displaced] = neighbor + 1e-4 * (start[displaced] - neighbor);
  const double minimum = TypeParam::minimum * energy.total_weight(), least_decrease = 1e-6 * (energy(start) - minimum);

  Level::Uv swept = start, followed_up = start, not_followed_up = start;
  relaxation.sweep(swept);
  const auto effect = relaxation.sweep_and_follow_up(followed_up, least_decrease);
  EXPECT_FALSE(effect.lively_vertices.empty());
  EXPECT_NEAR(energy(start) - energy(followed_up), effect.decrease, 1e-9 * energy(start));
  EXPECT_LT(energy(followed_up) - minimum, 0.1 * (energy(swept) - minimum));
  EXPECT_TRUE(is_map_valid(f.level.rings(), followed_up));
  EXPECT_GT(effect.visits, start.size());
  EXPECT_LE(effect.visits, start.size() + start.size() / 4);

  EXPECT_EQ(relaxation.sweep_and_follow_up(not_followed_up, energy(start)).visits, start.size());
  EXPECT_EQ(not_followed_up, swept);
}

TYPED_TEST(Relaxation_of, moves_the_vertices_it_is_told_to)
{
  const Finest_level f(grid(12, 9, wavy), parameters::coarsest_size(20));
  const Level_energy<TypeParam> energy(f.level, Triangle_weight::ONE);
  const Vertex_relaxation<TypeParam> relaxation(energy, 1);
  const Level::Uv start = first_map(f.level);
  for (std::size_t group = 0; group <= f.level.index(); ++group) {
    const std::size_t first = group == 0 ? 0 : f.hierarchy.number_of_vertices(group - 1), last = f.hierarchy.number_of_vertices(group);
    Level::Uv uv = start;
    relaxation.sweep_group(group, uv);
    for (std::size_t v = 0; v < uv.size(); ++v)
      EXPECT_EQ(uv[v] != start[v], first <= v && v < last);
  }
}

TYPED_TEST(Relaxation_of, leaves_pinned_vertices)
{
  const Flat_mesh m = grid(5, 5, wavy);
  const Finest_level f(m, parameters::coarsest_size(1000).vertex_is_constrained_map(CGAL::Constant_property_map<std::size_t, bool>(true)));
  const Level_energy<TypeParam> energy(f.level, Triangle_weight::ONE);
  Vertex_relaxation<TypeParam> relaxation(energy, 1);
  const Level::Uv start = first_map(f.level);
  Level::Uv uv = start;
  EXPECT_EQ(relaxation.sweep(uv), 0);
  EXPECT_EQ(uv, start);
}

// ---- Newton's method ----

// Triangles in space and in the plane, among them isometries and similarities.
struct Random_triangle
{
  std::array<Point_3, 3> p;
  std::array<Point_2, 3> q;

  Random_triangle(int kind, Random& random)
  {
    for (Point_3& point : p) {
      const double x = random(-1, 1), y = random(-1, 1);
      point = Point_3(x, y, kind > 0 ? 0 : random(-1, 1));
    }
    const double angle = random(0, 6), scale = kind == 2 ? random(0.5, 2) : 1;
    for (int i = 0; i < 3; ++i)
      q[i] = kind > 0 ? Point_2(scale * (p[i].x() * std::cos(angle) - p[i].y() * std::sin(angle)), scale * (p[i].x() * std::sin(angle) + p[i].y() * std::cos(angle)))
                      : Point_2(random(-1, 1), p[i].z() * random(0.1, 1));
    if (!is_left_turn(q[0], q[1], q[2])) {
      std::swap(q[0], q[1]);
      if (kind > 0)
        std::swap(p[0], p[1]);
    }
  }

  // Row i of the Hessian by its blocks for the corners i, i + 1, i + 2, and the gradient.
  template <class Energy>
  Corner_hessian corner(int i) const
  {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    return corner_hessian(Energy(), rest_corner(p[i], p[a], p[b]), 1.5, q[a] - q[i], q[b] - q[i]);
  }

  template <class Energy>
  Star<Energy> star(int i) const
  {
    const One_rings rings(3, { { 0, 1, 2 } });
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    const Rest_corner c = rest_corner(p[i], p[a], p[b]);
    Star<Energy> result;
    result.gather(rings, { q[i], q[a], q[b] }, 0, &c, Triangle_weight::ONE);
    return result;
  }

  // Well shaped in space and in the plane.
  bool is_fat() const
  {
    for (int i = 0; i < 3; ++i) {
      const Vector_2 ab = q[(i + 2) % 3] - q[(i + 1) % 3];
      if (rest_corner(p[i], p[(i + 1) % 3], p[(i + 2) % 3]).height < 0.2 || cross(ab, q[i] - q[(i + 1) % 3]) < 0.2 * ab.squared_length())
        return false;
    }
    return true;
  }
};

TYPED_TEST(Newton_of, gradient_is_that_of_the_star)
{
  Random random(1);
  for (int k = 0; k < 600; ++k) {
    const Random_triangle t(k % 3, random);
    if (!t.is_fat())
      continue;
    for (int i = 0; i < 3; ++i) {
      const auto d = t.star<TypeParam>(i).derivatives(t.q[i]);
      const Corner_hessian h = t.corner<TypeParam>(i);
      for (int e = 0; e < 2; ++e)
        EXPECT_NEAR(h.gradient[e], 1.5 * d.gradient[e], 1e-9 * (d.value + std::abs(d.hessian[0]) + std::abs(d.hessian[2])));
    }
  }
}

TYPED_TEST(Newton_of, hessian_is_exact_at_an_isometry)
{
  Random random(2);
  for (int k = 0; k < 300; ++k) {
    const Random_triangle t(1, random);
    if (!t.is_fat())
      continue;
    for (int i = 0; i < 3; ++i) {
      const auto d = t.star<TypeParam>(i).derivatives(t.q[i]);
      const Corner_hessian h = t.corner<TypeParam>(i);
      const double tolerance = 1e-8 * (d.hessian[0] + d.hessian[2]);
      EXPECT_NEAR(h.to_v(0, 0), 1.5 * d.hessian[0], tolerance);
      EXPECT_NEAR(h.to_v(0, 1), 1.5 * d.hessian[1], tolerance);
      EXPECT_NEAR(h.to_v(1, 0), 1.5 * d.hessian[1], tolerance);
      EXPECT_NEAR(h.to_v(1, 1), 1.5 * d.hessian[2], tolerance);
    }
  }
}

TYPED_TEST(Newton_of, hessian_is_symmetric_and_positive_semidefinite)
{
  Random random(3);
  for (int k = 0; k < 600; ++k) {
    const Random_triangle t(k % 3, random);
    if (!t.is_fat())
      continue;
    Eigen::Matrix<double, 6, 6> hessian;
    for (int i = 0; i < 3; ++i) {
      const Corner_hessian h = t.corner<TypeParam>(i);
      hessian.block<2, 2>(2 * i, 2 * i) = h.to_v;
      hessian.block<2, 2>(2 * i, 2 * ((i + 2) % 3)) = h.to_b;
      hessian.block<2, 2>(2 * i, 2 * ((i + 1) % 3)) = -h.to_v - h.to_b;
    }
    EXPECT_NEAR((hessian - hessian.transpose()).norm(), 0, 1e-9 * hessian.norm());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(hessian);
    EXPECT_GE(solver.eigenvalues()[0], -1e-9 * solver.eigenvalues()[5]);
  }
}

TYPED_TEST(Newton_of, steps_lower_the_energy_by_exactly_what_they_return)
{
  for (const Flat_mesh& m : { grid(12, 9, wavy), grid_with_holes(20), delaunay_patch(400, 2, wavy), deep_cap(), folded_fan(), strip(20) }) {
    const Finest_level f(m);
    const Level_energy<TypeParam> energy(f.level, Triangle_weight::AREA);
    Newton_multigrid<TypeParam> newton(energy);
    Level::Uv uv = first_map(f.level);
    for (int i = 0; i < 10; ++i) {
      const double before = energy(uv);
      const auto step = newton.step(uv, before, 0.1);
      EXPECT_GE(step.decrease, 0);
      EXPECT_NEAR(before - energy(uv), step.decrease, 1e-12 * before);
      EXPECT_TRUE(!TypeParam::is_flip_free || is_map_valid(f.level.rings(), uv));
    }
  }
}

TYPED_TEST(Newton_of, finds_the_same_minimum_as_relaxation)
{
  for (const Flat_mesh& m : { grid(12, 9, wavy), disk_with_hole(), hemisphere() }) {
    const Finest_level f(m);
    Refinement_options options;
    options.triangle_weight = Triangle_weight::AREA;
    options.number_of_iterations = 3000;
    options.tolerance = 1e-9;
    double energy[2];
    for (int i = 0; i < 2; ++i) {
      options.optimizer = i == 0 ? Optimizer::NEWTON : Optimizer::SWEEPS;
      Level::Uv uv = first_map(f.level);
      Level_summary summary;
      Level_refiner<TypeParam>(f.level, uv, options, summary).run();
      EXPECT_TRUE(summary.converged);
      energy[i] = summary.energy_end;
    }
    EXPECT_NEAR((energy[0] - TypeParam::minimum) / (energy[1] - TypeParam::minimum), 1, 1e-4);
  }
}

// ---- loops ----

// The blocks are computed at once, and the result of each one counts.
TEST(Loops, least_and_sum_see_every_index)
{
  const Loops loops = Loops::of<CGAL::Parallel_if_available_tag>();
  constexpr Index n = 300000;
  for (int i = 0; i < 300; ++i)
    for (const Index bad : { Index(0), Index(997 * i), n - 1 })
      ASSERT_FALSE(loops.min(0, n, true, [&](Index k) { return k != bad; }));
  EXPECT_TRUE(loops.min(0, n, true, [](Index) { return true; }));
  EXPECT_EQ(loops.sum(3, n, 0., [](Index k) { return double(k); }), 0.5 * n * (n - 1.) - 3);
  EXPECT_EQ(loops.sum(5, 5, 0., [](Index) { return 7.; }), 0);
}

// ---- multigrid ----

// A random symmetric, diagonally dominant matrix with the pattern of a level's edges; and the same one, unscaled and dense.
struct Random_matrix
{
  Block_matrix matrix;
  Eigen::MatrixXd dense;

  Random_matrix(const Level& level, Random& random) : dense(Eigen::MatrixXd::Zero(2 * level.number_of_vertices(), 2 * level.number_of_vertices()))
  {
    const One_rings& rings = level.rings();
    matrix.set_pattern(rings.number_of_vertices(), rings.offsets(), rings.neighbors());
    for (Index v = 0; v < rings.number_of_vertices(); ++v)
      for (const Index w : rings[v])
        for (int e = 0; e < 4 && v < w; ++e)
          dense(2 * v + e / 2, 2 * w + e % 2) = dense(2 * w + e % 2, 2 * v + e / 2) = random(-1, 1);
    for (int i = 0; i < dense.rows(); ++i)
      dense(i, i) = 0.1 + dense.row(i).cwiseAbs().sum();
    for (Index v = 0; v < rings.number_of_vertices(); ++v) {
      matrix.set_diagonal(v, dense.block<2, 2>(2 * v, 2 * v));
      for (Index k = matrix.first[v]; k < matrix.first[v + 1]; ++k)
        matrix.blocks[k] = dense.block<2, 2>(2 * v, 2 * matrix.columns[k]);
    }
  }
};

Eigen::MatrixXd unscaled(const Block_matrix& a)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(2 * a.number_of_rows(), 2 * a.number_of_rows());
  for (Index i = 0; i < a.number_of_rows(); ++i) {
    result.block<2, 2>(2 * i, 2 * i) = a.unscaled_diagonal_block(i);
    for (Index k = a.first[i]; k < a.first[i + 1]; ++k)
      result.block<2, 2>(2 * i, 2 * a.columns[k]) = a.blocks[k] / (a.scale[i] * a.scale[a.columns[k]]);
  }
  return result;
}

Pair_vector random_pairs(std::size_t n, Random& random)
{
  Pair_vector result(n);
  for (Pair& pair : result)
    pair = { random(-1, 1), random(-1, 1) };
  return result;
}

TEST(Block_matrix, is_scaled_to_diagonal_blocks_of_trace_2)
{
  Random random(4);
  const Finest_level f(grid(5, 5, wavy));
  Random_matrix a(f.level, random);
  a.matrix.scale_blocks(Loops());
  EXPECT_NEAR((unscaled(a.matrix) - a.dense).norm(), 0, 1e-12 * a.dense.norm());
  for (Index i = 0; i < a.matrix.number_of_rows(); ++i) {
    EXPECT_NEAR(a.matrix.diagonal_block(i).trace(), 2, 1e-14);
  }
}

TEST(Block_matrix, relaxes_a_group_at_once_as_one_by_one)
{
  Random random(8);
  const Finest_level f(grid(20, 20, wavy), parameters::coarsest_size(20));
  Random_matrix a(f.level, random);
  a.matrix.scale_blocks(Loops());
  const Pair_vector b = random_pairs(f.level.number_of_vertices(), random);
  Pair_vector x = random_pairs(f.level.number_of_vertices(), random), y = x, z = x, scratch;
  for (std::size_t l = 1; l <= f.level.index(); ++l) {
    const Index begin = Index(f.hierarchy.number_of_vertices(l - 1)), end = Index(f.hierarchy.number_of_vertices(l));
    a.matrix.relax_forward(begin, end, b, x);
    a.matrix.relax_backward(begin, end, b, y);
    a.matrix.relax_at_once(Loops(), begin, end, b, z, scratch);
    EXPECT_EQ(x, y);
    EXPECT_EQ(x, z);
    for (Index i = begin; i < end; ++i)
      EXPECT_NEAR((a.matrix.row_times(i, x) - b[i]).norm(), 0, 1e-12);
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
    for (Index v = 0; v < p.coarse_size(); ++v)
      entries -= std::size_t(p.column_end(v) - p.column_begin(v));
    EXPECT_EQ(entries, 0u);
  }
}

TEST(Galerkin_product, is_the_product_of_the_matrices)
{
  Random random(5);
  const Finest_level f(grid(12, 9, wavy), parameters::coarsest_size(20));
  const std::size_t finest = f.hierarchy.number_of_levels() - 1;
  const Pruned_prolongation p(f.hierarchy, finest - 3, finest, Loops());
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(2 * p.fine_size(), 2 * p.coarse_size());
  for (Index v = 0; v < p.fine_size(); ++v)
    for (int e = 0; e < 2; ++e)
      for (int k = 0; k < Pruned_prolongation::row_size; ++k)
        dense(2 * v + e, 2 * p.row(v).columns[k] + e) += p.row(v).weights[k];
  Random_matrix first(f.level, random);
  std::vector<Index> order(p.coarse_size());
  std::iota(order.rbegin(), order.rend(), 0);     // any order will do
  Galerkin_product product(first.matrix, p, order, Loops());
  for (int i = 0; i < 2; ++i) {     // the pattern serves for other values, too
    const Random_matrix a(f.level, random);
    Block_matrix coarse;
    product.compute(a.matrix, coarse, Loops());
    coarse.scale_blocks(Loops());
    const Eigen::MatrixXd expected = dense.transpose() * a.dense * dense;
    EXPECT_NEAR((unscaled(coarse) - expected).norm(), 0, 1e-12 * expected.norm());
  }
}

TEST(V_cycle, is_a_symmetric_positive_preconditioner)
{
  Random random(6);
  const Finest_level f(grid(40, 40, wavy));
  const Finest_level many(grid(40, 40, wavy), parameters::coarsest_size(20));
  for (const Level* level : { &f.level, &many.level }) {
    V_cycle cycle(*level);
    cycle.matrix() = Random_matrix(*level, random).matrix;
    cycle.setup();
    ASSERT_TRUE(cycle.is_ready());
    for (int i = 0; i < 5; ++i) {
      const Pair_vector x = random_pairs(level->number_of_vertices(), random), y = random_pairs(level->number_of_vertices(), random);
      const Pair_vector mx = cycle(x), my = cycle(y);
      EXPECT_NEAR(dot(Loops(), mx, y), dot(Loops(), x, my), 1e-10 * std::sqrt(dot(Loops(), mx, mx) * dot(Loops(), y, y)));
      EXPECT_GT(dot(Loops(), mx, x), 0);
    }
  }
}

TEST(Conjugate_gradients, reach_the_residual_they_are_asked_for)
{
  Random random(7);
  const Finest_level f(grid(40, 40, wavy), parameters::coarsest_size(20));
  V_cycle cycle(f.level);
  cycle.matrix() = Random_matrix(f.level, random).matrix;
  cycle.setup();
  for (const double tolerance : { 0.1, 1e-4, 1e-8 }) {
    Conjugate_gradients_space space;
    const Pair_vector b = random_pairs(f.level.number_of_vertices(), random);
    space.residual = b;
    const std::size_t iterations = conjugate_gradients(Loops(), cycle.matrix(), cycle, tolerance, 100, space);
    EXPECT_LT(iterations, 50u);
    double residual2 = 0;
    for (Index i = 0; i < b.size(); ++i)
      residual2 += (b[i] - cycle.matrix().row_times(i, space.solution)).squaredNorm();
    EXPECT_LE(std::sqrt(residual2), 1.001 * tolerance * std::sqrt(dot(Loops(), b, b)));
  }
}

// ---- refining a level ----

TEST(Level_refiner, finds_the_isometry_of_a_developable_surface)
{
  for (const Flat_mesh& m : { grid(12, 9, flat), grid(12, 9, rolled), delaunay_patch(150, 4, flat), strip(20), fan(3), single_triangle() })
    for (const Optimizer optimizer : { Optimizer::NEWTON, Optimizer::SWEEPS }) {
      const Finest_level f(m);
      Refinement_options options;
      options.optimizer = optimizer;
      options.number_of_iterations = 5000;
      options.tolerance = 1e-9;
      Level::Uv uv = first_map(f.level);
      Level_summary summary;
      Level_refiner<MIPS_energy_2>(f.level, uv, options, summary).run();
      const bool is_cone = m.triangles.size() == 3;     // the one that cannot be developed
      const double excess = summary.energy_end - 2 * double(m.triangles.size());
      EXPECT_EQ(excess < 1e-5 * double(m.triangles.size()), !is_cone) << m.triangles.size() << " triangles, excess " << excess;
      EXPECT_GE(excess, -1e-9);
    }
}

// A winding staircase: a developable surface whose angles at vertex 0, on the border, sum to more than a turn. The isometry is not allowed, so the best map has
// hardly a gap there.
Flat_mesh staircase()
{
  constexpr Index rings = 6, sectors = 40;
  Flat_mesh m;
  m.points.emplace_back(0, 0, 0);
  for (Index r = 1; r <= rings; ++r)
    for (Index k = 0; k <= sectors; ++k) {
      const double angle = 2.2 * CGAL_PI * k / sectors;
      m.points.emplace_back(r * std::cos(angle), r * std::sin(angle), 1e-3 * k);
    }
  const auto vertex = [&](Index r, Index k) { return 1 + (r - 1) * (sectors + 1) + k; };
  for (Index k = 0; k < sectors; ++k) {
    m.triangles.push_back({ 0, vertex(1, k), vertex(1, k + 1) });
    for (Index r = 1; r < rings; ++r) {
      m.triangles.push_back({ vertex(r, k), vertex(r + 1, k), vertex(r + 1, k + 1) });
      m.triangles.push_back({ vertex(r, k), vertex(r + 1, k + 1), vertex(r, k + 1) });
    }
  }
  return m;
}

// Newton's method must slide along that bound, to where sweeps do not get further down either.
TEST(Level_refiner, slides_along_the_bound_of_the_angles_at_the_border)
{
  const Flat_mesh m = staircase();
  const Finest_level f(m);
  const Level::Uv start = first_map(f.level);
  double energy[2];
  for (const Optimizer optimizer : { Optimizer::NEWTON, Optimizer::SWEEPS }) {
    Refinement_options options;
    options.optimizer = optimizer;
    options.number_of_iterations = optimizer == Optimizer::NEWTON ? 100 : 5000;
    options.tolerance = optimizer == Optimizer::NEWTON ? 1e-6 : 1e-9;
    Level::Uv uv = start;
    Level_summary summary;
    Level_refiner<Symmetric_Dirichlet_energy_2>(f.level, uv, options, summary).run();
    energy[int(optimizer)] = summary.energy_end - 4 * double(m.triangles.size());
    EXPECT_TRUE(is_map_valid(f.level.rings(), uv));
    const Level::Ring ring = f.level.one_ring(0);
    double turn = 0;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
      const Vector_2 a = uv[ring[i]] - uv[0], b = uv[ring[i + 1]] - uv[0];
      turn += std::atan2(cross(a, b), a * b);
    }
    EXPECT_LT(turn, 2 * CGAL_PI);
    EXPECT_GT(turn, 2 * CGAL_PI - 0.05);
  }
  EXPECT_GT(energy[int(Optimizer::NEWTON)], 1e-3);
  EXPECT_LT(energy[int(Optimizer::NEWTON)], 1.001 * energy[int(Optimizer::SWEEPS)]);
}

// Steps of the whole map come close to that place in full length, without sweeps that free them: where the bound turns a border vertex aside, its neighbors go along.
TEST(Newton_multigrid, keeps_the_length_of_steps_at_the_bound_of_the_angles_at_the_border)
{
  const Flat_mesh m = staircase();
  const Finest_level f(m);
  const Level_energy<Symmetric_Dirichlet_energy_2> energy(f.level, Triangle_weight::ONE);
  const auto excess = [&](const Level::Uv& uv) { return energy(uv) - 4 * double(m.triangles.size()); };
  Level::Uv best = first_map(f.level), uv = best;
  Refinement_options options;
  options.number_of_iterations = 200;
  Level_summary summary;
  Level_refiner<Symmetric_Dirichlet_energy_2>(f.level, best, options, summary).run();

  Newton_multigrid<Symmetric_Dirichlet_energy_2> newton(energy);
  for (int i = 0; i < 10; ++i)
    newton.step(uv, energy(uv), 0.07);
  EXPECT_TRUE(is_map_valid(f.level.rings(), uv));
  EXPECT_LT(excess(uv), 1.2 * excess(best));
}

TEST(Level_refiner, tells_what_it_did)
{
  const Finest_level f(grid(12, 9, wavy));
  for (const Optimizer optimizer : { Optimizer::NEWTON, Optimizer::SWEEPS, Optimizer::RANDOM_VERTICES })
    for (const Triangle_weight weight : { Triangle_weight::ONE, Triangle_weight::AREA }) {
      Refinement_options options;
      options.optimizer = optimizer;
      options.triangle_weight = weight;
      options.number_of_iterations = 3;
      options.tolerance = 0;
      const Level_energy<MIPS_energy_2> energy(f.level, weight);
      const double unit = weight == Triangle_weight::ONE ? 1 : energy.total_weight();
      Level::Uv uv = first_map(f.level);
      Level_summary summary;
      const double before = energy(uv);
      Level_refiner<MIPS_energy_2>(f.level, uv, options, summary).run();
      EXPECT_NEAR(summary.energy_start * unit / before, 1, 1e-12);
      EXPECT_NEAR(summary.energy_end * unit / energy(uv), 1, 1e-12);
      EXPECT_LT(summary.energy_end, summary.energy_start);
      EXPECT_EQ(summary.iterations, 3u);
      EXPECT_FALSE(summary.converged);
      EXPECT_EQ(summary.cycles > 0, optimizer == Optimizer::NEWTON);
      EXPECT_TRUE(optimizer == Optimizer::NEWTON || summary.vertex_visits == 3 * uv.size());
    }
}

TEST(Level_refiner, takes_exactly_the_local_steps_it_is_given)
{
  const Finest_level f(grid(12, 9, wavy));
  Refinement_options options;
  options.optimizer = Optimizer::RANDOM_VERTICES;
  options.number_of_local_steps = 1000;
  std::vector<Level::Uv> results;
  for (const unsigned int seed : { 3u, 3u, 4u }) {
    options.random_seed = seed;
    results.push_back(first_map(f.level));
    Level_summary summary;
    Level_refiner<MIPS_energy_2>(f.level, results.back(), options, summary).run();
    EXPECT_EQ(summary.vertex_visits, 1000u);
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_NE(results[0], results[2]);
}

TEST(Level_refiner, weights_matter_on_an_irregular_mesh)
{
  const Finest_level f(delaunay_patch(300, 5, wavy));
  Refinement_options options;
  std::vector<Level::Uv> maps;
  for (const Triangle_weight weight : { Triangle_weight::ONE, Triangle_weight::AREA }) {
    options.triangle_weight = weight;
    maps.push_back(first_map(f.level));
    Level_summary summary;
    Level_refiner<MIPS_energy_2>(f.level, maps.back(), options, summary).run();
    EXPECT_TRUE(is_map_valid(f.level.rings(), maps.back()));
  }
  const Level_energy<MIPS_energy_2> one(f.level, Triangle_weight::ONE), by_area(f.level, Triangle_weight::AREA);
  EXPECT_LT(one(maps[0]), one(maps[1]));    // each is best by its own measure
  EXPECT_LT(by_area(maps[1]), by_area(maps[0]));
}

// ---- scale ----

double area_in_space(const Level& level)
{
  double area = 0;
  for (const Index_triangle& t : level.triangles())
    area += std::sqrt(CGAL::squared_area(level.point(t[0]), level.point(t[1]), level.point(t[2])));
  return area;
}

double area_in_plane(const Level& level, const Level::Uv& uv)
{
  double area = 0;
  for (const Index_triangle& t : level.triangles())
    area += CGAL::area(uv[t[0]], uv[t[1]], uv[t[2]]);
  return area;
}

TEST(Scale_to_area, makes_the_areas_equal)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    const Finest_level f(m);
    for (const double scale : { 1e-5, 1., 1e5 }) {
      Level::Uv uv = first_map(f.level);
      for (Point_2& p : uv)
        p = Point_2(scale * p.x(), scale * p.y());
      scale_to_area(f.level, uv);
      EXPECT_NEAR(area_in_plane(f.level, uv) / area_in_space(f.level), 1, 1e-9);
      EXPECT_TRUE(is_map_valid(f.level.rings(), uv));
    }
  }
}

TEST(Scale_to_area, leaves_the_map_of_a_surface_without_area)
{
  Flat_mesh m = fan(5);
  std::fill(m.points.begin(), m.points.end(), Point_3(0, 0, 0));
  const Finest_level f(m);
  Level::Uv uv;
  ASSERT_EQ(Tutte_embedding::compute(f.level, uv), OK);
  const Level::Uv before = uv;
  scale_to_area(f.level, uv);
  EXPECT_EQ(uv, before);
}

// ---- up the levels ----

TEST(Insert_new_vertices, keeps_every_level_valid)
{
  Refinement_options options;
  options.optimizer = Optimizer::SWEEPS;
  options.number_of_iterations = 20;
  for (const auto& [name, m] : named_meshes())
    for (unsigned int seed = 0; seed < 10; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      const Collapse_hierarchy_3 hierarchy(surface(m), parameters::coarsest_size(3).random_seed(seed));
      Progressive_mesh_3 mesh(hierarchy);
      Level::Uv uv;
      for (std::size_t i = 0; i < hierarchy.number_of_levels(); ++i) {
        mesh.walk_to_level(i);
        const Level level(mesh, i);
        if (i == 0)
          uv = first_map(level);
        else {
          const Level::Uv before = uv;
          ASSERT_EQ(insert_new_vertices(level, uv), no_index);
          EXPECT_TRUE(std::equal(before.begin(), before.end(), uv.begin()));
        }
        ASSERT_EQ(uv.size(), level.number_of_vertices());
        ASSERT_TRUE(is_map_valid(level.rings(), uv));
        Level_summary summary;
        Level_refiner<MIPS_energy_2>(level, uv, options, summary).run();
        ASSERT_TRUE(is_map_valid(level.rings(), uv));
      }
    }
}

// The exponential map of an interior vertex of a planar mesh is an isometry, and the best place is where the vertex was.
TEST(Insert_new_vertices, of_a_planar_mesh_puts_interior_vertices_back)
{
  for (const Flat_mesh& m : { grid(15, 15, flat), delaunay_patch(400, 2, flat) }) {
    const Finest_level f(m, parameters::coarsest_size(60));
    for (std::size_t i = 1; i < f.hierarchy.number_of_levels(); ++i) {
      Progressive_mesh_3 mesh(f.hierarchy);
      mesh.walk_to_level(i - 1);
      Level::Uv uv = identity_map(Level(mesh, i - 1));
      if (!is_map_valid(Level(mesh, i - 1).rings(), uv))
        continue;     // a coarse level of a convex patch can have a flat ear
      mesh.walk_to_level(i);
      const Level level(mesh, i);
      const Level::Uv expected = identity_map(level);
      ASSERT_EQ(insert_new_vertices(level, uv), no_index);
      for (Index v = 0; v < level.number_of_vertices(); ++v)
        EXPECT_TRUE(level.is_border(v) || CGAL::squared_distance(uv[v], expected[v]) < 1e-20);
    }
  }
}

// An ear goes where its triangle is similar to the one in space.
TEST(Insert_new_vertices, puts_ears_back_in_shape)
{
  const Flat_mesh m = { { Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.5, 0.8, 0), Point_3(0.5, -0.5, 0), Point_3(1.2, 0.8, 0), Point_3(-0.2, 0.8, 0) },
                        { { 0, 1, 2 }, { 1, 0, 3 }, { 2, 1, 4 }, { 0, 2, 5 } } };
  int ears = 0;
  for (unsigned int seed = 0; seed < 10; ++seed) {
    const Finest_level f(m, parameters::coarsest_size(5).random_seed(seed));
    ASSERT_EQ(f.hierarchy.number_of_levels(), 2u);
    const Level::Uv expected = identity_map(f.level);
    Level::Uv uv(expected.begin(), expected.begin() + f.hierarchy.number_of_vertices(0));
    if (!is_map_valid(Level(Progressive_mesh_3(f.hierarchy), 0).rings(), uv))
      continue;
    ASSERT_EQ(insert_new_vertices(f.level, uv), no_index);
    for (Index v = Index(f.level.first_new_vertex()); v < 6; ++v)
      if (f.level.rings().number_of_triangles(v) == 1) {
        EXPECT_NEAR(std::sqrt(CGAL::squared_distance(uv[v], expected[v])), 0, 1e-12);
        ++ears;
      }
  }
  EXPECT_GT(ears, 3);
}

} // namespace
