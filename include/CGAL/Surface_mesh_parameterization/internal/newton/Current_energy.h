// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CURRENT_ENERGY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CURRENT_ENERGY_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_refiner_options.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Surface_mesh_parameterization::internal {

// The energy of a map that is refined, kept up by what is gained, and what is little in comparison.
class Current_energy
{
public:
  Current_energy(const Level_energy& energy, const Level::Uv& uv, const Level_refiner_options& options)
    : m_energy(energy), m_uv(uv), m_options(options), m_value(energy(uv))
  { }

  double value() const { return m_value; }
  void compute() { m_value = m_energy(m_uv); }

  // Subtracts what an iteration gained. After a deep fall, from a triangle that was almost degenerate, the difference
  // means nothing.
  void lower_by(double decrease)
  {
    m_value -= decrease;
    if (!(decrease < std::abs(m_value) && m_value < (std::numeric_limits<double>::infinity)()))
      compute();
  }

  // What is above the least energy of the triangles.
  double excess() const
  {
    const double minimum = m_energy.minimum_of_map();
    return (std::max)(m_value - minimum, m_options.least_excess * std::abs(minimum));
  }

  // Whether no triangle has more than the least energy, but for rounding.
  bool is_least() const { return m_value - m_energy.minimum_of_map() <= rounding(); }

  // A part of the excess energy.
  double little(double part) const
  {
    return (std::max)(part * excess(), rounding());
  }

  // Whether a decrease that led to the current energy is next to nothing.
  bool is_little(double decrease, double part) const { return !(decrease > little(part)); }

private:
  double rounding() const { return m_options.rounding * m_energy.size_of_values() * m_energy.total_weight(); }

  const Level_energy& m_energy;
  const Level::Uv& m_uv;
  const Level_refiner_options& m_options;
  double m_value;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CURRENT_ENERGY_H
