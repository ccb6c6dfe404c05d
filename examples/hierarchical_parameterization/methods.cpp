// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The methods that --method can name.

#include "methods.h"

#include "run_shipped.h"

#include <CGAL/Surface_mesh_parameterization/Option_defaults.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace {

// One that minimizes the distortion of triangles.
Method distortion_method(std::string name, std::string description, Run_method* run, Run_atlas* run_atlas,
                         SMP::Triangle_weight weight)
{
  const SMP::Refinement_options defaults;
  Method result{ std::move(name), std::move(description), run, run_atlas };
  result.tolerance = defaults.tolerance;
  result.iterations = defaults.number_of_iterations;
  result.triangle_weight = weight;
  result.is_flip_free = true;
  result.improves_map = true;
  result.has_free_border = true;
  return result;
}

// One with a linear system on each level.
Method edge_energy_method(std::string name, std::string description, Run_method* run, Run_atlas* run_atlas)
{
  Method result{ std::move(name), std::move(description), run, run_atlas };
  result.tolerance = SMP::Option_defaults::tolerance_of_edge_energies;
  return result;
}

// One of CGAL's, with a linear system on the input.
Method linear_method_of_CGAL(std::string name, std::string description, Run_method* run, Run_atlas* run_atlas,
                             Run_method* run_shipped)
{
  Method result = edge_energy_method(std::move(name), std::move(description), run, run_atlas);
  result.tolerance = SMP::Option_defaults::tolerance_of_linear_solver;
  result.has_levels = false;
  result.run_shipped = run_shipped;
  return result;
}

Method lscm_method(std::string name, std::string description)
{
  Method result =
      linear_method_of_CGAL(std::move(name), std::move(description), run_lscm, run_lscm_atlas, run_shipped_lscm);
  result.has_free_border = true;
  return result;
}

// The package's own, which stands in for CGAL's.
Method as_rigid_as_possible_method(std::string name, std::string description)
{
  Method result = distortion_method(std::move(name), std::move(description), run_arap, run_arap_atlas,
                                    SMP::Triangle_weight::AREA);
  result.is_flip_free = false;
  result.run_shipped = run_shipped_arap;
  return result;
}

} // namespace

const std::vector<Method>& methods()
{
  static const std::vector<Method> all = {
    distortion_method("mips", "least distortion of angles, free border", run_mips, run_mips_atlas,
                      SMP::Triangle_weight::ONE),
    distortion_method("symmetric-dirichlet", "least distortion of lengths, free border", run_symmetric_dirichlet,
                      run_symmetric_dirichlet_atlas, SMP::Triangle_weight::AREA),
    edge_energy_method("uniform", "every vertex the mean of its neighbors, border on a circle", run_uniform,
                       run_uniform_atlas),
    edge_energy_method("chordal", "the same, weighted by the inverse lengths of the edges", run_chordal,
                       run_chordal_atlas),
    edge_energy_method("harmonic", "the same, weighted by cotangents", run_harmonic, run_harmonic_atlas),
    edge_energy_method("shape-preserving", "the same, by Floater's weights", run_shape_preserving,
                       run_shape_preserving_atlas),
    linear_method_of_CGAL("barycentric", "CGAL's Tutte map, border on a circle", run_barycentric,
                          run_barycentric_atlas, run_shipped_barycentric),
    linear_method_of_CGAL("mean-value", "CGAL's mean value coordinates, border on a circle", run_mean_value,
                          run_mean_value_atlas, run_shipped_mean_value),
    linear_method_of_CGAL("conformal", "CGAL's discrete conformal map, border on a circle", run_conformal,
                          run_conformal_atlas, run_shipped_conformal),
    linear_method_of_CGAL("authalic", "CGAL's discrete authalic map, border on a circle", run_authalic,
                          run_authalic_atlas, run_shipped_authalic),
    linear_method_of_CGAL("iterative-authalic", "CGAL's iterative authalic map, border on a circle",
                          run_iterative_authalic, run_iterative_authalic_atlas, run_shipped_iterative_authalic),
    lscm_method("lscm", "CGAL's least squares conformal map, free border"),
    as_rigid_as_possible_method("arap", "as rigid as possible, free border")
  };
  return all;
}

const Method* find_method(const std::string& name)
{
  const auto found = std::find_if(methods().begin(), methods().end(), [&](const Method& m) { return m.name == name; });
  return found == methods().end() ? nullptr : &*found;
}
