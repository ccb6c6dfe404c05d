// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/Edge_system.h>

#include <CGAL/Bbox_2.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Edge_system::Edge_system(const Level& level, const Make_weight_function& make_weight_function)
  : m_level(level), m_weights(level.rings().number_of_slots()), m_row_sums(level.number_of_vertices())
{
  struct Scratch { Weight_function compute_weights; std::vector<Point_3> ring; std::vector<double> row; };
  level.loops().for_each_block_with_scratch(
      0, size(),
      [&] {
        return Scratch{ make_weight_function(), {}, {} };
      },
      [&](Index begin, Index end, Scratch& scratch) {
        for (Index i = begin; i < end; ++i) {
          scratch.ring.clear();
          for (Index j : level.one_ring(i))
            scratch.ring.push_back(level.point(j));
          scratch.compute_weights(level.point(i), scratch.ring, !level.is_border(i), scratch.row);
          set_row(i, scratch.row);
        }
      });
  m_unit = squared_residual_in_one_point();
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double Edge_system::relative_residual(const Level::Uv& uv) const
{
  return relative(m_level.loops().sum(0, size(), 0., [&](Index i) {
    return m_level.is_fixed(i) ? 0 : residual(i, uv).squared_length();
  }));
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double Edge_system::sweep(Level::Uv& uv, double relaxation_factor) const
{
  double sum = 0;
  Index first = 0;
  for (std::size_t group = 0; group <= m_level.index(); ++group) {
    const Index last = Index(m_level.hierarchy().number_of_vertices(group));
    const Loops loops = group == 0 ? Loops() : m_level.loops();
    sum += loops.sum(first, last, 0., [&](Index i) {
      if (m_level.is_fixed(i))
        return 0.;
      const Vector_2 r = residual(i, uv);
      uv[i] = uv[i] + relaxation_factor * r;
      return r.squared_length();
    });
    first = last;
  }
  return relative(sum);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double Edge_system::energy(const Level::Uv& uv) const
{
  const double sum = m_level.loops().sum(0, size(), 0., [&](Index i) {
    const double* weight = m_weights.data() + m_level.rings().first_slot(i);
    double row = 0;
    for (Index j : m_level.one_ring(i))
      row += *weight++ * CGAL::squared_distance(uv[i], uv[j]);
    return m_row_sums[i] * row;
  });
  return std::ldexp(0.25 * sum, -2 * m_level.scale_exponent());
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Edge_system::set_row(Index i, const std::vector<double>& row)
{
  double sum = 0;
  for (double w : row)
    sum += w;
  const bool is_usable = sum > 0 && std::isfinite(sum);
  m_row_sums[i] = is_usable ? sum : double(row.size());
  double* const weights = m_weights.data() + m_level.rings().first_slot(i);
  for (std::size_t k = 0; k < row.size(); ++k)
    weights[k] = is_usable ? row[k] / sum : 1 / double(row.size());
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double Edge_system::squared_residual_in_one_point() const
{
  Bbox_2 box;
  for (Index i = 0; i < size(); ++i)
    if (m_level.is_fixed(i))
      box += m_level.fixed_place(i).bbox();
  const Point_2 middle(0.5 * (box.xmin() + box.xmax()), 0.5 * (box.ymin() + box.ymax()));
  return m_level.loops().sum(0, size(), 0., [&](Index i) {
    Vector_2 r(0, 0);
    const double* weight = m_weights.data() + m_level.rings().first_slot(i);
    for (Index j : m_level.one_ring(i)) {
      if (m_level.is_fixed(j))
        r = r + *weight * (m_level.fixed_place(j) - middle);
      ++weight;
    }
    return m_level.is_fixed(i) ? 0 : r.squared_length();
  });
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_IMPL_H
