// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_RELAXATION_FACTOR_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_RELAXATION_FACTOR_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Surface_mesh_parameterization::internal {

// The factor w of successive over-relaxation, learned while sweeps go on.
//
// On n unknowns the best factor is about 2 / (1 + s / sqrt(n)). The number s is pi on a square grid; it depends on the
// shape of the domain and on the weights, but little on n, so it is kept from one level to the next. Young's relation
// tells it from the rate r by which a sweep with w lowers the residual: the plain Jacobi step then has the rate m with
// (r + w - 1)^2 = r w^2 m^2, and 1 - m^2 = s^2 / n.
//
// With a positive definite matrix, sweeps converge for every factor below 2, if not without detours. If the matrix is
// not symmetric, a large factor may make them diverge: then s is raised, and kept above what it was raised to, on the
// next level above a part of that.
class Relaxation_factor
{
public:
  explicit Relaxation_factor(bool is_symmetric) : m_is_symmetric(is_symmetric) { }

  // Sweeps begin on so many unknowns.
  void start(std::size_t number_of_unknowns)
  {
    m_root = std::sqrt(double((std::max)(number_of_unknowns, std::size_t(1))));
    m_least_s *= 0.7;
    m_least = (std::numeric_limits<double>::infinity)();
    m_sweeps = 0;
  }

  double value() const { return 2 / (1 + (std::min)(1., m_s / m_root)); }

  // Learns from the residual that a sweep has met.
  void learn(double residual)
  {
    constexpr int window = 16;
    constexpr double greatest_growth = 3;
    m_least = (std::min)(m_least, residual);
    if (!m_is_symmetric && residual > greatest_growth * m_least) {
      m_least_s = m_s = 1.4 * m_s;
      m_least = residual;
      m_sweeps = 0;
    } else if (m_sweeps++ == 0)
      m_first = residual;
    else if (m_sweeps > window) {
      learn_rate(std::pow(residual / m_first, 1. / window));
      m_sweeps = 0;
    }
  }

private:
  // With a factor above the best one the rate is w - 1, whatever s: then s is raised a little. Where the residual has
  // not fallen, nothing is known.
  void learn_rate(double rate)
  {
    const double w = value(), jacobi = (rate + w - 1) * (rate + w - 1) / (rate * w * w);
    const bool is_above_best = rate - (w - 1) < 0.1 * (2 - w);
    const double s = is_above_best ? 1.2 * m_s : jacobi < 1 ? m_root * std::sqrt(1 - jacobi) : m_s;
    m_s = (std::max)({ m_least_s, 0.5 * m_s, (std::min)(s, 1.2 * m_s) });
  }

  bool m_is_symmetric;
  double m_s = 6, m_least_s = 0;
  double m_root = 1;
  double m_least = 0;           // residual of the level
  double m_first = 0;           // residual of the window of sweeps from which a rate is learned
  int m_sweeps = 0;             // of that window
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_RELAXATION_FACTOR_H
