// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Multigrid for the systems of Newton's method: the cycle and the iteration.

#include "hierarchies.h"
#include "level_maps.h"
#include "random_block_matrices.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_multigrid.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Krylov_methods.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Contact_pattern.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>

namespace test_v_cycle {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;
using test_systems::Random_matrix;
using test_systems::dense_of;
using test_systems::random_vectors;
namespace parameters = CGAL::parameters;

TEST(V_cycle, is_a_symmetric_positive_preconditioner)
{
  Random random(6);
  const Finest_level f(grid(40, 40, wavy));
  const Finest_level many(grid(40, 40, wavy), parameters::coarsest_size(20));
  Block_multigrid_options one_sweep, two_sweeps;
  one_sweep.sweeps = 1;
  for (const Level* level : { &f.level, &many.level })
    for (const Block_multigrid_options& options : { one_sweep, two_sweeps }) {
      Block_multigrid multigrid(*level, options);
      const Random_matrix a(*level, random);
      multigrid.matrix() = a.matrix;
      multigrid.setup();
      ASSERT_TRUE(multigrid.is_ready());
      for (int i = 0; i < 5; ++i) {
        const Block_vectors x = random_vectors(level->number_of_vertices(), random),
                            y = random_vectors(level->number_of_vertices(), random);
        const Block_vectors mx = multigrid.cycle(x), my = multigrid.cycle(y);
        EXPECT_NEAR(inner_product(Loops(), mx, y), inner_product(Loops(), x, my),
                    1e-10 * std::sqrt(inner_product(Loops(), mx, mx) * inner_product(Loops(), y, y)));
        EXPECT_GT(inner_product(Loops(), mx, x), 0);
      }
    }
}

TEST(V_cycle, is_a_direct_solution_without_coarse_grids)
{
  Random random(8);
  const Finest_level f(grid(40, 40, wavy), parameters::coarsest_size(20));
  Block_multigrid multigrid(f.level);
  const Random_matrix a(f.level, random);
  const Block_vectors b = random_vectors(f.level.number_of_vertices(), random);
  Block_vectors ax(b.size());
  for (const bool is_direct : { false, true }) {
    if (is_direct)
      multigrid.drop_coarse_grids();
    multigrid.matrix() = a.matrix;
    multigrid.setup();
    ASSERT_TRUE(multigrid.is_ready());
    EXPECT_EQ(multigrid.is_direct(), is_direct);
    multigrid.multiply(multigrid.cycle(b), ax);
    EXPECT_EQ((dense_of(b) - dense_of(ax)).norm() < 1e-9 * dense_of(b).norm(), is_direct);
  }
}

// The system as the method sees it.
struct Block_system
{
  Block_multigrid& multigrid;
  double target;
  Loops sequential = {};

  Index number_of_rows() const { return multigrid.matrix().number_of_rows(); }
  const Loops& loops() const { return sequential; }
  double multiply(const Block_vectors& x, Block_vectors& y, const Block_vectors& z) const
  {
    multigrid.multiply(x, y);
    return inner_product(sequential, z, y);
  }
  Block_vectors& precondition(const Block_vectors& r) { return multigrid.cycle(r); }
  double squared_size(Index, const Block_vector& r) const { return inner_product(r, r); }
  double direction_factor(double a, double b) const { return SMP::internal::quotient(a, b); }
  bool is_finished(double squared_norm) const { return std::sqrt(squared_norm) <= target; }
};

TEST(Conjugate_gradients_with_V_cycles, reach_the_residual_they_are_asked_for)
{
  Random random(7);
  const Finest_level f(grid(40, 40, wavy), parameters::coarsest_size(20));
  Block_multigrid multigrid(f.level);
  const Random_matrix a(f.level, random);
  multigrid.matrix() = a.matrix;
  multigrid.setup();
  for (const double tolerance : { 0.1, 1e-4, 1e-8 }) {
    const Block_vectors b = random_vectors(f.level.number_of_vertices(), random);
    const double target = tolerance * std::sqrt(inner_product(Loops(), b, b));
    Block_system system{ multigrid, target };
    Block_vectors x(b.size(), Block_vector::zero()), residual = b, scratch(b.size());
    const std::size_t iterations = conjugate_gradients(system, x, residual, scratch, 100);
    EXPECT_LT(iterations, 50u);
    Block_vectors ax(b.size());
    multigrid.multiply(x, ax);
    EXPECT_LE((dense_of(b) - dense_of(ax)).norm(), 1.001 * target);
  }
}

// The cycles that reduce the residual by a factor of 100 for the Hessian of MIPS at a conformal map, where the right
// side is that of an almost conformal motion.
std::size_t cycles_for_conformal_motion(Index n)
{
  const Finest_level f(grid(n, n, flat), parameters::coarsest_size(20));
  const Level::Uv uv = identity_map(f.level);
  const Level_energy_of<MIPS_energy_2> energy(f.level, Triangle_weight::ONE);
  Block_multigrid multigrid(f.level, multigrid_options_of(energy));
  const Contact_pattern pattern(f.level.rings());
  pattern.give_to(multigrid.matrix());
  Block_vectors gradient(uv.size()), motion, b(uv.size());
  energy.assemble(uv, 0, gradient, multigrid.matrix());
  multigrid.setup();
  for (Index v = 0; v < uv.size(); ++v) {
    const std::complex<double> z(uv[v].x() - 0.4, uv[v].y() - 0.3), w = z * z * z / multigrid.matrix().scale[v];
    motion.emplace_back(w.real(), w.imag());
  }
  multigrid.multiply(motion, b);
  Block_system system{ multigrid, 0.01 * std::sqrt(inner_product(Loops(), b, b)) };
  Block_vectors x(b.size(), Block_vector::zero()), scratch(b.size());
  return conjugate_gradients(system, x, b, scratch, 100);
}

TEST(Conjugate_gradients_with_V_cycles, need_not_many_more_cycles_for_conformal_motions_on_more_grids)
{
  // 20,000 vertices and 1300. With plain V-cycles there would be four times as many, or more.
  EXPECT_LE(cycles_for_conformal_motion(140), 3 * cycles_for_conformal_motion(35));
}

} // namespace test_v_cycle
