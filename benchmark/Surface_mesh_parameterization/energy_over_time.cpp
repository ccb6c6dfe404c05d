// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of the map of the whole mesh over processor time, with and without the hierarchy, by default options and
// one thread. CSV on stdout.

#include "benchmark_utilities.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Nested_iteration_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>

#include <CGAL/Timer.h>

struct Moment
{
  double seconds, energy;
};

// Notes each new energy on the finest level. A run without the hierarchy has that level only.
struct Recorder : SMP::Hierarchy_visitor_3
{
  Recorder(const CGAL::Timer& timer, std::vector<Moment>& moments) : timer(timer), moments(moments) { }

  bool progressed(const SMP::Parameterization_progress& progress)
  {
    const bool is_on_finest_level = progress.number_of_levels > 0 && progress.level + 1 == progress.number_of_levels;
    if (is_on_finest_level && (moments.empty() || progress.energy != moments.back().energy))
      moments.push_back({ timer.time(), progress.energy });
    return true;
  }

  const CGAL::Timer& timer;
  std::vector<Moment>& moments;
};

// By default options, but for those given.
template <class Method>
std::vector<Moment> record(Mesh& mesh, std::size_t coarsest_size, const Method& method = Method())
{
  std::vector<Moment> moments;
  CGAL::Timer timer;
  timer.start();
  parameterize(mesh, SMP::Nested_iteration_parameterizer_3<Method>(
                       method, CGAL::parameters::coarsest_size(coarsest_size).visitor(Recorder(timer, moments))));
  return moments;
}

template <class Method>
void measure(Mesh& mesh, const std::string& method, double minimum, bool with_flat)
{
  constexpr std::size_t coarsest_size = SMP::Collapse_hierarchy_3::default_coarsest_size;
  const double optimum = record(mesh, coarsest_size, Method(CGAL::parameters::tolerance(1e-13))).back().energy;
  for (const bool is_flat : { false, true })
    if (!is_flat || with_flat)
      for (const Moment& moment : record<Method>(mesh, is_flat ? mesh.number_of_vertices() : coarsest_size))
        std::cout << method << ',' << (is_flat ? "flat" : "hierarchical") << ',' << mesh.number_of_faces() << ','
                  << moment.seconds << ',' << (moment.energy - optimum) / (optimum - minimum) << std::endl;
}

void run(int argc, char* argv[])
{
  po::options_description options("Options");
  add_subdivide_option(options);
  options.add_options()
    ("flat", po::bool_switch(), "also without the hierarchy, with a direct solver");
  const po::variables_map values =
      parse(argc, argv, options, "energy_over_time [MESH.off] [--subdivide K] [--flat]");
  Mesh mesh = only_mesh(values).mesh;
  subdivide(mesh, subdivisions_of(values));

  const bool with_flat = values["flat"].as<bool>();
  std::cout << "method,run,triangles,seconds,relative_excess" << std::endl;
  measure<MIPS>(mesh, "mips", SMP::MIPS_energy_2::minimum * double(mesh.number_of_faces()), with_flat);
  measure<SMP::Symmetric_Dirichlet_parameterizer_3<Mesh>>(mesh, "symmetric-dirichlet",
                                                          SMP::Symmetric_Dirichlet_energy_2::minimum, with_flat);
}

int main(int argc, char* argv[])
{
  return exit_status_of([&] { run(argc, argv); });
}
