// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The linear system of an edge energy on one level: every vertex i that is not fixed lies at the weighted mean of its
// neighbors,
//
//     sum_j c_ij (p_j - p_i) = 0.
//
// Rows are scaled so that their weights sum to 1. Residuals are therefore vectors in the plane: from a vertex to the
// mean of its neighbors.
class Edge_system
{
public:
  // Computes the weights of the edges of one vertex, see EdgeWeights_3.
  typedef std::function<void(const Point_3&, const std::vector<Point_3>&, bool, std::vector<double>&)>   Weight_function;

  template <class EdgeWeights>
  Edge_system(const Level& level, const EdgeWeights& weights)
    : Edge_system(level, Make_weight_function([&] { return Weight_function(EdgeWeights(weights)); }))
  { }

  const Level& level() const { return m_level; }
  Index size() const { return Index(m_row_sums.size()); }

  // c_ij of the neighbor at a position in the ring of i; the diagonal.
  double weight(Index i, std::size_t position) const
  {
    return m_row_sums[i] * m_weights[m_level.rings().first_slot(i) + position];
  }
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
  double relative_residual(const Level::Uv& uv) const;

  // One Gauss-Seidel sweep, group by group, with steps of `relaxation_factor` times the residual, as in successive
  // over-relaxation. The vertices of a group share no edge, but those of level 0 may. Returns the relative norm of the
  // residuals as they were found.
  double sweep(Level::Uv& uv, double relaxation_factor) const;

  // 1/2 sum c_ij |p_i - p_j|^2 over the edges, in the user's units in the plane; c_ij is the mean of both directions.
  double energy(const Level::Uv& uv) const;

private:
  // Each thread has a function of its own, which may hold scratch.
  typedef Function_ref<Weight_function()>   Make_weight_function;

  Edge_system(const Level& level, const Make_weight_function& make_weight_function);

  // A row that has no mean is taken for one of uniform weights.
  void set_row(Index i, const std::vector<double>& row);

  double squared_residual_in_one_point() const;

  double relative(double squared_residual) const
  {
    return squared_residual > 0 ? std::sqrt(squared_residual / m_unit) : 0;
  }

  const Level& m_level;
  std::vector<double> m_weights;      // of every slot of the rings, scaled
  std::vector<double> m_row_sums;     // before they were scaled
  double m_unit;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/Edge_system_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_H
