// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

#include <CGAL/Bbox_2.h>

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
  typedef std::function<void(const Point_3&, const std::vector<Point_3>&, bool, std::vector<double>&)>
      Weight_function;

  template <class EdgeWeights>
  Edge_system(const Level& level, const EdgeWeights& weights)
    : Edge_system(level, Make_weight_function([&] { return Weight_function(EdgeWeights(weights)); }))
  { }

  const Level& level() const { return m_level; }
  Index size() const { return Index(m_row_sums.size()); }

  // The vertices that are not fixed, in the order of the hierarchy's input, which suits the cache: the unknowns of
  // matrix().
  std::vector<Index> free_vertices() const;

  // Row i holds the sum of its weights on the diagonal, and -c_ij; columns ascend. The solution for right_side() is by
  // how much the vertices are to move. With rows of unit sum, it is that for residual().
  Sparse_rows<double> matrix(const std::vector<Index>& free_vertices, bool has_unit_sums = false) const;

  // sum_j c_ij (p_j - p_i)
  Vector_2 right_side(Index i, const Level::Uv& uv) const { return m_row_sums[i] * residual(i, uv); }

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

  // Whether rows of uniform weights took the place of others, or rows have another sum than their weights, so that the
  // matrix need not be symmetric even if the weights are.
  bool has_replaced_rows() const { return m_has_replaced_rows; }

  // Puts every vertex that is not fixed into the middle of the others.
  void put_in_one_point(Level::Uv& uv) const;

  // The norm of all residuals, relative to those of that map. No number if the map has places that are not finite.
  double relative_residual(const Level::Uv& uv) const;

  // 1/2 sum c_ij |p_i - p_j|^2 over the edges, in the user's units in the plane; c_ij is the mean of both directions.
  double energy(const Level::Uv& uv) const;

private:
  // Each thread has a function of its own, which may hold scratch.
  typedef Function_ref<Weight_function()>   Make_weight_function;

  Edge_system(const Level& level, const Make_weight_function& make_weight_function);

  void set_rows(const Make_weight_function& make_weight_function);

  // A row whose sum is not positive or not finite is taken for one of uniform weights. Returns whether it was not.
  bool set_row(Index i, const std::vector<double>& row);

  // So that the greatest of a free vertex is about 1. Those that are next to 0 then are raised: they may take any
  // value, but for the symmetry of the matrix.
  void scale_row_sums();

  Bbox_2 box_of_fixed_places() const;

  double squared_residual(const Level::Uv& uv) const;

  const Level& m_level;
  std::vector<double> m_weights;      // of every slot of the rings, scaled, so that the sum of a row is 1
  std::vector<double> m_row_sums;     // before that, times a power of two
  int m_exponent_of_sums = 0;         // of that power
  bool m_has_replaced_rows = false;
  double m_unit;                      // a power of two: the fixed places, divided by it, have about size 1
  double m_squared_residual_in_one_point;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/Edge_system_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_EDGE_SYSTEM_H
