// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VERTEX_RELAXATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VERTEX_RELAXATION_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/relax_vertex.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Vertex relaxation on one level: minimizes the weighted sum of the energies of all triangles, one vertex at a time.
template <class Energy>
class Vertex_relaxation
{
public:
  // Steps are `relaxation_factor` times Newton's, as in successive over-relaxation; between 0 and 2.
  Vertex_relaxation(const Level& level, Triangle_weight weight, double relaxation_factor)
    : m_level(level), m_weight(weight), m_relaxation_factor(relaxation_factor)
  {
    const One_rings& rings = level.rings();
    m_corners.resize(rings.number_of_slots());
    for (Index v = 0; v < level.number_of_vertices(); ++v) {
      const Level::Ring ring = level.one_ring(v);
      Rest_corner* const corners = m_corners.data() + rings.first_slot(v);
      for (std::size_t i = 0; i < rings.number_of_triangles(v); ++i)
        corners[i] = rest_corner(level.point(v), level.point(ring[i]), level.point(ring[i + 1 == ring.size() ? 0 : i + 1]));
    }
  }

  // The weighted sum of the triangles' energies; infinite if one of them is not positive.
  double energy(const Level::Uv& uv)
  {
    double sum = 0;
    for (Index v = 0; v < m_level.number_of_vertices(); ++v) {
      gather(v, uv);
      sum += m_star.energy(uv[v]);
    }
    return sum / 3;
  }

  // The sum of the triangles' weights.
  double total_weight() const
  {
    if (m_weight == Triangle_weight::ONE)
      return double(m_level.number_of_faces());
    double sum = 0;
    for (Index v = 0; v < m_level.number_of_vertices(); ++v)
      for (std::size_t i = 0; i < m_level.rings().number_of_triangles(v); ++i)
        sum += 1 / m_corners[m_level.rings().first_slot(v) + i].inverse_area;
    return sum / 3;
  }

  // Returns by how much the energy fell.
  double relax(Index v, Level::Uv& uv)
  {
    if (m_level.is_pinned(v))
      return 0;
    gather(v, uv);
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
  void gather(Index v, const Level::Uv& uv)
  {
    m_star.gather(m_level.rings(), uv, v, m_corners.data() + m_level.rings().first_slot(v), m_weight);
  }

  const Level& m_level;
  Triangle_weight m_weight;
  double m_relaxation_factor;
  std::vector<Rest_corner> m_corners;    // of every slot of the level's rings
  Star<Energy> m_star;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VERTEX_RELAXATION_H
