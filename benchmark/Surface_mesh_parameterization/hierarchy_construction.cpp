// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Figure 4 of Hormann, Greiner and Campagna (1999), in numbers: how long the levels take to build, compared with
// reading the file; what they hold in memory; how many triangles go per collapse group.

#include "Peak_memory.h"
#include "benchmark_utilities.h"

#include <filesystem>
#include <iomanip>
#include <optional>
#include <random>

namespace fs = std::filesystem;

// An OFF file in the folder for temporary files that goes when the object does.
class Temporary_OFF
{
public:
  explicit Temporary_OFF(const Mesh& mesh)
    : m_file(fs::temp_directory_path() / ("hierarchy_construction_" + std::to_string(std::random_device()()) + ".off"))
  {
    if (!CGAL::IO::write_OFF(m_file.string(), mesh, CGAL::parameters::stream_precision(17))) {
      fs::remove(m_file);
      throw std::runtime_error(m_file.string() + ": cannot be written");
    }
  }
  ~Temporary_OFF() { std::error_code ignored; fs::remove(m_file, ignored); }
  Temporary_OFF(const Temporary_OFF&) = delete;
  Temporary_OFF& operator=(const Temporary_OFF&) = delete;

  std::string name() const { return m_file.string(); }

private:
  fs::path m_file;
};

struct Measurement
{
  double read, component, hierarchy;        // seconds
  std::optional<double> peak_growth;        // bytes
};

// Reads the file and builds its hierarchy.
Measurement measure(const std::string& file, std::size_t coarsest_size,
                    std::optional<SMP::Collapse_hierarchy_3>& hierarchy)
{
  Measurement m;
  Mesh mesh;
  m.read = seconds_of([&] { mesh = read_mesh(file); });
  const Mesh::Halfedge_index border = outer_border(mesh);

  hierarchy.reset();
  const Peak_memory memory;
  std::optional<SMP::Mesh_component<Mesh>> component;
  m.component = seconds_of([&] { component.emplace(mesh, border); });
  check(component->error());
  m.hierarchy = seconds_of(
      [&] { hierarchy.emplace(std::move(component->surface()), CGAL::parameters::coarsest_size(coarsest_size)); });
  m.peak_growth = memory.growth();
  return m;
}

void print_levels(const SMP::Collapse_hierarchy_3& hierarchy)
{
  std::cout << "level,vertices,faces,ratio_to_coarser\n";
  for (std::size_t level = hierarchy.number_of_levels(); level-- > 0;) {
    std::cout << level << ',' << hierarchy.number_of_vertices(level) << ',' << hierarchy.number_of_faces(level) << ',';
    if (level > 0)
      std::cout << double(hierarchy.number_of_faces(level)) / double(hierarchy.number_of_faces(level - 1));
    std::cout << '\n';
  }
}

// Prints the medians of the repetitions, and the levels of the last one.
void measure_and_print(const std::string& name, const std::string& file, std::size_t coarsest_size,
                       std::size_t repetitions)
{
  std::optional<SMP::Collapse_hierarchy_3> hierarchy;
  std::vector<double> read, component, construction, ratio;
  std::optional<double> peak_growth;
  for (std::size_t i = 0; i < repetitions; ++i) {
    const Measurement m = measure(file, coarsest_size, hierarchy);
    read.push_back(m.read);
    component.push_back(m.component);
    construction.push_back(m.hierarchy);
    ratio.push_back((m.component + m.hierarchy) / m.read);
    if (i == 0)
      peak_growth = m.peak_growth;
  }

  const double n = double(hierarchy->number_of_vertices());
  std::cout << name << ": " << hierarchy->number_of_vertices() << " vertices, " << hierarchy->number_of_faces()
            << " triangles, median of " << repetitions << '\n'
            << std::fixed << std::setprecision(4) << "  read the OFF file    " << std::setw(8) << median(read) << " s\n"
            << "  take the component   " << std::setw(8) << median(component) << " s\n"
            << "  build the hierarchy  " << std::setw(8) << median(construction) << " s\n"
            << std::setprecision(3) << "  (component + hierarchy) / read  " << median(ratio) << '\n'
            << std::setprecision(1) << "  hierarchy holds      " << std::setw(8) << double(hierarchy->memory()) / n
            << " bytes per vertex\n"
            << "  peak of construction ";
  if (peak_growth)
    std::cout << std::setw(8) << *peak_growth / n << " bytes per vertex\n\n";
  else
    std::cout << " unknown\n\n";
  std::cout << std::setprecision(4);
  print_levels(*hierarchy);
}

void run(int argc, char* argv[])
{
  constexpr std::size_t enough_faces = 1000000;
  po::options_description options("Options");
  add_subdivide_option(options);
  options.add_options()
    ("repetitions", po::value<int>()->default_value(5), "runs to take the median of")
    ("coarsest-size", po::value<int>()->default_value(int(SMP::Collapse_hierarchy_3::default_coarsest_size)),
     "vertices of the coarsest level at most");
  const po::variables_map values =
      parse(argc, argv, options,
            "hierarchy_construction [MESH.off] [--subdivide K] [--repetitions N] [--coarsest-size N]");
  std::size_t subdivisions = subdivisions_of(values);
  const std::size_t repetitions = count_of(values, "repetitions", 1, 1000),
                    coarsest_size = count_of(values, "coarsest-size", 3, 1000000000);

  std::optional<Temporary_OFF> subdivided_file;
  std::string name, file;
  {
    Named_mesh input = only_mesh(values);
    const bool is_built_in = values["mesh"].as<std::vector<std::string>>().empty();
    if (is_built_in && values["subdivide"].defaulted())
      for (std::size_t faces = input.mesh.number_of_faces(); faces <= enough_faces; faces *= 4)
        ++subdivisions;
    name = file = input.name;
    if (is_built_in || subdivisions > 0) {
      subdivide(input.mesh, subdivisions);
      subdivided_file.emplace(input.mesh);
      file = subdivided_file->name();
      name += ", subdivided " + std::to_string(subdivisions) + " times";
    }
  }
  measure_and_print(name, file, coarsest_size, repetitions);
}

int main(int argc, char* argv[])
{
  return exit_status_of([&] { run(argc, argv); });
}
