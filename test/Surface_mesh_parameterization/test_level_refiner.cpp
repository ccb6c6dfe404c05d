// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A level refined by each of the optimizers.

#include "energy_archetype.h"
#include "hierarchies.h"
#include "level_maps.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_convergence.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_refiner.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_refiner_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace test_level_refiner {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;

TEST(Level_refiner, finds_the_isometry_of_a_developable_surface)
{
  for (const Flat_mesh& m :
       { grid(12, 9, flat), grid(12, 9, rolled), delaunay_patch(150, 4, flat), strip(20), fan(3), single_triangle() })
    for (const Optimizer optimizer : { Optimizer::NEWTON, Optimizer::SWEEPS }) {
      const Finest_level f(m);
      Refinement_options options;
      options.optimizer = optimizer;
      options.number_of_iterations = 5000;
      options.tolerance = 1e-9;
      Level::Uv uv = first_map(f.level);
      Level_summary summary;
      refine<MIPS_energy_2>(f.level, uv, options, summary);
      const bool is_cone = m.triangles.size() == 3;     // the one that cannot be developed
      const double excess = summary.energy_end - 2 * double(m.triangles.size());
      EXPECT_EQ(excess < 1e-5 * double(m.triangles.size()), !is_cone)
          << m.triangles.size() << " triangles, excess " << excess;
      EXPECT_GE(excess, -1e-9);
    }
}

// Its derivatives lead up, so that no step is possible.
struct Misled_energy : Energy_archetype
{
  const Misled_energy& of_area(double) const { return *this; }
  static Distortion_derivatives_2 derivatives(double f, double d)
  {
    Distortion_derivatives_2 result = Energy_archetype::derivatives(f, d);
    result.f = -result.f;
    result.d = -result.d;
    return result;
  }
};

template <class Energy>
bool converges()
{
  const Finest_level f(grid(8, 8, wavy));
  Level::Uv uv = first_map(f.level);
  Level_summary summary;
  refine<Energy>(f.level, uv, Refinement_options(), summary);
  return summary.converged;
}

TEST(Level_refiner, has_not_converged_where_it_is_stuck)
{
  EXPECT_TRUE(converges<Energy_archetype>());
  EXPECT_FALSE(converges<Misled_energy>());
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
    refine<Symmetric_Dirichlet_energy_2>(f.level, uv, options, summary);
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

// Where Newton's method converges slowly, small steps are no sign that nothing is left.
TEST(Level_refiner, leaves_no_more_than_twice_the_tolerance)
{
  for (const Flat_mesh& m : { grid(12, 9, wavy), deep_cap(), hemisphere(), delaunay_patch(300, 5, wavy) }) {
    const Finest_level f(m);
    const double minimum = 2 * double(m.triangles.size());
    const auto excess = [&](double tolerance) {
      Refinement_options options;
      options.number_of_iterations = 200;
      options.tolerance = tolerance;
      Level::Uv uv = first_map(f.level);
      Level_summary summary;
      refine<MIPS_energy_2>(f.level, uv, options, summary);
      return summary.energy_end - minimum;
    };
    const double best = excess(1e-13);
    for (const double tolerance : { 1e-3, 1e-4, 1e-5, 1e-6, 1e-7 })
      EXPECT_LE(excess(tolerance), best * (1 + 2 * tolerance)) << m.triangles.size() << " triangles, " << tolerance;
  }
}

// Its steps, and whether it was given up, with borders kept apart or not.
std::pair<std::size_t, bool> steps_of(const Level& level, bool keeps_borders_apart,
                                      const Level_refiner_options& options)
{
  const Level_energy_of<MIPS_energy_2> energy(level, Triangle_weight::ONE);
  Refinement_options refinement;
  refinement.is_globally_injective = keeps_borders_apart;
  Level::Uv uv = first_map(level);
  Level_summary summary;
  summary.iterations = 1000;        // those of another start
  const Error_code status = Level_refiner(energy, uv, refinement, summary, options).run();
  return { summary.iterations - 1000, status == GIVEN_UP };
}

TEST(Level_refiner, gives_up_what_keeps_borders_apart_in_vain)
{
  Finest_level f(grid(12, 9, wavy));
  Level_refiner_options options;
  options.most_steps_in_vain = 2;
  const auto [steps, unused] = steps_of(f.level, true, options);
  ASSERT_GT(steps, 2u);
  typedef std::pair<std::size_t, bool>   Result;
  const double minimum = 2 * double(f.level.number_of_faces());
  f.level.give_up_above(minimum);
  EXPECT_EQ(steps_of(f.level, true, options), Result(2, true));
  EXPECT_EQ(steps_of(f.level, true, Level_refiner_options()), Result(steps, false));
  EXPECT_FALSE(steps_of(f.level, false, options).second);
  f.level.give_up_above(100 * minimum);
  EXPECT_EQ(steps_of(f.level, true, options), Result(steps, false));
}

TEST(Level_refiner, gives_up_sooner_what_is_far_above)
{
  Finest_level f(grid(12, 9, wavy));
  Level_refiner_options options;
  const std::size_t steps = steps_of(f.level, true, options).first;
  ASSERT_GT(steps, 2u);
  typedef std::pair<std::size_t, bool>   Result;
  const double minimum = 2 * double(f.level.number_of_faces());
  options.most_steps_far_above = 2;
  f.level.give_up_above(minimum / options.far_above);
  EXPECT_EQ(steps_of(f.level, true, options), Result(2, true));
  f.level.give_up_above(minimum);
  EXPECT_EQ(steps_of(f.level, true, options), Result(steps, false));
}

// It is at rest only when the energy has not fallen for long, or it has had its steps.
TEST(Level_refiner, goes_on_while_vertices_are_wedged_between_borders)
{
  const Finest_level f(grid(12, 9, wavy));
  Level_refiner_options options;
  const std::size_t steps = steps_of(f.level, true, options).first;
  ASSERT_LT(steps, options.most_steps_without_fall);
  options.least_part_of_jam = 0;        // else much of the energy must be at one vertex
  EXPECT_EQ(steps_of(f.level, true, options).first, steps);
  options.least_ratio_of_jam = 0;
  EXPECT_GE(steps_of(f.level, true, options).first, options.most_steps_without_fall);
  EXPECT_LT(steps_of(f.level, false, options).first, options.most_steps_without_fall);
  options.most_steps_in_jam = steps + 2;
  EXPECT_LE(steps_of(f.level, true, options).first, steps + 3);
  options.most_steps_in_jam = 60;
  options.least_part_of_jam = 1;
  EXPECT_EQ(steps_of(f.level, true, options).first, steps);
}

// Of the sum it is at least the mean and at most all, which it is nearly where one triangle is about to vanish.
TEST(Level_energy, tells_the_greatest_part_of_it)
{
  const Finest_level f(grid(12, 9, wavy));
  const Level_energy_of<MIPS_energy_2> energy(f.level, Triangle_weight::ONE);
  Level::Uv uv = first_map(f.level);
  const double all = energy(uv), greatest = energy.greatest_of_vertices(uv);
  EXPECT_GE(greatest, all / double(f.level.number_of_vertices()));
  EXPECT_LT(greatest, 0.5 * all);
  const Level::Triangle t = f.level.triangles().front();
  const Point_2 middle = CGAL::midpoint(uv[t[1]], uv[t[2]]);
  uv[t[0]] = middle + 1e-9 * (uv[t[0]] - middle);
  EXPECT_GT(energy.greatest_of_vertices(uv), 0.25 * energy(uv));
  EXPECT_GT(energy(uv), 1e6 * all);
  EXPECT_LE(energy.greatest_of_vertices(uv), energy(uv));
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
      const Level_energy_of<MIPS_energy_2> energy(f.level, weight);
      const double unit = weight == Triangle_weight::ONE ? 1 : energy.total_weight();
      Level::Uv uv = first_map(f.level);
      Level_summary summary;
      const double before = energy(uv);
      refine<MIPS_energy_2>(f.level, uv, options, summary);
      EXPECT_NEAR(summary.energy_start * unit / before, 1, 1e-12);
      EXPECT_NEAR(summary.energy_end * unit / energy(uv), 1, 1e-12);
      EXPECT_LT(summary.energy_end, summary.energy_start);
      EXPECT_EQ(summary.iterations, 3u);
      EXPECT_FALSE(summary.converged);
      EXPECT_EQ(summary.cycles > 0, optimizer == Optimizer::NEWTON);
      EXPECT_TRUE(optimizer == Optimizer::NEWTON || summary.vertex_visits == 3 * uv.size());
    }
}

// Whatever was done on the level before.
TEST(Level_refiner, takes_exactly_the_local_steps_it_is_given)
{
  constexpr std::size_t visits_before = 5000;
  const Finest_level f(grid(12, 9, wavy));
  Refinement_options options;
  options.optimizer = Optimizer::RANDOM_VERTICES;
  options.number_of_local_steps = 1000;
  std::vector<Level::Uv> results;
  for (const unsigned int seed : { 3u, 3u, 4u }) {
    options.random_seed = seed;
    results.push_back(first_map(f.level));
    Level_summary summary;
    summary.vertex_visits = visits_before;
    refine<MIPS_energy_2>(f.level, results.back(), options, summary);
    EXPECT_EQ(summary.vertex_visits, visits_before + options.number_of_local_steps);
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
    refine<MIPS_energy_2>(f.level, maps.back(), options, summary);
    EXPECT_TRUE(is_map_valid(f.level.rings(), maps.back()));
  }
  const Level_energy_of<MIPS_energy_2> one(f.level, Triangle_weight::ONE), by_area(f.level, Triangle_weight::AREA);
  EXPECT_LT(one(maps[0]), one(maps[1]));    // each is best by its own measure
  EXPECT_LT(by_area(maps[1]), by_area(maps[0]));
}

// ---- what decreases tell ----

TEST(Decreases, foretell_the_rest_of_a_geometric_series)
{
  for (const double ratio : { 0.1, 0.5, 0.9 }) {
    Decreases decreases(1e-5);
    for (int i = 0; i < 3; ++i)
      decreases.add(std::pow(ratio, i), true);
    double rest = 0;
    for (int i = 3; i < 1000; ++i)
      rest += std::pow(ratio, i);
    EXPECT_NEAR(decreases.remainder(), rest, 1e-12 * rest);
  }
}

// One that is much smaller than those before makes no series that converges so fast.
TEST(Decreases, foretell_no_less_than_each_of_them_says)
{
  Decreases decreases(1e-5);
  for (const double decrease : { 3000., 2000., 0.05 })
    decreases.add(decrease, true);
  EXPECT_GE(decreases.remainder(), 0.05 * (2. / 3) / (1 - 2. / 3) * (1 - 1e-12));
}

TEST(Decreases, foretell_nothing_after_steps_that_are_not_regular)
{
  Decreases decreases(1e-5);
  for (const bool is_regular : { true, true, false, true, true })
    decreases.add(1, is_regular);
  EXPECT_TRUE(std::isinf(decreases.remainder()));
  decreases.add(1, true);      // none gains less than the one before
  EXPECT_TRUE(std::isinf(decreases.remainder()));
}

// An energy that goes up and down, or falls by next to nothing, stagnates; one that falls below all before does not.
TEST(Stagnation, lasts_while_the_energy_does_not_fall_below_what_it_was)
{
  Stagnation stagnation(10);
  for (const double energy : { 9., 8., 7. }) {
    stagnation.add(energy, 0.5);
    EXPECT_EQ(stagnation.number_of_steps(), 0u);
  }
  std::size_t steps = 0;
  for (const double energy : { 12., 7.1, 11., 6.9, 6.6 }) {
    stagnation.add(energy, 0.5);
    EXPECT_EQ(stagnation.number_of_steps(), ++steps);
  }
  stagnation.add(6.4, 0.5);
  EXPECT_EQ(stagnation.number_of_steps(), 0u);
  stagnation.add(std::numeric_limits<double>::quiet_NaN(), 0.5);
  EXPECT_EQ(stagnation.number_of_steps(), 1u);
}

TEST(Decreases, are_sudden_once)
{
  Decreases decreases(1e-5);
  decreases.add(1e-9, true);       // the first one
  EXPECT_FALSE(decreases.is_sudden());
  decreases.add(1, true);
  EXPECT_FALSE(decreases.is_sudden());
  decreases.add(1e-9, true);
  EXPECT_TRUE(decreases.is_sudden());
  decreases.add(1e-9, true);
  EXPECT_FALSE(decreases.is_sudden());
}

} // namespace test_level_refiner
