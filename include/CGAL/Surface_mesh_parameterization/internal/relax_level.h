// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_RELAX_LEVEL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_RELAX_LEVEL_H

#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/Vertex_relaxation.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <algorithm>
#include <cstddef>
#include <random>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// In which order vertex relaxation visits the vertices of a level.
enum class Visit_order
{
  SWEEPS,   ///< all of them, one after the other, over and over
  RANDOM    ///< each time one that is chosen at random, as in the paper; a sweep is then as many visits as there are vertices
};

namespace internal {

struct Relaxation_options
{
  std::size_t most_sweeps = 10;
  double relaxation_factor = 1.8;             // of sweeps; random steps are plain
  double tolerance = 1e-6;                    // of the decrease in one sweep, relative to the excess over the minimum
  std::size_t number_of_local_steps = 0;      // unless 0: exactly so many visits instead of sweeps until convergence
  Visit_order order = Visit_order::SWEEPS;
  Triangle_weight weight = Triangle_weight::ONE;
  unsigned int seed = 0;

  template <class NamedParameters>
  explicit Relaxation_options(const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    most_sweeps = choose_parameter(get_parameter(np, internal_np::number_of_iterations), most_sweeps);
    tolerance = choose_parameter(get_parameter(np, internal_np::tolerance), tolerance);
    number_of_local_steps = choose_parameter(get_parameter(np, internal_np::number_of_local_steps), number_of_local_steps);
    order = choose_parameter(get_parameter(np, internal_np::visit_order), order);
    weight = choose_parameter(get_parameter(np, internal_np::triangle_weight), weight);
    seed = choose_parameter(get_parameter(np, internal_np::random_seed), seed);
  }
};

// Lets the vertices that were just inserted settle among their neighbors, then relaxes all vertices until convergence or until the
// steps are used up; the coarsest of several levels always until convergence, for what it lacks no finer level can
// make good, and it costs nothing. Energies are reported as the sum over the triangles, or as the mean over the area if triangles are weighted so.
template <class Energy>
void relax_level(const Level& level, Level::Uv& uv, const Relaxation_options& options, Level_summary& summary)
{
  constexpr int settling_sweeps = 3;
  constexpr std::size_t most_sweeps_on_coarsest_level = 2000;
  const Index n = Index(level.number_of_vertices());
  const bool is_first_of_many = level.index() == 0 && !level.is_finest();
  const std::size_t most_sweeps = is_first_of_many ? (std::max)(options.most_sweeps, most_sweeps_on_coarsest_level) : options.most_sweeps;

  Vertex_relaxation<Energy> relaxation(level, options.weight, options.order == Visit_order::SWEEPS ? options.relaxation_factor : 1);
  const double unit = options.weight == Triangle_weight::AREA ? relaxation.total_weight() : 1;
  const double minimum = Energy::minimum * relaxation.total_weight();
  double energy = relaxation.energy(uv);
  summary.energy_start = energy / unit;

  std::mt19937 random(options.seed);
  if (options.number_of_local_steps > 0) {
    relaxation.random_steps(uv, options.number_of_local_steps, random);
    summary.vertex_visits = options.number_of_local_steps;
    summary.iterations = (options.number_of_local_steps + n - 1) / n;
  } else {
    for (int i = 0; i < settling_sweeps && level.index() > 0; ++i) {
      energy -= relaxation.sweep(uv, Index(level.first_new_vertex()));
      summary.vertex_visits += n - level.first_new_vertex();
    }
    while (summary.iterations < most_sweeps && !summary.converged) {
      const double decrease = options.order == Visit_order::RANDOM ? relaxation.random_steps(uv, n, random) : relaxation.sweep(uv);
      summary.converged = !(decrease > options.tolerance * (energy - minimum));
      energy -= decrease;
      summary.vertex_visits += n;
      ++summary.iterations;
    }
  }
  summary.energy_end = relaxation.energy(uv) / unit;
}

} // namespace internal

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_RELAX_LEVEL_H
