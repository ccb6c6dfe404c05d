// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONSTRAINED_SESSION_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONSTRAINED_SESSION_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/linear/Constrained_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Constraint_elimination.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Constrained_session::solve(const Sparse_matrix& matrix, const Vector& right_side, Vector& solution)
{
  // Of two vertices that face each other across the seam the one that lives on coarser levels stays an unknown. The
  // other one is none, but if it is there on a coarse grid it may become one: were functions 0 there, the iterations
  // would grow with the mesh. Coarse functions on the two sides are independent but for the fine edges, whose energy
  // ties them.
  const Constraint_elimination elimination(*matrix.rows(), right_side.values(), m_ranks);
  if (!elimination.is_complete())
    return false;
  m_is_free.resize(m_ranks.size());
  std::vector<Index> tied_vertices;
  for (Index i = 0; i < m_ranks.size(); ++i) {
    m_is_free[i] = elimination.is_free(i);
    if (elimination.is_tied(i))
      tied_vertices.push_back(m_ranks[i]);
  }

  Vector reduced_right_side, free_points(elimination.number_of_unknowns());
  reduced_right_side.values() = elimination.reduced_right_side();
  if (elimination.number_of_unknowns() > 0 && !(set_up(elimination.reduced_matrix(), tied_vertices) &&
                                                Multigrid_session::solve(reduced_right_side, free_points)))
    return false;
  solution.values() = elimination.expand(free_points.values());
  solution.values().resize(right_side.size(), 0.);
  return true;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONSTRAINED_SESSION_IMPL_H
