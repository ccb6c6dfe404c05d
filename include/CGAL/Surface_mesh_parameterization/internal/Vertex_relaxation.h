// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VERTEX_RELAXATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VERTEX_RELAXATION_H

#include <CGAL/Surface_mesh_parameterization/internal/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/relax_vertex.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Surface_mesh_parameterization::internal {

// Vertex relaxation on one level: minimizes its energy one vertex at a time.
template <class Energy>
class Vertex_relaxation
{
public:
  // Steps are `relaxation_factor` times Newton's, as in successive over-relaxation; between 0 and 2.
  Vertex_relaxation(const Level_energy<Energy>& energy, double relaxation_factor)
    : m_energy(energy), m_level(energy.level()), m_relaxation_factor(relaxation_factor)
  { }

  // Returns by how much the energy fell.
  double relax(Index v, Level::Uv& uv)
  {
    if (m_level.is_pinned(v))
      return 0;
    m_energy.gather(v, uv, m_star);
    return relax_vertex(m_star, m_level.rings(), v, m_relaxation_factor, uv);
  }

  // Relaxes the vertices from `first` on, in the order of their ranks, and returns by how much the energy fell.
  double sweep(Level::Uv& uv, Index first = 0)
  {
    double decrease = 0;
    for (Index v = first; v < m_level.number_of_vertices(); ++v)
      decrease += relax(v, uv);
    return decrease;
  }

  // Relaxes vertices that are chosen at random by a generator of 32-bit numbers, as the paper does; returns by how much the energy fell.
  template <class RandomGenerator>
  double random_steps(Level::Uv& uv, std::size_t number_of_steps, RandomGenerator& random)
  {
    double decrease = 0;
    for (std::size_t i = 0; i < number_of_steps; ++i)
      decrease += relax(Index((std::uint64_t(random()) * m_level.number_of_vertices()) >> 32), uv);
    return decrease;
  }

private:
  const Level_energy<Energy>& m_energy;
  const Level& m_level;
  double m_relaxation_factor;
  Star<Energy> m_star;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VERTEX_RELAXATION_H
