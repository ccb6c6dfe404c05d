// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The methods that are CGAL's.

#include "Confinement.h"
#include "Level_visitor.h"
#include "input.h"
#include "methods.h"

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>

#include <CGAL/tags.h>

#include <functional>

namespace {

// Runs one of CGAL's parameterizers hierarchically.
template <class Parameterizer>
SMP::Parameterization_summary run_wrapped(Input& input, const Method_options& options)
{
  SMP::Parameterization_summary summary;
  const SMP::Hierarchical_parameterizer_3<Parameterizer, CGAL::Parallel_if_available_tag> hierarchical(
    CGAL::parameters::tolerance(options.tolerance).flip_policy(options.flip_policy).fill_holes(options.fills_holes)
      .summary(std::ref(summary)).number_of_iterations(options.iterations).random_seed(options.seed)
      .visitor(Level_visitor(input, options, "residual")));
  SMP::parameterize(input.mesh, hierarchical, input.border, input.uvmap);
  return summary;
}

} // namespace

SMP::Parameterization_summary run_barycentric(Input& input, const Method_options& options)
{
  return run_wrapped<SMP::Barycentric_mapping_parameterizer_3<Mesh>>(input, options);
}

SMP::Parameterization_summary run_mean_value(Input& input, const Method_options& options)
{
  return run_wrapped<SMP::Mean_value_coordinates_parameterizer_3<Mesh>>(input, options);
}

SMP::Parameterization_summary run_conformal(Input& input, const Method_options& options)
{
  return run_wrapped<SMP::Discrete_conformal_map_parameterizer_3<Mesh>>(input, options);
}

SMP::Parameterization_summary run_authalic(Input& input, const Method_options& options)
{
  return run_wrapped<SMP::Discrete_authalic_parameterizer_3<Mesh>>(input, options);
}

// In CGAL 5 this parameterizer prints its progress, and writes a file into the current folder in every iteration.
SMP::Parameterization_summary run_iterative_authalic(Input& input, const Method_options& options)
{
  const Confinement confinement;
  return run_wrapped<SMP::Iterative_authalic_parameterizer_3<Mesh>>(input, options);
}

SMP::Parameterization_summary run_lscm(Input& input, const Method_options& options)
{
  return run_wrapped<SMP::LSCM_parameterizer_3<Mesh>>(input, options);
}
