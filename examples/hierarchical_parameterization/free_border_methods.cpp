// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The methods of least distortion.

#include "run_refinable.h"

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
