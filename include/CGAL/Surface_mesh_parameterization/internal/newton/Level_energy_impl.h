// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double Level_energy::sum_of_weights() const
{
  if (m_weight == Triangle_weight::ONE)
    return double(m_level.number_of_faces());
  return m_level.loops().sum(0, Index(m_level.number_of_vertices()), 0., [&](Index v) {
    double sum = 0;
    const Rest_corners corners = m_level.rest_corners(v);
    m_level.rings().for_each_triangle_of_least_vertex(v, [&](Index, Index, std::size_t i) {
      sum += weight(corners[i]);
    });
    return sum;
  });
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double Level_energy::operator()(const Level::Uv& uv) const
{
  return m_level.loops().sum_of_blocks(0, Index(m_level.number_of_vertices()),
                                       [&](Index begin, Index end) { return sum(begin, end, uv); });
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double Level_energy::greatest_of_vertices(const Level::Uv& uv) const
{
  return -m_level.loops().min(0, Index(m_level.number_of_vertices()), 0.,
                              [&](Index v) { return -sum(v, v + 1, uv); });
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Level_energy::assemble(const Level::Uv& uv, double indefinite_part, Block_vectors& gradient,
                            Block_matrix& hessian) const
{
  // Row by row, so that no two rows write to one place.
  m_level.loops().for_each_block(0, Index(m_level.number_of_vertices()), [&](Index begin, Index end) {
    assemble_rows(begin, end, uv, indefinite_part, gradient, hessian);
  });
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Level_energy::differentiate_gradient_twice(const Level::Uv& uv, const Block_vectors& direction, double t,
                                                Block_vectors& result) const
{
  m_level.loops().for_each_block(0, Index(m_level.number_of_vertices()), [&](Index begin, Index end) {
    differentiate_rows_twice(begin, end, uv, direction, t, result);
  });
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_IMPL_H
