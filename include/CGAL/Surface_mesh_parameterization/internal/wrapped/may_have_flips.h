// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_MAY_HAVE_FLIPS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_MAY_HAVE_FLIPS_H

#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Solver_use.h>

#include <CGAL/Default.h>

#include <type_traits>

namespace CGAL::Surface_mesh_parameterization {

template <class> class Circular_border_arc_length_parameterizer_3;
template <class> class Circular_border_uniform_parameterizer_3;
template <class, class, class> class LSCM_parameterizer_3;
template <class, class> class Orbifold_Tutte_parameterizer_3;

namespace internal {

// The border parameterizer of a parameterizer, as its template argument says.
template <class Border>
struct Is_circle : std::false_type { };

template <>
struct Is_circle<Default> : std::true_type { };

template <class Mesh>
struct Is_circle<Circular_border_arc_length_parameterizer_3<Mesh>> : std::true_type { };

template <class Mesh>
struct Is_circle<Circular_border_uniform_parameterizer_3<Mesh>> : std::true_type { };

// Whether a parameterizer's maps may have flips. With positive weights and a border that is strictly convex they have
// none, by Tutte's and Floater's theorems. On a square, triangles with three vertices on a side are degenerate.
template <class Parameterizer>
constexpr bool may_have_flips = true;

template <template <class, class, class> class Parameterizer, class Mesh, class Border, class Solver>
constexpr bool may_have_flips<Parameterizer<Mesh, Border, Solver>> =
    !(Solver_use<Parameterizer<Mesh, Border, Solver>>::has_positive_weights && Is_circle<Border>::value);

// An orbifold's map keeps its flips.
template <class SeamMesh, class Solver>
constexpr bool may_have_flips<Orbifold_Tutte_parameterizer_3<SeamMesh, Solver>> = false;

// The method without flips that minimizes the same kind of distortion as a parameterizer with a free border; void if
// there is none.
template <class Parameterizer>
struct Flip_free_substitute
{
  typedef void   type;
};

template <class M, class B, class S>
struct Flip_free_substitute<LSCM_parameterizer_3<M, B, S>>
{
  typedef MIPS_parameterizer_3<M>   type;
};

} // namespace internal

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_MAY_HAVE_FLIPS_H
