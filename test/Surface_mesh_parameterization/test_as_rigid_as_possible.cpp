// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The as-rigid-as-possible method, beside CGAL's.

#include "generated_meshes.h"
#include "mapped_mesh.h"
#include "measures.h"
#include "mesh_conversions.h"
#include "numbers_of_threads.h"
#include "test_meshes.h"
#include "visitors.h"

#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Two_vertices_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace test_as_rigid_as_possible {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef As_rigid_as_possible_parameterizer_3<Surface_mesh>    Method;
typedef Hierarchical_parameterizer_3<Method>                  Hierarchical_method;

constexpr double infinity = std::numeric_limits<double>::infinity();

// CGAL's energy of a map as it is defined: half of the sum over the triangles of sum cot |e - L x|^2 + lambda (a^2 +
// b^2 - 1)^2 with the best L = (a b; -b a).
double energy_by_definition(const Flat_mesh& m, const std::vector<Kernel::Point_2>& uv, double lambda)
{
  double sum = 0;
  for (const Index_triangle& t : m.triangles) {
    const Vector_3 p = m.points[t[1]] - m.points[t[0]], q = m.points[t[2]] - m.points[t[0]];
    const double length = std::sqrt(p.squared_length()),
                 doubled_area = std::sqrt(CGAL::cross_product(p, q).squared_length());
    const Eigen::Vector2d x[3] = { { 0, 0 }, { length, 0 }, { p * q / length, doubled_area / length } };
    double cotangents[3];
    Eigen::Vector2d in_space[3], in_plane[3], direction(0, 0);
    for (int i = 0; i < 3; ++i) {
      const Index a = t[(i + 1) % 3], b = t[(i + 2) % 3];
      in_space[i] = x[(i + 2) % 3] - x[(i + 1) % 3];
      in_plane[i] = Eigen::Vector2d(uv[b].x() - uv[a].x(), uv[b].y() - uv[a].y());
      cotangents[i] = (m.points[a] - m.points[t[i]]) * (m.points[b] - m.points[t[i]]) / doubled_area;
      direction += cotangents[i] * Eigen::Vector2d(in_plane[i].dot(in_space[i]),
                                                   in_plane[i][0] * in_space[i][1] - in_plane[i][1] * in_space[i][0]);
    }
    direction.normalize();
    sum += least_value([&](double s) {
      const double a = s * direction[0], b = s * direction[1], penalty = s * s - 1;
      double result = lambda * penalty * penalty;
      for (int i = 0; i < 3; ++i)
        result += cotangents[i] * (in_plane[i] - Eigen::Vector2d(a * in_space[i][0] + b * in_space[i][1],
                                                                 -b * in_space[i][0] + a * in_space[i][1]))
                                      .squaredNorm();
      return result;
    }, 0, 100);
  }
  return 0.5 * sum;
}

struct Mesh_with_ARAP_map : Mapped_mesh
{
  const Flat_mesh flat_mesh;

  explicit Mesh_with_ARAP_map(const Flat_mesh& m) : Mapped_mesh(m), flat_mesh(m) { }

  Error_code parameterize_hierarchically(double lambda, double tolerance = 1e-6, unsigned int seed = 0)
  {
    return parameterize(Hierarchical_method(
        Method(parameters::lambda(lambda).tolerance(tolerance)),
        parameters::coarsest_size(20).flip_policy(Flip_policy::KEEP).summary(std::ref(summary)).random_seed(seed)));
  }

  double energy(double lambda) const { return energy_by_definition(flat_mesh, uv(), lambda); }
};

std::vector<Flat_mesh> smooth_meshes()
{
  return { grid(16, 12, wavy), hemisphere(), disk_with_hole(), delaunay_patch(200, 1, wavy) };
}

TEST(As_rigid_as_possible, refuses_a_lambda_below_zero)
{
  for (const double lambda : { -1., std::numeric_limits<double>::quiet_NaN() })
    for (const bool starts_from_map : { false, true }) {
      Mesh_with_ARAP_map m(grid(20, 20, wavy));
      const auto options = parameters::lambda(lambda).initial_map(starts_from_map);
      if (starts_from_map)
        m.project();
      const std::vector<Kernel::Point_2> before = m.uv();
      EXPECT_EQ(m.parameterize(Method(options)), ERROR_WRONG_PARAMETER);
      EXPECT_EQ(m.parameterize(Hierarchical_method(options)), ERROR_WRONG_PARAMETER);
      const auto is_held = m.mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:is_held", false).first;
      is_held[Surface_mesh::Vertex_index(7)] = true;
      EXPECT_EQ(m.parameterize(Method(options.vertex_is_constrained_map(is_held))), ERROR_WRONG_PARAMETER);
      EXPECT_EQ(m.uv(), before);
    }
}

TEST(As_rigid_as_possible, energy_is_that_of_the_definition)
{
  for (const Flat_mesh& m : { grid(12, 9, wavy), crumpled_grid(14, 1), deep_cap() })
    for (const double lambda : { 0., 1e-4, 0.02, 1000. }) {
      Mesh_with_ARAP_map mapped(m);
      EXPECT_EQ(mapped.parameterize_hierarchically(lambda, 1e-3), OK);
      EXPECT_NEAR(mapped.summary.energy, mapped.energy(lambda), 1e-8 * mapped.summary.energy + 1e-14)
          << "lambda " << lambda;
    }
}

TEST(As_rigid_as_possible, energy_is_not_above_that_of_CGAL)
{
  std::vector<Flat_mesh> meshes = smooth_meshes();
  for (const Flat_mesh& m : { deep_cap(), crumpled_grid(14, 1), grid_with_holes(20), strip(20), fan(5) })
    meshes.push_back(m);
  for (const Flat_mesh& m : meshes)
    for (const double lambda : { 0.01, 1., 1000. }) {
      Mesh_with_ARAP_map ours(m), theirs(m);
      EXPECT_EQ(ours.parameterize_hierarchically(lambda), OK);
      theirs.parameterize(
          ARAP_parameterizer_3<Surface_mesh>(lambda));      // its repair of flips may fail, and leaves the map
      EXPECT_LE(ours.energy(lambda), theirs.energy(lambda) * (1 + 1e-6) + 1e-12)
          << m.triangles.size() << " triangles, lambda " << lambda;
    }
}

// Which takes negative twist that is kept: the map of a cap must compress its triangles.
TEST(As_rigid_as_possible, converges_in_few_steps)
{
  for (const Flat_mesh& m : { cap(24, 60, 0.93 * CGAL_PI), cap(40, 100, 0.93 * CGAL_PI) }) {
    Mesh_with_ARAP_map mapped(m);
    EXPECT_EQ(mapped.parameterize_hierarchically(1000, 1e-9), OK);
    EXPECT_TRUE(mapped.summary.converged);
    EXPECT_LE(mapped.summary.levels.back().iterations, 8u);
  }
}

TEST(As_rigid_as_possible, finds_the_isometry_of_a_developable_surface)
{
  for (const Flat_mesh& m :
       { grid(12, 9, flat), grid(12, 9, rolled), delaunay_patch(150, 4, flat), strip(20), single_triangle() })
    for (const double lambda : { 1e-3, 1000., infinity }) {
      Mesh_with_ARAP_map mapped(m);
      EXPECT_EQ(mapped.parameterize_hierarchically(lambda), OK);
      EXPECT_LT(mapped.summary.energy, 1e-9) << m.triangles.size() << " triangles, lambda " << lambda;
      EXPECT_NEAR(mapped.quality().symmetric_dirichlet, 4, 1e-4);
    }
}

TEST(As_rigid_as_possible, hierarchical_and_flat_runs_find_the_same_minimum)
{
  for (const Flat_mesh& m : smooth_meshes())
    for (const double lambda : { 0.1, 1000. }) {
      Mesh_with_ARAP_map mapped(m);
      EXPECT_EQ(mapped.parameterize_hierarchically(lambda, 1e-9), OK);
      Parameterization_summary flat;
      EXPECT_EQ(mapped.parameterize(Method(parameters::lambda(lambda).tolerance(1e-9).summary(std::ref(flat)))), OK);
      EXPECT_TRUE(flat.converged && mapped.summary.converged);
      EXPECT_NEAR(mapped.summary.energy / flat.energy, 1, 1e-4);
    }
}

TEST(As_rigid_as_possible, lambda_weighs_lengths_against_angles)
{
  Mesh_with_ARAP_map mapped(grid(16, 12, wavy));
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
  Mesh_with_ARAP_map mapped(grid(16, 12, wavy));
  EXPECT_EQ(mapped.parameterize_hierarchically(infinity, 1e-9), OK);
  const double rigid = mapped.summary.energy;
  for (const double lambda : { 1e6, 1e15, 1e300 }) {
    EXPECT_EQ(mapped.parameterize_hierarchically(lambda, 1e-9), OK);
    EXPECT_NEAR(mapped.summary.energy / rigid, 1, 1e-6);
  }
}

// Rounding to the user's numbers is all that happens to a map with flips that is to be kept.
TEST(As_rigid_as_possible, keeps_flips_in_floats)
{
  const auto map_in = [](auto& mapped, auto uvmap) {
    return SMP::parameterize(mapped.mesh, Hierarchical_method(parameters::flip_policy(Flip_policy::KEEP)),
                             longest_border(mapped.mesh), uvmap);
  };
  Mesh_with_ARAP_map mapped(crumpled_grid(14, 1));
  const auto floats = mapped.add_map_of_floats();
  ASSERT_EQ(map_in(mapped, mapped.uvmap), OK);
  ASSERT_GT(mapped.quality().flips, 0u);
  ASSERT_EQ(map_in(mapped, floats), OK);
  for (const auto v : vertices(mapped.mesh)) {
    EXPECT_EQ(floats[v].x(), float(mapped.uvmap[v].x()));
    EXPECT_EQ(floats[v].y(), float(mapped.uvmap[v].y()));
  }
}

TEST(As_rigid_as_possible, is_not_written_where_floats_overflow)
{
  Mesh_with_ARAP_map m(affine_image(grid(8, 8, flat), 1e45, 0, 0, 1e45));
  const auto map = m.add_map_of_floats();
  const Hierarchical_method arap(parameters::flip_policy(Flip_policy::KEEP).summary(std::ref(m.summary)));
  EXPECT_EQ(SMP::parameterize(m.mesh, arap, longest_border(m.mesh), map), ERROR_WRONG_PARAMETER);
  EXPECT_NE(std::string(m.summary.error.cause).find("too large"), std::string::npos);
  for (const auto v : vertices(m.mesh))
    EXPECT_EQ(map[v], untouched<Float_point_2>());
}

// Where angles cannot be kept and a change of scale costs next to nothing, the cheapest map is a point.
TEST(As_rigid_as_possible, shrinks_the_map_for_tiny_lambda)
{
  Mesh_with_ARAP_map mapped(crumpled_grid(14, 1));
  EXPECT_EQ(mapped.parameterize_hierarchically(1e-12), OK);
  EXPECT_LE(mapped.energy(1e-12), 0.5e-12 * double(mapped.flat_mesh.triangles.size()) * (1 + 1e-6));
}

// With lambda = 0 two vertices are held, and at no other one the energy has a slope.
TEST(As_rigid_as_possible, is_the_least_squares_conformal_map_for_lambda_0)
{
  for (const Flat_mesh& m : { grid(8, 6, wavy), disk_with_hole(), fan(5) })
    for (const bool is_hierarchical : { true, false }) {
      Mesh_with_ARAP_map mapped(m);
      EXPECT_EQ(is_hierarchical ? mapped.parameterize_hierarchically(0, 1e-12)
                                : mapped.parameterize(
                                      Method(parameters::lambda(0.).flip_policy(Flip_policy::KEEP).tolerance(1e-12))),
                OK);
      std::vector<Kernel::Point_2> uv = mapped.uv();
      const double h = 1e-4, energy = mapped.energy(0);
      std::size_t held = 0;
      for (Index v = 0; v < uv.size(); ++v) {
        Flat_mesh star = m;      // what moves with the vertex
        const auto is_apart = [&](const Index_triangle& t) { return std::find(t.begin(), t.end(), v) == t.end(); };
        star.triangles.erase(std::remove_if(star.triangles.begin(), star.triangles.end(), is_apart),
                             star.triangles.end());
        Kernel::Point_2& p = uv[v];
        const Kernel::Point_2 place = p;
        double slope = 0;
        for (const Kernel::Vector_2& step : { Kernel::Vector_2(h, 0), Kernel::Vector_2(0, h) }) {
          p = place + step;
          const double plus = energy_by_definition(star, uv, 0);
          p = place - step;
          slope = (std::max)(slope, std::abs(plus - energy_by_definition(star, uv, 0)) / (2 * h));
          p = place;
        }
        held += slope > 1e-4 * std::sqrt(energy);
      }
      EXPECT_LE(held, 2u);
      // The scale is that of the surface, more or less.
      double area_in_space = 0, area_in_plane = 0;
      for (const Index_triangle& t : m.triangles) {
        area_in_space += std::sqrt(CGAL::squared_area(m.points[t[0]], m.points[t[1]], m.points[t[2]]));
        area_in_plane += CGAL::area(uv[t[0]], uv[t[1]], uv[t[2]]);
      }
      EXPECT_NEAR(area_in_plane / area_in_space, 1, 0.5);
    }
}

TEST(As_rigid_as_possible, lambda_is_in_the_units_of_the_mesh)
{
  const Flat_mesh m = delaunay_patch(300, 1, wavy);
  Mesh_with_ARAP_map mapped(m);
  EXPECT_EQ(mapped.parameterize_hierarchically(0.01), OK);
  for (const double scale : { std::ldexp(1., -60), 0.25, 3., 1e60 }) {
    Flat_mesh larger = m;
    for (Point_3& p : larger.points)
      p = Point_3(scale * p.x(), scale * p.y(), scale * p.z());
    Mesh_with_ARAP_map scaled(larger);
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
    Mesh_with_ARAP_map mapped(delaunay_patch(300, 1, wavy));
    EXPECT_EQ(mapped.parameterize_hierarchically(1000, 1e-6, seed), OK);
    return mapped.uv();
  };
  EXPECT_EQ(run(8), run(8));
  EXPECT_NE(run(8), run(9));
}

// The map that takes the place of one that a repair would spoil is a minimum, too: another run gains nothing.
TEST(As_rigid_as_possible, replaces_a_map_by_one_that_has_converged)
{
  std::size_t replaced = 0;
  for (const Flat_mesh& m : { deep_cap(), tube(20, 12, 12), cap(20, 24, 0.97 * CGAL_PI) }) {
    Mesh_with_ARAP_map mapped(m);
    EXPECT_EQ(mapped.parameterize(Hierarchical_method(Method(), parameters::summary(std::ref(mapped.summary)))), OK);
    if (!mapped.summary.is_replaced)
      continue;
    ++replaced;
    const Parameterization_summary before = mapped.summary;
    EXPECT_EQ(mapped.parameterize(Method(parameters::initial_map(true).summary(std::ref(mapped.summary)))), OK);
    EXPECT_TRUE(mapped.summary.is_replaced);
    EXPECT_NEAR(mapped.summary.energy, before.energy, 1e-4 * before.energy);
    EXPECT_TRUE(before.converged);
  }
  EXPECT_GT(replaced, 0u);
}

// What comes of flips, by a repair or without them, is not better than the start if that was valid and had less energy.
TEST(As_rigid_as_possible, does_not_end_above_a_valid_start)
{
  for (unsigned int seed = 0; seed < 20; ++seed) {
    Random random(seed);
    Mesh_with_ARAP_map mapped(tents(8, 4, 2, random));
    const auto run = [&](bool is_restart) {
      const auto options = parameters::initial_map(is_restart).summary(std::ref(mapped.summary));
      EXPECT_EQ(mapped.parameterize(Hierarchical_method(Method(), options)), OK);
      return mapped.summary.energy;
    };
    const double energy = run(false);
    EXPECT_LE(run(true), energy * (1 + 1e-6)) << seed;
  }
}

// After a repair, too. A map that the repair would spoil is replaced: its energy is little above that of the map with
// flips, and never above that of the symmetric Dirichlet map.
TEST(As_rigid_as_possible, energy_is_that_of_the_result)
{
  std::size_t repaired = 0, replaced = 0;
  for (const Flat_mesh& m : { deep_cap(), tube(20, 12, 12), crumpled_grid(12, 1), cap(20, 24, 0.97 * CGAL_PI) })
    for (const double lambda : { 1., 1000. }) {
      Mesh_with_ARAP_map mapped(m), with_flips(m), without_flips(m);
      EXPECT_EQ(mapped.parameterize(Hierarchical_method(
                    Method(parameters::lambda(lambda)), parameters::summary(std::ref(mapped.summary)))),
                OK);
      EXPECT_EQ(mapped.quality().flips, 0u);
      EXPECT_NEAR(mapped.summary.energy, mapped.energy(lambda), 1e-6 * mapped.summary.energy);
      repaired += mapped.summary.moved_vertices > 0;
      replaced += mapped.summary.is_replaced;
      typedef Symmetric_Dirichlet_parameterizer_3<Surface_mesh>   Flip_free;
      EXPECT_EQ(without_flips.parameterize(Hierarchical_parameterizer_3<Flip_free>()), OK);
      EXPECT_LE(mapped.summary.energy, without_flips.energy(lambda));
      const auto keeping_flips = parameters::lambda(lambda).flip_policy(Flip_policy::KEEP);
      EXPECT_EQ(with_flips.parameterize(Hierarchical_method(keeping_flips)), OK);
      EXPECT_LE(mapped.summary.energy, 1.3 * with_flips.energy(lambda));
    }
  EXPECT_GT(repaired, 0u);
  EXPECT_GT(replaced, 0u);
}

// With lambda = 0 a map without flips from the start has another scale. It does not take the place of one that a repair
// of large folds, which the method may give up, leaves near the minimum.
TEST(As_rigid_as_possible, repairs_large_folds_where_that_costs_little)
{
  Random random(3);
  const Flat_mesh surface = tents(30, 10, 3, random);
  for (const double lambda : { 0., 1e-6 })
    for (const bool is_hierarchical : { true, false }) {
      Mesh_with_ARAP_map mapped(surface), with_flips(surface);
      const auto run = [&](Mesh_with_ARAP_map& m, Flip_policy policy) {
        const auto options = parameters::lambda(lambda).flip_policy(policy).summary(std::ref(m.summary));
        return is_hierarchical ? m.parameterize(Hierarchical_method(options)) : m.parameterize(Method(options));
      };
      ASSERT_EQ(run(mapped, Flip_policy::REPAIR), OK);
      ASSERT_EQ(run(with_flips, Flip_policy::KEEP), OK);
      EXPECT_EQ(mapped.quality().flips, 0u);
      EXPECT_FALSE(mapped.summary.is_replaced);
      EXPECT_LT(mapped.summary.energy, 10 * with_flips.summary.energy);
    }
}

// The repair moves two vertices: the tips of ears that are a fifth of the area.
TEST(As_rigid_as_possible, compares_a_repair_that_costs_energy_with_a_map_without_flips)
{
  Mesh_with_ARAP_map mapped(square_with_ears(10, 1000));
  EXPECT_EQ(mapped.parameterize(Hierarchical_method(Method(), parameters::summary(std::ref(mapped.summary)))), OK);
  EXPECT_GT(mapped.summary.flips, 0u);
  EXPECT_TRUE(mapped.summary.is_replaced);
  EXPECT_EQ(mapped.quality().flips, 0u);
  EXPECT_LT(mapped.summary.energy, 1e-3);      // the area is about 500
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(As_rigid_as_possible, threads_do_not_change_the_map)
{
  typedef As_rigid_as_possible_parameterizer_3<Surface_mesh, CGAL::Parallel_tag>   Parallel_method;
  Mesh_with_ARAP_map mapped(grid(120, 110, wavy));     // groups of several blocks
  EXPECT_EQ(mapped.parameterize(Hierarchical_method()), OK);
  const std::vector<Kernel::Point_2> sequential = mapped.uv();
  numbers_of_threads::for_each_number_of_threads([&] {
    EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Parallel_method>()), OK);
    EXPECT_EQ(mapped.uv(), sequential);
  });
}
#endif

// Without flips on all levels but the finest.
TEST(As_rigid_as_possible, takes_every_mesh)
{
  const On_level visitor([](const Level& level, const Level::Uv& uv) {
    EXPECT_TRUE(level.is_finest() || SMP::internal::is_map_valid(level.rings(), uv)) << "level " << level.index();
    return true;
  });
  for (const auto& [name, m] : named_meshes())
    for (const double lambda : { 0., 1000., infinity })
      for (const Optimizer optimizer : { Optimizer::NEWTON, Optimizer::SWEEPS, Optimizer::RANDOM_VERTICES }) {
        SCOPED_TRACE(name + ", lambda " + std::to_string(lambda) + ", optimizer " + std::to_string(int(optimizer)));
        Mesh_with_ARAP_map mapped(m);
        const Method method(parameters::lambda(lambda).optimizer(optimizer).number_of_iterations(20));
        EXPECT_EQ(mapped.parameterize(Hierarchical_method(method, parameters::coarsest_size(20)
                                                                      .flip_policy(Flip_policy::KEEP)
                                                                      .summary(std::ref(mapped.summary))
                                                                      .visitor(visitor))),
                  OK);
        EXPECT_TRUE(std::isfinite(mapped.summary.energy));
        EXPECT_LE(mapped.summary.levels.back().energy_end, mapped.summary.levels.back().energy_start + 1e-15);
        for (const Kernel::Point_2& p : mapped.uv())
          EXPECT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y()));
      }
}

// ---- in the place of CGAL's ----

typedef ARAP_parameterizer_3<Surface_mesh>          CGAL_method;
typedef Hierarchical_parameterizer_3<CGAL_method>   Hierarchical_CGAL_method;

TEST(Hierarchical_ARAP_parameterizer, takes_the_arguments_of_CGALs_and_named_parameters)
{
  const Two_vertices_parameterizer_3<Surface_mesh> border;
  Mesh_with_ARAP_map mapped(grid(16, 12, wavy));
  const auto uv = [&mapped](const auto& parameterizer) {
    EXPECT_EQ(mapped.parameterize(parameterizer), OK);
    return mapped.uv();
  };
  const auto coarse = parameters::coarsest_size(20);
  const auto method_uv = [&](const auto& method_parameters) {
    return uv(Hierarchical_method(Method(method_parameters), coarse));
  };

  EXPECT_EQ(uv(Hierarchical_CGAL_method()), uv(Hierarchical_method()));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(0.1)), uv(Hierarchical_method(Method(parameters::lambda(0.1)))));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(10)), uv(Hierarchical_method(Method(parameters::lambda(10.)))));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border)), uv(Hierarchical_method()));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(coarse)), method_uv(parameters::default_values()));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(0.1, coarse)), method_uv(parameters::lambda(0.1)));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border, coarse)), method_uv(parameters::default_values()));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border, 0.1, coarse)), method_uv(parameters::lambda(0.1)));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border, 0.1, 1, coarse)),
            method_uv(parameters::lambda(0.1).number_of_iterations(1)));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border, 0.1, 9, 0.1, coarse)),
            method_uv(parameters::lambda(0.1).tolerance(0.1).number_of_iterations(9)));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(parameters::lambda(0.1).coarsest_size(20))),
            method_uv(parameters::lambda(0.1)));
}

TEST(Hierarchical_ARAP_parameterizer, tells_what_it_did)
{
  Mesh_with_ARAP_map mapped(hemisphere());
  EXPECT_EQ(mapped.parameterize(
                Hierarchical_CGAL_method(10., parameters::coarsest_size(20).summary(std::ref(mapped.summary)))),
            OK);
  EXPECT_TRUE(mapped.summary.converged);
  EXPECT_GT(mapped.summary.levels.size(), 3u);
  EXPECT_NEAR(mapped.summary.energy, mapped.energy(10), 1e-8 * mapped.summary.energy);

  Mesh_with_ARAP_map theirs(hemisphere());
  EXPECT_EQ(theirs.parameterize(CGAL_method(10.)), OK);
  EXPECT_LE(mapped.summary.energy, theirs.energy(10) * (1 + 1e-6));
}

} // namespace test_as_rigid_as_possible
