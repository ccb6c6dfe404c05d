// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameterizes surfaces from the command line: see --help.

#include "program_input.h"
#include "program_methods.h"
#include "program_output.h"

#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_SVG.h>

#include <CGAL/Real_timer.h>

#include <boost/program_options.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

enum Exit_status { WRITTEN = 0, WRONG_USAGE = 1, BAD_INPUT = 2, METHOD_FAILED = 3 };

struct Options : Method_options
{
  std::vector<std::string> inputs;
  const Program_method* method;
  std::string output, picture, report;
  int threads;
};

struct Usage_error { std::string message; };

// Returns whether there is something to do: not after --help.
bool read_options(int argc, char** argv, Options& options)
{
  namespace po = boost::program_options;
  std::string method, weights, flips;
  po::options_description described("Options");
  described.add_options()
    ("help,h", "print this text")
    ("method", po::value(&method)->default_value("mips"), "one of those above")
    ("output", po::value(&options.output), "write the mesh with its map as OBJ")
    ("picture", po::value(&options.picture), "draw the map as SVG, colored by distortion")
    ("report", po::value(&options.report), "write figures as JSON, one line per input")
    ("levels", po::value(&options.levels), "write every level of the hierarchy as OBJ into this folder")
    ("flat", po::bool_switch(&options.flat), "run the method without the hierarchy; those of CGAL as they are shipped")
    ("tolerance", po::value(&options.tolerance), "mips, symmetric-dirichlet, arap: converged when a step lowers the energy by less than this part of its excess over the minimum "
                                                 "(default 1e-6); others: when the relative residual is not greater (default 1e-8, of CGAL's 1e-10)")
    ("iterations", po::value(&options.iterations), "the most steps on a level: of Newton's method (default 100), or sweeps (default 10000); of CGAL's methods: the most steps of the linear solver (default 300)")
    ("weights", po::value(&weights), "of the triangles: triangle (all alike; default of mips) or area (in space; default of symmetric-dirichlet)")
    ("flips", po::value(&flips)->default_value("fail"), "of methods that can flip triangles: fail (an error), repair or keep")
    ("globally-injective", po::bool_switch(&options.is_globally_injective), "mips, symmetric-dirichlet: keep the free border from running over itself")
    ("seed", po::value(&options.seed)->default_value(0), "of the random choices: the same seed gives the same result")
    ("threads", po::value(&options.threads)->default_value(0), "the most threads to use, if built with TBB; 0: as many as there are. The result is the same")
    ("quiet", po::bool_switch(&options.quiet), "print errors only");
  po::options_description all;
  all.add(described).add_options()("input", po::value(&options.inputs));
  po::variables_map values;
  try {
    po::store(po::command_line_parser(argc, argv).options(all).positional(po::positional_options_description().add("input", -1)).run(), values);
    po::notify(values);
  } catch (const po::error& error) {
    throw Usage_error{ error.what() };
  }
  if (values.count("help")) {
    std::cout << "Usage: hierarchical_parameterization [INPUT ...] [OPTION ...]\n\n"
                 "Lays triangulated surfaces (OFF, OBJ, PLY or STL) in the plane, coarse to fine.\n"
                 "Without INPUT: a built-in face of 1042 vertices.\n\nMethods:\n  "
              << list_of_methods("\n  ", [](const Program_method& m) { return m.name + ": " + m.description + (m.is_flip_free ? "; no triangle flips" : ""); }) << "\n\n" << described << "\n"
                 "Exit status: 0 maps written, 1 wrong usage, 2 an input is no surface to parameterize, 3 a method failed.\n";
    return false;
  }
  options.method = find_method(method);
  if (!options.method)
    throw Usage_error{ "unknown method '" + method + "'; there are: " + list_of_methods(", ", [](const Program_method& m) { return m.name; }) };
  if (!weights.empty() && weights != "triangle" && weights != "area")
    throw Usage_error{ "unknown weights '" + weights + "'; there are: triangle, area" };
  options.triangle_weight = weights.empty() ? options.method->triangle_weight : weights == "area" ? SMP::Triangle_weight::AREA : SMP::Triangle_weight::ONE;
  if (flips != "fail" && flips != "repair" && flips != "keep")
    throw Usage_error{ "unknown way with flips '" + flips + "'; there are: fail, repair, keep" };
  options.flip_policy = flips == "fail" ? SMP::Flip_policy::FAIL : flips == "repair" ? SMP::Flip_policy::REPAIR : SMP::Flip_policy::KEEP;
  if (!values.count("tolerance"))
    options.tolerance = options.method->tolerance;
  if (!values.count("iterations"))
    options.iterations = options.method->iterations;
  if (!(options.tolerance >= 0))
    throw Usage_error{ "the tolerance must not be negative" };
  if (options.is_globally_injective && !options.method->is_flip_free)
    throw Usage_error{ "--globally-injective: " + method + " does not promise maps without flips" };
  if (options.threads < 0)
    throw Usage_error{ "the number of threads must not be negative" };
  if (!options.levels.empty() && !options.method->has_levels)
    throw Usage_error{ "--levels: " + method + " parameterizes the finest level only" };
  if (options.inputs.size() > 1 && !(options.output.empty() && options.picture.empty() && options.levels.empty()))
    throw Usage_error{ "--output, --picture and --levels take one input" };
  if (options.inputs.empty())
    options.inputs.emplace_back();
  return true;
}

void print_summary(const Input& input, const SMP::Parameterization_summary& summary, const SMP::Parameterization_quality& quality)
{
  if (input.number_of_components > 1)
    std::cout << input.name << ": has " << input.number_of_components << " components; the largest is parameterized\n";
  const std::string levels = summary.levels.empty() ? "" : std::to_string(summary.levels.size()) + " levels, ";
  std::printf("%s: %zu triangles, %s%s, MIPS %.6f (%.6f above its minimum), symmetric Dirichlet %.5f, %zu flips, %zu overlapping pairs, %.3f s\n",
              input.name.c_str(), input.faces.size(), levels.c_str(), summary.converged ? "converged" : "not converged",
              quality.mips, quality.mips_excess, quality.symmetric_dirichlet, quality.flips, quality.overlaps, summary.seconds_hierarchy + summary.seconds_parameterize);
}

// Reads, parameterizes, checks and writes one input; appends its line to the report.
Exit_status run(const std::string& file, const Options& options, std::string& report)
{
  CGAL::Real_timer timer;
  timer.start();
  Input input;
  try {
    input = read_input(file);
  } catch (const Input_error& error) {
    std::cerr << file << ": " << error.message << '\n';
    return BAD_INPUT;
  }
  const double seconds_read = timer.time();

  if (!options.levels.empty())
    std::filesystem::create_directories(options.levels);
  const UV_map uvmap = input.mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const SMP::Parameterization_summary summary = options.method->run(input, options, uvmap);
  if (summary.error.code != SMP::OK) {
    std::cerr << input.name << ": " << error_message(summary.error) << '\n';
    report += make_report(input, options.method->name, summary, seconds_read, 0, nullptr).dump() + '\n';
    return summary.error.code == SMP::ERROR_NO_1_TO_1_MAPPING || summary.error.code == SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM ? METHOD_FAILED : BAD_INPUT;
  }

  const SMP::Parameterization_quality quality = SMP::parameterization_quality(input.mesh, input.faces, uvmap);
  const double seconds_before_writing = timer.time();
  if (!options.output.empty()) {
    auto is_parameterized = input.mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_parameterized", false).first;
    for (const Mesh::Face_index f : input.faces)
      for (const Mesh::Vertex_index v : input.mesh.vertices_around_face(input.mesh.halfedge(f)))
        is_parameterized[v] = true;
    write_file(options.output, [&](std::ostream& out) { SMP::IO::write_OBJ(out, input.mesh, uvmap, is_parameterized); });
  }
  if (!options.picture.empty())
    write_file(options.picture, [&](std::ostream& out) { SMP::IO::write_SVG(out, input.mesh, input.faces, uvmap); });
  report += make_report(input, options.method->name, summary, seconds_read, timer.time() - seconds_before_writing, &quality).dump() + '\n';
  if (!options.quiet)
    print_summary(input, summary, quality);
  const bool is_promise_kept = (quality.flips == 0 || !options.method->is_flip_free) && (quality.overlaps == 0 || !options.is_globally_injective);
  return is_promise_kept ? WRITTEN : METHOD_FAILED;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    Options options;
    if (!read_options(argc, argv, options))
      return WRITTEN;
#ifdef CGAL_LINKED_WITH_TBB
    constexpr auto most_threads = tbb::global_control::max_allowed_parallelism;
    const tbb::global_control limit(most_threads, options.threads > 0 ? std::size_t(options.threads) : tbb::global_control::active_value(most_threads));
#endif
    std::string report;
    int status = WRITTEN;
    for (const std::string& input : options.inputs)
      status = (std::max)(status, int(run(input, options, report)));
    if (!options.report.empty())
      write_file(options.report, [&](std::ostream& out) { out << report; });
    return status;
  } catch (const Usage_error& error) {
    std::cerr << "hierarchical_parameterization: " << error.message << "; see --help\n";
    return WRONG_USAGE;
  } catch (const std::exception& error) {
    std::cerr << "hierarchical_parameterization: " << error.what() << '\n';
    return METHOD_FAILED;
  }
}
