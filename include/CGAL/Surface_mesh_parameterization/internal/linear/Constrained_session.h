// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONSTRAINED_SESSION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONSTRAINED_SESSION_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Solves systems of Orbifold_Tutte_parameterizer_3: u and v of every vertex, and then a Lagrange multiplier for each
// constraint. Multigrid needs a definite matrix whose unknowns sit at the vertices, so it gets what
// Constraint_elimination leaves.
class Constrained_session : public Multigrid_session
{
public:
  // `ranks` holds the ranks of the vertices in their order in the system.
  Constrained_session(std::shared_ptr<const Hierarchy_interpolation> interpolation, std::vector<Index> ranks,
                      const Linear_solver_options& options, Make_linear_solver make_solver)
    : Multigrid_session(std::move(interpolation), Mesh_unknowns(ranks, [this](std::size_t i) { return !m_is_free[i]; }),
                        options, make_solver),
      m_ranks(std::move(ranks))
  { }

  // The multipliers, for which nobody asks, become 0.
  CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE bool solve(const Sparse_matrix& matrix, const Vector& right_side,
                                                       Vector& solution) override;

private:
  std::vector<Index> m_ranks;
  std::vector<bool> m_is_free;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/linear/Constrained_session_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_CONSTRAINED_SESSION_H
