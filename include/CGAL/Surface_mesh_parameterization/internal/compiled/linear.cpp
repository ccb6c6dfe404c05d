// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The core library: linear systems.

#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/Edge_system_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/solve_edge_system_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Constrained_session_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Own_solver.h>

#include <CGAL/Eigen_matrix.h>
#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/IterativeLinearSolvers>

namespace CGAL::Surface_mesh_parameterization::internal {

template std::unique_ptr<Direct_solver> factorize_symmetric<double>(Index, const std::vector<Matrix_entry>&);
template std::unique_ptr<Direct_solver> factorize_hermitian<double>(const Sparse_rows<Complex<double>>&);
template std::unique_ptr<Direct_solver> factorize<double>(Index, const std::vector<Matrix_entry>&);
template std::unique_ptr<Linear_solver>
make_multigrid_linear_solver<1>(const Hierarchy_interpolation*, std::shared_ptr<const Sparse_rows<double>>,
                                std::vector<Mesh_unknown>, const std::vector<Index>&, const Loops&);
template std::unique_ptr<Linear_solver>
make_multigrid_linear_solver<2>(const Hierarchy_interpolation*, std::shared_ptr<const Sparse_rows<double>>,
                                std::vector<Mesh_unknown>, const std::vector<Index>&, const Loops&);
template std::unique_ptr<Direct_solver> make_own_solver<Default_solver_traits>(const Sparse_rows<double>&);
template Error_code solve_directly<true>(const Edge_system&, Level::Uv&);
template Error_code solve_directly<false>(const Edge_system&, Level::Uv&);

} // namespace CGAL::Surface_mesh_parameterization::internal
