// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FREE_MINIMIZER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FREE_MINIMIZER_H

#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/first_maps.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/minimize_from.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>

#include <cstddef>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// Minimizes an energy from a start, without regard to places, and from others where that ends badly: the best result
// stays.
class Free_minimizer
{
public:
  Free_minimizer(const Level_energy& energy, const Refinement_options& options, Level::Uv& uv, Level_summary& summary)
    : m_energy(energy), m_options(options), m_uv(uv), m_summary(summary)
  { }

  Error_code run()
  {
    const bool is_experiment = m_options.number_of_local_steps > 0;
    const std::size_t iterations_before = m_summary.iterations;
    m_status = minimize_from(m_energy, m_uv, m_options, m_summary);
    if (m_status == ERROR_STOPPED || m_status == GIVEN_UP || m_energy.level().is_draft())
      return m_status;
    const bool is_bad = !is_experiment && has_ended_badly(m_summary.iterations - iterations_before);
    if (m_status != OK || is_bad)
      start_from_first_maps();
    return m_status;
  }

private:
  // Whether another start costs little.
  bool is_small() const
  {
    constexpr std::size_t most_vertices = 5000;
    return m_energy.level().number_of_vertices() <= most_vertices;
  }

  // Whether the energy is so high that another start may lead to a better map.
  bool is_far_above_minimum(double value) const
  {
    constexpr double greatest_ratio_of_small = 2, greatest_ratio_of_large = 4;
    const double minimum = m_energy.minimum_of_map();
    return minimum > 0 && !(value <= (is_small() ? greatest_ratio_of_small : greatest_ratio_of_large) * minimum);
  }

  // Far above the minimum; on a small surface also where much may be left, if the run did not end at a low limit of its
  // user's.
  bool has_ended_badly(std::size_t iterations) const
  {
    constexpr double least_ratio = 1.01;
    constexpr std::size_t many_iterations = 100;
    const double value = m_summary.energy_end * m_energy.unit(), minimum = m_energy.minimum_of_map();
    if (is_far_above_minimum(value))
      return true;
    return !m_summary.converged && m_energy.level().is_finest() && is_small() && minimum > 0 &&
           value > least_ratio * minimum &&
           (iterations < m_options.number_of_iterations || iterations >= many_iterations);
  }

  // What coarse levels decide may be wrong where they have little in common with the surface. So a bad result is
  // compared with what comes of a first map of the finest level, and of the same at the scale of least energy: surfaces
  // that do not arrive from the one may do so from the other.
  void start_from_first_maps()
  {
    const bool began_there = m_energy.level().index() == 0;
    Level::Uv first;
    if ((began_there && m_energy.is_scale_invariant()) || choose_first_map(m_energy, m_options, first) != OK)
      return;
    if (!began_there)
      start_from(first);
    if (m_energy.is_scale_invariant() || m_status == ERROR_STOPPED ||
        (m_status == OK && !is_far_above_minimum(m_energy(m_uv))))
      return;
    scale_to_energy(m_energy, first);
    start_from(std::move(first));
  }

  // Replaces the result by what comes of another start, if that is better; on a large level only if the start is, too.
  void start_from(Level::Uv start)
  {
    const double value = m_energy(m_uv);
    const auto is_better = [&](const Level::Uv& uv) { return m_status != OK || m_energy(uv) < value; };
    if (!is_small() && !is_better(start))
      return;
    const Level_summary before = m_summary;
    const Error_code status = minimize_from(m_energy, start, m_options, m_summary);
    m_summary.energy_start = before.energy_start;
    if (status == OK && is_better(start)) {
      m_uv.swap(start);
      m_status = OK;
      return;
    }
    m_summary.energy_end = before.energy_end;
    m_summary.converged = before.converged;
    if (status == ERROR_STOPPED)
      m_status = ERROR_STOPPED;
  }

  const Level_energy& m_energy;
  const Refinement_options& m_options;
  Level::Uv& m_uv;
  Level_summary& m_summary;
  Error_code m_status = OK;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FREE_MINIMIZER_H
