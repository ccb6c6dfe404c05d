// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_MULTIGRID_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_MULTIGRID_H

#include <CGAL/Surface_mesh_parameterization/internal/Border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/Border_guard.h>
#include <CGAL/Surface_mesh_parameterization/internal/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/V_cycle.h>
#include <CGAL/Surface_mesh_parameterization/internal/conjugate_gradients.h>
#include <CGAL/Surface_mesh_parameterization/internal/corner_hessian.h>
#include <CGAL/Surface_mesh_parameterization/internal/star_validity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Newton's method for the energy of a level: the exact gradient, a Hessian that is made positive semidefinite, the step by conjugate gradients that are
// preconditioned by a V-cycle, and a line search that keeps the map valid, if the energy keeps triangles positive. Patterns are made once, for all steps.
template <class Energy>
class Newton_multigrid
{
public:
  struct Step
  {
    double decrease = 0;          // of the energy, with the barrier's; 0 if no step was possible
    double predicted = 0;         // decrease of the quadratic model by the whole step
    double length = 0;            // 1 for the whole step
    std::size_t cycles = 0;       // V-cycles
  };

  // `barrier`, if there is one, keeps the borders apart; its energy is minimized along with the level's.
  explicit Newton_multigrid(const Level_energy<Energy>& energy, Border_barrier* barrier = nullptr)
    : m_energy(energy), m_level(energy.level()), m_barrier(barrier), m_border_guard(energy.level()), m_cycle(energy.level())
  {
    const One_rings& rings = m_level.rings();
    m_cycle.matrix().set_pattern(rings.number_of_vertices(), rings.offsets(), rings.neighbors());
    m_gradient.resize(rings.number_of_vertices());
    m_direction.resize(rings.number_of_vertices());
  }

  // Lets no step move the given vertices. They have to be vertices of the coarsest level, so that all grids have them.
  void hold(std::vector<Index> vertices) { m_held = std::move(vertices); }

  // One step from `uv`, whose energy is given; the linear system is solved to the relative residual `tolerance`.
  Step step(Level::Uv& uv, double energy, double tolerance)
  {
    Step result = try_step(uv, energy, tolerance);
    if (result.length == 0 && m_lent > 0) {
      lend(0);
      result = try_step(uv, energy, tolerance);
    }
    lend(Energy::is_flip_free || result.length < 1 ? 0 : most_lent);
    return result;
  }

private:
  Step try_step(Level::Uv& uv, double energy, double tolerance)
  {
    Step result;
    if (m_barrier) {
      m_barrier->set_gaps(uv);
      energy += (*m_barrier)(uv);
    }
    assemble(uv);
    if (m_needs_setup)
      m_cycle.setup();
    else
      m_cycle.scale();
    if (!m_cycle.is_ready())
      return result;
    result.cycles = solve(tolerance);
    if (m_trial.size() == uv.size())
      add_previous_step(uv);
    m_needs_setup = result.cycles > most_cycles_without_setup;

    const double slope = dot_with_gradient();
    result.predicted = -0.5 * slope;
    if (slope < 0)
      search_line(uv, energy, slope, tolerance, result);
    return result;
  }

  // Gradient and Hessian row by row, so that no two rows write to one place.
  void assemble(const Level::Uv& uv)
  {
    Block_matrix& matrix = m_cycle.matrix();
    for_each_vertex([&](Index v) { assemble_row(uv, v, matrix); });
    constexpr double stiffness = 1e12;      // of a spring that holds a vertex, to those of its triangles
    for (const Index v : m_held) {
      m_gradient[v] = Pair(0, 0);
      matrix.set_diagonal(v, stiffness * matrix.unscaled_diagonal_block(v));
    }
    if (m_barrier)
      m_barrier->derivatives(uv, [&](Index v, const Pair& gradient, const Block_matrix::Block& block) {
        m_gradient[v] += gradient;
        matrix.set_diagonal(v, matrix.unscaled_diagonal_block(v) + block);
        m_needs_setup = true;
      });
  }

  // The energy that steps lower.
  double objective(const Level::Uv& uv) const { return m_energy(uv) + (m_barrier ? (*m_barrier)(uv) : 0); }

  void assemble_row(const Level::Uv& uv, Index v, Block_matrix& matrix)
  {
    const Level::Ring ring = m_level.one_ring(v);
    m_level.rings().prefetch_neighbors_after(v, uv);
    const Rest_corner* const corners = m_level.rest_corners(v);
    Block_matrix::Block* const row = matrix.blocks.data() + matrix.first[v];
    std::fill(row, row + ring.size(), Block_matrix::Block::Zero());
    Block_matrix::Block diagonal = Block_matrix::Block::Zero();
    m_gradient[v] = Pair(0, 0);
    for (std::size_t i = 0; i < m_level.rings().number_of_triangles(v); ++i) {
      const std::size_t j = i + 1 == ring.size() ? 0 : i + 1;
      const Corner_hessian h = corner_hessian(m_energy.triangle_energy(corners[i]), corners[i], m_energy.weight(corners[i]),
                                              uv[ring[i]] - uv[v], uv[ring[j]] - uv[v], m_lent);
      m_gradient[v] += h.gradient;
      diagonal += h.to_v;
      row[j] += h.to_b;
      row[i] -= h.to_v + h.to_b;
    }
    matrix.set_diagonal(v, diagonal);
  }

  Index number_of_vertices() const { return Index(m_level.number_of_vertices()); }

  template <class Function>
  void for_each_vertex(const Function& f) const { m_level.loops().for_each(0, number_of_vertices(), f); }

  // See Jacobian_hessian. An energy that lets triangles flip has a negative twist wherever they are compressed, and without a loan Newton's method
  // creeps: on a camel's head it takes six times as many steps. Where a step cannot be taken in full length the model is indefinite, or no good: the next one
  // goes without, with a Hessian that is surely positive semidefinite.
  static constexpr double most_lent = 0.95;

  void lend(double part)
  {
    m_needs_setup = m_needs_setup || part != m_lent;
    m_lent = part;
  }

  // The coarse grids of an earlier step serve as long as they work: to make them costs as much as three cycles.
  static constexpr std::size_t most_cycles_without_setup = 8;

  // Solves for the direction, in scaled variables; returns the number of V-cycles.
  std::size_t solve(double tolerance)
  {
    const std::vector<double>& scale = m_cycle.matrix().scale;
    m_space.residual.resize(number_of_vertices());
    for_each_vertex([&](Index v) { m_space.residual[v] = -scale[v] * m_gradient[v]; });
    const std::size_t cycles = solve_for_residual(tolerance);
    for_each_vertex([&](Index v) { m_direction[v] = scale[v] * m_space.solution[v]; });
    return cycles;
  }

  // Solves for m_space.solution; the right side stands in m_space.residual.
  std::size_t solve_for_residual(double tolerance)
  {
    constexpr std::size_t most_cycles = 10;
    const std::size_t cycles = conjugate_gradients(m_level.loops(), m_cycle.matrix(), m_cycle, tolerance, most_cycles, m_space);
    for (const Index v : m_held)
      m_space.solution[v] = Pair(0, 0);
    return cycles;
  }

  // Takes the direction that is best for the quadratic model among all combinations of the one found and the step before, as nonlinear conjugate
  // gradients do: where the V-cycle is weak, in almost conformal changes of an almost conformal map, this saves more than half of the steps.
  void add_previous_step(const Level::Uv& uv)
  {
    const Block_matrix& a = m_cycle.matrix();
    Pair_vector &x = m_space.solution, &s = m_space.direction;
    for_each_vertex([&](Index v) {    // the line search left the map before that step in m_trial
      s[v] = Pair(uv[v].x() - m_trial[v].x(), uv[v].y() - m_trial[v].y()) / a.scale[v];
    });
    typedef Eigen::Matrix<double, 5, 1> Products;     // x A x, x A s, s A s, b x, b s
    const Products p = m_level.loops().sum(0, number_of_vertices(), Products(Products::Zero()), [&](Index v) {
      const Pair as = a.row_times(v, s), b = -a.scale[v] * m_gradient[v];
      Products result;
      result << x[v].dot(b - m_space.residual[v]), x[v].dot(as), s[v].dot(as), b.dot(x[v]), b.dot(s[v]);
      return result;
    });
    constexpr double least_relative_determinant = 1e-10;
    const double determinant = p[0] * p[2] - p[1] * p[1];
    if (!(determinant > least_relative_determinant * p[0] * p[2]))
      return;
    const double factor_x = (p[3] * p[2] - p[4] * p[1]) / determinant, factor_s = (p[4] * p[0] - p[3] * p[1]) / determinant;
    for_each_vertex([&](Index v) { m_direction[v] = a.scale[v] * (factor_x * x[v] + factor_s * s[v]); });
  }

  double dot_with_gradient() const { return dot(m_level.loops(), m_gradient, m_direction); }

  // The least t > 0 at which a triangle vanishes on the way to uv + t direction.
  double longest_step(const Level::Uv& uv) const
  {
    return m_energy.min(uv, [&](Index v, Index a, Index b, const Rest_corner&) {
      const Vector_2 p = uv[a] - uv[v], q = uv[b] - uv[v];
      const Pair d = m_direction[a] - m_direction[v], e = m_direction[b] - m_direction[v];
      const Vector_2 dp(d[0], d[1]), dq(e[0], e[1]);
      const double c0 = cross(p, q), c1 = cross(p, dq) + cross(dp, q), c2 = cross(dp, dq);
      // The least positive root of c0 + c1 t + c2 t^2, c0 > 0, in the form that does not cancel.
      const double discriminant = c1 * c1 - 4 * c0 * c2;
      const double root = discriminant < 0 || (c1 >= 0 && c2 >= 0) ? 0 : 2 * c0 / (std::sqrt(discriminant) - c1);
      return root > 0 ? root : (std::numeric_limits<double>::infinity)();
    });
  }

  // Goes along the direction as far as the energy falls and the map stays valid. Where the angles at a border vertex would reach a full turn, of which the
  // energy knows nothing, the direction is bent so that they do not, and at last cut off: the rest of the map need not wait for them.
  void search_line(Level::Uv& uv, double energy, double slope, double tolerance, Step& result)
  {
    constexpr int rounds_of_bending = 6, most_rounds = 10;
    for (int i = 0; i < most_rounds && slope < 0; ++i) {
      try_lengths(uv, energy, slope, result);
      if (result.length > 0 || !Energy::is_flip_free)
        return;
      const std::vector<Border_guard::Gap> gaps = m_border_guard.lost_gaps(uv, m_trial);
      if (gaps.empty())
        return;
      if (i < rounds_of_bending)
        result.cycles += bend(gaps, tolerance);
      else
        cut_off(gaps);
      slope = dot_with_gradient();
    }
  }

  // Changes the direction as little as is needed, in the norm of the Hessian, for no gap to lose too much, to first order: so the neighbors go along.
  // Returns the number of V-cycles.
  std::size_t bend(const std::vector<Border_guard::Gap>& gaps, double tolerance)
  {
    const std::vector<double>& scale = m_cycle.matrix().scale;
    for_each_vertex([&](Index v) { m_space.residual[v] = Pair(0, 0); });
    for (const Border_guard::Gap& gap : gaps)
      for (int i = 0; i < 3 && gap.missing > 0; ++i)
        m_space.residual[gap.vertices[i]] += scale[gap.vertices[i]] * gap.missing * gap.gradients[i];
    const std::size_t cycles = solve_for_residual(tolerance);
    const auto correction = [&](Index v) -> Pair { return scale[v] * m_space.solution[v]; };
    double factor = 0;
    std::vector<Border_guard::Gap> hopeless;
    for (const Border_guard::Gap& gap : gaps)
      if (const double change = gap.change(correction); gap.missing > 0 && change > 0)
        factor = (std::max)(factor, gap.missing / change);
      else
        hopeless.push_back(gap);
    for_each_vertex([&](Index v) { m_direction[v] += factor * correction(v); });
    cut_off(hopeless);
    return cycles;
  }

  void cut_off(const std::vector<Border_guard::Gap>& gaps)
  {
    for (const Border_guard::Gap& gap : gaps)
      for (const Index v : gap.vertices)
        m_direction[v] = Pair(0, 0);
  }

  // Halves the step until it is acceptable; ends early at one that fails only by the angles at the border.
  void try_lengths(Level::Uv& uv, double energy, double slope, Step& result)
  {
    constexpr int most_halvings = 12;
    constexpr double part_of_longest_step = 0.9, sufficient_decrease = 1e-4;
    double length = Energy::is_flip_free ? (std::min)(1., part_of_longest_step * longest_step(uv)) : 1;
    if (m_barrier)
      length = (std::min)(length, part_of_longest_step * m_barrier->longest_step(uv, m_direction));
    m_trial.resize(uv.size());
    for (int i = 0; i < most_halvings; ++i, length *= 0.5) {
      for_each_vertex([&](Index v) { m_trial[v] = uv[v] + Vector_2(length * m_direction[v][0], length * m_direction[v][1]); });
      const double decrease = energy - objective(m_trial);
      if (!(decrease > -sufficient_decrease * length * slope))
        continue;
      if (!Energy::is_flip_free || (!m_border_guard.turns_too_far(uv, m_trial) && is_map_valid(m_level.rings(), m_trial, m_level.loops()) &&
                                    (!m_barrier || m_barrier->keeps_apart(m_trial)))) {
        uv.swap(m_trial);
        result.decrease = decrease;
        result.length = length;
        return;
      }
      if (m_border_guard.turns_too_far(uv, m_trial))
        return;
    }
  }

  const Level_energy<Energy>& m_energy;
  const Level& m_level;
  Border_barrier* m_barrier;
  Border_guard m_border_guard;
  V_cycle m_cycle;
  bool m_needs_setup = true;
  double m_lent = Energy::is_flip_free ? 0 : most_lent;
  std::vector<Index> m_held;
  Pair_vector m_gradient, m_direction;
  Conjugate_gradients_space m_space;
  Level::Uv m_trial;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_MULTIGRID_H
