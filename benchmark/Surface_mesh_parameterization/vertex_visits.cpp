// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Nanoseconds per vertex visit of MIPS relaxation on the finest level of a nested iteration: in sweeps, and in random
// order.

#include "benchmark_utilities.h"

#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_refiner.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Vertex_relaxation.h>

#include <iomanip>
#include <random>

struct Timings
{
  std::vector<double> sweeps, random_steps;   // nanoseconds per visit, one entry per sweep
};

// Relaxes a copy of the finest level's map and takes the time of each sweep.
class Finest_level_timer : public SMP::Hierarchy_visitor_3
{
public:
  Finest_level_timer(std::size_t number_of_sweeps, Timings& timings)
    : m_number_of_sweeps(number_of_sweeps), m_timings(timings)
  { }

  bool level_parameterized(const SMP::Level& level, const SMP::Level::Uv& uv, const SMP::Level_summary&)
  {
    if (!level.is_finest())
      return true;
    const double over_relaxation = SMP::internal::Level_refiner_options().over_relaxation;
    m_timings.sweeps =
        time(level, uv, over_relaxation, [](Relaxation& relaxation, SMP::Level::Uv& map) { relaxation.sweep(map); });
    std::mt19937 random;
    m_timings.random_steps = time(level, uv, 1, [&](Relaxation& relaxation, SMP::Level::Uv& map) {
      relaxation.random_steps(map, map.size(), random);
    });
    return true;
  }

private:
  typedef SMP::internal::Vertex_relaxation   Relaxation;

  template <class Sweep>
  std::vector<double> time(const SMP::Level& level, SMP::Level::Uv uv, double relaxation_factor,
                           const Sweep& sweep) const
  {
    const SMP::internal::Level_energy_of<SMP::MIPS_energy_2> energy(level, SMP::Triangle_weight::ONE);
    Relaxation relaxation(energy, relaxation_factor);
    std::vector<double> nanoseconds;
    for (std::size_t i = 0; i < m_number_of_sweeps; ++i)
      nanoseconds.push_back(1e9 * seconds_of([&] { sweep(relaxation, uv); }) / double(uv.size()));
    return nanoseconds;
  }

  std::size_t m_number_of_sweeps;
  Timings& m_timings;
};

void print_row(const std::string& name, const std::vector<double>& nanoseconds)
{
  const auto [least, greatest] = std::minmax_element(nanoseconds.begin(), nanoseconds.end());
  std::cout << "  " << std::left << std::setw(14) << name << std::right << std::setw(9) << median(nanoseconds)
            << std::setw(9) << *least << std::setw(9) << *greatest << '\n';
}

void run(int argc, char* argv[])
{
  po::options_description options("Options");
  add_subdivide_option(options);
  options.add_options()
    ("sweeps", po::value<int>()->default_value(20), "sweeps to take the median of");
  const po::variables_map values = parse(argc, argv, options, "vertex_visits [MESH.off] [--subdivide K] [--sweeps N]");
  const std::size_t subdivisions = subdivisions_of(values),
                    sweeps = count_of(values, "sweeps", 1, 1000000);
  Named_mesh input = only_mesh(values);
  subdivide(input.mesh, subdivisions);

  constexpr int sweeps_before = 3;   // on every level, so that the map is one under way, neither raw nor converged
  Timings timings;
  const MIPS mips(CGAL::parameters::optimizer(SMP::Optimizer::SWEEPS).number_of_iterations(sweeps_before));
  parameterize(input.mesh, Hierarchical_MIPS(mips, CGAL::parameters::visitor(Finest_level_timer(sweeps, timings))));

  std::cout << input.name << ": " << input.mesh.number_of_vertices() << " vertices, " << sweeps
            << " sweeps; nanoseconds per vertex visit\n"
            << "                   median      min      max\n"
            << std::fixed << std::setprecision(1);
  print_row("sweeps", timings.sweeps);
  print_row("random steps", timings.random_steps);
}

int main(int argc, char* argv[])
{
  return exit_status_of([&] { run(argc, argv); });
}
