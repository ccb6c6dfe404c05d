// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_SOLVE_AND_COPY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_SOLVE_AND_COPY_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/flat_map.h>

#include <CGAL/number_utils.h>

#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Puts the numbers of a solution where a map has the marks of its unknowns.
template <class Point>
Error_code replace_marks(Multigrid_session& session, std::vector<Point>& uv)
{
  std::vector<double> solution;
  if (!session.solve_marked(solution))
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  const auto replace = [&solution](const auto& coordinate) {
    const Index i = Mesh_unknowns::marked_unknown(CGAL::to_double(coordinate), solution.size());
    return i == no_index ? coordinate : std::decay_t<decltype(coordinate)>(solution[i]);
  };
  for (Point& p : uv)
    p = Point(replace(p.x()), replace(p.y()));
  return OK;
}

// Calls `parameterize()`, which makes a parameterizer whose solver is that of the session and writes its map to `uv`.
// Where the session gives marks of the unknowns for a solution, a parameterizer that just copies it has done its work,
// and the numbers replace the marks; any other one is called once more.
template <class Point, class Function>
Error_code solve_and_copy(const std::shared_ptr<Multigrid_session>& session, std::vector<Point>& uv,
                          const Function& parameterize, bool copies_solution)
{
  const Multigrid_solver_traits::Scope scope{ Multigrid_solver_traits(session) };
  Error_code code = parameterize();
  if (session->has_given_marks()) {
    const bool are_clear = session->read_marks(flat_map(uv));
    code = code == OK && are_clear && copies_solution ? replace_marks(*session, uv) : parameterize();
  }
  return code == OK && !session->finish() ? ERROR_CANNOT_SOLVE_LINEAR_SYSTEM : code;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_SOLVE_AND_COPY_H
