// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A few sweeps on every level of the hierarchy against as many, and ten times as many, vertex visits on the input
// alone, in order and in random order. The coarsest level is swept until it converges, up to 2000 times or as often as
// the others, whichever is more.

#include "benchmark_utilities.h"

#include <iomanip>

struct Result
{
  double excess;              // of the energy over the minimum of 2 per triangle
  std::size_t visits;
  double seconds;
};

Result result_of(const Mesh& mesh, const SMP::Parameterization_summary& summary)
{
  return { summary.energy - SMP::MIPS_energy_2::minimum * double(mesh.number_of_faces()), vertex_visits(summary),
           summary.seconds_hierarchy + summary.seconds_parameterize };
}

Result run_hierarchical(Mesh& mesh, std::size_t sweeps, SMP::Optimizer optimizer)
{
  SMP::Parameterization_summary summary;
  const MIPS mips(CGAL::parameters::optimizer(optimizer).number_of_iterations(sweeps));
  parameterize(mesh, Hierarchical_MIPS(mips, CGAL::parameters::summary(std::ref(summary))));
  return result_of(mesh, summary);
}

// Tolerance 0: the run ends with the visits, not when it stalls.
Result run_flat(Mesh& mesh, std::size_t visits, SMP::Optimizer optimizer)
{
  const std::size_t n = mesh.number_of_vertices(), sweeps = (visits + n - 1) / n;
  SMP::Parameterization_summary summary;
  parameterize(mesh, MIPS(CGAL::parameters::tolerance(0.)
                              .optimizer(optimizer)
                              .summary(std::ref(summary))
                              .number_of_iterations(sweeps)));
  return result_of(mesh, summary);
}

void print_row(const std::string& name, const Result& result, const Result& reference)
{
  std::cout << "  " << std::left << std::setw(30) << name << std::right << std::fixed << std::setprecision(3)
            << std::setw(14) << result.excess << std::setprecision(2) << std::setw(10)
            << result.excess / reference.excess << std::setw(14) << result.visits << std::setprecision(3)
            << std::setw(10) << result.seconds << std::endl;
}

// All runs of one order. The flat ones have the visits of the hierarchical one of the same order.
void compare(Mesh& mesh, std::size_t sweeps, SMP::Optimizer optimizer, const std::string& order)
{
  const Result reference = run_hierarchical(mesh, sweeps, optimizer);
  print_row("hierarchical, " + order, reference, reference);
  print_row("flat, " + order, run_flat(mesh, reference.visits, optimizer), reference);
  print_row("flat, " + order + ", 10 times", run_flat(mesh, 10 * reference.visits, optimizer), reference);
}

void run(int argc, char* argv[])
{
  po::options_description options("Options");
  add_subdivide_option(options);
  options.add_options()
    ("sweeps", po::value<int>()->default_value(10), "the most sweeps on every level but the coarsest");
  const po::variables_map values =
      parse(argc, argv, options, "sweeps_against_flat [MESH.off] [--subdivide K] [--sweeps N]");
  const std::size_t subdivisions = subdivisions_of(values),
                    sweeps = count_of(values, "sweeps", 1, 1000000);
  Named_mesh input = only_mesh(values);
  Mesh& mesh = input.mesh;
  subdivide(mesh, subdivisions);

  std::cout << input.name << ": " << mesh.number_of_vertices() << " vertices, " << mesh.number_of_faces()
            << " triangles, at most " << sweeps << " sweeps on every level but the coarsest\n"
            << "                                  excess energy     ratio        visits   seconds\n";
  compare(mesh, sweeps, SMP::Optimizer::SWEEPS, "sweeps");
  compare(mesh, sweeps, SMP::Optimizer::RANDOM_VERTICES, "random order");
}

int main(int argc, char* argv[])
{
  return exit_status_of([&] { run(argc, argv); });
}
