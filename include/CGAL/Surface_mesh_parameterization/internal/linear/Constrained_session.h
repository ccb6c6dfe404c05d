// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONSTRAINED_SESSION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONSTRAINED_SESSION_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Constraint_elimination.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Solves systems of Orbifold_Tutte_parameterizer_3: u and v of every vertex, and then a Lagrange multiplier for each constraint. Multigrid needs a
// definite matrix whose unknowns sit at the vertices, so it gets what Constraint_elimination leaves.
class Constrained_session : public Multigrid_session
{
public:
  // `ranks` holds the ranks of the vertices in their order in the system.
  Constrained_session(std::shared_ptr<const Hierarchy_interpolation> interpolation, std::vector<Index> ranks, const Multigrid_linear_solver::Options& options)
    : Multigrid_session(std::move(interpolation), Mesh_unknowns(ranks, [this](std::size_t i) { return !m_is_free[i]; }), options), m_ranks(std::move(ranks))
  { }

  // The multipliers, for which nobody asks, become 0.
  bool solve(const Sparse_matrix& matrix, const Vector& right_side, Vector& solution) override
  {
    // Of two vertices that face each other across the seam the one that lives on coarser levels stays an unknown. The other one is none, but if it is there on
    // a coarse grid it may become one: were functions 0 there, the iterations would grow with the mesh. Coarse functions on the two sides are independent
    // but for the fine edges, whose energy ties them.
    const Constraint_elimination elimination(*matrix.rows(), right_side.eigen_object(), m_ranks);
    if (!elimination.is_complete())
      return false;
    m_is_free.resize(m_ranks.size());
    std::vector<Index> tied_vertices;
    for (Index i = 0; i < m_ranks.size(); ++i) {
      m_is_free[i] = elimination.is_free(i);
      if (elimination.is_tied(i))
        tied_vertices.push_back(m_ranks[i]);
    }

    Vector reduced_right_side, free_points;
    reduced_right_side = elimination.reduced_right_side();
    if (elimination.number_of_unknowns() > 0
        && !(set_up(elimination.reduced_matrix(), tied_vertices) && Multigrid_session::solve(reduced_right_side, free_points)))
      return false;
    const Vector::EigenType points = elimination.expand(free_points.eigen_object());
    solution.setZero(right_side.size());
    solution.head(points.size()) = points;
    return true;
  }

private:
  std::vector<Index> m_ranks;
  std::vector<bool> m_is_free;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONSTRAINED_SESSION_H
