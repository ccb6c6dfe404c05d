// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_SOLVER_USE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_SOLVER_USE_H

#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Surface_mesh_parameterization {

template <class, class, class> class Barycentric_mapping_parameterizer_3;
template <class, class, class> class Discrete_authalic_parameterizer_3;
template <class, class, class> class Discrete_conformal_map_parameterizer_3;
template <class, class, class> class Iterative_authalic_parameterizer_3;
template <class, class, class> class LSCM_parameterizer_3;
template <class, class, class> class Mean_value_coordinates_parameterizer_3;

namespace internal {

struct Plain_solver_use
{
  static constexpr bool is_shipped = false;               // with CGAL
  static constexpr bool solves_in_pairs = false;          // for u and for v, before it looks at either
  static constexpr bool has_uniform_weights = false;
  static constexpr bool always_suits_multigrid = true;    // see Multigrid_session::suits_multigrid()
  static constexpr bool is_complex = false;               // its matrix is that of a complex one, see complex_rows()
  static constexpr bool has_positive_weights = false;     // see may_have_flips
  static constexpr bool takes_iterations = false;         // as the first further argument; 0 would be a crash
  static constexpr std::size_t most_failures = 0;         // if it goes on trying where a solution fails; else 0
  static constexpr double part_of_solution = 0.9;         // of what is left of a run, the time of a solution

  // Of the matrices that are for multigrid, see Linear_solver_options. Cotangent weights of the worst triangles stay
  // below a half of this.
  static constexpr double greatest_row_sum = 10;

  // How far iterations go on below the tolerance, see there, too. Where a matrix is not diagonally dominant or depends
  // on the solution before it, errors may be far greater than residuals.
  static constexpr double aim = 1;
};

// How a parameterizer uses its solver.
template <class Parameterizer>
struct Solver_use : Plain_solver_use { };

struct Solves_in_pairs : Plain_solver_use
{
  static constexpr bool is_shipped = true;
  static constexpr bool solves_in_pairs = true;
};

template <class M, class B, class S>
struct Solver_use<Barycentric_mapping_parameterizer_3<M, B, S>> : Solves_in_pairs
{
  static constexpr bool has_uniform_weights = true;
  static constexpr bool has_positive_weights = true;
};

template <class M, class B, class S>
struct Solver_use<Discrete_authalic_parameterizer_3<M, B, S>> : Solves_in_pairs
{
  static constexpr bool always_suits_multigrid = false;
  static constexpr double greatest_row_sum = 3;
  static constexpr double aim = 1e-2;
};
template <class M, class B, class S>
struct Solver_use<Discrete_conformal_map_parameterizer_3<M, B, S>> : Solves_in_pairs
{
};
template <class M, class B, class S>
struct Solver_use<Iterative_authalic_parameterizer_3<M, B, S>> : Solves_in_pairs
{
  static constexpr bool always_suits_multigrid = false;
  static constexpr double greatest_row_sum = 3;
  static constexpr bool takes_iterations = true;
  static constexpr std::size_t most_failures = 6;     // it ends by itself after 5, but its count starts at any number
  static constexpr double aim = 1e-5;
  static constexpr double part_of_solution = 0.1;
};
template <class M, class B, class S>
struct Solver_use<Mean_value_coordinates_parameterizer_3<M, B, S>> : Solves_in_pairs
{
  static constexpr bool has_positive_weights = true;
};

template <class M, class B, class S>
struct Solver_use<LSCM_parameterizer_3<M, B, S>> : Plain_solver_use
{
  static constexpr bool is_shipped = true;
  static constexpr double greatest_row_sum = (std::numeric_limits<double>::infinity)();
  static constexpr bool is_complex = true;

  // Iterations grow with the border, like its square root: the conformal motions that it allows cost next to no energy,
  // and coarse grids resist them. The time of a factorization grows with the surface, almost like its square.
  static bool is_factorization_faster(std::size_t vertices, std::size_t border_vertices)
  {
    constexpr double vertices_by_root_of_border = 7000;
    return double(vertices) < vertices_by_root_of_border * std::sqrt(double(border_vertices));
  }
};

} // namespace internal

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_SOLVER_USE_H
