// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_SOLVER_USE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_SOLVER_USE_H

#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>

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
  static constexpr bool copies_solution = false;          // to the map, and does nothing else with it
  static constexpr bool has_uniform_weights = false;
  static constexpr double part_of_solution = 0.9;         // of what is left of a run, the time of a solution
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
};

template <class M, class B, class S>
struct Solver_use<Discrete_authalic_parameterizer_3<M, B, S>> : Solves_in_pairs
{
};
template <class M, class B, class S>
struct Solver_use<Discrete_conformal_map_parameterizer_3<M, B, S>> : Solves_in_pairs
{
};
template <class M, class B, class S>
struct Solver_use<Iterative_authalic_parameterizer_3<M, B, S>> : Solves_in_pairs
{
  static constexpr double part_of_solution = 0.1;
};
template <class M, class B, class S>
struct Solver_use<Mean_value_coordinates_parameterizer_3<M, B, S>> : Solves_in_pairs
{
};

// The method without flips that minimizes the same kind of distortion as a parameterizer with a free border; void if
// there is none.
template <class Parameterizer>
struct Flip_free_relative
{
  typedef void   type;
};

template <class M, class B, class S>
struct Flip_free_relative<LSCM_parameterizer_3<M, B, S>>
{
  typedef MIPS_parameterizer_3<M>   type;
};

template <class M, class B, class S>
struct Solver_use<LSCM_parameterizer_3<M, B, S>> : Plain_solver_use
{
  static constexpr bool is_shipped = true;
  static constexpr bool copies_solution = true;
};

} // namespace internal

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_SOLVER_USE_H
