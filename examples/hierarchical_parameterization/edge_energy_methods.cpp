// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The methods that make every vertex a weighted mean of its neighbors.

#include "run_refinable.h"

#include <CGAL/Surface_mesh_parameterization/Chordal_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Shape_preserving_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>

#include <functional>

namespace {

template <class EdgeWeights>
SMP::Parameterization_summary minimize_edge_energy(Input& input, const Method_options& options)
{
  typedef SMP::Circular_border_arc_length_parameterizer_3<Mesh>   Border;
  SMP::Parameterization_summary summary;
  const SMP::Edge_energy_parameterizer_3<Mesh, EdgeWeights, Border, CGAL::Parallel_if_available_tag> method(
    Border(), EdgeWeights(),
    CGAL::parameters::tolerance(options.tolerance).flip_policy(options.flip_policy).fill_holes(options.fills_holes)
      .summary(std::ref(summary)).number_of_iterations(options.iterations));
  run_refinable(input, options, method, summary);
  return summary;
}

} // namespace

SMP::Parameterization_summary run_uniform(Input& input, const Method_options& options)
{
  return minimize_edge_energy<SMP::Uniform_edge_weights_3>(input, options);
}

SMP::Parameterization_summary run_chordal(Input& input, const Method_options& options)
{
  return minimize_edge_energy<SMP::Chordal_edge_weights_3>(input, options);
}

SMP::Parameterization_summary run_harmonic(Input& input, const Method_options& options)
{
  return minimize_edge_energy<SMP::Harmonic_edge_weights_3>(input, options);
}

SMP::Parameterization_summary run_shape_preserving(Input& input, const Method_options& options)
{
  return minimize_edge_energy<SMP::Shape_preserving_edge_weights_3>(input, options);
}
