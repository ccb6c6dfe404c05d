// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <type_traits>

/// \file parameters.h
/// The named parameters of this package that CGAL does not have: `coarsest_size`, `unit_edges`, `tolerance`,
/// `triangle_weight`, `number_of_local_steps`, `optimizer`, `lambda`, `globally_injective`, `flip_policy`, `fill_holes`
/// and `summary`. In a chain they come first, and CGAL's own (`random_seed`, `number_of_iterations`, `visitor`,
/// `vertex_is_constrained_map`) follow:
/// \code
///   CGAL::parameters::coarsest_size(50).tolerance(1e-8).random_seed(7)
/// \endcode

namespace CGAL {

namespace internal_np {

enum coarsest_size_t { coarsest_size };
enum unit_edges_t { unit_edges };
enum tolerance_t { tolerance };
enum triangle_weight_t { triangle_weight };
enum number_of_local_steps_t { number_of_local_steps };
enum optimizer_t { optimizer };
enum lambda_t { lambda };
enum globally_injective_t { globally_injective };
enum flip_policy_t { flip_policy };
enum fill_holes_t { fill_holes };
enum summary_t { summary };

} // namespace internal_np

namespace Surface_mesh_parameterization::internal {

#define CGAL_SURFACE_MESH_PARAMETERIZATION_NAMED_PARAMETERS(X) \
  X(coarsest_size) X(unit_edges) X(tolerance) X(triangle_weight) X(number_of_local_steps) X(optimizer) X(lambda) X(globally_injective) X(flip_policy) X(fill_holes) \
  X(summary)

// CGAL's parameters with the package's as further members.
template <class T, class Tag, class Base = internal_np::No_property>
struct Named_parameters : Named_function_parameters<T, Tag, Base>
{
  typedef Named_function_parameters<T, Tag, Base>   Plain;
  using Plain::Plain;

#define CGAL_SURFACE_MESH_PARAMETERIZATION_MEMBER(name) \
  template <class K> \
  Named_parameters<K, internal_np::name##_t, Plain> name(const K& value) const { return { value, *this }; }

  CGAL_SURFACE_MESH_PARAMETERIZATION_NAMED_PARAMETERS(CGAL_SURFACE_MESH_PARAMETERIZATION_MEMBER)
#undef CGAL_SURFACE_MESH_PARAMETERIZATION_MEMBER
};

template <class T, class Tag, class Base>
std::true_type test_named_parameters(const Named_function_parameters<T, Tag, Base>*);
std::false_type test_named_parameters(const void*);

template <class T>
constexpr bool is_named_parameters = decltype(test_named_parameters(static_cast<const T*>(nullptr)))::value;

} // namespace Surface_mesh_parameterization::internal

namespace parameters {

#define CGAL_SURFACE_MESH_PARAMETERIZATION_FUNCTION(name)                                                              \
  template <class K>                                                                                                   \
  Surface_mesh_parameterization::internal::Named_parameters<K, internal_np::name##_t> name(const K& value)             \
  {                                                                                                                    \
    return { value };                                                                                                  \
  }

CGAL_SURFACE_MESH_PARAMETERIZATION_NAMED_PARAMETERS(CGAL_SURFACE_MESH_PARAMETERIZATION_FUNCTION)
#undef CGAL_SURFACE_MESH_PARAMETERIZATION_FUNCTION
#undef CGAL_SURFACE_MESH_PARAMETERIZATION_NAMED_PARAMETERS

} // namespace parameters

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERS_H
