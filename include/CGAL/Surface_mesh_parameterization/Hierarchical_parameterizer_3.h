// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Nested_iteration_parameterizer_3.h>

#include <type_traits>
#include <utility>

namespace CGAL::Surface_mesh_parameterization {

namespace internal {

template <class Parameterizer, class = void>
struct Is_refinable : std::false_type { };

template <class Parameterizer>
struct Is_refinable<Parameterizer, std::void_t<
    typename Parameterizer::Triangle_mesh, typename Parameterizer::Concurrency_tag, std::bool_constant<Parameterizer::is_flip_free>,
    decltype(std::declval<Parameterizer&>().parameterize_coarsest(std::declval<const Level&>(), std::declval<Level::Uv&>())),
    decltype(std::declval<Parameterizer&>().refine(std::declval<const Level&>(), std::declval<Level::Uv&>(), std::declval<Level_summary&>()))>>
  : std::true_type { };

// How a parameterizer is run hierarchically.
template <class Parameterizer>
struct Hierarchical_base
{
  static_assert(Is_refinable<Parameterizer>::value,
                "Hierarchical_parameterizer_3<P>: P must model RefinableParameterizer_3, that is, "
                "have the types Triangle_mesh and Concurrency_tag, the constant is_flip_free and the members parameterize_coarsest(level, uv) and "
                "refine(level, uv, summary).");
  typedef Nested_iteration_parameterizer_3<Parameterizer>   type;
};

} // namespace internal

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// Runs a parameterizer hierarchically: coarse to fine, level by level. A method that improves a given map (`RefinableParameterizer_3`) runs by
/// `Nested_iteration_parameterizer_3`, whose constructor this class has; any other type is refused when it is compiled.
///
/// \code
///   namespace SMP = CGAL::Surface_mesh_parameterization;
///   SMP::Hierarchical_parameterizer_3<SMP::MIPS_parameterizer_3<Mesh>> mips;
///   SMP::Error_code status = SMP::parameterize(mesh, mips, bhd, uvmap);
/// \endcode
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam Parameterizer a model of `RefinableParameterizer_3`
template <class Parameterizer>
class Hierarchical_parameterizer_3
  : public internal::Hierarchical_base<Parameterizer>::type
{
  typedef typename internal::Hierarchical_base<Parameterizer>::type   Base;

public:
  using Base::Base;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H
