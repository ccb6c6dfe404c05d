// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

/// \file parameters.h
/// The named parameters of this package. `CGAL::Surface_mesh_parameterization::parameters` has all names that the
/// package takes, its own and those of CGAL (`random_seed`, `number_of_iterations`, `visitor`,
/// `vertex_is_constrained_map`, `edge_is_constrained_map`), and a chain may have any order:
/// \code
///   namespace SMP = CGAL::Surface_mesh_parameterization;
///   SMP::parameters::random_seed(7).summary(std::ref(s)).tolerance(1e-8)
/// \endcode
/// The package's own names are in `CGAL::parameters`, too. A chain that begins with CGAL's function of a name, such as
/// `CGAL::parameters::random_seed(7)`, can only go on with CGAL's names.

namespace CGAL {

// X(name, tag) for the names that CGAL does not have, and for those of CGAL that this package takes.
#define CGAL_SURFACE_MESH_PARAMETERIZATION_OWN_NAMES(X)                                                                \
  X(coarsest_size, coarsest_size_t) X(unit_edges, unit_edges_t) X(tolerance, tolerance_t)                              \
  X(triangle_weight, triangle_weight_t) X(number_of_local_steps, number_of_local_steps_t) X(optimizer, optimizer_t)    \
  X(lambda, lambda_t) X(globally_injective, globally_injective_t) X(flip_policy, flip_policy_t)                        \
  X(fill_holes, fill_holes_t) X(initial_map, initial_map_t) X(summary, summary_t)                                      \
  X(distortion_bound, distortion_bound_t) X(join_borders, join_borders_t) X(margin, margin_t)                          \
  X(unit_square, unit_square_t) X(least_used_part, least_used_part_t) X(overlap_bound, overlap_bound_t)                \
  X(hole_bound, hole_bound_t)                                                                                          \
  X(position_weight_map, position_weight_t)
#define CGAL_SURFACE_MESH_PARAMETERIZATION_NAMES(X)                                                                    \
  CGAL_SURFACE_MESH_PARAMETERIZATION_OWN_NAMES(X)                                                                      \
  X(random_seed, random_seed_t) X(number_of_iterations, number_of_iterations_t) X(visitor, visitor_t)                  \
  X(vertex_is_constrained_map, vertex_is_constrained_t) X(edge_is_constrained_map, edge_is_constrained_t)

namespace internal_np {

#define CGAL_SURFACE_MESH_PARAMETERIZATION_TAG(name, tag) enum tag { name };
CGAL_SURFACE_MESH_PARAMETERIZATION_OWN_NAMES(CGAL_SURFACE_MESH_PARAMETERIZATION_TAG)
#undef CGAL_SURFACE_MESH_PARAMETERIZATION_TAG

} // namespace internal_np

namespace Surface_mesh_parameterization {

namespace internal {

// CGAL's parameters with all names of the package as members, which lead to this class again.
template <class T, class Tag, class Base = internal_np::No_property>
struct Named_parameters : Named_function_parameters<T, Tag, Base>
{
  typedef Named_function_parameters<T, Tag, Base>   Plain;
  using Plain::Plain;

#define CGAL_SURFACE_MESH_PARAMETERIZATION_MEMBER(name, tag)                                                           \
  template <class K>                                                                                                   \
  Named_parameters<K, internal_np::tag, Plain> name(const K& value) const                                              \
  {                                                                                                                    \
    return { value, *this };                                                                                           \
  }

  CGAL_SURFACE_MESH_PARAMETERIZATION_NAMES(CGAL_SURFACE_MESH_PARAMETERIZATION_MEMBER)
#undef CGAL_SURFACE_MESH_PARAMETERIZATION_MEMBER
};

template <class T, class Tag, class Base>
std::true_type test_named_parameters(const Named_function_parameters<T, Tag, Base>*);
std::false_type test_named_parameters(const void*);

template <class T>
constexpr bool is_named_parameters = decltype(test_named_parameters(static_cast<const T*>(nullptr)))::value;

// The names that a call takes.
template <class... Tags>
struct Names { };

template <class... Lists>
struct Join;

template <class... Tags>
struct Join<Names<Tags...>>
{
  typedef Names<Tags...>   type;
};

template <class... Tags, class... Others, class... Lists>
struct Join<Names<Tags...>, Names<Others...>, Lists...> : Join<Names<Tags..., Others...>, Lists...> { };

template <class... Lists>
using Joined_names = typename Join<Lists...>::type;

template <class Tag, class... Tags>
constexpr bool has_name(Names<Tags...>)
{
  return std::is_same<Tag, internal_np::all_default_t>::value || (std::is_same<Tag, Tags>::value || ...);
}

// Says that a call does not take the name with this tag.
template <class Tag, class Call>
struct Refused_name
{
  static_assert(!sizeof(Call*), "a named parameter of CGAL's has no effect here: no call of this package takes it");
};

#define CGAL_SURFACE_MESH_PARAMETERIZATION_REFUSED(name, tag)                                                          \
  template <class Call>                                                                                                \
  struct Refused_name<internal_np::tag, Call>                                                                          \
  {                                                                                                                    \
    static_assert(!sizeof(Call*),                                                                                      \
                  "the named parameter '" #name "' has no effect here: this argument of the call does not take it");   \
  };
CGAL_SURFACE_MESH_PARAMETERIZATION_NAMES(CGAL_SURFACE_MESH_PARAMETERIZATION_REFUSED)
#undef CGAL_SURFACE_MESH_PARAMETERIZATION_REFUSED

// Asserts that a call that takes `Taken` takes all that is in the chain.
template <class Chain, class Taken>
struct Chain_check { };

template <class T, class Tag, class Base, class Taken>
struct Chain_check<internal_np::Named_params_impl<T, Tag, Base>, Taken>
  : std::conditional_t<has_name<Tag>(Taken()), Chain_check<typename Base::base, Taken>, Refused_name<Tag, T>>
{ };

template <class T, class Tag, class Taken>
struct Chain_check<internal_np::Named_params_impl<T, Tag, internal_np::No_property>, Taken>
  : std::conditional_t<has_name<Tag>(Taken()), Chain_check<void, Taken>, Refused_name<Tag, T>>
{ };

// Named parameters of which somebody else asserts that they are taken, such as those of an adaptor and of its method.
template <class NamedParameters>
struct Checked_named_parameters : NamedParameters
{
  explicit Checked_named_parameters(const NamedParameters& np) : NamedParameters(np) { }
};

// The names that a parameterizer takes, where it tells them.
template <class Parameterizer>
using Option_names_of = typename Parameterizer::Option_names;

template <class Taken, class NamedParameters>
void assert_names(const NamedParameters&)
{
  static_assert(sizeof(Chain_check<typename NamedParameters::base, Taken>) > 0);
}

template <class Taken, class NamedParameters>
void assert_names(const Checked_named_parameters<NamedParameters>&)
{ }

} // namespace internal

/// \cond SKIP_IN_MANUAL
namespace parameters {

using namespace CGAL::parameters;

#define CGAL_SURFACE_MESH_PARAMETERIZATION_FUNCTION(name, tag)                                                         \
  template <class K>                                                                                                   \
  internal::Named_parameters<K, internal_np::tag> name(const K& value)                                                 \
  {                                                                                                                    \
    return { value };                                                                                                  \
  }
CGAL_SURFACE_MESH_PARAMETERIZATION_NAMES(CGAL_SURFACE_MESH_PARAMETERIZATION_FUNCTION)
#undef CGAL_SURFACE_MESH_PARAMETERIZATION_FUNCTION

} // namespace parameters
/// \endcond

} // namespace Surface_mesh_parameterization

namespace parameters {

#define CGAL_SURFACE_MESH_PARAMETERIZATION_USING(name, tag) using Surface_mesh_parameterization::parameters::name;
CGAL_SURFACE_MESH_PARAMETERIZATION_OWN_NAMES(CGAL_SURFACE_MESH_PARAMETERIZATION_USING)
#undef CGAL_SURFACE_MESH_PARAMETERIZATION_USING

} // namespace parameters

#undef CGAL_SURFACE_MESH_PARAMETERIZATION_NAMES
#undef CGAL_SURFACE_MESH_PARAMETERIZATION_OWN_NAMES

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERS_H
