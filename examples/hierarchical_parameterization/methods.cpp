// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The methods that --method can name.

#include "methods.h"

#include "run_shipped.h"

#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

const std::vector<Method>& methods()
{
  constexpr SMP::Triangle_weight one = SMP::Triangle_weight::ONE, area = SMP::Triangle_weight::AREA;
  static const std::size_t newton_steps = SMP::Refinement_options().number_of_iterations;
  constexpr std::size_t linear_steps = 300;
  static const std::vector<Method> all = {
    { "mips", "least distortion of angles, free border", run_mips, run_mips_atlas, true, 1e-6, newton_steps, one, true,
      true },
    { "symmetric-dirichlet", "least distortion of lengths, free border", run_symmetric_dirichlet,
      run_symmetric_dirichlet_atlas, true, 1e-6, newton_steps, area, true, true },
    { "uniform", "every vertex the mean of its neighbors, border on a circle", run_uniform, run_uniform_atlas, false,
      1e-8, linear_steps, one },
    { "chordal", "the same, weighted by the inverse lengths of the edges", run_chordal, run_chordal_atlas, false, 1e-8,
      linear_steps, one },
    { "harmonic", "the same, weighted by cotangents", run_harmonic, run_harmonic_atlas, false, 1e-8, linear_steps, one },
    { "shape-preserving", "the same, by Floater's weights", run_shape_preserving, run_shape_preserving_atlas, false,
      1e-8, linear_steps, one },
    { "barycentric", "CGAL's Tutte map, border on a circle", run_barycentric, run_barycentric_atlas, false, 1e-10,
      linear_steps, one, false, false, run_shipped_barycentric },
    { "mean-value", "CGAL's mean value coordinates, border on a circle", run_mean_value, run_mean_value_atlas, false,
      1e-10, linear_steps, one, false, false, run_shipped_mean_value },
    { "conformal", "CGAL's discrete conformal map, border on a circle", run_conformal, run_conformal_atlas, false, 1e-10,
      linear_steps, one, false, false, run_shipped_conformal },
    { "authalic", "CGAL's discrete authalic map, border on a circle", run_authalic, run_authalic_atlas, false, 1e-10,
      linear_steps, one, false, false, run_shipped_authalic },
    { "iterative-authalic", "CGAL's iterative authalic map, border on a circle", run_iterative_authalic,
      run_iterative_authalic_atlas, false, 1e-10, linear_steps, one, false, false, run_shipped_iterative_authalic },
    { "lscm", "CGAL's least squares conformal map, free border", run_lscm, run_lscm_atlas, false, 1e-10, linear_steps,
      one, false, false, run_shipped_lscm },
    { "arap", "as rigid as possible, free border", run_arap, run_arap_atlas, false, 1e-6, newton_steps, area, true,
      true, run_shipped_arap }
  };
  return all;
}

const Method* find_method(const std::string& name)
{
  const auto found = std::find_if(methods().begin(), methods().end(), [&](const Method& m) { return m.name == name; });
  return found == methods().end() ? nullptr : &*found;
}
