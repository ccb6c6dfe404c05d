// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/Edge_system.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Edge_system::Edge_system(const Level& level, const Make_weight_function& make_weight_function)
  : m_level(level), m_weights(level.rings().number_of_slots()), m_row_sums(level.number_of_vertices())
{
  constexpr int greatest_exponent = 1000;       // of a power that is finite
  set_rows(make_weight_function);
  scale_row_sums();
  m_unit = std::ldexp(1., -(std::min)(scale_exponent_of(box_of_fixed_places()), greatest_exponent));
  Level::Uv one_point;
  put_in_one_point(one_point);
  m_squared_residual_in_one_point = squared_residual(one_point);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Edge_system::set_rows(const Make_weight_function& make_weight_function)
{
  struct Scratch { Weight_function compute_weights; std::vector<Point_3> ring; std::vector<double> row; };
  std::atomic<bool> has_replaced_rows(false);
  m_level.loops().for_each_block_with_scratch(
      0, size(),
      [&] {
        return Scratch{ make_weight_function(), {}, {} };
      },
      [&](Index begin, Index end, Scratch& scratch) {
        for (Index i = begin; i < end; ++i) {
          scratch.ring.clear();
          for (Index j : m_level.one_ring(i))
            scratch.ring.push_back(m_level.point(j));
          scratch.compute_weights(m_level.point(i), scratch.ring, !m_level.is_border(i), scratch.row);
          if (!set_row(i, scratch.row) && !m_level.is_fixed(i))
            has_replaced_rows = true;
        }
      });
  m_has_replaced_rows = has_replaced_rows;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Edge_system::set_row(Index i, const std::vector<double>& row)
{
  const std::size_t size = m_level.one_ring(i).size();
  CGAL_precondition_msg(row.size() == size, "the edge weights' functor makes one weight for each neighbor");
  const double sum = std::accumulate(row.begin(), row.end(), 0.);
  const bool is_usable = sum > 0 && std::isfinite(sum) && row.size() == size;
  m_row_sums[i] = is_usable ? sum : double(size);
  double* const weights = m_weights.data() + m_level.rings().first_slot(i);
  for (std::size_t k = 0; k < size; ++k)
    weights[k] = is_usable ? row[k] / sum : 1 / double(size);
  return is_usable;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Edge_system::scale_row_sums()
{
  const double least = std::ldexp(1., -500), greatest = (std::numeric_limits<double>::max)();
  double greatest_of_free = 0;
  for (Index i = 0; i < size(); ++i)
    if (!m_level.is_fixed(i))
      greatest_of_free = (std::max)(greatest_of_free, m_row_sums[i]);
  if (greatest_of_free == 0)
    return;
  m_exponent_of_sums = -std::ilogb(greatest_of_free);
  for (Index i = 0; i < size(); ++i) {
    const double sum = std::ldexp(m_row_sums[i], m_exponent_of_sums);
    m_row_sums[i] = std::clamp(sum, least, greatest);
    m_has_replaced_rows = m_has_replaced_rows || (sum < least && !m_level.is_fixed(i));
  }
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Index> Edge_system::free_vertices() const
{
  std::vector<Index> result;
  for (Index i = 0; i < size(); ++i)
    if (!m_level.is_fixed(i))
      result.push_back(i);
  const Collapse_hierarchy_3& hierarchy = m_level.hierarchy();
  std::sort(result.begin(), result.end(),
            [&](Index i, Index j) { return hierarchy.input_vertex(i) < hierarchy.input_vertex(j); });
  return result;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Sparse_rows<double> Edge_system::matrix(const std::vector<Index>& free_vertices, bool has_unit_sums) const
{
  const std::vector<Index> number = positions_in(free_vertices, size());
  Sparse_rows<double> result;
  result.reserve(free_vertices.size(), size() + m_weights.size());
  Sparse_row row;
  for (const Index i : free_vertices) {
    const double sum = has_unit_sums ? 1 : m_row_sums[i];
    row.assign(1, { number[i], sum });
    const double* weight = m_weights.data() + m_level.rings().first_slot(i);
    for (const Index j : m_level.one_ring(i)) {
      if (number[j] != no_index)
        row.push_back({ number[j], -sum * *weight });
      ++weight;
    }
    std::sort(row.begin(), row.end());
    result.append(row);
  }
  return result;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Bbox_2 Edge_system::box_of_fixed_places() const
{
  Bbox_2 box;
  for (Index i = 0; i < size(); ++i)
    if (m_level.is_fixed(i))
      box += m_level.fixed_place(i).bbox();
  return box;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Edge_system::put_in_one_point(Level::Uv& uv) const
{
  const Bbox_2 box = box_of_fixed_places();
  uv.assign(size(), Point_2(0.5 * (box.xmin() + box.xmax()), 0.5 * (box.ymin() + box.ymax())));
  for (Index i = 0; i < size(); ++i)
    if (m_level.is_fixed(i))
      uv[i] = m_level.fixed_place(i);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double Edge_system::squared_residual(const Level::Uv& uv) const
{
  return m_level.loops().sum(0, size(), 0., [&](Index i) {
    return m_level.is_fixed(i) ? 0 : (residual(i, uv) / m_unit).squared_length();
  });
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double Edge_system::relative_residual(const Level::Uv& uv) const
{
  const double squared = squared_residual(uv);
  return squared == 0 ? 0 : std::sqrt(squared / m_squared_residual_in_one_point);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double Edge_system::energy(const Level::Uv& uv) const
{
  const double sum = m_level.loops().sum(0, size(), 0., [&](Index i) {
    const double* weight = m_weights.data() + m_level.rings().first_slot(i);
    double row = 0;
    for (Index j : m_level.one_ring(i))
      row += *weight++ * ((uv[j] - uv[i]) / m_unit).squared_length();
    return m_row_sums[i] * row;
  });
  return std::ldexp(0.25 * sum, 2 * std::ilogb(m_unit) - 2 * m_level.scale_exponent() - m_exponent_of_sums);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_IMPL_H
