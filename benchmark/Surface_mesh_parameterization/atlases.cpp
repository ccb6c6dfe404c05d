// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Atlases of closed surfaces: with handles, of many components, and of mechanical parts.

#include "../../test/Surface_mesh_parameterization/closed_meshes.h"
#include "../../test/Surface_mesh_parameterization/mesh_conversions.h"
#include "Peak_memory.h"
#include "benchmark_utilities.h"

#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/atlas_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>

#include <cmath>
#include <iomanip>
#include <iterator>
#include <random>
#include <utility>

typedef Mesh::Property_map<Mesh::Halfedge_index, Point_2>   Corner_map;

double area(const test_meshes::Flat_mesh& mesh)
{
  return CGAL::Polygon_mesh_processing::area(test_meshes::make<Mesh>(mesh));
}

// Spheres, tetrahedra and wavy squares whose sizes differ as those of the charts of scanned scenes do: the logarithms
// are spread evenly over a range.
test_meshes::Flat_mesh many_components(std::size_t number, double range)
{
  const test_meshes::Flat_mesh kinds[] = { test_meshes::sphere(8, 10), test_meshes::tetrahedron(),
                                           test_meshes::grid(5, 5, test_meshes::wavy) };
  std::mt19937 random(1);
  test_meshes::Flat_mesh mesh;
  for (std::size_t i = 0; i < number; ++i) {
    const double scale = std::exp(range * double(random()) / double(random.max()));
    mesh = test_meshes::with_component(std::move(mesh), kinds[i % 3], scale, 100. * double(i));
  }
  return mesh;
}

// A few plates with handles, whose area is about half of the whole, and many small components.
test_meshes::Flat_mesh mixed_components(std::size_t number)
{
  test_meshes::Flat_mesh mesh = many_components(number - 8, 1.5);
  const double scale = std::sqrt(area(mesh) / area(test_meshes::plate_with_holes(2, 4)) / 8);
  for (test_meshes::Index i = 0; i < 8; ++i)
    mesh = test_meshes::with_component(std::move(mesh), test_meshes::plate_with_holes(i % 4, 4), scale,
                                       -100. * scale * (i + 1));
  return mesh;
}

double diagonal(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

struct Column
{
  const char* name;
  int width, precision;
};

constexpr Column columns[] = { { "triangles", 9, 0 }, { "charts", 6, 0 }, { "hdls", 4, 0 },  { "seam", 7, 2 },
                               { "energy", 7, 3 },    { "cut s", 7, 2 },  { "map s", 7, 2 }, { "pack s", 7, 2 },
                               { "used", 6, 3 },      { "flips", 5, 0 },  { "overl", 5, 0 }, { "s/10^6", 8, 1 },
                               { "B/tri", 6, 0 } };
constexpr int width_of_names = 28;

void print_header()
{
  std::cout << std::string(width_of_names, ' ');
  for (const Column& column : columns)
    std::cout << ' ' << std::setw(column.width) << column.name;
  std::cout << std::endl;
}

template <std::size_t N>
void print_row(const std::string& name, const double (&values)[N])
{
  static_assert(N == std::size(columns));
  std::cout << std::left << std::setw(width_of_names) << name << std::right << std::fixed;
  for (std::size_t i = 0; i < N; ++i)
    std::cout << ' ' << std::setw(columns[i].width) << std::setprecision(columns[i].precision) << values[i];
  std::cout << std::endl;
}

struct Atlas_bounds
{
  double least_used_part, overlap;
};

template <template <class...> class Method>
void measure_atlas(const std::string& name, Mesh mesh, bool is_mips, const Atlas_bounds& bounds)
{
  const Corner_map uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  const Peak_memory memory;
  const SMP::Atlas_summary summary = SMP::atlas_parameterization<Method>(
      mesh, uv, SMP::parameters::least_used_part(bounds.least_used_part).overlap_bound(bounds.overlap));
  const double bytes = memory.growth().value_or(0);
  check(summary.error);
  std::size_t handles = 0;
  for (const SMP::Cut_summary::Component& component : summary.cut.components)
    handles += component.genus;
  const SMP::Parameterization_quality quality = SMP::atlas_quality(mesh, uv);
  const double seconds = summary.seconds_cut + summary.seconds_parameterize + summary.seconds_pack,
               triangles = double(mesh.number_of_faces());
  const double energy = is_mips ? quality.mips / triangles : quality.symmetric_dirichlet;      // a mean
  print_row(name, { triangles, double(summary.charts.size()), double(handles),
                    summary.cut.seam_length / diagonal(mesh), energy, summary.seconds_cut,
                    summary.seconds_parameterize, summary.seconds_pack, summary.used_part, double(quality.flips),
                    double(quality.overlaps), 1e6 * seconds / triangles, bytes / triangles });
}

template <class Measure>
void measure_mechanical_parts(const Measure& measure)
{
  const std::pair<const char*, test_meshes::Flat_mesh> parts[] = {
    { "heat sink, 20 fins", test_meshes::heat_sink(20) },
    { "heat sink, 40 fins", test_meshes::heat_sink(40) },
    { "perforated plate, 64 holes", test_meshes::perforated_plate(8) },
    { "Menger sponge, 2 steps", test_meshes::menger_sponge(2) },
    { "Menger sponge, 3 steps", test_meshes::menger_sponge(3) }
  };
  for (const auto& [name, part] : parts)
    measure(name, test_meshes::make<Mesh>(part));
}

void run(int argc, char* argv[])
{
  po::options_description options("Options");
  options.add_options()
    ("components", po::value<std::vector<int>>()->default_value({ 100, 1000, 10000 }, "100, 1000, 10000"),
     "numbers of components of generated meshes")
    ("handles", po::value<std::vector<int>>()->default_value({ 0, 1, 5, 20 }, "0, 1, 5, 20"),
     "numbers of handles of generated meshes")
    ("least-used-part", po::value<double>()->default_value(0.25),
     "divide charts until they cover this part of the square")
    ("overlap-bound", po::value<double>()->default_value(0.2),
     "divide charts that would lie over themselves with more than this part of their triangles")
    ("mechanical-parts", po::bool_switch(), "heat sinks, a perforated plate and Menger sponges, made of cubes");
  const po::variables_map values =
      parse(argc, argv, options,
            "atlases [MESH.off ...] [--components N]... [--handles N]... [--mechanical-parts] [--least-used-part P] "
            "[--overlap-bound P]");
  const auto files = values["mesh"].as<std::vector<std::string>>();
  const std::vector<std::size_t> numbers_of_handles = counts_of(values, "handles", 0, 1000),
                                 numbers_of_components = counts_of(values, "components", 10, 1000000);
  const Atlas_bounds bounds = { part_of(values, "least-used-part"), part_of(values, "overlap-bound") };

  const auto measure = [&](const std::string& name, const Mesh& mesh) {
    measure_atlas<SMP::Symmetric_Dirichlet_parameterizer_3>(name, mesh, false, bounds);
    measure_atlas<SMP::MIPS_parameterizer_3>(name + ", MIPS", mesh, true, bounds);
  };

  print_header();
  for (const std::string& file : files) {
    Mesh mesh = read_mesh(file);
    CGAL::Polygon_mesh_processing::stitch_borders(mesh);
    mesh.collect_garbage();
    measure(file.substr(file.find_last_of('/') + 1), mesh);
  }
  const bool makes_mechanical_parts = values["mechanical-parts"].as<bool>();
  if (makes_mechanical_parts)
    measure_mechanical_parts(measure);
  const bool makes_all = files.empty() && !makes_mechanical_parts;
  const auto is_wanted = [&](const char* option) { return makes_all || !values[option].defaulted(); };
  if (is_wanted("handles"))
    for (const std::size_t handles : numbers_of_handles)
      measure("plate, " + std::to_string(handles) + " handles",
              test_meshes::make<Mesh>(test_meshes::plate_with_holes(test_meshes::Index(handles), 10)));
  if (is_wanted("components"))
    for (const std::size_t number : numbers_of_components) {
      measure("sizes within 1:3", test_meshes::make<Mesh>(many_components(number, std::log(3.))));
      measure("sizes within 1:100", test_meshes::make<Mesh>(many_components(number, std::log(100.))));
      measure("8 plates and small ones", test_meshes::make<Mesh>(mixed_components(number)));
    }
}

int main(int argc, char* argv[])
{
  return exit_status_of([&] { run(argc, argv); });
}
