// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs that start from a map, hold vertices, or hold the whole border, beside runs that do not. CSV on stdout.

#include "benchmark_utilities.h"

#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace np = SMP::parameters;

typedef Mesh::Property_map<Mesh::Vertex_index, bool>     Held_map;

// Each coordinate moves by a twentieth of the map's size times a sine or cosine of the other one.
Places bent(const Places& places)
{
  const CGAL::Bbox_2 box = box_of(places);
  const double size = diagonal_of(box);
  Places result;
  for (const Point_2& p : places) {
    const double x = (p.x() - box.xmin()) / size, y = (p.y() - box.ymin()) / size;
    result.emplace_back(p.x() + 0.05 * size * std::sin(4 * y), p.y() + 0.05 * size * std::cos(3 * x));
  }
  return result;
}

// Runs of a method on a mesh, and a row for each.
template <template <class...> class Method>
class Measurement
{
public:
  Measurement(Named_mesh& input, const std::string& method)
    : m_mesh(input.mesh), m_names(input.name + ',' + method + ','), m_uvmap(add_uv_map(m_mesh)),
      m_is_held(m_mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_held").first)
  { }

  void run()
  {
    hold_none();
    measure("free", places(), np::default_values());
    const Places free = places();
    measure("from its result", free, np::initial_map(true));
    check(SMP::hierarchical_parameterization<SMP::LSCM_parameterizer_3>(
              m_mesh, m_uvmap, np::flip_policy(SMP::Flip_policy::KEEP)).error);
    measure("from LSCM", places(), np::initial_map(true));
    const Places target = bent(free);
    for (const std::size_t n : { 1, 10, 100, 1000 })
      if (n < m_mesh.number_of_vertices()) {
        hold_some(n);
        measure("held", target, np::vertex_is_constrained_map(m_is_held));
      }
    hold_border();
    const Places circle = places();
    measure("circle", circle, np::vertex_is_constrained_map(m_is_held));
    measure_against_flat(circle);
  }

private:
  Places places() const { return places_of(m_mesh, m_uvmap); }

  void put(const Places& places)
  {
    for (const Mesh::Vertex_index v : m_mesh.vertices())
      m_uvmap[v] = places[v];
  }

  void hold_none()
  {
    for (const Mesh::Vertex_index v : m_mesh.vertices())
      m_is_held[v] = false;
  }

  // So many different vertices, chosen at random.
  void hold_some(std::size_t n)
  {
    hold_none();
    std::mt19937 random(1);
    std::vector<Mesh::Vertex_index> vertices(m_mesh.vertices().begin(), m_mesh.vertices().end()), chosen;
    std::sample(vertices.begin(), vertices.end(), std::back_inserter(chosen), n, random);
    for (const Mesh::Vertex_index v : chosen)
      m_is_held[v] = true;
  }

  // The longest border on a circle whose area is that of the surface.
  void hold_border()
  {
    constexpr double area_of_circle = CGAL_PI / 4;      // of diameter 1
    hold_none();
    const auto index = m_mesh.add_property_map<Mesh::Vertex_index, int>("v:index").first;
    check(SMP::Circular_border_arc_length_parameterizer_3<Mesh>().parameterize(m_mesh, outer_border(m_mesh), m_uvmap,
                                                                              index, m_is_held));
    const double width = std::sqrt(CGAL::Polygon_mesh_processing::area(m_mesh) / area_of_circle);
    for (const Mesh::Vertex_index v : m_mesh.vertices())
      m_uvmap[v] = Point_2(width * m_uvmap[v].x(), width * m_uvmap[v].y());
  }

  // To the last digit, coarse to fine and on the finest level alone.
  void measure_against_flat(const Places& border)
  {
    const auto options = np::vertex_is_constrained_map(m_is_held).tolerance(1e-14);
    measure("circle to 1e-14", border, options);
    const Places map = places();
    put(border);
    SMP::Parameterization_summary summary;
    const double seconds = seconds_of([&] {
      check(SMP::parameterize(m_mesh, Method<Mesh>(options.summary(std::ref(summary))), outer_border(m_mesh),
                              m_uvmap));
    });
    print("circle to 1e-14 flat", border, summary, seconds, relative_distance(map, places()));
  }

  template <class NamedParameters>
  void measure(const std::string& run, const Places& given, const NamedParameters& options)
  {
    put(given);
    SMP::Parameterization_summary summary;
    const double seconds =
        seconds_of([&] { summary = SMP::hierarchical_parameterization<Method>(m_mesh, m_uvmap, options); });
    print(run, given, summary, seconds, 0);
  }

  void print(const std::string& run, const Places& given, const SMP::Parameterization_summary& summary, double seconds,
             double distance_from_hierarchical) const
  {
    std::size_t held = 0, displaced = 0;
    for (const Mesh::Vertex_index v : m_mesh.vertices())
      if (m_is_held[v]) {
        ++held;
        displaced += m_uvmap[v] != given[v];
      }
    const auto flips = SMP::parameterization_quality(m_mesh, m_uvmap).flips;
    std::cout << m_names << run << ',' << held << ',' << displaced << ',' << flips << ','
              << (!summary.is_ok() ? SMP::error_message(summary.error) : summary.converged ? "ok" : "not converged")
              << ',' << (summary.levels.empty() ? 0 : summary.levels.back().iterations) << ',' << summary.energy << ','
              << seconds << ',' << distance_from_hierarchical << std::endl;
  }

  Mesh& m_mesh;
  std::string m_names;
  Uv_map m_uvmap;
  Held_map m_is_held;
};

void run(int argc, char* argv[])
{
  const po::variables_map values = parse(argc, argv, po::options_description("Options"), "given_places [MESH.off ...]");
  std::vector<Named_mesh> meshes = meshes_of(values);
  std::cout.precision(10);
  std::cout << "mesh,method,run,held,displaced,flips,status,steps,energy,seconds,distance" << std::endl;
  for (Named_mesh& input : meshes) {
    Measurement<SMP::MIPS_parameterizer_3>(input, "mips").run();
    Measurement<SMP::Symmetric_Dirichlet_parameterizer_3>(input, "symmetric-dirichlet").run();
  }
}

int main(int argc, char* argv[])
{
  return exit_status_of([&] { run(argc, argv); });
}
