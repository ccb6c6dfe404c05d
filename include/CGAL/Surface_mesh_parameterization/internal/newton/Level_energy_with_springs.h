// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_WITH_SPRINGS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_WITH_SPRINGS_H

#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// An energy of a level together with that of springs, which pull vertices to places:
//
//   sum of stiffness / 2 |uv[v] - place|^2
//
// Vertices with springs are moved by Newton's method only, not one at a time.
class Level_energy_with_springs final
  : public Level_energy
{
public:
  typedef Triangulated_surface_3::Spring   Spring;

  // `energy` is kept by reference. The vertices of the springs ascend.
  Level_energy_with_springs(const Level_energy& energy, std::vector<Spring> springs)
    : Level_energy(energy), m_energy(energy), m_springs(std::move(springs))
  { }

  const Level_energy& without_springs() const { return m_energy; }
  const std::vector<Spring>& springs() const { return m_springs; }

  // The part of the springs.
  double energy_of_springs(const Level::Uv& uv) const { return sum_of_springs(m_springs.begin(), m_springs.end(), uv); }

  std::unique_ptr<Vertex_relaxer> make_vertex_relaxer() const override
  {
    return std::make_unique<Relaxer>(m_energy.make_vertex_relaxer(), *this);
  }

private:
  typedef std::vector<Spring>::const_iterator   Iterator;

  struct Relaxer final
    : Vertex_relaxer
  {
    std::unique_ptr<Vertex_relaxer> relaxer;
    const Level_energy_with_springs& energy;

    Relaxer(std::unique_ptr<Vertex_relaxer> relaxer_, const Level_energy_with_springs& energy_)
      : relaxer(std::move(relaxer_)), energy(energy_)
    { }

    double relax(Index v, int steps, double relaxation_factor, double reach, Level::Uv& uv) override
    {
      return energy.has_spring(v) ? 0 : relaxer->relax(v, steps, relaxation_factor, reach, uv);
    }
  };

  Iterator first_from(Index v) const
  {
    return std::lower_bound(m_springs.begin(), m_springs.end(), v,
                            [](const Spring& s, Index w) { return s.vertex < w; });
  }

  bool has_spring(Index v) const
  {
    const Iterator s = first_from(v);
    return s != m_springs.end() && s->vertex == v;
  }

  static double sum_of_springs(Iterator begin, Iterator end, const Level::Uv& uv)
  {
    double result = 0;
    for (Iterator s = begin; s != end; ++s)
      result += 0.5 * s->stiffness * (uv[s->vertex] - s->place).squared_length();
    return result;
  }

  double sum(Index begin, Index end, const Level::Uv& uv) const override
  {
    return m_energy.sum(begin, end, uv) + sum_of_springs(first_from(begin), first_from(end), uv);
  }

  void assemble_rows(Index begin, Index end, const Level::Uv& uv, double indefinite_part, Block_vectors& gradient,
                     Block_matrix& hessian) const override
  {
    m_energy.assemble_rows(begin, end, uv, indefinite_part, gradient, hessian);
    const Iterator last = first_from(end);
    for (Iterator s = first_from(begin); s != last; ++s) {
      const Vector_2 force = s->stiffness * (uv[s->vertex] - s->place);
      gradient[s->vertex] += Block_vector(force.x(), force.y());
      hessian.set_diagonal(s->vertex, hessian.unscaled_diagonal_block(s->vertex) +
                                          Block(s->stiffness, 0, 0, s->stiffness));
    }
  }

  void differentiate_rows_twice(Index begin, Index end, const Level::Uv& uv, const Block_vectors& direction, double t,
                                Block_vectors& result) const override
  {
    m_energy.differentiate_rows_twice(begin, end, uv, direction, t, result);     // springs are quadratic
  }

  const Level_energy& m_energy;
  std::vector<Spring> m_springs;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_WITH_SPRINGS_H
