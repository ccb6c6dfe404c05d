// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Table 1 of Hormann, Greiner and Campagna (1999): the MIPS energy after the same number of random local steps, with
// and without a hierarchy.

#include "benchmark_utilities.h"

#include <cmath>
#include <iomanip>
#include <numeric>

// The energy of a hierarchical run in sweeps until one lowers the excess by less than the given part of it.
double converged_energy(Mesh& mesh, double tolerance)
{
  constexpr int more_sweeps_than_needed = 10000000;
  SMP::Parameterization_summary summary;
  const MIPS mips(CGAL::parameters::optimizer(SMP::Optimizer::SWEEPS)
                      .tolerance(tolerance)
                      .number_of_iterations(more_sweeps_than_needed));
  parameterize(mesh, Hierarchical_MIPS(mips, CGAL::parameters::summary(std::ref(summary))));
  return summary.energy;
}

// The optimum, to at least six digits of its excess over the minimum.
double optimal_energy(Mesh& mesh)
{
  const double energy = converged_energy(mesh, 1e-13), check = converged_energy(mesh, 1e-11);
  const double excess = energy - SMP::MIPS_energy_2::minimum * double(mesh.number_of_faces()),
               rounding = 1e-12 * energy;
  if (!(std::abs(energy - check) < 1e-6 * excess + rounding))
    throw std::runtime_error("the optimum has not been found to six digits");
  return energy;
}

std::size_t number_of_levels(const Mesh& mesh, std::size_t coarsest_size, unsigned int seed)
{
  SMP::Mesh_component<Mesh> component(mesh, outer_border(mesh));
  check(component.error());
  return SMP::Collapse_hierarchy_3(std::move(component.surface()),
                                   CGAL::parameters::coarsest_size(coarsest_size).random_seed(seed))
      .number_of_levels();
}

// The energy after the same number of random steps on each of `levels` levels.
double hierarchical_energy(Mesh& mesh, std::size_t steps, std::size_t levels, std::size_t coarsest_size,
                           unsigned int seed)
{
  SMP::Parameterization_summary summary;
  const MIPS mips(CGAL::parameters::number_of_local_steps(steps / levels)
                      .optimizer(SMP::Optimizer::RANDOM_VERTICES)
                      .random_seed(seed));
  parameterize(mesh,
               Hierarchical_MIPS(
                   mips, CGAL::parameters::coarsest_size(coarsest_size).summary(std::ref(summary)).random_seed(seed)));
  return summary.energy;
}

double conventional_energy(Mesh& mesh, std::size_t steps, unsigned int seed)
{
  SMP::Parameterization_summary summary;
  parameterize(mesh, MIPS(CGAL::parameters::number_of_local_steps(steps)
                              .optimizer(SMP::Optimizer::RANDOM_VERTICES)
                              .summary(std::ref(summary))
                              .random_seed(seed)));
  return summary.energy;
}

double mean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.) / double(values.size());
}

void print_row(const std::string& name, const std::vector<double>& energies, double optimum)
{
  const auto [least, greatest] = std::minmax_element(energies.begin(), energies.end());
  std::cout << "  " << std::left << std::setw(14) << name << std::right << std::setw(12) << mean(energies)
            << std::setw(12) << mean(energies) - optimum << std::setw(12) << *least - optimum << std::setw(12)
            << *greatest - optimum << '\n';
}

void print_table(Named_mesh input, std::size_t steps, std::size_t coarsest_size, std::size_t number_of_seeds)
{
  Mesh& mesh = input.mesh;
  const double optimum = optimal_energy(mesh);
  std::vector<double> hierarchical, conventional;
  std::size_t fewest_levels = std::size_t(-1), most_levels = 0;
  for (unsigned int seed = 0; seed < number_of_seeds; ++seed) {
    const std::size_t levels = number_of_levels(mesh, coarsest_size, seed);
    fewest_levels = (std::min)(fewest_levels, levels);
    most_levels = (std::max)(most_levels, levels);
    hierarchical.push_back(hierarchical_energy(mesh, steps, levels, coarsest_size, seed));
    conventional.push_back(conventional_energy(mesh, steps, seed));
  }

  std::cout << input.name << ": " << mesh.number_of_vertices() << " vertices, " << mesh.number_of_faces()
            << " triangles, " << fewest_levels;
  if (most_levels > fewest_levels)
    std::cout << " to " << most_levels;
  std::cout << " levels, " << steps << " steps, mean of " << number_of_seeds << " seeds\n"
            << std::fixed << std::setprecision(4)
            << "                      energy         gap         min         max\n";
  print_row("optimal", { optimum }, optimum);
  print_row("hierarchical", hierarchical, optimum);
  print_row("conventional", conventional, optimum);
  std::cout << "  gap conventional / hierarchical: " << std::setprecision(1)
            << (mean(conventional) - optimum) / (mean(hierarchical) - optimum) << "\n\n";
}

void run(int argc, char* argv[])
{
  po::options_description options("Options");
  options.add_options()
    ("steps", po::value<std::vector<int>>()->default_value({}, "672 per vertex"),
     "local steps in total; once per mesh, in their order")
    ("coarsest-size", po::value<int>()->default_value(int(SMP::Collapse_hierarchy_3::default_coarsest_size)),
     "vertices of the coarsest level at most")
    ("seeds", po::value<int>()->default_value(5), "runs to average");
  const po::variables_map values =
      parse(argc, argv, options, "paper_table_1 [MESH.off ...] [--steps N]... [--coarsest-size N] [--seeds N]");
  const std::vector<std::size_t> steps = counts_of(values, "steps", 1000, 2000000000);
  const std::size_t coarsest_size = count_of(values, "coarsest-size", 3, 1000000),
                    number_of_seeds = count_of(values, "seeds", 1, 1000);

  std::size_t i = 0;
  for (const Named_mesh& input : meshes_of(values)) {
    print_table(input, i < steps.size() ? steps[i] : paper_steps(input.mesh), coarsest_size, number_of_seeds);
    ++i;
  }
}

int main(int argc, char* argv[])
{
  return exit_status_of([&] { run(argc, argv); });
}
