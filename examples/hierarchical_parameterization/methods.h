// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The methods that --method can name.

#ifndef METHODS_H
#define METHODS_H

#include "Mesh.h"

#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Option_defaults.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

struct Atlas_summary;

} // namespace CGAL::Surface_mesh_parameterization

namespace SMP = CGAL::Surface_mesh_parameterization;

struct Input;

// What the command line tells a method.
struct Method_options
{
  double tolerance = 0;
  std::size_t iterations = 0;
  SMP::Triangle_weight triangle_weight = SMP::Triangle_weight::ONE;
  unsigned int seed = 0;
  std::string levels;       // a folder, or empty
  std::string start;        // a file with a map to start from, or empty
  std::string hold;         // a file with places of vertices, or empty
  // Of an atlas; none: the default.
  std::optional<double> least_used_part, distortion_bound, overlap_bound, hole_bound, margin;
  std::optional<double> sharp_angle;                          // in degrees; none: no edge is a seam as it is sharp
  bool flat = false, quiet = false, is_globally_injective = false, fills_holes = false;
  bool avoids_overlaps = false;     // one chart is globally injective, too, or becomes an atlas if that distorts it
  SMP::Flip_policy flip_policy = SMP::Flip_policy::REPAIR;
};

// Fills in the map of the input.
typedef SMP::Parameterization_summary Run_method(Input&, const Method_options&);

// What an atlas is made of.
struct Atlas_mesh
{
  const Mesh& mesh;
  Seam_map seams;             // edges that are seams whatever the method does
  Corner_map corner_map;      // is filled in
};

// Cuts a whole mesh, lays out its charts, and packs them. Runs of one chart only, and what they need, are no matter
// here: the options `levels`, `start`, `hold` and `flat`.
typedef SMP::Atlas_summary Run_atlas(const Atlas_mesh&, const Method_options&);

// A method that --method can name. A new one is a row in methods().
struct Method
{
  std::string name, description;
  Run_method* run = nullptr;
  Run_atlas* run_atlas = nullptr;
  double tolerance = 0;                       // the defaults of the options
  std::size_t iterations = SMP::Option_defaults::iterations_of_linear_solver;
  SMP::Triangle_weight triangle_weight = SMP::Triangle_weight::ONE;
  bool is_flip_free = false;                  // whether flips are a failure
  bool has_levels = true;                     // whether every level is parameterized
  bool improves_map = false;                  // whether a run may start from a map, and hold vertices
  bool has_free_border = false;               // else it lies on a circle
  Run_method* run_shipped = nullptr;          // with --flat, if that is not run()
};

const std::vector<Method>& methods();

// The method of that name, null if there is none.
const Method* find_method(const std::string& name);

// Each group is compiled by itself: what a method is made of takes a compiler long.
Run_method run_mips, run_symmetric_dirichlet;
Run_method run_uniform, run_chordal, run_harmonic, run_shape_preserving;
Run_method run_barycentric, run_mean_value, run_conformal, run_authalic, run_iterative_authalic, run_lscm;
Run_method run_arap;
Run_atlas run_mips_atlas, run_symmetric_dirichlet_atlas, run_arap_atlas;
Run_atlas run_uniform_atlas, run_chordal_atlas, run_harmonic_atlas, run_shape_preserving_atlas;
Run_atlas run_barycentric_atlas, run_mean_value_atlas, run_conformal_atlas, run_authalic_atlas;
Run_atlas run_iterative_authalic_atlas, run_lscm_atlas;

#endif // METHODS_H
