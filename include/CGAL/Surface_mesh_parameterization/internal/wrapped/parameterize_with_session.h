// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_PARAMETERIZE_WITH_SESSION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_PARAMETERIZE_WITH_SESSION_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/flat_map.h>

#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Calls `parameterize()`, which makes a parameterizer whose solver is that of the session and writes its map to `uv`.
// Where the session gives marks of the unknowns for a solution, it is called once more.
template <class Point, class Function>
Error_code parameterize_with_session(const std::shared_ptr<Multigrid_session>& session, const std::vector<Point>& uv,
                                     const Function& parameterize)
{
  const Multigrid_solver_traits::Scope scope{ Multigrid_solver_traits(session) };
  Error_code code = parameterize();
  if (session->has_given_marks()) {
    session->read_marks(flat_map(uv));
    code = parameterize();
  }
  return code == OK && !session->finish() ? ERROR_CANNOT_SOLVE_LINEAR_SYSTEM : code;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_PARAMETERIZE_WITH_SESSION_H
