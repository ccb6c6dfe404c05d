// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_LINEAR_SOLVER_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_LINEAR_SOLVER_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_linear_solver.h>

#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

template <int most_right_sides>
std::unique_ptr<Linear_solver>
make_multigrid_linear_solver(const Hierarchy_interpolation* hierarchy, std::shared_ptr<const Sparse_rows<double>> rows,
                             std::vector<Mesh_unknown> unknowns, const std::vector<Index>& tied_vertices,
                             const Loops& loops)
{
  return std::make_unique<Multigrid_linear_solver<float, most_right_sides>>(hierarchy, std::move(rows),
                                                                            std::move(unknowns), tied_vertices,
                                                                            loops);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_LINEAR_SOLVER_IMPL_H
