// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CONFORMAL_REFINER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CONFORMAL_REFINER_H

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_method.h>

#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Minimizes the as-rigid-as-possible energy with lambda = 0, that of least squares conformal maps, on one level. It is
// quadratic, and 0 for a map to one point: two vertices stay where they are at least, besides those whose places are
// given.
class Conformal_refiner
{
public:
  Conformal_refiner(const Level& level, Level::Uv& uv, const Refinement_options& options, Level_summary& summary)
    : m_level(level), m_uv(uv), m_options(options), m_summary(summary),
      m_energy(level, Triangle_weight::AREA, As_rigid_as_possible_energy_2(0))
  { }

  // Returns false if a visitor stopped the run.
  bool run()
  {
    Newton_method newton(m_energy);
    newton.fix_vertices(vertices_to_hold());
    double current = m_energy(m_uv);
    m_summary.converged = false;
    bool may_go_on = tell(current, 0);
    const std::size_t iterations_before = m_summary.iterations;
    std::size_t iterations = 0;
    while (may_go_on && iterations < m_options.number_of_iterations && !m_summary.converged) {
      const auto step = newton.step(m_uv, current);
      current -= step.decrease;
      m_summary.iterations = iterations_before + ++iterations;
      m_summary.cycles += step.cycles;
      m_summary.converged = !(step.decrease > m_options.tolerance * current);
      may_go_on = tell(current, part_of_iteration(step.decrease / current, m_options.tolerance, iterations,
                                                  m_options.number_of_iterations));
    }
    return may_go_on;
  }

private:
  // Tells of an energy, in the user's units, and of the part of the work on the level that is done.
  bool tell(double energy, double part)
  {
    m_summary.energy_end = std::ldexp(energy, -2 * m_level.scale_exponent());
    return m_level.progressed(m_summary, part);
  }

  std::vector<Index> vertices_to_hold() const
  {
    std::vector<Index> result = fixed_vertices(m_level);
    if (result.empty())
      result.push_back(farthest_border_vertex(0));
    if (result.size() == 1)
      result.push_back(farthest_border_vertex(result.front()));
    return result;
  }

  // The vertex on the outer border, and on the coarsest level, that lies farthest from v in the plane.
  Index farthest_border_vertex(Index v) const
  {
    Index result = v;
    double greatest = 0;
    for (Index w = 0; w < m_level.hierarchy().number_of_vertices(0); ++w) {
      const double distance2 = (m_uv[w] - m_uv[v]).squared_length();
      if (m_level.hierarchy().is_on_outer_border(w) && distance2 > greatest) {
        result = w;
        greatest = distance2;
      }
    }
    return result;
  }

  const Level& m_level;
  Level::Uv& m_uv;
  const Refinement_options& m_options;
  Level_summary& m_summary;
  Level_energy_of<As_rigid_as_possible_energy_2> m_energy;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CONFORMAL_REFINER_H
