// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_REFINEMENT_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_REFINEMENT_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/number_checks.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// The optimizer that minimizes the energy of a level.
enum class Optimizer
{
  NEWTON,           ///< Newton's method with multigrid: to convergence
  SWEEPS,           ///< vertex relaxation in sweeps over all vertices, with over-relaxation
  RANDOM_VERTICES   ///< vertex relaxation of vertices that are chosen at random, as in the paper
};

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// The options of the methods that minimize a distortion energy, with their defaults.
struct Refinement_options
{
  /// \cond SKIP_IN_MANUAL
  typedef internal::Names<internal_np::optimizer_t, internal_np::tolerance_t, internal_np::number_of_iterations_t,
                          internal_np::number_of_local_steps_t, internal_np::triangle_weight_t,
                          internal_np::globally_injective_t, internal_np::random_seed_t>   Option_names;
  /// \endcond

  /// named parameter `optimizer`
  Optimizer optimizer = Optimizer::NEWTON;

  /// named parameter `tolerance`: a level has converged when an iteration lowers the energy by less than this fraction
  /// of its excess over the lower bound, which counts as 1e-4 of the lower bound at least. With Newton's method it has
  /// converged, too, when the last three steps show that the remaining ones would lower the energy by less than that;
  /// and levels below the finest use 5e-3 instead: they only need to give a good initial guess. Below 1e-12, which is
  /// the accuracy of energies in doubles, Newton's method ends with a few steps that the gradient judges, as long as
  /// they make it smaller: the map is the minimizer up to rounding, not only up to the square root of that.
  /// `globally_injective` prevents them; where it keeps borders apart, a level has converged when a step lowers the
  /// excess by less than 1e-4, if that is greater. A tolerance or a count that is negative or no number makes a method
  /// return `ERROR_WRONG_PARAMETER`; a count may be infinite
  double tolerance = 1e-6;

  /// named parameter `number_of_iterations`: the maximum number of iterations on a level, from each start: Newton
  /// steps, or sweeps (of as many visits as there are vertices); on the coarsest of several levels 2000 sweeps, if that
  /// is more
  std::size_t number_of_iterations = 200;

  /// named parameter `number_of_local_steps`: if it is not 0, every level gets exactly this number of random vertex
  /// visits, and the parameters above have no effect, though their values are checked: the experiment of the paper
  std::size_t number_of_local_steps = 0;

  /// named parameter `triangle_weight`: the weight of the energy of a triangle in the sum. The default is that of MIPS;
  /// `Symmetric_Dirichlet_parameterizer_3` has `AREA`
  Triangle_weight triangle_weight = Triangle_weight::ONE;

  /// named parameter `globally_injective`: whether the borders of the map are kept from meeting, so that the map is
  /// one-to-one as a whole. If `false`, a free border may overlap itself
  bool is_globally_injective = false;

  /// named parameter `random_seed`, of vertices chosen at random
  unsigned int random_seed = 0;

  /// \cond SKIP_IN_MANUAL
  const char* fault_of_counts = nullptr;      // what was wrong with counts among the named parameters; null: nothing

  // What is wrong with the options; null if nothing is.
  const char* fault() const
  {
    return internal::first_fault({ internal::fault_of_tolerance(tolerance), fault_of_counts });
  }
  /// \endcond

  /// whether all options are in their ranges
  bool are_valid() const { return fault() == nullptr; }

  /// sets the options that are among the given named parameters.
  template <class NamedParameters>
  void set(const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    optimizer = choose_parameter(get_parameter(np, internal_np::optimizer), optimizer);
    tolerance = choose_parameter(get_parameter(np, internal_np::tolerance), tolerance);
    number_of_iterations = internal::chosen_count(np, internal_np::number_of_iterations, number_of_iterations);
    number_of_local_steps = internal::chosen_count(np, internal_np::number_of_local_steps, number_of_local_steps);
    triangle_weight = choose_parameter(get_parameter(np, internal_np::triangle_weight), triangle_weight);
    is_globally_injective = choose_parameter(get_parameter(np, internal_np::globally_injective), is_globally_injective);
    random_seed = choose_parameter(get_parameter(np, internal_np::random_seed), random_seed);
    fault_of_counts = internal::first_fault({ fault_of_counts, internal::fault_of_counts(np) });
  }
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_REFINEMENT_OPTIONS_H
