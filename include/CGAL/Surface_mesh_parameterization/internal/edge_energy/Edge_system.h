// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_H

#include <CGAL/Surface_mesh_parameterization/Level.h>

#include <CGAL/Bbox_2.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The linear system of an edge energy on one level: every vertex i that is not fixed lies at the weighted mean of its neighbors,
//
//     sum_j c_ij (p_j - p_i) = 0.
//
// Rows are scaled so that their weights sum to 1. Residuals are therefore vectors in the plane: from a vertex to the mean of its neighbors.
class Edge_system
{
public:
  template <class EdgeWeights>
  Edge_system(const Level& level, const EdgeWeights& weights)
    : m_level(level), m_weights(level.rings().number_of_slots()), m_row_sums(level.number_of_vertices())
  {
    struct Scratch { EdgeWeights weights; std::vector<Point_3> ring; std::vector<double> row; };
    level.loops().for_each_block(0, size(), [&] { return Scratch{ weights, {}, {} }; }, [&](Index begin, Index end, Scratch& scratch) {
      for (Index i = begin; i < end; ++i) {
        scratch.ring.clear();
        for (Index j : level.one_ring(i))
          scratch.ring.push_back(level.point(j));
        scratch.weights(level.point(i), scratch.ring, !level.is_border(i), scratch.row);
        set_row(i, scratch.row);
      }
    });
    m_unit = squared_residual_in_one_point();
  }

  const Level& level() const { return m_level; }
  Index size() const { return Index(m_row_sums.size()); }

  // c_ij of the neighbor at a position in the ring of i; the diagonal.
  double weight(Index i, std::size_t position) const { return m_row_sums[i] * m_weights[m_level.rings().first_slot(i) + position]; }
  double sum_of_weights(Index i) const { return m_row_sums[i]; }

  Vector_2 residual(Index i, const Level::Uv& uv) const
  {
    const Point_2& p = uv[i];
    const double* weight = m_weights.data() + m_level.rings().first_slot(i);
    double x = 0, y = 0;
    for (Index j : m_level.one_ring(i)) {
      x += *weight * (uv[j].x() - p.x());
      y += *weight++ * (uv[j].y() - p.y());
    }
    return Vector_2(x, y);
  }

  // The norm of all residuals, relative to those of the map that has every vertex that is not fixed in one point.
  double relative_residual(const Level::Uv& uv) const
  {
    return relative(m_level.loops().sum(0, size(), 0., [&](Index i) { return m_level.is_fixed(i) ? 0 : residual(i, uv).squared_length(); }));
  }

  // One Gauss-Seidel sweep, group by group, with steps of `relaxation_factor` times the residual, as in successive over-relaxation. The vertices of a group
  // share no edge, but those of level 0 may. Returns the relative norm of the residuals as they were found.
  double sweep(Level::Uv& uv, double relaxation_factor) const
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

  // 1/2 sum c_ij |p_i - p_j|^2 over the edges, in the user's units in the plane; c_ij is the mean of both directions.
  double energy(const Level::Uv& uv) const
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

private:
  // A row that has no mean is taken for one of uniform weights.
  void set_row(Index i, const std::vector<double>& row)
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

  double squared_residual_in_one_point() const
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

  double relative(double squared_residual) const { return squared_residual > 0 ? std::sqrt(squared_residual / m_unit) : 0; }

  const Level& m_level;
  std::vector<double> m_weights;      // of every slot of the rings, scaled
  std::vector<double> m_row_sums;     // before they were scaled
  double m_unit;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_H
