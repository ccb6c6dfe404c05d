// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SYSTEM_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SYSTEM_H

#include <CGAL/Surface_mesh_parameterization/internal/border/Contact.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Values.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_multigrid.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Krylov_methods.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Contact_pattern.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_options.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Grids for Newton's systems on a level. Conformal motions, which a scale-invariant energy hardly resists, cost on a
// coarse grid what the interpolation misses of them: such grids have to follow each other more closely, and are worth
// more work than the smoother.
inline Block_multigrid_options multigrid_options_of(const Level_energy& energy)
{
  Block_multigrid_options result;
  result.groups_per_grid = energy.is_scale_invariant() ? 5 : 6;
  result.sweeps = energy.is_scale_invariant() ? 1 : 2;
  result.has_k_cycles = energy.is_scale_invariant();
  return result;
}

// Whether the level of an energy has one of the grids that the finest one has.
inline bool has_grid_of_finest_level(const Level_energy& energy)
{
  return Block_multigrid::has_grid_of_finest_level(energy.level(), multigrid_options_of(energy));
}

// The quadratic model of a level's energy at a map: the exact gradient, and a Hessian that is made positive
// semidefinite. Its linear systems are solved by conjugate gradients that are preconditioned by a multigrid cycle.
// Patterns are made once, for all maps.
class Newton_system
{
public:
  Newton_system(const Level_energy& energy, const Newton_options& options)
    : m_energy(energy), m_level(energy.level()), m_options(options),
      m_multigrid(energy.level(), multigrid_options_of(energy)),
      m_pattern(energy.level().rings(), m_multigrid.parts_of_finest())
  {
    m_pattern.give_to(m_multigrid.matrix());
    for (Block_vectors* vectors : { &m_solution, &m_residual, &m_direction })
      vectors->resize(m_level.number_of_vertices());
  }

  // Lets no solution move the given vertices. They have to be vertices of the coarsest level, so that all grids have
  // them, or lie on the border between such vertices, from which the grids interpolate there.
  void fix_vertices(std::vector<Index> vertices) { m_fixed = std::move(vertices); }

  // The part of what makes them indefinite that the next Hessians keep, see Jacobian_hessian. Without it Newton's
  // method converges slowly: for energies that depend on scale it takes six times as many steps on a camel's head. With
  // too much of it, its steps may lead away from the minimum.
  double indefinite_part() const { return m_indefinite_part; }

  void set_indefinite_part(double part)
  {
    m_are_grids_outdated = m_are_grids_outdated || part != m_indefinite_part;
    m_indefinite_part = part;
  }

  // Makes the model at `uv`, with the energies of the contacts; returns whether its systems can be solved.
  bool assemble(const Level::Uv& uv, const Contacts& contacts)
  {
    Block_matrix& matrix = m_multigrid.matrix();
    if (m_were_cycles_too_few && can_be_solved_directly()) {
      m_multigrid.drop_coarse_grids();
      m_are_grids_outdated = true;
    }
    if (m_pattern.join(contacts)) {
      m_pattern.give_to(matrix);
      m_multigrid.forget_pattern();
      m_are_grids_outdated = true;
    }
    Block_vectors& gradient = m_residual;
    m_energy.assemble(uv, m_indefinite_part, gradient, matrix);
    for (const Index v : m_fixed) {
      gradient[v] = Block_vector(0, 0);
      matrix.set_diagonal(v, m_options.stiffness_of_fixed_vertex * matrix.unscaled_diagonal_block(v));
    }
    m_pattern.add(contacts, matrix);
    for (const Contact& c : contacts)
      for (int i = 0; i < 3; ++i)
        gradient[c.vertices[i]] += c.first * c.gradients[i];
    for_each_vertex([&](Index v) { m_residual[v] = -matrix.scale[v] * gradient[v]; });
    m_decrease_by_relaxation = 0.5 * inner_product(m_level.loops(), m_residual, m_residual);
    if (can_keep_grids() && contacts.empty())
      m_multigrid.scale();
    else
      m_multigrid.setup();
    m_are_grids_outdated = !m_multigrid.is_ready();
    return m_multigrid.is_ready();
  }

  // When to end before the minimum of the model: where a cycle lowers it by less than the part `forcing` of what all
  // have lowered it by, or by `negligible`, or after so many cycles.
  struct Accuracy
  {
    double forcing, negligible;
    std::size_t most_cycles;
  };

  // Finds the moves that lead to the minimum, once for each model; returns the number of cycles. Where they do not
  // suffice, as for needles and where borders nearly meet, the next systems are solved directly, if the level is small.
  std::size_t solve(const Accuracy& accuracy)
  {
    const std::size_t cycles = solve_for_residual(accuracy);
    m_are_grids_weak = cycles > m_options.most_cycles_without_setup;
    m_were_cycles_too_few = cycles >= accuracy.most_cycles;
    return cycles;
  }

  // Lets the coarse grids serve for the next map, however many cycles they took.
  void keep_coarse_grids() { m_are_grids_weak = false; }

  // Finds half of the second derivative by t of the path that leads from `uv` down the valley of the model's minima,
  // and begins with the direction that solve() found.
  std::size_t solve_for_bend(const Level::Uv& uv, const Block_vectors& direction, double t, const Accuracy& accuracy)
  {
    m_energy.differentiate_gradient_twice(uv, direction, t, m_residual);
    for (const Index v : m_fixed)
      m_residual[v] = Block_vector(0, 0);
    for_each_vertex([&](Index v) { m_residual[v] *= -0.5 * m_multigrid.matrix().scale[v]; });
    return solve_for_residual(accuracy);
  }

  // Makes the last solution that of solve() the best for the model among all combinations of it and the step that led
  // from `previous` to `uv`, as nonlinear conjugate gradients do: where the cycle is weak, in almost conformal
  // changes of an almost conformal map, this saves more than half of the steps.
  void add_previous_step(const Level::Uv& previous, const Level::Uv& uv)
  {
    const Block_matrix& a = m_multigrid.matrix();
    Block_vectors &x = m_solution, &s = m_direction, &as = m_multigrid.scratch();
    for_each_vertex(
        [&](Index v) { s[v] = Block_vector(uv[v].x() - previous[v].x(), uv[v].y() - previous[v].y()) / a.scale[v]; });
    m_multigrid.multiply(s, as);
    typedef Values<double, 3>   Products;     // x A s, s A s, r s; b = r + A x
    const Products p = m_level.loops().sum(0, Index(x.size()), Products::zero(), [&](Index v) {
      return Products{ { inner_product(x[v], as[v]), inner_product(s[v], as[v]), inner_product(m_residual[v], s[v]) } };
    });
    const double xx = m_energy_of_solution, xs = p[0], ss = p[1], bx = m_product_with_right_side, bs = p[2] + xs;
    const double determinant = xx * ss - xs * xs;
    if (!(determinant > m_options.least_relative_determinant * xx * ss))
      return;
    const double factor_x = (bx * ss - bs * xs) / determinant, factor_s = (bs * xx - bx * xs) / determinant;
    for_each_vertex([&](Index v) { x[v] = factor_x * x[v] + factor_s * s[v]; });
    m_product_with_right_side = factor_x * bx + factor_s * bs;
  }

  // By how much the last solution lowers the model, as the minimum along its direction.
  double predicted_decrease() const { return 0.5 * m_product_with_right_side; }

  // By how much a step against the gradient would lower the model, about, whether there is a solution or not.
  double decrease_by_relaxation() const { return m_decrease_by_relaxation; }

  // Where the last solution moves the vertices. It is overwritten by the next one.
  const Block_vectors& moves()
  {
    const std::vector<double>& scale = m_multigrid.matrix().scale;
    for_each_vertex([&](Index v) { m_direction[v] = scale[v] * m_solution[v]; });
    return m_direction;
  }

private:
  // The system as conjugate gradients see it.
  class Iteration
  {
  public:
    Iteration(Block_multigrid& multigrid, const Level& level, double residual_reduction)
      : m_multigrid(multigrid), m_level(level), m_residual_reduction(residual_reduction)
    { }

    Index number_of_rows() const { return m_multigrid.matrix().number_of_rows(); }
    const Loops& loops() const { return m_level.loops(); }
    double multiply(const Block_vectors& x, Block_vectors& y, const Block_vectors& z) const
    {
      m_multigrid.multiply(x, y);
      return inner_product(loops(), z, y);
    }
    Block_vectors& precondition(const Block_vectors& r) { return m_multigrid.cycle(r); }
    double squared_size(Index, const Block_vector& r) const { return inner_product(r, r); }

    // Where rounding has made the cycle indefinite, the iteration begins anew.
    double direction_factor(double product, double last_product) const
    {
      return last_product > 0 ? product / last_product : 0;
    }

    // The first residual is that at the start. A run that is stopped ends with the step.
    bool is_finished(double squared_norm)
    {
      if (m_target < 0)
        m_target = m_residual_reduction * m_residual_reduction * squared_norm;
      return !(squared_norm > m_target) || !m_level.may_go_on();
    }

  private:
    Block_multigrid& m_multigrid;
    const Level& m_level;
    double m_residual_reduction, m_target = -1;
  };

  // Whether those of the last map serve for the next one. A finest level without coarse grids has its matrix factorized
  // for each map: what the factors of an earlier one miss is little enough in a cycle to be taken for convergence.
  bool can_keep_grids() const
  {
    return !m_are_grids_outdated && !m_are_grids_weak && !(m_multigrid.is_direct() && m_level.is_finest());
  }

  bool can_be_solved_directly() const
  {
    return !m_multigrid.is_direct() && m_level.number_of_vertices() <= m_options.most_vertices_solved_directly;
  }

  template <class Function>
  void for_each_vertex(const Function& f) const { m_level.loops().for_each(0, Index(m_solution.size()), f); }

  // Solves for m_solution; the right side stands in m_residual.
  std::size_t solve_for_residual(const Accuracy& accuracy)
  {
    for_each_vertex([&](Index v) { m_solution[v] = Block_vector(0, 0); });
    Iteration iteration(m_multigrid, m_level, m_options.residual_reduction);
    double sum = 0;
    const std::size_t cycles = conjugate_gradients(
        iteration, m_solution, m_residual, m_direction, accuracy.most_cycles,
        [&](double d) { return d > (std::max)(accuracy.forcing * (sum += d), accuracy.negligible); });
    for (const Index v : m_fixed)
      m_solution[v] = Block_vector(0, 0);
    const Block_matrix& a = m_multigrid.matrix();
    m_energy_of_solution = m_level.loops().sum(0, Index(m_solution.size()), 0.,
                                               [&](Index v) { return a.energy_of_row(v, m_solution); });
    m_product_with_right_side = m_energy_of_solution + inner_product(m_level.loops(), m_residual, m_solution);
    return cycles;
  }

  const Level_energy& m_energy;
  const Level& m_level;
  const Newton_options& m_options;
  Block_multigrid m_multigrid;
  Contact_pattern m_pattern;
  bool m_are_grids_outdated = true;       // they are of another pattern, or of another part of what is indefinite
  bool m_are_grids_weak = false;          // the last solution took many cycles
  bool m_were_cycles_too_few = false;     // for the last solution
  double m_indefinite_part = 0;
  std::vector<Index> m_fixed;
  Block_vectors m_solution, m_residual, m_direction;      // of the linear system A x = b, in scaled variables
  double m_decrease_by_relaxation = 0;
  double m_energy_of_solution = 0, m_product_with_right_side = 0;     // x A x, b x
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SYSTEM_H
