// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameterizes surfaces from the command line: see --help.

#include "program_file.h"
#include "program_input.h"
#include "program_methods.h"
#include "program_output.h"

#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_SVG.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>

#include <CGAL/Real_timer.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>
#include <CGAL/version.h>

#include <boost/program_options.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
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
  bool triangulate;
};

// Returns whether there is something to do: not after --help and --version.
bool read_options(int argc, char** argv, Options& options)
{
  namespace po = boost::program_options;
  std::string method, weights, flips;
  po::options_description described("Options");
  described.add_options()
    ("help,h", "print this text")
    ("version", "print the version")
    ("method", po::value(&method)->default_value("mips"), "one of those above")
    ("output", po::value(&options.output), "write the mesh with its map as OBJ, or as PLY with the vertex properties u and v")
    ("picture", po::value(&options.picture), "draw the map as SVG, colored by distortion")
    ("report", po::value(&options.report), "write figures as JSON, one line per input")
    ("levels", po::value(&options.levels), "write every level of the hierarchy as OBJ into this folder")
    ("triangulate", po::bool_switch(&options.triangulate), "cut faces of more than three corners into triangles")
    ("flat", po::bool_switch(&options.flat), "run the method without the hierarchy; those of CGAL as they are shipped")
    ("tolerance", po::value(&options.tolerance), "mips, symmetric-dirichlet, arap: converged when a step lowers the energy by less than this part of its excess over the minimum "
                                                 "(default 1e-6); others: when the relative residual is not greater (default 1e-8, of CGAL's 1e-10)")
    ("iterations", po::value(&options.iterations), "the most steps on a level: of Newton's method (default 200), or sweeps (default 10000); of CGAL's methods: the most steps of the linear solver (default 300)")
    ("weights", po::value(&weights), "of the triangles: triangle (all alike; default of mips) or area (in space; default of symmetric-dirichlet)")
    ("flips", po::value(&flips)->default_value("fail"), "of methods that can flip triangles: fail (an error), repair or keep")
    ("globally-injective", po::bool_switch(&options.is_globally_injective), "mips, symmetric-dirichlet: keep the free border from running over itself")
    ("fill-holes", po::bool_switch(&options.fills_holes), "close every border but the longest one by a virtual vertex, so that a hole is laid out as a part of the surface")
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
                 "Without INPUT: a built-in face of 1042 vertices. INPUT may be -, the standard input.\n\n"
                 "Examples:\n"
                 "  hierarchical_parameterization scan.ply --output scan.obj --picture map.svg\n"
                 "  hierarchical_parameterization --method symmetric-dirichlet --globally-injective scan.ply --output map.ply\n"
                 "  find charts -name '*.off' | xargs -P 8 -n 100 hierarchical_parameterization --quiet --threads 1\n\n"
                 "Methods:\n  "
              << list_of_methods("\n  ", [](const Program_method& m) { return m.name + ": " + m.description + (m.is_flip_free ? "; no triangle flips" : ""); }) << "\n\n" << described << "\n"
                 "Exit status: 0 maps written, 1 wrong usage, 2 an input cannot be read or is no surface to parameterize, 3 a method failed or a file cannot be written.\n";
    return false;
  }
  if (values.count("version")) {
    std::cout << "hierarchical_parameterization " PROGRAM_VERSION " with CGAL " << CGAL_STR(CGAL_VERSION) << '\n';
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
  if (std::find(options.inputs.begin(), options.inputs.end(), "") != options.inputs.end())
    throw Usage_error{ "the name of an input is empty" };
  if (options.inputs.empty())
    options.inputs.emplace_back();
  return true;
}

void print_summary(const Run_record& run)
{
  const Input& input = run.input;
  if (input.number_of_components > 1)
    std::cerr << input.name << ": has " << input.number_of_components << " components; the largest is parameterized\n";
  const std::string levels = run.summary.levels.empty() ? "" : std::to_string(run.summary.levels.size()) + " levels, ";
  std::printf("%s: %zu triangles, %s%s, MIPS %.6f (%.6f above its minimum), symmetric Dirichlet %.5f, %zu flips, %zu overlapping pairs, %.3f s\n",
              input.name.c_str(), input.faces.size(), levels.c_str(), run.summary.converged ? "converged" : "not converged",
              run.quality->mips, run.quality->mips_excess, run.quality->symmetric_dirichlet, run.quality->flips,
              run.quality->overlaps, run.summary.seconds_hierarchy + run.summary.seconds_parameterize);
}

// What a method, or its map, fails with.
struct Method_error { std::string message; SMP::Error_code code; };

void write_map(Run_record& run, const Options& options, UV_map uvmap)
{
  Input& input = run.input;
  if (!options.output.empty()) {
    auto is_parameterized = input.mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_parameterized", false).first;
    for (const Mesh::Face_index f : input.faces)
      for (const Mesh::Vertex_index v : input.mesh.vertices_around_face(input.mesh.halfedge(f)))
        is_parameterized[v] = true;
    write_file(options.output, [&](std::ostream& out) {
      if (has_suffix(options.output, ".ply"))
        write_PLY(out, input.mesh, uvmap);
      else
        SMP::IO::write_OBJ(out, input.mesh, uvmap, is_parameterized);
    });
  }
  if (!options.picture.empty())
    write_file(options.picture, [&](std::ostream& out) { SMP::IO::write_SVG(out, input.mesh, input.faces, uvmap); });
}

// Reads, parameterizes, checks and writes one input.
void run_input(const std::string& file, const Options& options, Run_record& run)
{
  CGAL::Real_timer timer;
  timer.start();
  Input& input = run.input;
  read_input(file, options.triangulate, input);
  run.seconds_read = timer.time();

  if (!options.levels.empty())
    std::filesystem::create_directories(options.levels);
  const UV_map uvmap = input.mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  run.summary = options.method->run(input, options, uvmap);
  if (run.summary.error.code == SMP::ERROR_NO_1_TO_1_MAPPING && run.summary.flips > 0)
    throw Method_error{ "the map has " + std::to_string(run.summary.flips) + " triangles flipped; --flips repair or keep", SMP::ERROR_NO_1_TO_1_MAPPING };
  if (run.summary.error.code != SMP::OK)
    throw Method_error{ SMP::error_message(run.summary.error), run.summary.error.code };
  const SMP::Parameterization_quality quality = SMP::parameterization_quality(input.mesh, input.faces, uvmap);
  if (quality.flips > 0 && options.method->is_flip_free)
    throw Method_error{ "no map without flips was found: " + std::to_string(quality.flips) + " triangles are not positive", SMP::ERROR_NO_1_TO_1_MAPPING };
  if (quality.overlaps > 0 && options.is_globally_injective)
    throw Method_error{ "no map without overlaps was found: " + std::to_string(quality.overlaps) + " pairs of triangles overlap", SMP::ERROR_NO_1_TO_1_MAPPING };

  const double seconds_before_writing = timer.time();
  write_map(run, options, uvmap);
  run.seconds_write = timer.time() - seconds_before_writing;
  run.quality = quality;
  run.status = run.summary.converged ? "ok" : "not_converged";
}

// Runs one input; appends its line to the report.
Exit_status run(const std::string& file, const Options& options, std::string& report)
{
  Run_record run;
  run.input.name = file.empty() ? "face" : file;
  const auto fail = [&](Exit_status exit_status, const std::string& status, const std::string& message) {
    run.status = status;
    run.error = message;
    std::cerr << run.input.name << ": " << message << '\n';
    return exit_status;
  };

  Exit_status exit_status = WRITTEN;
  try {
    run_input(file, options, run);
    if (!options.quiet)
      print_summary(run);
  } catch (const Input_error& error) {
    exit_status = fail(BAD_INPUT, error.code == SMP::OK ? "unreadable" : error_name(error.code), error.message);
  } catch (const Method_error& error) {
    const bool is_input_good = error.code == SMP::ERROR_NO_1_TO_1_MAPPING || error.code == SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM
                               || error.code == SMP::ERROR_NON_CONVEX_BORDER;
    exit_status = fail(is_input_good ? METHOD_FAILED : BAD_INPUT, error_name(error.code), error.message);
  } catch (const CGAL::Failure_exception& error) {
    exit_status = fail(METHOD_FAILED, "failed", "an assertion of CGAL failed: " + error.expression() + " in " + error.filename() + ", line " + std::to_string(error.line_number()));
  } catch (const std::bad_alloc&) {
    exit_status = fail(METHOD_FAILED, "failed", "not enough memory");
  } catch (const std::exception& error) {
    exit_status = fail(METHOD_FAILED, "failed", error.what());
  }
  report += make_report(run, options.method->name).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
  return exit_status;
}

} // namespace

int main(int argc, char** argv)
{
  // A failed assertion of CGAL is an exception, told in one line as every error; a file that may not grow further is a failed write, not the end.
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) { });
  std::signal(SIGXFSZ, SIG_IGN);
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
