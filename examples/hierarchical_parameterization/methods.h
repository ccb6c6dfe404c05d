// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The methods that --method can name.

#ifndef METHODS_H
#define METHODS_H

#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>

#include <cstddef>
#include <string>
#include <vector>

namespace SMP = CGAL::Surface_mesh_parameterization;

struct Input;

// What the command line tells a method.
struct Method_options
{
  double tolerance;
  std::size_t iterations;
  SMP::Triangle_weight triangle_weight;
  unsigned int seed;
  std::string levels;       // a folder, or empty
  std::string start;        // a file with a map to start from, or empty
  bool flat, quiet, is_globally_injective, fills_holes;
  SMP::Flip_policy flip_policy;
};

// Fills in the map of the input. May throw a Usage_error.
typedef SMP::Parameterization_summary Run_method(Input&, const Method_options&);

// A method that --method can name. A new one is a row in methods().
struct Method
{
  std::string name, description;
  Run_method* run;
  bool is_flip_free;                          // whether flips are a failure
  double tolerance;                           // the defaults of the options
  std::size_t iterations;
  SMP::Triangle_weight triangle_weight;
  bool has_levels = true;                     // whether every level is parameterized
  bool takes_start = false;                   // whether a run may start from a map
};

const std::vector<Method>& methods();

// The method of that name, null if there is none.
const Method* find_method(const std::string& name);

// Each group is compiled by itself: what a method is made of takes a compiler long.
Run_method run_mips, run_symmetric_dirichlet;
Run_method run_uniform, run_chordal, run_harmonic, run_shape_preserving;
Run_method run_barycentric, run_mean_value, run_conformal, run_authalic, run_iterative_authalic, run_lscm;
Run_method run_arap;

#endif // METHODS_H
