// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the methods of this package.

#ifndef RUN_REFINABLE_H
#define RUN_REFINABLE_H

#include "Level_visitor.h"
#include "input.h"
#include "methods.h"

#include <CGAL/Surface_mesh_parameterization/Nested_iteration_parameterizer_3.h>

#include <CGAL/boost/graph/properties.h>

#include <functional>

// Not by CGAL's parameterize(), whose preconditions refuse a mesh with isolated vertices.
template <class Parameterizer>
void parameterize(Input& input, Parameterizer& parameterizer)
{
  parameterizer.parameterize(input.mesh, input.border, input.uvmap, get(CGAL::dynamic_vertex_property_t<int>(), input.mesh),
                             get(CGAL::dynamic_vertex_property_t<bool>(), input.mesh));
}

// Runs a method, flat or coarse to fine. A flat run fills the summary that the method was made with: this one.
template <class Method>
void run_refinable(Input& input, const Method_options& options, Method method, SMP::Parameterization_summary& summary)
{
  if (options.flat)
    return parameterize(input, method);
  SMP::Nested_iteration_parameterizer_3<Method> hierarchical(
    method, CGAL::parameters::flip_policy(options.flip_policy).fill_holes(options.fills_holes).summary(std::ref(summary))
              .random_seed(options.seed).visitor(Level_visitor(input, options)));
  parameterize(input, hierarchical);
}

#endif // RUN_REFINABLE_H
