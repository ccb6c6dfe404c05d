// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SYSTEM_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SYSTEM_H

#include <CGAL/Surface_mesh_parameterization/internal/border/Border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/V_cycle.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/conjugate_gradients.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/corner_hessian.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The quadratic model of a level's energy at a map: the exact gradient, and a Hessian that is made positive semidefinite. Its linear systems are solved by
// conjugate gradients that are preconditioned by a V-cycle. Patterns are made once, for all maps.
template <class Energy>
class Newton_system
{
public:
  explicit Newton_system(const Level_energy<Energy>& energy) : m_energy(energy), m_level(energy.level()), m_cycle(energy.level())
  {
    const One_rings& rings = m_level.rings();
    m_cycle.matrix().set_pattern(rings.number_of_vertices(), rings.offsets(), rings.neighbors());
    m_gradient.resize(rings.number_of_vertices());
  }

  // Lets no solution move the given vertices. They have to be vertices of the coarsest level, so that all grids have them.
  void hold(std::vector<Index> vertices) { m_held = std::move(vertices); }

  // Whether triangles lend their negative twist to the next Hessian, see Jacobian_hessian: an energy that lets triangles flip has one wherever they are
  // compressed, and without a loan Newton's method creeps: on a camel's head it takes six times as many steps. But the Hessian may be indefinite then.
  bool lends_twist() const { return m_lent > 0; }

  void lend_twist(bool lends)
  {
    constexpr double most_lent = 0.95;
    const double part = lends ? most_lent : 0;
    m_needs_setup = m_needs_setup || part != m_lent;
    m_lent = part;
  }

  // Makes the model at `uv`, with the barrier's energy if there is one; returns whether its systems can be solved.
  bool assemble(const Level::Uv& uv, const Border_barrier* barrier)
  {
    // Row by row, so that no two rows write to one place.
    for_each_vertex([&](Index v) { assemble_row(uv, v); });
    Block_matrix& matrix = m_cycle.matrix();
    constexpr double stiffness = 1e12;      // of a spring that holds a vertex, to those of its triangles
    for (const Index v : m_held) {
      m_gradient[v] = Pair(0, 0);
      matrix.set_diagonal(v, stiffness * matrix.unscaled_diagonal_block(v));
    }
    if (barrier)
      barrier->derivatives(uv, [&](Index v, const Pair& gradient, const Block_matrix::Block& block) {
        m_gradient[v] += gradient;
        matrix.set_diagonal(v, matrix.unscaled_diagonal_block(v) + block);
        m_needs_setup = true;
      });
    if (m_needs_setup)
      m_cycle.setup();
    else
      m_cycle.scale();
    return m_cycle.is_ready();
  }

  const Pair_vector& gradient() const { return m_gradient; }

  // Finds the moves that lead to the minimum, to the relative residual `tolerance`; returns the number of V-cycles.
  std::size_t solve(double tolerance)
  {
    // The coarse grids of an earlier map serve as long as they work: to make them costs as much as three cycles.
    constexpr std::size_t most_cycles_without_setup = 8;
    const std::vector<double>& scale = m_cycle.matrix().scale;
    m_space.residual.resize(m_gradient.size());
    for_each_vertex([&](Index v) { m_space.residual[v] = -scale[v] * m_gradient[v]; });
    const std::size_t cycles = solve_for_residual(tolerance);
    m_needs_setup = cycles > most_cycles_without_setup;
    return cycles;
  }

  struct Force
  {
    Index vertex;
    Pair force;
  };

  // Finds the moves that forces cause: of all with their work, those that the Hessian resists least. Returns the number of V-cycles.
  std::size_t solve(const std::vector<Force>& forces, double tolerance)
  {
    m_space.residual.assign(m_gradient.size(), Pair(0, 0));
    for (const Force& f : forces)
      m_space.residual[f.vertex] += m_cycle.matrix().scale[f.vertex] * f.force;
    return solve_for_residual(tolerance);
  }

  // Where the last solution moves a vertex.
  Pair move(Index v) const { return m_cycle.matrix().scale[v] * m_space.solution[v]; }

  // Makes the last solution that of solve() the best for the model among all combinations of it and the step that led from `previous` to `uv`, as nonlinear
  // conjugate gradients do: where the V-cycle is weak, in almost conformal changes of an almost conformal map, this saves more than half of the steps.
  void add_previous_step(const Level::Uv& previous, const Level::Uv& uv)
  {
    const Block_matrix& a = m_cycle.matrix();
    Pair_vector &x = m_space.solution, &s = m_space.direction;
    for_each_vertex([&](Index v) { s[v] = Pair(uv[v].x() - previous[v].x(), uv[v].y() - previous[v].y()) / a.scale[v]; });
    typedef Eigen::Matrix<double, 5, 1> Products;     // x A x, x A s, s A s, b x, b s
    const Products p = m_level.loops().sum(0, Index(x.size()), Products(Products::Zero()), [&](Index v) {
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
    for_each_vertex([&](Index v) { x[v] = factor_x * x[v] + factor_s * s[v]; });
  }

private:
  template <class Function>
  void for_each_vertex(const Function& f) const { m_level.loops().for_each(0, Index(m_gradient.size()), f); }

  void assemble_row(const Level::Uv& uv, Index v)
  {
    Block_matrix& matrix = m_cycle.matrix();
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

  // Solves for m_space.solution; the right side stands in m_space.residual.
  std::size_t solve_for_residual(double tolerance)
  {
    constexpr std::size_t most_cycles = 10;
    const std::size_t cycles = conjugate_gradients(m_level.loops(), m_cycle.matrix(), m_cycle, tolerance, most_cycles, m_space);
    for (const Index v : m_held)
      m_space.solution[v] = Pair(0, 0);
    return cycles;
  }

  const Level_energy<Energy>& m_energy;
  const Level& m_level;
  V_cycle m_cycle;
  bool m_needs_setup = true;
  double m_lent = 0;
  std::vector<Index> m_held;
  Pair_vector m_gradient;
  Conjugate_gradients_space m_space;      // its unknowns are scaled
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SYSTEM_H
