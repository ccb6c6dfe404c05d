// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VERTEX_RELAXATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VERTEX_RELAXATION_H

#include <CGAL/Surface_mesh_parameterization/internal/Border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/relax_vertex.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL::Surface_mesh_parameterization::internal {

// Vertex relaxation on one level: minimizes its energy one vertex at a time.
template <class Energy>
class Vertex_relaxation
{
public:
  // Steps are `relaxation_factor` times Newton's, as in successive over-relaxation; between 0 and 2. `barrier`, if there is one, keeps the borders apart.
  Vertex_relaxation(const Level_energy<Energy>& energy, double relaxation_factor, Border_barrier* barrier = nullptr)
    : m_energy(energy), m_level(energy.level()), m_relaxation_factor(relaxation_factor), m_barrier(barrier)
  { }

  // Relaxes every vertex, group by group, and returns by how much the energy fell.
  double sweep(Level::Uv& uv) const
  {
    double decrease = 0;
    for (std::size_t group = 0; group <= m_level.index(); ++group)
      decrease += sweep_group(group, uv);
    return decrease;
  }

  // Relaxes the vertices that the level `group` has in addition to the next coarser one. They share no edge, so that only those on the border, where the
  // angles involve two neighbors, have to go one by one. So have all of level 0.
  double sweep_group(std::size_t group, Level::Uv& uv) const
  {
    const Collapse_hierarchy_3& hierarchy = m_level.hierarchy();
    const Index first = group == 0 ? 0 : Index(hierarchy.number_of_vertices(group - 1)), last = Index(hierarchy.number_of_vertices(group));
    const auto relax_if = [&](Index begin, Index end, bool at_border, Star<Energy>& star) {
      double decrease = 0;
      for (Index v = begin; v < end; ++v)
        if (m_level.is_border(v) == at_border)
          decrease += relax(v, uv, star);
      return decrease;
    };
    const Loops loops = group == 0 ? Loops() : m_level.loops();
    const double decrease = loops.reduce(first, last, 0., [] { return Star<Energy>(); }, [&](Index begin, Index end, Star<Energy>& star) {
      return relax_if(begin, end, false, star);
    }, [](double& sum, double d) { sum += d; });
    Star<Energy> star;
    if (m_barrier)
      m_barrier->set_reach(uv);
    return decrease + relax_if(first, last, true, star);
  }

  // Relaxes vertices that are chosen at random by a generator of 32-bit numbers, as the paper does; returns by how much the energy fell.
  template <class RandomGenerator>
  double random_steps(Level::Uv& uv, std::size_t number_of_steps, RandomGenerator& random) const
  {
    Star<Energy> star;
    double decrease = 0;
    for (std::size_t i = 0; i < number_of_steps; ++i) {
      if (m_barrier && i % m_level.number_of_vertices() == 0)
        m_barrier->set_reach(uv);
      decrease += relax(Index((std::uint64_t(random()) * m_level.number_of_vertices()) >> 32), uv, star);
    }
    return decrease;
  }

private:
  // Returns by how much the energy fell.
  double relax(Index v, Level::Uv& uv, Star<Energy>& star) const
  {
    if (m_level.is_pinned(v))
      return 0;
    m_energy.gather(v, uv, star);
    if (!m_barrier || !m_level.is_border(v))
      return relax_vertex(star, m_level.rings(), v, m_relaxation_factor, uv);
    const Point_2 start = uv[v];
    const double decrease = relax_vertex(star, m_level.rings(), v, m_relaxation_factor, uv, m_barrier->reach(v));
    m_barrier->reach(v) -= std::sqrt((uv[v] - start).squared_length());
    return decrease;
  }

  const Level_energy<Energy>& m_energy;
  const Level& m_level;
  double m_relaxation_factor;
  Border_barrier* m_barrier;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VERTEX_RELAXATION_H
