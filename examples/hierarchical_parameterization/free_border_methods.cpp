// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The methods of least distortion.

#include "run_refinable.h"
#include "run_shipped.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>

#include <functional>

namespace {

template <template <class, class> class Distortion>
SMP::Parameterization_summary minimize_distortion(Input& input, const Method_options& options)
{
  SMP::Parameterization_summary summary;
  const Distortion<Mesh, CGAL::Parallel_if_available_tag> method(
    CGAL::parameters::tolerance(options.tolerance).summary(std::ref(summary)).triangle_weight(options.triangle_weight)
      .fill_holes(options.fills_holes).globally_injective(options.is_globally_injective)
      .number_of_iterations(options.iterations));
  run_refinable(input, options, method, summary);
  return summary;
}

} // namespace

SMP::Parameterization_summary run_mips(Input& input, const Method_options& options)
{
  return minimize_distortion<SMP::MIPS_parameterizer_3>(input, options);
}

SMP::Parameterization_summary run_symmetric_dirichlet(Input& input, const Method_options& options)
{
  return minimize_distortion<SMP::Symmetric_Dirichlet_parameterizer_3>(input, options);
}

SMP::Parameterization_summary run_arap(Input& input, const Method_options& options)
{
  if (options.flat)
    return run_shipped_arap(input, options);
  SMP::Parameterization_summary summary;
  const SMP::As_rigid_as_possible_parameterizer_3<Mesh> method(
    CGAL::parameters::tolerance(options.tolerance).flip_policy(options.flip_policy).fill_holes(options.fills_holes)
      .summary(std::ref(summary)).number_of_iterations(options.iterations));
  run_refinable(input, options, method, summary);
  return summary;
}
