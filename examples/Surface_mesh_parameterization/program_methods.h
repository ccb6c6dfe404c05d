// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAM_METHODS_H
#define PROGRAM_METHODS_H

#include "program_file.h"
#include "program_input.h"
#include "program_output.h"

#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Chordal_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Shape_preserving_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/settle_flips.h>

#include <CGAL/Real_timer.h>

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <streambuf>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

typedef Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>   UV_map;

// What the command line tells a method.
struct Method_options
{
  double tolerance;
  std::size_t iterations;
  SMP::Triangle_weight triangle_weight;
  unsigned int seed;
  std::string levels;       // a folder, or empty
  bool flat, quiet, is_globally_injective, fills_holes;
  SMP::Flip_policy flip_policy;
};

// A method that --method can name. A new one is a row in methods().
struct Program_method
{
  typedef SMP::Parameterization_summary (*Run)(Input&, const Method_options&, UV_map);

  std::string name, description;
  Run run;
  bool is_flip_free;                          // whether flips are a failure
  double tolerance;                           // the defaults of the options
  std::size_t iterations;
  SMP::Triangle_weight triangle_weight;
  bool has_levels = true;                     // whether every level is parameterized
};

// Tells of progress on a terminal and writes the levels.
struct Program_visitor : SMP::Hierarchy_visitor_3
{
  const Method_options& options;
  const Mesh& mesh;
  const std::vector<Mesh::Vertex_index>& vertices;    // of the component, as the hierarchy numbers them
  bool has_progress_line;
  double seconds = 0;       // on the levels that are done

  Program_visitor(const Method_options& options, const Mesh& mesh, const std::vector<Mesh::Vertex_index>& vertices)
    : options(options), mesh(mesh), vertices(vertices), has_progress_line(!options.quiet && isatty(STDERR_FILENO))
  { }

  bool level_parameterized(const SMP::Level& level, const SMP::Level::Uv& uv, const SMP::Level_summary& summary)
  {
    if (has_progress_line)
      print_progress(level, summary);
    if (!options.levels.empty()) {
      char name[32];
      std::snprintf(name, sizeof name, "level_%02zu.obj", level.index());
      write_file((std::filesystem::path(options.levels) / name).string(),
                 [&](std::ostream& out) { write_level(out, mesh, vertices, level, uv); });
    }
    return true;
  }

  // The time that a level takes grows with its size, so what is left can be told from what is done.
  void print_progress(const SMP::Level& level, const SMP::Level_summary& summary)
  {
    const SMP::Collapse_hierarchy_3& hierarchy = level.hierarchy();
    double done = 0, left = 0;
    for (std::size_t l = 0; l < hierarchy.number_of_levels(); ++l)
      (l <= level.index() ? done : left) += double(hierarchy.number_of_vertices(l));
    seconds += summary.seconds;
    std::fprintf(stderr, "\rlevel %zu of %zu: %zu triangles, energy %.6g, about %.0f s left   %s", level.index() + 1, hierarchy.number_of_levels(),
                 summary.faces, summary.energy_end, seconds * left / done, level.is_finest() ? "\n" : "");
  }
};

// Not by CGAL's parameterize(), which copies, what not all parameterizers can, and whose preconditions refuse a mesh with isolated vertices.
template <class Parameterizer>
SMP::Error_code parameterize_flat(Input& input, Parameterizer& parameterizer, UV_map uvmap, const std::vector<Mesh::Vertex_index>& vertices_of_component)
{
  const auto index = get(CGAL::dynamic_vertex_property_t<int>(), input.mesh);
  const auto is_parameterized = get(CGAL::dynamic_vertex_property_t<bool>(), input.mesh);
  int n = 0;
  for (const Mesh::Vertex_index v : vertices_of_component)
    put(index, v, n++);
  return parameterizer.parameterize(input.mesh, input.border, uvmap, index, is_parameterized);
}

// Runs a refinable method, flat or coarse to fine. `make_method(summary)` makes it so that a flat run fills that summary.
template <class Make_method>
SMP::Parameterization_summary run_refinable(Input& input, const Method_options& options, UV_map uvmap, const Make_method& make_method)
{
  SMP::Parameterization_summary summary;
  auto method = make_method(summary);
  if (options.flat)
    parameterize_flat(input, method, uvmap, {});      // the method reads the component itself
  else {
    const std::vector<Mesh::Vertex_index> vertices = options.levels.empty() ? std::vector<Mesh::Vertex_index>()
      : SMP::Mesh_component<Mesh>(input.mesh, input.border).vertices_of_component();
    const SMP::Hierarchical_parameterizer_3<std::decay_t<decltype(method)>> hierarchical(
      method, CGAL::parameters::flip_policy(options.flip_policy).fill_holes(options.fills_holes).summary(std::ref(summary)).random_seed(options.seed).visitor(Program_visitor(options, input.mesh, vertices)));
    SMP::parameterize(input.mesh, hierarchical, input.border, uvmap);
  }
  return summary;
}

template <template <class, class> class Method>
SMP::Parameterization_summary minimize_distortion(Input& input, const Method_options& options, UV_map uvmap)
{
  return run_refinable(input, options, uvmap, [&](SMP::Parameterization_summary& summary) {
    return Method<Mesh, CGAL::Parallel_if_available_tag>(CGAL::parameters::tolerance(options.tolerance).summary(std::ref(summary))
                                                         .triangle_weight(options.triangle_weight).fill_holes(options.fills_holes)
                                                         .globally_injective(options.is_globally_injective).number_of_iterations(options.iterations));
  });
}

template <class EdgeWeights>
SMP::Parameterization_summary minimize_edge_energy(Input& input, const Method_options& options, UV_map uvmap)
{
  typedef SMP::Circular_border_arc_length_parameterizer_3<Mesh>                                                Border;
  typedef SMP::Edge_energy_parameterizer_3<Mesh, EdgeWeights, Border, CGAL::Parallel_if_available_tag>   Method;
  return run_refinable(input, options, uvmap, [&](SMP::Parameterization_summary& summary) {
    return Method(Border(), EdgeWeights(),
                  CGAL::parameters::tolerance(options.tolerance).flip_policy(options.flip_policy).fill_holes(options.fills_holes).summary(std::ref(summary))
                  .number_of_iterations(options.iterations));
  });
}

// Runs a parameterizer as CGAL ships it.
template <class Parameterizer>
SMP::Parameterization_summary run_flat(Input& input, const Method_options& options, UV_map uvmap)
{
  if (options.fills_holes)
    throw Usage_error{ "--flat runs this method as CGAL ships it, which does not fill holes" };
  SMP::Parameterization_summary summary;
  CGAL::Real_timer timer;
  timer.start();
  const SMP::Mesh_component<Mesh> component(input.mesh, input.border);
  summary.error = component.error();
  if (summary.error.code != SMP::OK)
    return summary;
  Parameterizer parameterizer;
  SMP::Error_code code = parameterize_flat(input, parameterizer, uvmap, component.vertices_of_component());
  if (code == SMP::OK)
    code = SMP::settle_flips(input.mesh, input.border, uvmap, options.flip_policy, CGAL::parameters::summary(std::ref(summary)));
  summary.error.code = code;
  summary.converged = summary.error.code == SMP::OK;
  summary.seconds_parameterize = timer.time();
  return summary;
}

// Runs one of CGAL's parameterizers, flat or hierarchically.
template <class Parameterizer>
SMP::Parameterization_summary run_wrapped(Input& input, const Method_options& options, UV_map uvmap)
{
  if (options.flat)
    return run_flat<Parameterizer>(input, options, uvmap);
  SMP::Parameterization_summary summary;
  const std::vector<Mesh::Vertex_index> vertices = options.levels.empty() ? std::vector<Mesh::Vertex_index>()
    : SMP::Mesh_component<Mesh>(input.mesh, input.border).vertices_of_component();
  const SMP::Hierarchical_parameterizer_3<Parameterizer> hierarchical(
    CGAL::parameters::tolerance(options.tolerance).flip_policy(options.flip_policy).fill_holes(options.fills_holes).summary(std::ref(summary)).number_of_iterations(options.iterations)
    .random_seed(options.seed).visitor(Program_visitor(options, input.mesh, vertices)));
  SMP::parameterize(input.mesh, hierarchical, input.border, uvmap);
  return summary;
}

// While it lives, the current folder is a new one, which goes with it, and the standard output is switched off.
class Confinement
{
public:
  Confinement()
    : m_outside(std::filesystem::current_path()),
      m_folder(std::filesystem::temp_directory_path() / ("hierarchical_parameterization_" + std::to_string(getpid()))), m_output(std::cout.rdbuf(nullptr))
  {
    std::filesystem::create_directory(m_folder);
    std::filesystem::current_path(m_folder);
  }

  ~Confinement()
  {
    std::error_code unused_error;
    std::filesystem::current_path(m_outside, unused_error);
    std::filesystem::remove_all(m_folder, unused_error);
    std::cout.rdbuf(m_output);
  }

  Confinement(const Confinement&) = delete;
  Confinement& operator=(const Confinement&) = delete;

private:
  std::filesystem::path m_outside, m_folder;
  std::streambuf* m_output;
};

// In CGAL 5 this parameterizer prints its progress, and writes a file into the current folder in every iteration.
inline SMP::Parameterization_summary run_iterative_authalic(Input& input, const Method_options& options, UV_map uvmap)
{
  const Confinement confinement;
  return run_wrapped<SMP::Iterative_authalic_parameterizer_3<Mesh>>(input, options, uvmap);
}

inline const std::vector<Program_method>& methods()
{
  constexpr SMP::Triangle_weight one = SMP::Triangle_weight::ONE, area = SMP::Triangle_weight::AREA;
  static const std::size_t newton_steps = SMP::Refinement_options().number_of_iterations;
  static const std::vector<Program_method> all = {
    { "mips", "least distortion of angles, free border", minimize_distortion<SMP::MIPS_parameterizer_3>, true, 1e-6, newton_steps, one },
    { "symmetric-dirichlet", "least distortion of lengths, free border", minimize_distortion<SMP::Symmetric_Dirichlet_parameterizer_3>, true, 1e-6, newton_steps, area },
    { "uniform", "every vertex the mean of its neighbors, border on a circle", minimize_edge_energy<SMP::Uniform_edge_weights_3>, false, 1e-8, 10000, one },
    { "chordal", "the same, weighted by the inverse lengths of the edges", minimize_edge_energy<SMP::Chordal_edge_weights_3>, false, 1e-8, 10000, one },
    { "harmonic", "the same, weighted by cotangents", minimize_edge_energy<SMP::Harmonic_edge_weights_3>, false, 1e-8, 10000, one },
    { "shape-preserving", "the same, by Floater's weights", minimize_edge_energy<SMP::Shape_preserving_edge_weights_3>, false, 1e-8, 10000, one },
    { "barycentric", "CGAL's Tutte map, border on a circle", run_wrapped<SMP::Barycentric_mapping_parameterizer_3<Mesh>>, false, 1e-10, 300, one, false },
    { "mean-value", "CGAL's mean value coordinates, border on a circle", run_wrapped<SMP::Mean_value_coordinates_parameterizer_3<Mesh>>, false, 1e-10, 300, one, false },
    { "conformal", "CGAL's discrete conformal map, border on a circle", run_wrapped<SMP::Discrete_conformal_map_parameterizer_3<Mesh>>, false, 1e-10, 300, one, false },
    { "authalic", "CGAL's discrete authalic map, border on a circle", run_wrapped<SMP::Discrete_authalic_parameterizer_3<Mesh>>, false, 1e-10, 300, one, false },
    { "iterative-authalic", "CGAL's iterative authalic map, border on a circle", run_iterative_authalic, false, 1e-10, 300, one, false },
    { "lscm", "CGAL's least squares conformal map, free border", run_wrapped<SMP::LSCM_parameterizer_3<Mesh>>, false, 1e-10, 300, one, false },
    { "arap", "as rigid as possible, free border", run_wrapped<SMP::ARAP_parameterizer_3<Mesh>>, false, 1e-6, newton_steps, area } };
  return all;
}

// The method of that name, null if there is none.
inline const Program_method* find_method(const std::string& name)
{
  const auto found = std::find_if(methods().begin(), methods().end(), [&](const Program_method& m) { return m.name == name; });
  return found == methods().end() ? nullptr : &*found;
}

// One text of what `describe(method)` returns, for all of them.
template <class Describe>
std::string list_of_methods(const std::string& separator, const Describe& describe)
{
  std::string list;
  for (const Program_method& method : methods())
    list += (list.empty() ? "" : separator) + describe(method);
  return list;
}

#endif // PROGRAM_METHODS_H
