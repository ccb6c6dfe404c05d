// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameterizes surfaces from the command line: see --help.

#include "File_place.h"
#include "Output_files.h"
#include "check_files.h"
#include "counted.h"
#include "errors.h"
#include "input.h"
#include "lay_out.h"
#include "name_for_input.h"
#include "one_line.h"
#include "options.h"
#include "report.h"
#include "write_file.h"
#include "write_map.h"

#include <CGAL/Real_timer.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace {

enum Exit_status { WRITTEN = 0, WRONG_USAGE = 1, BAD_INPUT = 2, METHOD_FAILED = 3 };

// All that is printed is one line.
void print_error(const std::string& name, const std::string& message)
{
  std::cerr << one_line(name + ": " + message) << '\n';
}

std::string atlas_text(const SMP::Atlas_summary& atlas)
{
  char text[128];
  std::snprintf(text, sizeof text, ", seams of length %.6g, %.2f of the square used, ", atlas.cut.seam_length,
                atlas.used_part);
  return counted(atlas.charts.size(), "chart") + text;
}

std::string replaced_maps_text(const Run_record& run)
{
  if (!run.atlas)
    return "the map";
  const std::vector<SMP::Atlas_summary::Chart>& charts = run.atlas->charts;
  const auto replaced = std::count_if(charts.begin(), charts.end(), [](const auto& chart) {
    return chart.summary.is_ok() && chart.summary.is_replaced;
  });
  return "the maps of " + std::to_string(replaced) + " of " + std::to_string(charts.size()) + " charts";
}

// What the repair of flips did; a map that another method made tells it by itself.
std::string repair_text(const SMP::Parameterization_summary& summary)
{
  return summary.moved_vertices == 0 || summary.is_replaced
             ? ""
             : counted(summary.flips, "flip") + " repaired by moving " +
                   counted(summary.moved_vertices, "vertex", "vertices") + ", ";
}

std::string pairs_text(std::size_t n) { return counted(n, "pair of triangles", "pairs of triangles"); }

// How many components the branches of the seam do not bring within the bound that the user gave.
std::size_t components_above_bound(const Options& options, const Run_record& run)
{
  if (!run.atlas || !options.distortion_bound)
    return 0;
  const std::vector<SMP::Cut_summary::Component>& components = run.atlas->cut.components;
  return std::size_t(std::count_if(components.begin(), components.end(), [&](const auto& component) {
    return component.distortion > *options.distortion_bound;
  }));
}

// Tells what the user may not expect of the map.
void print_warnings(const Input& input, const Options& options, const Run_record& run)
{
  constexpr double great_part = 0.1;
  const std::string name = one_line(input.name);
  if (!options.start.empty() && run.summary.levels.size() > 1)
    std::cerr << name << ": the method found no map from that of --start; this one starts from none\n";
  if (const std::size_t n = components_above_bound(options, run); n > 0)
    std::cerr << name << ": " << counted(n, "component")
              << " above --distortion-bound: more branches gain too little\n";
  else if (run.atlas && options.distortion_bound && run.quality->symmetric_dirichlet > *options.distortion_bound &&
           options.method->name != "symmetric-dirichlet")
    std::cerr << name << ": the maps of " << options.method->name
              << " exceed --distortion-bound; those of symmetric-dirichlet, for which the surface is cut, do so less\n";
  if (run.overlaps_of_one_chart > 0)
    std::cerr << name << ": one chart would lie over itself at " << pairs_text(run.overlaps_of_one_chart)
              << ", so this is an atlas; --globally-injective makes one chart, --cut none one with overlaps\n";
  if (run.summary.is_replaced)
    std::cerr << name << ": " << replaced_maps_text(run) << " of " << options.method->name
              << " had flips whose repair would have failed or cost much; "
              << (run.atlas ? "maps without flips took their place\n" : "a map without flips took its place\n");
  else if (run.summary.moved_vertices > 0) {
    const std::vector<bool> is_mapped = vertices_of_faces(input);
    const std::size_t vertices = std::size_t(std::count(is_mapped.begin(), is_mapped.end(), true));
    const std::size_t moved = (std::min)(run.summary.moved_vertices, vertices);      // others are in filled holes
    if (double(moved) > great_part * double(vertices))
      std::cerr << name << ": to repair the flips of " << options.method->name << ", " << moved << " of " << vertices
                << " vertices were moved: the map is hardly its own\n";
  }
}

// An atlas is cut where the least symmetric Dirichlet energy is great, which that of another method need not tell.
const char* advice_against_distortion(const Method& method)
{
  if (!method.has_free_border)
    return "--atlas may cut the surface, a method with a free border may distort it less";
  return method.name == "symmetric-dirichlet"
             ? "--atlas cuts the surface"
             : "--atlas may cut the surface, symmetric-dirichlet may distort it less";
}

// What may help where charts overlap themselves.
void print_advice_for_atlas(const Input& input, const Options& options, const Run_record& run)
{
  if (run.quality->overlaps > 0 && options.cuts && options.overlap_bound != 0.)
    std::cerr << one_line(input.name) << ": charts overlap themselves at " << pairs_text(run.quality->overlaps)
              << "; --overlap-bound 0 divides most of them, mips and symmetric-dirichlet keep borders apart\n";
}

// What may help where one chart is not enough.
void print_advice(const Input& input, const Options& options, const Run_record& run)
{
  constexpr double great_distortion = 50;
  constexpr std::size_t many_borders = 20;
  if (run.atlas)
    return print_advice_for_atlas(input, options, run);
  const std::string one_chart = options_of_one_chart(options),
                    without = one_chart.empty() ? "" : ", without " + one_chart + ",";
  if (run.quality->overlaps > 0 && (options.cuts || !one_chart.empty()))
    std::cerr << one_line(input.name) << ": the map lies over itself at " << pairs_text(run.quality->overlaps) << "; "
              << (options.method->is_flip_free ? "--globally-injective keeps borders apart"
                                               : "--overlap-bound 0" + without + " divides most of it")
              << '\n';
  if (!options.cuts)
    return;
  if (run.quality->symmetric_dirichlet > great_distortion && run.quality->flips == 0) {
    std::ostringstream energy;
    energy << std::setprecision(3) << run.quality->symmetric_dirichlet;
    std::cerr << one_line(input.name) << ": the map is distorted far (symmetric Dirichlet " << energy.str()
              << ", 4 without distortion); "
              << advice_against_distortion(*options.method) << '\n';
  }
  if (input.number_of_borders > many_borders && !options.fills_holes)
    std::cerr << one_line(input.name) << ": has " << input.number_of_borders
              << " borders; --fill-holes treats holes as parts of the surface, which is quicker\n";
}

void print_summary(const Input& input, const Options& options, const Run_record& run)
{
  const std::string name = one_line(input.name);
  if (input.number_of_components > 1 && !options.takes_all_components)
    std::cerr << name << ": has " << input.number_of_components << " components; the largest is parameterized\n";
  if (input.collapsed_faces > 0)
    std::cerr << name << ": "
              << counted(input.collapsed_faces, "face with less than three vertices was",
                         "faces with less than three vertices were")
              << " left out\n";
  if (input.number_of_pieces > 0)
    std::cerr << name << ": has " << input.number_of_pieces << " components whose borders "
              << (options.is_stitched
                      ? "still coincide with those of others: more than two at an edge, or of two orientations"
                      : "coincide with those of others; --stitch joins them")
              << (options.is_stitched && !options.is_oriented ? "; --orient turns or cuts such faces\n" : "\n");
  print_warnings(input, options, run);
  print_advice(input, options, run);
  const std::string levels =
      run.summary.levels.empty() || run.atlas ? "" : counted(run.summary.levels.size(), "level") + ", ";
  std::fprintf(is_standard_output_taken(options) ? stderr : stdout,
               "%s: %s, %s%s%s, MIPS %.6f (%.6f above its lower bound), symmetric Dirichlet %.5f, %s, %s, %.3f s\n",
               name.c_str(), counted(input.faces.size(), "triangle").c_str(),
               (run.atlas ? atlas_text(*run.atlas) : levels).c_str(), repair_text(run.summary).c_str(),
               run.summary.converged ? "converged" : "not converged", run.quality->mips, run.quality->mips_excess,
               run.quality->symmetric_dirichlet, counted(run.quality->flips, "flip").c_str(),
               counted(run.quality->overlaps, "overlapping pair").c_str(), run.seconds_of_map());
}

// What is printed may be buffered: whether it arrives is known at the end only.
void finish_standard_output()
{
  std::cout.flush();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) || !std::cout)
    throw std::runtime_error("the standard output cannot be written");
}

// Both files, or none.
void write_files(const Options& options, const std::string& file, Input& input)
{
  Output_files files;
  std::size_t spoilt_triangles = 0;
  if (!options.output.empty())
    spoilt_triangles = write_mesh(files, name_for_input(options.output, file), options.is_output_binary, input);
  if (!options.picture.empty())
    write_picture(files, name_for_input(options.picture, file), input);
  files.commit();
  if (spoilt_triangles > 0 && !options.quiet)
    std::cerr << one_line(input.name) << ": "
              << counted(spoilt_triangles, "triangle of the map has no area, there or in space, or is",
                         "triangles of the map have no area, there or in space, or are")
              << " turned over, in the floats of glTF; OBJ and PLY hold doubles\n";
}

void make_folder(const std::string& name)
{
  std::error_code error;
  std::filesystem::create_directories(name, error);
  if (error)
    throw std::runtime_error(name + ": cannot be written (" + error.message() + ')');
}

// Reads, parameterizes, checks and writes one input.
void run_input(const std::string& file, const Options& options, Input& input, Run_record& run)
{
  CGAL::Real_timer timer;
  timer.start();
  read_input(file, options, input);
  run.seconds_read = timer.time();

  if (!options.levels.empty())
    make_folder(options.levels);
  lay_out(input, options, run);

  const double seconds_before_writing = timer.time();
  try {
    write_files(options, file, input);
  } catch (...) {
    run.quality.reset();      // of no map that is there
    throw;
  }
  run.seconds_write = timer.time() - seconds_before_writing;
  if (!options.quiet)
    print_summary(input, options, run);
  check_complete(input, options, run);
}

// Runs one input; appends its line to the report.
Exit_status run(const std::string& file, const Options& options, std::string& report)
{
  Input input;
  input.name = file.empty() ? "face" : file;
  Run_record run;
  const auto fail = [&](Exit_status exit_status, const std::string& status, const std::string& message) {
    run.status = status;
    run.error = message;
    print_error(input.name, message);
    return exit_status;
  };

  Exit_status exit_status = WRITTEN;
  try {
    run_input(file, options, input, run);
  } catch (const Input_error& error) {
    exit_status = fail(BAD_INPUT, error.code ? error_name(*error.code) : "unreadable", error.message);
  } catch (const Method_error& error) {
    exit_status =
        fail(is_fault_of_method(error.code) ? METHOD_FAILED : BAD_INPUT, error_name(error.code), error.message);
  } catch (const CGAL::Failure_exception& error) {
    exit_status = fail(METHOD_FAILED, "failed",
                       "an assertion of CGAL failed: " + error.expression() + " in " + error.filename() + ", line " +
                           std::to_string(error.line_number()));
  } catch (const std::bad_alloc&) {
    exit_status = fail(METHOD_FAILED, "failed", "not enough memory");
  } catch (const std::exception& error) {
    exit_status = fail(METHOD_FAILED, "failed", error.what());
  }
  run.input = input.name;
  run.method = options.method->name;
  run.vertices = input.mesh.number_of_vertices();
  run.faces = input.mesh.number_of_faces();
  run.borders = input.number_of_borders;
  run.components = input.number_of_components;
  report += report_line(run);
  return exit_status;
}

} // namespace

int main(int argc, char** argv)
{
  // A failed assertion of CGAL is an exception, told in one line as every error, and its warnings are for those who
  // write methods; a file that may not grow further is a failed write, not the end.
  const auto be_silent = [](const char*, const char*, const char*, int, const char*) { };
  CGAL::set_error_handler(be_silent);
  CGAL::set_warning_handler(be_silent);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    Options options;
    if (!read_options(argc, argv, options)) {
      finish_standard_output();
      return WRITTEN;
    }
    check_files(options);
#ifdef CGAL_LINKED_WITH_TBB
    constexpr auto most_threads = tbb::global_control::max_allowed_parallelism;
    constexpr std::size_t enough_threads = 1024;      // TBB prepares as many as it is told
    const tbb::global_control limit(most_threads, options.threads > 0
                                                      ? (std::min)(std::size_t(options.threads), enough_threads)
                                                      : tbb::global_control::active_value(most_threads));
#endif
    const bool has_report = !options.report.empty(), prints_report = has_report && is_standard_output(options.report);
    std::string report;
    const auto write_report = [&] { write_file(options.report, [&](std::ostream& out) { out << report; }); };
    int status = WRITTEN;
    for (const std::string& input : options.inputs) {
      status = (std::max)(status, int(run(input, options, report)));
      if (prints_report) {      // a line at a time, for those who wait for it
        write_report();
        report.clear();
      }
    }
    if (has_report && !prints_report)
      write_report();
    finish_standard_output();
    return status;
  } catch (const Usage_error& error) {
    print_error("hierarchical_parameterization", error.message + "; see --help");
    return WRONG_USAGE;
  } catch (const std::exception& error) {
    print_error("hierarchical_parameterization", error.what());
    return METHOD_FAILED;
  }
}
