// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_SOLVE_EDGE_SYSTEM_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_SOLVE_EDGE_SYSTEM_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/Edge_system.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// Solves an edge system by factorization. Returns `OK`, or `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM` if it is singular: for
// one, because no vertex is fixed.
//
// A template for the sake of who uses the package header-only: only one of the two factorizations is compiled.
template <bool is_symmetric>
Error_code solve_directly(const Edge_system& system, Level::Uv& uv);

// Improves a map by a multigrid method until the relative residual is small enough, with the most iterations; after
// these a direct solver takes over on the finest level, while on the others the map stays as it was. Tells of the
// iterations. Returns `OK`, `ERROR_STOPPED`, or `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM` if the finest level has no map.
Error_code solve_by_multigrid(const Edge_system& system, double tolerance, std::size_t most_iterations, Level::Uv& uv,
                              Level_summary& summary);

#ifdef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
extern template Error_code solve_directly<true>(const Edge_system&, Level::Uv&);
extern template Error_code solve_directly<false>(const Edge_system&, Level::Uv&);
#endif

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/solve_edge_system_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EDGE_ENERGY_SOLVE_EDGE_SYSTEM_H
