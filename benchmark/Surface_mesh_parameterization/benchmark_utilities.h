// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_UTILITIES_H
#define BENCHMARK_UTILITIES_H

#include "../../examples/Surface_mesh_parameterization/face_mesh.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/subdivision_method_3.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace po = boost::program_options;

typedef CGAL::Simple_cartesian<double>                         Kernel;
typedef Kernel::Point_2                                        Point_2;
typedef Kernel::Point_3                                        Point_3;
typedef CGAL::Surface_mesh<Point_3>                            Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, Point_2>        Uv_map;
typedef std::vector<Point_2>                                   Places;       // in the plane, one for each vertex
typedef SMP::MIPS_parameterizer_3<Mesh>                        MIPS;
typedef SMP::Hierarchical_parameterizer_3<MIPS>                Hierarchical_MIPS;

// The command line is wrong: exit status 1. Any other exception: 2.
struct Usage_error : std::runtime_error { using std::runtime_error::runtime_error; };

// Runs a program; what it throws becomes one line and the exit status.
template <class Program>
int exit_status_of(const Program& program)
{
  try {
    program();
    return 0;
  } catch (const Usage_error& error) {
    std::cerr << error.what() << '\n';
    return 1;
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 2;
  }
}

// Reads the command line; names without an option are values of `mesh`.
inline po::variables_map parse(int argc, char* argv[], po::options_description options, const std::string& usage)
{
  options.add_options()("help,h", "show this text");
  po::options_description all_options = options;
  all_options.add_options()("mesh", po::value<std::vector<std::string>>()->default_value({}, ""));
  po::positional_options_description positional;
  positional.add("mesh", -1);
  po::variables_map values;
  try {
    po::store(po::command_line_parser(argc, argv).options(all_options).positional(positional).run(), values);
    po::notify(values);
  } catch (const po::error& error) {
    throw Usage_error(std::string(error.what()) + "; usage: " + usage);
  }
  if (values.count("help")) {
    std::cout << "usage: " << usage << '\n' << options;
    std::exit(0);
  }
  return values;
}

// `value` if it is in the range that its option allows.
inline std::size_t checked_count(const std::string& option, int value, int least, int most)
{
  if (value < least || value > most)
    throw Usage_error("--" + option + " must lie between " + std::to_string(least) + " and " + std::to_string(most));
  return std::size_t(value);
}

inline std::size_t count_of(const po::variables_map& values, const std::string& option, int least, int most)
{
  return checked_count(option, values[option].as<int>(), least, most);
}

inline std::vector<std::size_t> counts_of(const po::variables_map& values, const std::string& option, int least,
                                          int most)
{
  std::vector<std::size_t> counts;
  for (const int value : values[option].as<std::vector<int>>())
    counts.push_back(checked_count(option, value, least, most));
  return counts;
}

inline double positive_number_of(const po::variables_map& values, const std::string& option)
{
  const double value = values[option].as<double>();
  if (!(value > 0 && std::isfinite(value)))
    throw Usage_error("--" + option + " must be positive and finite");
  return value;
}

// A part of a whole.
inline double part_of(const po::variables_map& values, const std::string& option)
{
  const double value = values[option].as<double>();
  if (!(value >= 0 && value <= 1))
    throw Usage_error("--" + option + " must lie between 0 and 1");
  return value;
}

// `--subdivide`, for a program that measures the mesh once.
inline void add_subdivide_option(po::options_description& options)
{
  options.add_options()("subdivide", po::value<int>()->default_value(0), "Loop subdivisions of the mesh");
}

// The same for a program that measures the mesh and all its subdivisions.
inline void add_subdivide_option(po::options_description& options, int default_subdivisions)
{
  options.add_options()("subdivide", po::value<int>()->default_value(default_subdivisions),
                        "measure after 0, 1, ... so many Loop subdivisions");
}

inline std::size_t subdivisions_of(const po::variables_map& values) { return count_of(values, "subdivide", 0, 12); }

inline bool contains(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The names that an option was given; all that it knows if it was given none.
inline std::vector<std::string> names_of(const po::variables_map& values, const std::string& option,
                                         const std::vector<std::string>& known)
{
  const std::vector<std::string> names = values[option].as<std::vector<std::string>>();
  for (const std::string& name : names)
    if (!contains(known, name))
      throw Usage_error("--" + option + " must be one of " + boost::algorithm::join(known, ", "));
  return names.empty() ? known : names;
}

inline Mesh read_mesh(const std::string& file_name)
{
  Mesh mesh;
  if (!CGAL::IO::read_OFF(file_name, mesh))
    throw std::runtime_error(file_name + ": cannot be read as a mesh in OFF");
  return mesh;
}

inline Mesh built_in_face()
{
  Mesh mesh;
  make_face(mesh);
  return mesh;
}

// Leaves no removed elements.
inline void subdivide(Mesh& mesh, std::size_t times)
{
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(unsigned(times)));
  mesh.collect_garbage();
}

// Calls `measure(k)` when the mesh has k = 0, 1, ..., `subdivisions` Loop subdivisions.
template <class Measure>
void for_each_subdivision(Mesh& mesh, std::size_t subdivisions, const Measure& measure)
{
  for (std::size_t k = 0; k <= subdivisions; ++k) {
    if (k > 0)
      subdivide(mesh, 1);
    measure(k);
  }
}

inline Mesh::Halfedge_index outer_border(const Mesh& mesh)
{
  const Mesh::Halfedge_index border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  if (border == Mesh::null_halfedge())
    throw std::runtime_error("the mesh has no border");
  return border;
}

inline void check(const SMP::Parameterization_error& error)
{
  if (error.code != SMP::OK)
    throw std::runtime_error(SMP::error_message(error));
}

inline void check(SMP::Error_code code)
{
  check(SMP::Parameterization_error{ code });
}

// A mesh and what to call it in a table.
struct Named_mesh
{
  std::string name;
  Mesh mesh;
};

// The meshes of a command line; the built-in face if there is none. Throws if parameterizers do not take one of them.
inline std::vector<Named_mesh> meshes_of(const po::variables_map& values)
{
  std::vector<Named_mesh> meshes;
  for (const std::string& file : values["mesh"].as<std::vector<std::string>>())
    meshes.push_back({ file, read_mesh(file) });
  if (meshes.empty())
    meshes.push_back({ "built-in face", built_in_face() });
  for (const Named_mesh& input : meshes)
    check(SMP::Mesh_component<Mesh>(input.mesh, outer_border(input.mesh)).error());
  return meshes;
}

// The mesh of a command line that takes one.
inline Named_mesh only_mesh(const po::variables_map& values)
{
  if (values["mesh"].as<std::vector<std::string>>().size() > 1)
    throw Usage_error("more than one mesh");
  return meshes_of(values).front();
}

inline Uv_map add_uv_map(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
}

// The map of any mesh, in doubles.
template <class TriangleMesh, class VertexUVMap>
Places places_of(const TriangleMesh& mesh, const VertexUVMap& uvmap)
{
  Places places;
  for (const auto v : vertices(mesh)) {
    const auto& p = get(uvmap, v);
    places.emplace_back(p.x(), p.y());
  }
  return places;
}

inline CGAL::Bbox_2 box_of(const Places& places)
{
  CGAL::Bbox_2 box;
  for (const Point_2& p : places)
    box += p.bbox();
  return box;
}

inline double diagonal_of(const CGAL::Bbox_2& box)
{
  return std::hypot(box.x_span(), box.y_span());
}

// The greatest distance between the places of a vertex in two maps.
inline double greatest_distance(const Places& map, const Places& other)
{
  double greatest = 0;
  for (std::size_t v = 0; v < map.size(); ++v)
    greatest = (std::max)(greatest, CGAL::squared_distance(map[v], other[v]));
  return std::sqrt(greatest);
}

// The same relative to the diagonal of the first map.
inline double relative_distance(const Places& map, const Places& other)
{
  return greatest_distance(map, other) / diagonal_of(box_of(map));
}

template <class Parameterizer>
void parameterize(Mesh& mesh, const Parameterizer& parameterizer)
{
  check(SMP::parameterize(mesh, parameterizer, outer_border(mesh), add_uv_map(mesh)));
}

// The paper's number of local steps, 700 000 on 1042 vertices, for a mesh of any size; its 350 000 on 476 vertices are
// 9 % more per vertex.
inline std::size_t paper_steps(const Mesh& mesh)
{
  return std::size_t(700000. / 1042 * double(mesh.number_of_vertices()) + 0.5);
}

inline std::size_t vertex_visits(const SMP::Parameterization_summary& summary)
{
  std::size_t visits = 0;
  for (const SMP::Level_summary& level : summary.levels)
    visits += level.vertex_visits;
  return visits;
}

template <class Function>
double seconds_of(const Function& function)
{
  CGAL::Real_timer timer;
  timer.start();
  function();
  return timer.time();
}

inline double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

#endif // BENCHMARK_UTILITIES_H
