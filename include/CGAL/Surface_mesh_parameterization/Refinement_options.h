// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_REFINEMENT_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_REFINEMENT_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// How the energy of a level is minimized.
enum class Optimizer
{
  NEWTON,           ///< Newton's method with multigrid: to convergence
  SWEEPS,           ///< vertex relaxation, all vertices one after the other, over and over, with over-relaxation
  RANDOM_VERTICES   ///< vertex relaxation, each time of a vertex that is chosen at random, as in the paper
};

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// The options of the methods that minimize a distortion energy, with their defaults.
struct Refinement_options
{
  /// named parameter `optimizer`
  Optimizer optimizer = Optimizer::NEWTON;

  /// named parameter `tolerance`: a level has converged when an iteration lowers the energy by less than this part of its excess over the minimum. By
  /// Newton's method the levels below the finest converge to 5e-3, whatever is asked for: they only hand on a good start
  double tolerance = 1e-6;

  /// named parameter `number_of_iterations`: the most iterations on a level: Newton steps, or sweeps (of as many visits as there are vertices)
  std::size_t number_of_iterations = 200;

  /// named parameter `number_of_local_steps`: unless 0, exactly so many vertex visits on every level, of vertices chosen at random, whatever the others say: the paper's experiment
  std::size_t number_of_local_steps = 0;

  /// named parameter `triangle_weight`
  Triangle_weight triangle_weight = Triangle_weight::ONE;

  /// named parameter `globally_injective`: whether the borders of the map must not meet, so that it is one-to-one as a whole. Without it a free border can run over itself
  bool is_globally_injective = false;

  /// named parameter `random_seed`, of vertices chosen at random
  unsigned int random_seed = 0;

  /// takes from named parameters what they hold.
  template <class NamedParameters>
  void set(const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    optimizer = choose_parameter(get_parameter(np, internal_np::optimizer), optimizer);
    tolerance = choose_parameter(get_parameter(np, internal_np::tolerance), tolerance);
    number_of_iterations = choose_parameter(get_parameter(np, internal_np::number_of_iterations), number_of_iterations);
    number_of_local_steps = choose_parameter(get_parameter(np, internal_np::number_of_local_steps), number_of_local_steps);
    triangle_weight = choose_parameter(get_parameter(np, internal_np::triangle_weight), triangle_weight);
    is_globally_injective = choose_parameter(get_parameter(np, internal_np::globally_injective), is_globally_injective);
    random_seed = choose_parameter(get_parameter(np, internal_np::random_seed), random_seed);
  }
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_REFINEMENT_OPTIONS_H
