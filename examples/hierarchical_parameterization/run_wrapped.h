// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs parameterizers of CGAL hierarchically.

#ifndef RUN_WRAPPED_H
#define RUN_WRAPPED_H

#include "Level_visitor.h"
#include "input.h"
#include "methods.h"
#include "run_shipped.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>

#include <functional>

// Runs one of CGAL's parameterizers, flat or hierarchically.
template <class Parameterizer>
SMP::Parameterization_summary run_wrapped(Input& input, const Method_options& options)
{
  if (options.flat)
    return run_shipped<Parameterizer>(input, options);
  SMP::Parameterization_summary summary;
  const SMP::Hierarchical_parameterizer_3<Parameterizer> hierarchical(
    CGAL::parameters::tolerance(options.tolerance).flip_policy(options.flip_policy).fill_holes(options.fills_holes)
      .summary(std::ref(summary)).number_of_iterations(options.iterations).random_seed(options.seed)
      .visitor(Level_visitor(input, options)));
  SMP::parameterize(input.mesh, hierarchical, input.border, input.uvmap);
  return summary;
}

#endif // RUN_WRAPPED_H
