// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The methods that are this package's. Together, as they are made of the same parts.

#include "Level_visitor.h"
#include "input.h"
#include "lambda_of_area.h"
#include "methods.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Chordal_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Nested_iteration_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Option_defaults.h>
#include <CGAL/Surface_mesh_parameterization/Shape_preserving_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>

#include <CGAL/boost/graph/properties.h>

#include <functional>

namespace {

// Not by CGAL's parameterize(), whose preconditions refuse a mesh with isolated vertices.
template <class Parameterizer>
void parameterize(Input& input, Parameterizer& parameterizer)
{
  parameterizer.parameterize(input.mesh, input.border, input.uvmap,
                             get(CGAL::dynamic_vertex_property_t<int>(), input.mesh),
                             get(CGAL::dynamic_vertex_property_t<bool>(), input.mesh));
}

// Runs a method, flat or coarse to fine. A flat run fills the summary that the method was made with: this one.
template <class Method>
void run_refinable(Input& input, const Method_options& options, Method method, SMP::Parameterization_summary& summary)
{
  if (options.flat)
    return parameterize(input, method);
  const auto np = CGAL::parameters::flip_policy(options.flip_policy).fill_holes(options.fills_holes)
                    .summary(std::ref(summary)).random_seed(options.seed).visitor(Level_visitor(input, options));
  typedef SMP::Nested_iteration_parameterizer_3<Method>   Hierarchical;
  if constexpr (Method::is_flip_free) {
    Hierarchical hierarchical(method,
                              np.initial_map(!options.start.empty()).vertex_is_constrained_map(input.is_held));
    parameterize(input, hierarchical);
  } else {
    Hierarchical hierarchical(method, np);
    parameterize(input, hierarchical);
  }
}

// Free borders, by energies of triangles.
template <template <class, class> class Distortion>
SMP::Parameterization_summary minimize_distortion(Input& input, const Method_options& options)
{
  const double overlap_bound = options.is_globally_injective ? 1 : SMP::Option_defaults::overlap_bound;
  SMP::Parameterization_summary summary;
  const Distortion<Mesh, CGAL::Parallel_if_available_tag> method(
    CGAL::parameters::tolerance(options.tolerance).summary(std::ref(summary)).triangle_weight(options.triangle_weight)
      .fill_holes(options.fills_holes).globally_injective(options.is_globally_injective || options.avoids_overlaps)
      .overlap_bound(overlap_bound).number_of_iterations(options.iterations));
  run_refinable(input, options, method, summary);
  return summary;
}

// Borders on a circle: every vertex is a weighted mean of its neighbors.
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
  SMP::Parameterization_summary summary;
  const SMP::As_rigid_as_possible_parameterizer_3<Mesh, CGAL::Parallel_if_available_tag> method(
    CGAL::parameters::tolerance(options.tolerance).flip_policy(options.flip_policy).fill_holes(options.fills_holes)
      .summary(std::ref(summary)).number_of_iterations(options.iterations)
      .lambda(lambda_of_area(input.faces, input.mesh)));
  run_refinable(input, options, method, summary);
  return summary;
}

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
