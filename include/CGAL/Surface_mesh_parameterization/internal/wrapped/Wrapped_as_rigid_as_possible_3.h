// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_AS_RIGID_AS_POSSIBLE_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_AS_RIGID_AS_POSSIBLE_3_H

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Nested_iteration_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Two_vertices_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Default.h>

#include <type_traits>

namespace CGAL::Surface_mesh_parameterization::internal {

// Runs, in the place of CGAL's ARAP_parameterizer_3, the refinable method with the same energy: that one makes its
// first map and repairs flips with solvers of its own, which cannot be exchanged.
template <class TriangleMesh_, class BorderParameterizer, class ConcurrencyTag>
class Wrapped_as_rigid_as_possible_3
  : public Nested_iteration_parameterizer_3<As_rigid_as_possible_parameterizer_3<TriangleMesh_, ConcurrencyTag>>
{
  typedef As_rigid_as_possible_parameterizer_3<TriangleMesh_, ConcurrencyTag>   Method;
  typedef Nested_iteration_parameterizer_3<Method>               Base;
  typedef parameters::Default_named_parameters                   Default_parameters;

public:
  typedef typename Default::Get<BorderParameterizer, Two_vertices_parameterizer_3<TriangleMesh_>>::type
      Border_parameterizer;

  // The arguments are those of ARAP_parameterizer_3's constructors, less the solver; named parameters, of the method
  // and of the hierarchy, may follow them. The border parameterizer is not needed: the border is free, and what it pins
  // does not change the energy.
  template <class NamedParameters = Default_parameters, class = std::enable_if_t<is_named_parameters<NamedParameters>>>
  explicit Wrapped_as_rigid_as_possible_3(const NamedParameters& np = parameters::default_values())
    : Base(np)
  { }

  template <class NamedParameters = Default_parameters>
  explicit Wrapped_as_rigid_as_possible_3(double lambda, const NamedParameters& np = parameters::default_values())
    : Wrapped_as_rigid_as_possible_3(with<internal_np::lambda_t>(lambda, np))
  { }

  template <class NamedParameters = Default_parameters, class = std::enable_if_t<is_named_parameters<NamedParameters>>>
  explicit Wrapped_as_rigid_as_possible_3(const Border_parameterizer&,
                                          const NamedParameters& np = parameters::default_values())
    : Wrapped_as_rigid_as_possible_3(np)
  { }

  template <class NamedParameters = Default_parameters, class = std::enable_if_t<is_named_parameters<NamedParameters>>>
  Wrapped_as_rigid_as_possible_3(const Border_parameterizer&, double lambda,
                                 const NamedParameters& np = parameters::default_values())
    : Wrapped_as_rigid_as_possible_3(lambda, np)
  { }

  template <class NamedParameters = Default_parameters, class = std::enable_if_t<is_named_parameters<NamedParameters>>>
  Wrapped_as_rigid_as_possible_3(const Border_parameterizer&, double lambda, unsigned int iterations,
                                 const NamedParameters& np = parameters::default_values())
    : Wrapped_as_rigid_as_possible_3(lambda, with<internal_np::number_of_iterations_t>(iterations, np))
  { }

  template <class NamedParameters = Default_parameters>
  Wrapped_as_rigid_as_possible_3(const Border_parameterizer& border, double lambda, unsigned int iterations,
                                 double tolerance, const NamedParameters& np = parameters::default_values())
    : Wrapped_as_rigid_as_possible_3(border, lambda, iterations, with<internal_np::tolerance_t>(tolerance, np))
  { }

private:
  // The named parameters `np` and one more.
  template <class Tag, class Value, class NamedParameters>
  static Named_function_parameters<Value, Tag, NamedParameters> with(const Value& value, const NamedParameters& np)
  {
    static_assert(parameters::is_default_parameter<NamedParameters, Tag>::value,
                  "a number of ARAP_parameterizer_3 is given as an argument and as a named parameter");
    return { value, np };
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_AS_RIGID_AS_POSSIBLE_3_H
