// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Newton's method: the Hessian of a triangle, and steps of the whole map.

#include "contacts.h"
#include "dense_matrices.h"
#include "exact_kernel.h"
#include "hierarchies.h"
#include "level_maps.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_method.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/corner_hessian.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/longest_step_of_triangles.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Star.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace test_newton {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;
using test_systems::dense_of;
namespace parameters = CGAL::parameters;

typedef As_rigid_as_possible_energy_2   Energy;

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Energy>
class Newton_of : public testing::Test { };
typedef testing::Types<MIPS_energy_2, Symmetric_Dirichlet_energy_2, As_rigid_as_possible_energy_2>
  All_energies;     // some let triangles flip
TYPED_TEST_SUITE(Newton_of, All_energies, );

// Triangles in space and in the plane, well shaped in both, among them isometries and similarities.
struct Random_triangle
{
  std::array<Point_3, 3> p;
  std::array<Point_2, 3> q;

  Random_triangle(int kind, Random& random)
  {
    do
      draw(kind, random);
    while (!is_fat());
  }

  void draw(int kind, Random& random)
  {
    for (Point_3& point : p) {
      const double x = random(-1, 1), y = random(-1, 1);
      point = Point_3(x, y, kind > 0 ? 0 : random(-1, 1));
    }
    const double angle = random(0, 6), scale = kind == 2 ? random(0.5, 2) : 1;
    for (int i = 0; i < 3; ++i)
      q[i] = kind > 0 ? Point_2(scale * (p[i].x() * std::cos(angle) - p[i].y() * std::sin(angle)),
                                scale * (p[i].x() * std::sin(angle) + p[i].y() * std::cos(angle)))
                      : Point_2(random(-1, 1), p[i].z() * random(0.1, 1));
    if (!turns_left(q[0], q[1], q[2])) {
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

  bool is_fat() const
  {
    for (int i = 0; i < 3; ++i) {
      const Vector_2 ab = q[(i + 2) % 3] - q[(i + 1) % 3];
      if (rest_corner(p[i], p[(i + 1) % 3], p[(i + 2) % 3]).height < 0.2 ||
          cross(ab, q[i] - q[(i + 1) % 3]) < 0.2 * ab.squared_length())
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
    for (int i = 0; i < 3; ++i) {
      const auto d = t.star<TypeParam>(i).derivatives(t.q[i]);
      const Corner_hessian h = t.corner<TypeParam>(i);
      const double tolerance = 1e-9 * (d.value + std::abs(d.hessian[0]) + std::abs(d.hessian[2]));
      EXPECT_NEAR(h.gradient.x, 1.5 * d.gradient[0], tolerance);
      EXPECT_NEAR(h.gradient.y, 1.5 * d.gradient[1], tolerance);
    }
  }
}

TYPED_TEST(Newton_of, hessian_is_exact_at_an_isometry)
{
  Random random(2);
  for (int k = 0; k < 300; ++k) {
    const Random_triangle t(1, random);
    for (int i = 0; i < 3; ++i) {
      const auto d = t.star<TypeParam>(i).derivatives(t.q[i]);
      const Corner_hessian h = t.corner<TypeParam>(i);
      const double tolerance = 1e-8 * (d.hessian[0] + d.hessian[2]);
      EXPECT_NEAR(h.to_v.xx(), 1.5 * d.hessian[0], tolerance);
      EXPECT_NEAR(h.to_v.xy(), 1.5 * d.hessian[1], tolerance);
      EXPECT_NEAR(h.to_v.yx(), 1.5 * d.hessian[1], tolerance);
      EXPECT_NEAR(h.to_v.yy(), 1.5 * d.hessian[2], tolerance);
    }
  }
}

TYPED_TEST(Newton_of, hessian_is_symmetric_and_positive_semidefinite)
{
  Random random(3);
  for (int k = 0; k < 600; ++k) {
    const Random_triangle t(k % 3, random);
    Eigen::Matrix<double, 6, 6> hessian;
    for (int i = 0; i < 3; ++i) {
      const Corner_hessian h = t.corner<TypeParam>(i);
      hessian.block<2, 2>(2 * i, 2 * i) = dense_of(h.to_v);
      hessian.block<2, 2>(2 * i, 2 * ((i + 2) % 3)) = dense_of(h.to_b);
      hessian.block<2, 2>(2 * i, 2 * ((i + 1) % 3)) = -dense_of(h.to_v + h.to_b);
    }
    EXPECT_NEAR((hessian - hessian.transpose()).norm(), 0, 1e-9 * hessian.norm());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(hessian);
    EXPECT_GE(solver.eigenvalues()[0], -1e-9 * solver.eigenvalues()[5]);
  }
}

TYPED_TEST(Newton_of, steps_lower_the_energy_by_exactly_what_they_return)
{
  for (const Flat_mesh& m :
       { grid(12, 9, wavy), grid_with_holes(20), delaunay_patch(400, 2, wavy), deep_cap(), folded_fan(), strip(20) }) {
    const Finest_level f(m);
    const Level_energy_of<TypeParam> energy(f.level, Triangle_weight::AREA);
    Newton_method newton(energy);
    Level::Uv uv = first_map(f.level);
    for (int i = 0; i < 10; ++i) {
      const double before = energy(uv);
      const auto step = newton.step(uv, before);
      EXPECT_GE(step.decrease, 0);
      if (newton.turn_barrier().stiffness() == 0) {
        EXPECT_NEAR(before - energy(uv), step.decrease, 1e-12 * before);
      }
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
      refine<TypeParam>(f.level, uv, options, summary);
      EXPECT_TRUE(summary.converged);
      energy[i] = summary.energy_end;
    }
    EXPECT_NEAR((energy[0] - TypeParam::minimum) / (energy[1] - TypeParam::minimum), 1, 1e-4);
  }
}

// A triangle that opens before it closes: its area is (1 - t) (width + t).
TEST(Longest_step, is_exact_for_triangles_that_are_almost_degenerate)
{
  const Finest_level f(single_triangle());
  for (const double width : { 1e-2, 1e-10, 1e-16, 1e-30, 0x1p-1000 }) {
    const Level::Uv uv = { Point_2(0, 0), Point_2(1, 0), Point_2(0, width) };
    const Block_vectors direction = { Block_vector(0, 0), Block_vector(-1, 0), Block_vector(0, 1) };
    EXPECT_NEAR(longest_step_of_triangles(f.level, uv, direction), 1, 1e-15) << width;
  }
}

// Steps of the whole map come close to that place in full length, without sweeps that free them: where the bound turns
// a border vertex aside, its neighbors go along.
TEST(Newton_multigrid, keeps_the_length_of_steps_at_the_bound_of_the_angles_at_the_border)
{
  const Flat_mesh m = staircase();
  const Finest_level f(m);
  const Level_energy_of<Symmetric_Dirichlet_energy_2> energy(f.level, Triangle_weight::ONE);
  const auto excess = [&](const Level::Uv& uv) { return energy(uv) - 4 * double(m.triangles.size()); };
  Level::Uv best = first_map(f.level), uv = best;
  Refinement_options options;
  options.number_of_iterations = 200;
  Level_summary summary;
  refine<Symmetric_Dirichlet_energy_2>(f.level, best, options, summary);

  Newton_method newton(energy);
  for (int i = 0; i < 10; ++i)
    newton.step(uv, energy(uv));
  EXPECT_TRUE(is_map_valid(f.level.rings(), uv));
  EXPECT_LT(excess(uv), 1.2 * excess(best));
}

// By how much two cycles lower the model, when one cycle has been too little for the system before.
double decrease_by_two_cycles(const Level_energy& energy, const Level::Uv& uv, std::size_t most_vertices)
{
  Newton_options options;
  options.most_vertices_solved_directly = most_vertices;
  Newton_system system(energy, options);
  for (const std::size_t cycles : { 1, 2 }) {
    EXPECT_TRUE(system.assemble(uv, {}));
    EXPECT_LE(system.solve({ 0, 0, cycles }), cycles);
  }
  return system.predicted_decrease();
}

TEST(Newton_multigrid, gives_way_to_direct_solutions_where_cycles_do_not_suffice)
{
  const Finest_level f(grid(40, 40, wavy), parameters::coarsest_size(20));
  const Level_energy_of<MIPS_energy_2> energy(f.level, Triangle_weight::ONE);
  const Level::Uv uv = first_map(f.level);
  const Newton_options options;
  Newton_system exact(energy, options);
  ASSERT_TRUE(exact.assemble(uv, {}));
  exact.solve({ 1e-12, 0, 1000 });
  const double decrease = exact.predicted_decrease();
  EXPECT_NEAR(decrease_by_two_cycles(energy, uv, uv.size()), decrease, 1e-7 * decrease);
  EXPECT_LT(decrease_by_two_cycles(energy, uv, uv.size() - 1), 0.999 * decrease);
}

// ---- what makes the Hessian indefinite, and is kept ----

TEST(Corner_hessian, of_a_scale_invariant_energy_is_the_derivative_of_the_gradient_if_all_is_kept)
{
  Random random(5);
  for (int k = 0; k < 300; ++k) {
    const Random_triangle t(k % 3, random);
    const Rest_corner corner = SMP::internal::rest_corner(t.p[0], t.p[1], t.p[2]);
    const Vector_2 a = t.q[1] - t.q[0], b = t.q[2] - t.q[0];
    const auto at = [&](const Vector_2& move_of_v, const Vector_2& move_of_b) {
      return corner_hessian(MIPS_energy_2(), corner, 1, a - move_of_v, b - move_of_v + move_of_b, 1);
    };
    const Corner_hessian h = at(Vector_2(0, 0), Vector_2(0, 0));
    const double step = 1e-5, tolerance = 1e-6 * (dense_of(h.to_v).norm() + dense_of(h.to_b).norm());
    for (int i = 0; i < 2; ++i) {
      const Vector_2 zero(0, 0), move(i == 0 ? step : 0, i == 1 ? step : 0);
      const auto derivative = [&](const Corner_hessian& before, const Corner_hessian& after) -> Eigen::Vector2d {
        return Eigen::Vector2d(after.gradient.x - before.gradient.x, after.gradient.y - before.gradient.y) / (2 * step);
      };
      EXPECT_NEAR((derivative(at(-move, zero), at(move, zero)) - dense_of(h.to_v).col(i)).norm(), 0, tolerance);
      EXPECT_NEAR((derivative(at(zero, -move), at(zero, move)) - dense_of(h.to_b).col(i)).norm(), 0, tolerance);
    }
  }
}

// The rows and columns of all vertices but those on the border, of the Hessian at a map that scales a planar grid.
Eigen::MatrixXd inner_hessian(double scale, double indefinite_part)
{
  const Flat_mesh m = grid(8, 8, flat);
  const One_rings rings(m.points.size(), m.triangles);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(2 * Eigen::Index(m.points.size()), 2 * Eigen::Index(m.points.size()));
  const auto in_plane = [&](Index v, Index w) {
    return scale * Vector_2(m.points[w].x() - m.points[v].x(), m.points[w].y() - m.points[v].y());
  };
  for (Index v = 0; v < m.points.size(); ++v)
    for (std::size_t i = 0; i < rings[v].size() && !rings.is_border(v); ++i) {
      const Index a = rings[v][i], b = rings[v][(i + 1) % rings[v].size()];
      const auto h = SMP::internal::corner_hessian(Energy(infinity),
                                                   SMP::internal::rest_corner(m.points[v], m.points[a], m.points[b]), 1,
                                                   in_plane(v, a), in_plane(v, b), indefinite_part);
      result.block<2, 2>(2 * v, 2 * v) += dense_of(h.to_v);
      if (!rings.is_border(b))
        result.block<2, 2>(2 * v, 2 * b) += dense_of(h.to_b);
      if (!rings.is_border(a))
        result.block<2, 2>(2 * v, 2 * a) -= dense_of(h.to_v + h.to_b);
    }
  return result;
}

// Of a map that shrinks by less than one half, as a whole and not triangle by triangle.
TEST(Corner_hessian, that_lends_curvature_is_positive_and_less_stiff)
{
  for (const double scale : { 0.3, 0.45, 0.52, 0.6, 0.9, 1.5 }) {
    const Eigen::MatrixXd projected = inner_hessian(scale, 0), keeping = inner_hessian(scale, 0.95);
    EXPECT_NEAR((keeping - keeping.transpose()).norm(), 0, 1e-12 * keeping.norm());
    const Eigen::VectorXd least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(keeping).eigenvalues();
    EXPECT_GE(least[0], -1e-12 * keeping.norm()) << "scale " << scale;
    EXPECT_EQ((projected - keeping).trace() > 0.1 * projected.trace(), scale < 0.8) << "scale " << scale;
  }
}

TEST(Corner_hessian, that_lends_curvature_is_exact_down_to_half_the_scale)
{
  const Rest_corner corner = SMP::internal::rest_corner(Point_3(0, 0, 0), Point_3(1, 0.2, 0), Point_3(0.3, 0.8, 0));
  const One_rings rings(3, { { 0, 1, 2 } });
  for (const double scale : { 0.52, 0.7, 1.3 }) {
    const Vector_2 a(scale, 0.2 * scale), b(0.3 * scale, 0.8 * scale);
    SMP::internal::Star<Energy> star;
    star.gather(rings, { Point_2(0, 0), CGAL::ORIGIN + a, CGAL::ORIGIN + b }, 0, &corner, Triangle_weight::ONE,
                Energy(infinity));
    const auto d = star.derivatives(Point_2(0, 0));
    const auto h = SMP::internal::corner_hessian(Energy(infinity), corner, 1, a, b, 0.95);
    EXPECT_NEAR(h.to_v.xx(), d.hessian[0], 1e-9);
    EXPECT_NEAR(h.to_v.xy(), d.hessian[1], 1e-9);
    EXPECT_NEAR(h.to_v.yy(), d.hessian[2], 1e-9);
  }
}

// The second derivative of the gradient along a direction, times the direction, is the third one of the energy.
TYPED_TEST(Newton_of, knows_the_second_derivative_of_the_gradient)
{
  const Finest_level f(grid(9, 7, wavy));
  const Level_energy_of<TypeParam> energy(f.level, Triangle_weight::AREA);
  const Level::Uv uv = first_map(f.level);
  Random random(3);
  const Block_vectors direction = random_moves(uv.size(), random);
  Block_vectors second(uv.size());
  energy.differentiate_gradient_twice(uv, direction, 1e-4, second);
  double third = 0;
  for (Index v = 0; v < second.size(); ++v)
    third += inner_product(second[v], direction[v]);
  const double t = 1e-4;
  const auto odd_part = [&](double s) { return energy(moved(uv, s, direction)) - energy(moved(uv, -s, direction)); };
  const double differences = (odd_part(2 * t) - 2 * odd_part(t)) / (2 * t * t * t);
  EXPECT_NEAR(third, differences, 1e-3 * std::abs(differences));
}

// A direction that turns a map stretches it; with the bend it goes along a circle.
TYPED_TEST(Newton_of, bends_the_line_of_a_turn_to_a_circle)
{
  if (TypeParam::is_scale_invariant)
    GTEST_SKIP() << "scales cost nothing";
  const Finest_level f(grid(12, 9, flat));
  const Level_energy_of<TypeParam> energy(f.level, Triangle_weight::AREA);
  const Level::Uv uv = identity_map(f.level);
  Block_vectors direction;
  for (const Point_2& p : uv)
    direction.emplace_back(-p.y(), p.x());
  const Newton_options options;
  Newton_system system(energy, options);
  ASSERT_TRUE(system.assemble(uv, {}));
  system.solve_for_bend(uv, direction, 0.01, { 1e-8, 0, 60 });
  const Block_vectors bend = system.moves();
  const double angle = 0.3, least = energy(uv), straight = energy(moved(uv, angle, direction)) - least,
               bent = energy(moved(moved(uv, angle, direction), angle * angle, bend)) - least;
  EXPECT_GT(straight, 0);
  EXPECT_LT(std::abs(bent), 0.01 * straight);
}

} // namespace test_newton
