// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The as-rigid-as-possible energy and method, on all floors, beside CGAL's.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/corner_hessian.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef CGAL::Simple_cartesian<double>                                            Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                                       Surface_mesh;
typedef Surface_mesh::Property_map<Surface_mesh::Vertex_index, Kernel::Point_2>   UV_map;
typedef As_rigid_as_possible_energy_2                                             Energy;
typedef As_rigid_as_possible_parameterizer_3<Surface_mesh>                        Method;
typedef Hierarchical_parameterizer_3<Method>                                      Hierarchical_method;
typedef SMP::internal::Rest_corner                                                Rest_corner;

constexpr double infinity = std::numeric_limits<double>::infinity();

// ---- what the energy is, in other words ----

// The least value of a function that falls and then rises.
template <class Function>
double least_value(const Function& f, double from, double to)
{
  for (int i = 0; i < 200; ++i) {
    const double left = from + (to - from) / 3, right = to - (to - from) / 3;
    (f(left) < f(right) ? to : from) = f(left) < f(right) ? right : left;
  }
  return f(0.5 * (from + to));
}

// CGAL's energy of a map as it is defined: half of the sum over the triangles of sum cot |e - L x|^2 + lambda (a^2 + b^2 - 1)^2 with the best L = (a b; -b a).
double energy_by_definition(const Flat_mesh& m, const std::vector<Kernel::Point_2>& uv, double lambda)
{
  double sum = 0;
  for (const Index_triangle& t : m.triangles) {
    const Vector_3 p = m.points[t[1]] - m.points[t[0]], q = m.points[t[2]] - m.points[t[0]];
    const double length = std::sqrt(p.squared_length()), doubled_area = std::sqrt(CGAL::cross_product(p, q).squared_length());
    const Eigen::Vector2d x[3] = { { 0, 0 }, { length, 0 }, { p * q / length, doubled_area / length } };
    double cotangents[3];
    Eigen::Vector2d in_space[3], in_plane[3], direction(0, 0);
    for (int i = 0; i < 3; ++i) {
      const Index a = t[(i + 1) % 3], b = t[(i + 2) % 3];
      in_space[i] = x[(i + 2) % 3] - x[(i + 1) % 3];
      in_plane[i] = Eigen::Vector2d(uv[b].x() - uv[a].x(), uv[b].y() - uv[a].y());
      cotangents[i] = (m.points[a] - m.points[t[i]]) * (m.points[b] - m.points[t[i]]) / doubled_area;
      direction += cotangents[i] * Eigen::Vector2d(in_plane[i].dot(in_space[i]), in_plane[i][0] * in_space[i][1] - in_plane[i][1] * in_space[i][0]);
    }
    direction.normalize();
    sum += least_value([&](double s) {
      const double a = s * direction[0], b = s * direction[1], penalty = s * s - 1;
      double result = lambda * penalty * penalty;
      for (int i = 0; i < 3; ++i)
        result += cotangents[i] * (in_plane[i] - Eigen::Vector2d(a * in_space[i][0] + b * in_space[i][1], -b * in_space[i][0] + a * in_space[i][1])).squaredNorm();
      return result;
    }, 0, 100);
  }
  return 0.5 * sum;
}

const std::vector<double> stiffnesses = { 0, 1e-3, 0.3, 0.5, 1, 40, 1e6, 1e18, infinity };

// Singular values, one of which is negative now and then.
struct Random_map
{
  double s1, s2, f, d;

  explicit Random_map(Random& random) : s1(std::exp(random(-2, 1.5))), s2(s1 * random(-0.9, 0.95)), f(s1 * s1 + s2 * s2), d(s1 * s2) { }
};

TEST(As_rigid_as_possible_energy_2, is_the_least_over_all_scales)
{
  Random random(1);
  for (const double k : stiffnesses)
    for (int i = 0; i < 200; ++i) {
      const Random_map map(random);
      const auto energy = [&](double s) { return (map.s1 - s) * (map.s1 - s) + (map.s2 - s) * (map.s2 - s) + k * (s * s - 1) * (s * s - 1); };
      const double expected = k < 1e10 ? least_value(energy, 0, 10) : (map.s1 - 1) * (map.s1 - 1) + (map.s2 - 1) * (map.s2 - 1);
      EXPECT_NEAR(Energy(2 * k).value(map.f, map.d), expected, 1e-8 * (1 + expected)) << "stiffness " << k;
    }
}

TEST(As_rigid_as_possible_energy_2, depends_on_lambda_by_the_area)
{
  EXPECT_EQ(Energy(3).of_area(0.5).value(3, 0.7), Energy(12, 2).value(3, 0.7));
  EXPECT_EQ(Energy(3, 7).of_area(0.5).value(3, 0.7), Energy(12, 2).value(3, 0.7));
  EXPECT_LT(Energy(3).of_area(0.5).value(3, 0.7), Energy(3).of_area(0.4).value(3, 0.7));
}

TEST(As_rigid_as_possible_energy_2, derivatives_match_differences)
{
  Random random(2);
  for (const double k : stiffnesses)
    for (int i = 0; i < 200; ++i) {
      const Random_map map(random);
      const double f = map.f, d = map.d, q = f + 2 * d, h = 1e-5 * q;
      const Energy energy(2 * k);
      const Distortion_derivatives_2 e = energy.derivatives(f, d);
      EXPECT_NEAR(e.value, energy.value(f, d), 1e-14 * (1 + f));
      const double tolerance = 1e-6 * (1 + 1 / (q * q)), rounding = 1e-14 * (1 + f) / h;
      EXPECT_NEAR(e.f, (energy.value(f + h, d) - energy.value(f - h, d)) / (2 * h), tolerance + rounding);
      EXPECT_NEAR(e.d, (energy.value(f, d + h) - energy.value(f, d - h)) / (2 * h), tolerance + rounding);
      EXPECT_NEAR(e.ff, (energy.derivatives(f + h, d).f - energy.derivatives(f - h, d).f) / (2 * h), tolerance);
      EXPECT_NEAR(e.fd, (energy.derivatives(f, d + h).f - energy.derivatives(f, d - h).f) / (2 * h), tolerance);
      EXPECT_NEAR(e.fd, (energy.derivatives(f + h, d).d - energy.derivatives(f - h, d).d) / (2 * h), tolerance);
      EXPECT_NEAR(e.dd, (energy.derivatives(f, d + h).d - energy.derivatives(f, d - h).d) / (2 * h), tolerance);
    }
}

TEST(As_rigid_as_possible_energy_2, is_finite_everywhere)
{
  for (const double k : stiffnesses)
    for (const double d : { -2., 0., 2. })
      for (const double f : { 2 * std::abs(d), 3 * std::abs(d) }) {
        const Distortion_derivatives_2 e = Energy(2 * k).derivatives(f, d);
        for (const double x : { e.value, e.f, e.d, e.ff, e.fd, e.dd })
          EXPECT_TRUE(std::isfinite(x)) << "stiffness " << k << ", f " << f << ", d " << d;
      }
}

// ---- its Hessian ----

// The rows and columns of all vertices but those on the border, of the Hessian at a map that scales a planar grid.
Eigen::MatrixXd inner_hessian(double scale, double lent)
{
  const Flat_mesh m = grid(8, 8, flat);
  const One_rings rings(m.points.size(), m.triangles);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(2 * Eigen::Index(m.points.size()), 2 * Eigen::Index(m.points.size()));
  const auto in_plane = [&](Index v, Index w) { return scale * Vector_2(m.points[w].x() - m.points[v].x(), m.points[w].y() - m.points[v].y()); };
  for (Index v = 0; v < m.points.size(); ++v)
    for (std::size_t i = 0; i < rings[v].size() && !rings.is_border(v); ++i) {
      const Index a = rings[v][i], b = rings[v][(i + 1) % rings[v].size()];
      const auto h = SMP::internal::corner_hessian(Energy(infinity), SMP::internal::rest_corner(m.points[v], m.points[a], m.points[b]), 1, in_plane(v, a), in_plane(v, b), lent);
      result.block<2, 2>(2 * v, 2 * v) += h.to_v;
      if (!rings.is_border(b))
        result.block<2, 2>(2 * v, 2 * b) += h.to_b;
      if (!rings.is_border(a))
        result.block<2, 2>(2 * v, 2 * a) -= h.to_v + h.to_b;
    }
  return result;
}

// Of a map that shrinks by less than one half, as a whole and not triangle by triangle.
TEST(Corner_hessian, that_lends_curvature_is_positive_and_less_stiff)
{
  for (const double scale : { 0.3, 0.45, 0.52, 0.6, 0.9, 1.5 }) {
    const Eigen::MatrixXd projected = inner_hessian(scale, 0), lending = inner_hessian(scale, 0.95);
    EXPECT_NEAR((lending - lending.transpose()).norm(), 0, 1e-12 * lending.norm());
    const Eigen::VectorXd least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(lending).eigenvalues();
    EXPECT_GE(least[0], -1e-12 * lending.norm()) << "scale " << scale;
    EXPECT_EQ((projected - lending).trace() > 0.1 * projected.trace(), scale < 0.8) << "scale " << scale;
  }
}

TEST(Corner_hessian, that_lends_curvature_is_exact_down_to_half_the_scale)
{
  const Rest_corner corner = SMP::internal::rest_corner(Point_3(0, 0, 0), Point_3(1, 0.2, 0), Point_3(0.3, 0.8, 0));
  const One_rings rings(3, { { 0, 1, 2 } });
  for (const double scale : { 0.52, 0.7, 1.3 }) {
    const Vector_2 a(scale, 0.2 * scale), b(0.3 * scale, 0.8 * scale);
    SMP::internal::Star<Energy> star;
    star.gather(rings, { Point_2(0, 0), CGAL::ORIGIN + a, CGAL::ORIGIN + b }, 0, &corner, Triangle_weight::ONE, Energy(infinity));
    const auto d = star.derivatives(Point_2(0, 0));
    const auto h = SMP::internal::corner_hessian(Energy(infinity), corner, 1, a, b, 0.95);
    EXPECT_NEAR(h.to_v(0, 0), d.hessian[0], 1e-9);
    EXPECT_NEAR(h.to_v(0, 1), d.hessian[1], 1e-9);
    EXPECT_NEAR(h.to_v(1, 1), d.hessian[2], 1e-9);
  }
}

// ---- the method ----

struct Mapped_mesh
{
  const Flat_mesh flat_mesh;
  Surface_mesh mesh;
  UV_map uvmap;
  Parameterization_summary summary;

  explicit Mapped_mesh(const Flat_mesh& m) : flat_mesh(m), mesh(make<Surface_mesh>(m))
  {
    uvmap = mesh.add_property_map<Surface_mesh::Vertex_index, Kernel::Point_2>("v:uv", Kernel::Point_2(0, 0)).first;
  }

  Mapped_mesh(const Mapped_mesh&) = delete;

  template <class Parameterizer>
  Error_code parameterize(const Parameterizer& parameterizer) { return SMP::parameterize(mesh, parameterizer, longest_border(mesh), uvmap); }

  Error_code parameterize_hierarchically(double lambda, double tolerance = 1e-6, unsigned int seed = 0)
  {
    return parameterize(Hierarchical_method(Method(parameters::lambda(lambda).tolerance(tolerance)),
                                            parameters::coarsest_size(20).flip_policy(Flip_policy::KEEP).summary(std::ref(summary)).random_seed(seed)));
  }

  std::vector<Kernel::Point_2> uv() const { return std::vector<Kernel::Point_2>(uvmap.begin(), uvmap.end()); }
  double energy(double lambda) const { return energy_by_definition(flat_mesh, uv(), lambda); }
  Parameterization_quality quality() const { return parameterization_quality(mesh, uvmap); }
};

std::vector<Flat_mesh> smooth_meshes() { return { grid(16, 12, wavy), hemisphere(), disk_with_hole(), delaunay_patch(200, 1, wavy) }; }

TEST(As_rigid_as_possible, energy_is_that_of_the_definition)
{
  for (const Flat_mesh& m : { grid(12, 9, wavy), crumpled_grid(14, 1), deep_cap() })
    for (const double lambda : { 0., 1e-4, 0.02, 1000. }) {
      Mapped_mesh mapped(m);
      EXPECT_EQ(mapped.parameterize_hierarchically(lambda, 1e-3), OK);
      EXPECT_NEAR(mapped.summary.energy, mapped.energy(lambda), 1e-8 * mapped.summary.energy + 1e-14) << "lambda " << lambda;
    }
}

TEST(As_rigid_as_possible, energy_is_not_above_that_of_CGAL)
{
  std::vector<Flat_mesh> meshes = smooth_meshes();
  for (const Flat_mesh& m : { deep_cap(), crumpled_grid(14, 1), grid_with_holes(20), strip(20), fan(5) })
    meshes.push_back(m);
  for (const Flat_mesh& m : meshes)
    for (const double lambda : { 0.01, 1., 1000. }) {
      Mapped_mesh ours(m), theirs(m);
      EXPECT_EQ(ours.parameterize_hierarchically(lambda), OK);
      theirs.parameterize(ARAP_parameterizer_3<Surface_mesh>(lambda));    // its repair of flips may fail, and leaves the map
      EXPECT_LE(ours.energy(lambda), theirs.energy(lambda) * (1 + 1e-6) + 1e-12) << m.triangles.size() << " triangles, lambda " << lambda;
    }
}

// Which takes curvature that is lent: the map of a cap must compress its triangles.
TEST(As_rigid_as_possible, converges_in_few_steps)
{
  for (const Flat_mesh& m : { cap(24, 60, 0.93 * CGAL_PI), cap(40, 100, 0.93 * CGAL_PI) }) {
    Mapped_mesh mapped(m);
    EXPECT_EQ(mapped.parameterize_hierarchically(1000, 1e-9), OK);
    EXPECT_TRUE(mapped.summary.converged);
    EXPECT_LE(mapped.summary.levels.back().iterations, 8u);
  }
}

TEST(As_rigid_as_possible, finds_the_isometry_of_a_developable_surface)
{
  for (const Flat_mesh& m : { grid(12, 9, flat), grid(12, 9, rolled), delaunay_patch(150, 4, flat), strip(20), single_triangle() })
    for (const double lambda : { 1e-3, 1000., infinity }) {
      Mapped_mesh mapped(m);
      EXPECT_EQ(mapped.parameterize_hierarchically(lambda), OK);
      EXPECT_LT(mapped.summary.energy, 1e-9) << m.triangles.size() << " triangles, lambda " << lambda;
      EXPECT_NEAR(mapped.quality().symmetric_dirichlet, 4, 1e-4);
    }
}

TEST(As_rigid_as_possible, hierarchical_and_flat_runs_find_the_same_minimum)
{
  for (const Flat_mesh& m : smooth_meshes())
    for (const double lambda : { 0.1, 1000. }) {
      Mapped_mesh mapped(m);
      EXPECT_EQ(mapped.parameterize_hierarchically(lambda, 1e-9), OK);
      Parameterization_summary flat;
      EXPECT_EQ(mapped.parameterize(Method(parameters::lambda(lambda).tolerance(1e-9).summary(std::ref(flat)))), OK);
      EXPECT_TRUE(flat.converged && mapped.summary.converged);
      EXPECT_NEAR(mapped.summary.energy / flat.energy, 1, 1e-4);
    }
}

TEST(As_rigid_as_possible, lambda_weighs_lengths_against_angles)
{
  Mapped_mesh mapped(grid(16, 12, wavy));
  double angles = -1, lengths = infinity;
  for (const double lambda : { 1e-3, 1e-2, 0.1, 10. }) {
    EXPECT_EQ(mapped.parameterize_hierarchically(lambda, 1e-9), OK);
    const double rigid = mapped.energy(1e12);
    EXPECT_GT(mapped.quality().mips_excess, angles);
    EXPECT_LT(rigid, lengths);
    angles = mapped.quality().mips_excess;
    lengths = rigid;
  }
}

TEST(As_rigid_as_possible, great_lambdas_are_as_good_as_infinity)
{
  Mapped_mesh mapped(grid(16, 12, wavy));
  EXPECT_EQ(mapped.parameterize_hierarchically(infinity, 1e-9), OK);
  const double rigid = mapped.summary.energy;
  for (const double lambda : { 1e6, 1e15, 1e300 }) {
    EXPECT_EQ(mapped.parameterize_hierarchically(lambda, 1e-9), OK);
    EXPECT_NEAR(mapped.summary.energy / rigid, 1, 1e-6);
  }
}

// Where angles cannot be kept and a change of scale costs next to nothing, the cheapest map is a point.
TEST(As_rigid_as_possible, shrinks_the_map_for_tiny_lambda)
{
  Mapped_mesh mapped(crumpled_grid(14, 1));
  EXPECT_EQ(mapped.parameterize_hierarchically(1e-12), OK);
  EXPECT_LE(mapped.energy(1e-12), 0.5e-12 * double(mapped.flat_mesh.triangles.size()) * (1 + 1e-6));
}

// With lambda = 0 two vertices are held, and at no other one the energy has a slope.
TEST(As_rigid_as_possible, is_the_least_squares_conformal_map_for_lambda_0)
{
  for (const Flat_mesh& m : { grid(8, 6, wavy), disk_with_hole(), fan(5) })
    for (const bool is_hierarchical : { true, false }) {
      Mapped_mesh mapped(m);
      EXPECT_EQ(is_hierarchical ? mapped.parameterize_hierarchically(0, 1e-12) : mapped.parameterize(Method(parameters::lambda(0.).flip_policy(Flip_policy::KEEP).tolerance(1e-12))), OK);
      std::vector<Kernel::Point_2> uv = mapped.uv();
      const double h = 1e-4, energy = mapped.energy(0);
      std::size_t held = 0;
      for (Kernel::Point_2& p : uv) {
        const Kernel::Point_2 place = p;
        double slope = 0;
        for (const Kernel::Vector_2& step : { Kernel::Vector_2(h, 0), Kernel::Vector_2(0, h) }) {
          p = place + step;
          const double plus = energy_by_definition(m, uv, 0);
          p = place - step;
          slope = (std::max)(slope, std::abs(plus - energy_by_definition(m, uv, 0)) / (2 * h));
          p = place;
        }
        held += slope > 1e-4 * std::sqrt(energy);
      }
      EXPECT_LE(held, 2u);
      EXPECT_NEAR(mapped.quality().area, 1, 0.5);     // the scale is that of the surface, more or less
    }
}

TEST(As_rigid_as_possible, lambda_is_in_the_units_of_the_mesh)
{
  const Flat_mesh m = delaunay_patch(300, 1, wavy);
  Mapped_mesh mapped(m);
  EXPECT_EQ(mapped.parameterize_hierarchically(0.01), OK);
  for (const double scale : { std::ldexp(1., -60), 0.25, 3., 1e60 }) {
    Flat_mesh larger = m;
    for (Point_3& p : larger.points)
      p = Point_3(scale * p.x(), scale * p.y(), scale * p.z());
    Mapped_mesh scaled(larger);
    EXPECT_EQ(scaled.parameterize_hierarchically(0.01 * scale * scale), OK);
    EXPECT_NEAR(scaled.summary.energy / (scale * scale * mapped.summary.energy), 1, 1e-6) << "scale " << scale;
    const bool is_power_of_two = std::log2(scale) == std::round(std::log2(scale));
    for (const auto v : vertices(scaled.mesh))
      for (int i = 0; i < 2 && is_power_of_two; ++i)
        ASSERT_EQ(scaled.uvmap[v][i], scale * mapped.uvmap[v][i]);
  }
}

TEST(As_rigid_as_possible, same_seed_same_bytes)
{
  const auto run = [](unsigned int seed) {
    Mapped_mesh mapped(delaunay_patch(300, 1, wavy));
    EXPECT_EQ(mapped.parameterize_hierarchically(1000, 1e-6, seed), OK);
    return mapped.uv();
  };
  EXPECT_EQ(run(8), run(8));
  EXPECT_NE(run(8), run(9));
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(As_rigid_as_possible, threads_do_not_change_the_map)
{
  typedef As_rigid_as_possible_parameterizer_3<Surface_mesh, CGAL::Parallel_tag>   Parallel_method;
  Mapped_mesh mapped(grid(120, 110, wavy));     // groups of several blocks
  EXPECT_EQ(mapped.parameterize(Hierarchical_method()), OK);
  const std::vector<Kernel::Point_2> sequential = mapped.uv();
  for (const int threads : { 1, 2, 5 }) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Parallel_method>()), OK);
    EXPECT_EQ(mapped.uv(), sequential);
  }
}
#endif

// ---- in the place of CGAL's ----

typedef ARAP_parameterizer_3<Surface_mesh>          CGAL_method;
typedef Hierarchical_parameterizer_3<CGAL_method>   Hierarchical_CGAL_method;

TEST(Hierarchical_ARAP_parameterizer, takes_the_arguments_of_CGALs_and_named_parameters)
{
  const Two_vertices_parameterizer_3<Surface_mesh> border;
  Mapped_mesh mapped(grid(16, 12, wavy));
  const auto uv = [&mapped](const auto& parameterizer) {
    EXPECT_EQ(mapped.parameterize(parameterizer), OK);
    return mapped.uv();
  };
  const auto coarse = parameters::coarsest_size(20);
  const auto method_uv = [&](const auto& method_parameters) { return uv(Hierarchical_method(Method(method_parameters), coarse)); };

  EXPECT_EQ(uv(Hierarchical_CGAL_method()), uv(Hierarchical_method()));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(0.1)), uv(Hierarchical_method(Method(parameters::lambda(0.1)))));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(10)), uv(Hierarchical_method(Method(parameters::lambda(10.)))));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border)), uv(Hierarchical_method()));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(coarse)), method_uv(parameters::default_values()));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(0.1, coarse)), method_uv(parameters::lambda(0.1)));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border, coarse)), method_uv(parameters::default_values()));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border, 0.1, coarse)), method_uv(parameters::lambda(0.1)));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border, 0.1, 1, coarse)), method_uv(parameters::lambda(0.1).number_of_iterations(1)));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border, 0.1, 9, 0.1, coarse)), method_uv(parameters::lambda(0.1).tolerance(0.1).number_of_iterations(9)));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(parameters::lambda(0.1).coarsest_size(20))), method_uv(parameters::lambda(0.1)));
}

TEST(Hierarchical_ARAP_parameterizer, tells_what_it_did)
{
  Mapped_mesh mapped(hemisphere());
  EXPECT_EQ(mapped.parameterize(Hierarchical_CGAL_method(10., parameters::coarsest_size(20).summary(std::ref(mapped.summary)))), OK);
  EXPECT_TRUE(mapped.summary.converged);
  EXPECT_GT(mapped.summary.levels.size(), 3u);
  EXPECT_NEAR(mapped.summary.energy, mapped.energy(10), 1e-8 * mapped.summary.energy);

  Mapped_mesh theirs(hemisphere());
  EXPECT_EQ(theirs.parameterize(CGAL_method(10.)), OK);
  EXPECT_LE(mapped.summary.energy, theirs.energy(10) * (1 + 1e-6));
}

// Checks that all levels are free of flips but the finest.
struct Checking_visitor
{
  bool hierarchy_built(const Collapse_hierarchy_3&) { return true; }

  bool level_parameterized(const Level& level, const Level::Uv& uv, const Level_summary&)
  {
    EXPECT_TRUE(level.is_finest() || SMP::internal::is_map_valid(level.rings(), uv)) << "level " << level.index();
    return true;
  }
};

TEST(As_rigid_as_possible, takes_every_mesh)
{
  for (const auto& [name, m] : named_meshes())
    for (const double lambda : { 0., 1000., infinity })
      for (const Optimizer optimizer : { Optimizer::NEWTON, Optimizer::SWEEPS, Optimizer::RANDOM_VERTICES }) {
        SCOPED_TRACE(name + ", lambda " + std::to_string(lambda) + ", optimizer " + std::to_string(int(optimizer)));
        Mapped_mesh mapped(m);
        const Method method(parameters::lambda(lambda).optimizer(optimizer).number_of_iterations(20));
        EXPECT_EQ(mapped.parameterize(Hierarchical_method(method, parameters::coarsest_size(20).flip_policy(Flip_policy::KEEP).summary(std::ref(mapped.summary))
                                                              .visitor(Checking_visitor()))), OK);
        EXPECT_TRUE(std::isfinite(mapped.summary.energy));
        EXPECT_LE(mapped.summary.levels.back().energy_end, mapped.summary.levels.back().energy_start + 1e-15);
        for (const Kernel::Point_2& p : mapped.uv())
          EXPECT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y()));
      }
}

} // namespace
