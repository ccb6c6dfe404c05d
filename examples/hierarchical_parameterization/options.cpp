// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line.

#include "options.h"

#include "errors.h"
#include "has_suffix.h"
#include "name_for_input.h"

#include <CGAL/version.h>

#include <boost/any.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace po = boost::program_options;

// What is chosen by words.
struct Words
{
  std::string method, weights, flips, components, cut;
};

// Numbers as the command line has them: read as unsigned ones, -1 would be a huge one.
struct Numbers
{
  long long iterations = 0, seed = 0;
};

// A number that an atlas is made with.
struct Atlas_number
{
  std::string name;
  std::optional<double> Method_options::*value;
  double least, greatest;
  std::string expected;
};

const std::vector<Atlas_number>& numbers_of_atlas()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  static const std::vector<Atlas_number> numbers = {
    { "least-used-part", &Method_options::least_used_part, 0, 1, "a number from 0 to 1" },
    { "distortion-bound", &Method_options::distortion_bound, 4, infinity, "a number of at least 4" },
    { "overlap-bound", &Method_options::overlap_bound, 0, 1, "a number from 0 to 1" },
    { "hole-bound", &Method_options::hole_bound, 0, 1, "a number from 0 to 1" },
    { "sharp-angle", &Method_options::sharp_angle, 0, 180, "a number of degrees from 0 to 180" } };
  return numbers;
}

// One text of what `describe(method)` returns, for all of them.
template <class Describe>
std::string list_of_methods(const std::string& separator, const Describe& describe)
{
  std::string list;
  for (const Method& method : methods())
    list += (list.empty() ? "" : separator) + describe(method);
  return list;
}

// Texts for --help, and where the values go.
po::options_description describe_options(Options& options, Words& words, Numbers& numbers)
{
  po::options_description described("Options");
  auto add = described.add_options();
  add("help,h", "print this text");
  add("version", "print the version");
  add("method", po::value(&words.method)->default_value("mips"), "one of those above");
  add("output", po::value(&options.output),
      "write the mesh with its map as OBJ, PLY or binary glTF (.glb); as OBJ if the name has no ending. PLY has the "
      "vertex properties u and v, or the list texcoord of each face if corners of a vertex may have several places");
  add("binary", po::bool_switch(&options.is_output_binary),
      "write PLY in binary: two fifths shorter, in a third of the time. Then texcoord is a list of doubles");
  add("components", po::value(&words.components),
      "all (default): lay out every component, and pack the charts into the unit square; or largest: the one with the "
      "most faces. The default is largest with --flat, --levels, --start and --hold, which take one chart");
  add("cut", po::value(&words.cut),
      "auto (default): cut components that are closed or have handles along short seams; or none: leave them out, and "
      "let one chart lie over itself. The default is none with --flat, --levels, --start and --hold");
  add("least-used-part", po::value<double>(),
      "divide charts by short cuts until they cover this part of the unit square, from 0 to 1, or no cut helps; 0.7 is "
      "within reach of most surfaces; 0: none. The default is 0.25. Makes an atlas of one component, too");
  add("distortion-bound", po::value<double>(),
      "cut surfaces until there are maps of them whose mean symmetric Dirichlet energy, 4 without distortion, is "
      "within this bound, as far as 50 branches of the seam lead; inf: only what must be cut. The default is 4.5 for "
      "surfaces that must be cut or exceed 8. Makes an atlas of one component, too");
  add("overlap-bound", po::value<double>(),
      "divide charts whose map would lie over itself with more than this part of its triangles, from 0 to 1; 1: none. "
      "The default is 0.2. Makes an atlas of one component, too");
  add("hole-bound", po::value<double>(),
      "in an atlas, treat holes as parts of the surface whose border is no longer than this part, from 0 to 1, of the "
      "square root of their component's area; 0: none. The default is 0.1. Makes an atlas of one component, too");
  add("sharp-angle", po::value<double>(),
      "part the surface into regions along edges at which it turns by at least this angle, from 0 to 180 degrees: 40, "
      "for instance, parts the faces of a mechanical model, most of which have maps without distortion. Each region "
      "has the distortion bound 4.5 unless another one is given. Makes an atlas of one component, too");
  add("atlas", po::bool_switch(&options.makes_atlas),
      "make an atlas of one component, too: its chart or charts in the unit square");
  add("stitch", po::bool_switch(&options.is_stitched),
      "join borders whose points coincide, as where every face has points of its own. Of points that are joined, the "
      "first one stays; the numbers of those behind it change, also for --hold and --start, which count those of the "
      "output");
  add("start", po::value(&options.start),
      "mips, symmetric-dirichlet, arap: start from the map that this file has for the vertices of INPUT: PLY with u "
      "and v, or OBJ, as --output writes them for one chart");
  add("hold", po::value(&options.hold),
      "mips, symmetric-dirichlet, arap: hold vertices at the places that this file has: lines of a vertex, counted "
      "from 0, and its two coordinates; lines that are empty or begin with # are none");
  add("picture", po::value(&options.picture), "draw the map as SVG, colored by distortion");
  add("report", po::value(&options.report), "write figures as JSON, one line per input");
  add("levels", po::value(&options.levels),
      "write every level of the hierarchy as OBJ into this folder: level_00.obj, the coarsest one, and so on, with "
      "maps before the repair of flips. Files of an earlier run that had more levels stay there");
  add("triangulate", po::bool_switch(&options.is_triangulated), "cut faces of more than three corners into triangles");
  add("orient", po::bool_switch(&options.is_oriented),
      "turn faces so that neighbors, which share points, have one orientation. Where that cannot be, where more than "
      "two faces meet at an edge or several fans at a vertex, the surface is cut: points are there several times then, "
      "the new ones behind those of the input. Triangles that have a vertex twice are left out");
  add("flat", po::bool_switch(&options.flat),
      "run the method without the hierarchy; those of CGAL as they are shipped. --tolerance and --iterations are for "
      "mips and symmetric-dirichlet then: a direct solver, or CGAL, takes neither");
  add("tolerance", po::value(&options.tolerance),
      "mips, symmetric-dirichlet, arap: converged when a step lowers the energy by less than this part of its excess "
      "over the minimum (default 1e-6); others: when the relative residual is not greater (default 1e-8, of CGAL's "
      "1e-10)");
  add("iterations", po::value(&numbers.iterations),
      "mips, symmetric-dirichlet, arap: the most steps of Newton's method on a level (default 200; 0: vertices are "
      "only relaxed one by one); others: of the linear solver, before a direct one takes over (default 300; 0: at "
      "once)");
  add("weights", po::value(&words.weights),
      "mips, symmetric-dirichlet: of the triangles: triangle (all alike; default of mips) or area (in space; default "
      "of symmetric-dirichlet)");
  add("flips", po::value(&words.flips)->default_value("repair"),
      "not for mips and symmetric-dirichlet, which flip no triangle: repair (default), fail (an error) or keep");
  add("globally-injective", po::bool_switch(&options.is_globally_injective),
      "mips, symmetric-dirichlet: keep the free border from running over itself, whatever that costs. By default a "
      "chart for which it costs much becomes an atlas instead; with --cut none, --flat, --levels, --start and --hold "
      "borders are kept apart by this option only");
  add("fill-holes", po::bool_switch(&options.fills_holes),
      "close every border but the longest one by a virtual vertex, so that a hole is laid out as a part of the "
      "surface");
  add("seed", po::value(&numbers.seed)->default_value(0),
      "of the random choices: the same seed gives the same result");
  add("threads", po::value(&options.threads)->default_value(0),
      "the most threads to use, if built with TBB; 0: as many as there are. The result is the same");
  add("quiet", po::bool_switch(&options.quiet), "print errors only");
  return described;
}

void print_help(const po::options_description& described)
{
  std::cout << "Usage: hierarchical_parameterization [INPUT ...] [OPTION ...]\n\n"
               "Lays triangulated surfaces (OFF, OBJ, PLY or STL) in the plane, coarse to fine.\n"
               "One component that has a border and no handles becomes one chart. Anything else becomes an atlas: cut "
               "into charts, all at one scale, in the unit square. So does one chart that mips or symmetric-dirichlet "
               "would lay over itself, unless its borders can be kept apart with little distortion.\n"
               "Without INPUT: a built-in face of 1042 vertices. INPUT may be -, the standard input.\n"
               "The file of --output, --picture or --report may be -, the standard output; the summary goes to "
               "stderr then.\n"
               "In the names of --output and --picture, {.} stands for INPUT without its ending, and {/.} for the same "
               "without its folder.\n\n"
               "Examples:\n"
               "  hierarchical_parameterization scan.ply --output scan.obj --picture map.svg\n"
               "  hierarchical_parameterization --method symmetric-dirichlet statue.stl --output statue.glb\n"
               "  hierarchical_parameterization --method symmetric-dirichlet --globally-injective scan.ply --output "
               "map.ply\n"
               "  hierarchical_parameterization charts/*.off --output 'maps/{/.}.ply' --report maps/report.json\n"
               "  find charts -name '*.off' -print0 | xargs -0 -P 8 -n 100 hierarchical_parameterization --quiet "
               "--threads 1 --report -\n\n"
               "Methods:\n  "
            << list_of_methods("\n  ",
                               [](const Method& m) {
                                 return m.name + ": " + m.description + (m.is_flip_free ? "; no triangle flips" : "");
                               })
            << "\n\n"
            << described
            << "\n"
               "Exit status: 0 maps written, 1 wrong usage, 2 an input cannot be read or is no surface to "
               "parameterize, or a part of it was left out, 3 a method failed or a file cannot be written.\n";
}

void read_words(const Words& words, Options& options)
{
  options.method = find_method(words.method);
  if (!options.method)
    throw Usage_error{ "unknown method '" + words.method +
                       "'; there are: " + list_of_methods(", ", [](const Method& m) { return m.name; }) };
  if (!words.weights.empty() && words.weights != "triangle" && words.weights != "area")
    throw Usage_error{ "unknown weights '" + words.weights + "'; there are: triangle, area" };
  options.triangle_weight = words.weights.empty()     ? options.method->triangle_weight
                            : words.weights == "area" ? SMP::Triangle_weight::AREA
                                                      : SMP::Triangle_weight::ONE;
  if (words.flips != "fail" && words.flips != "repair" && words.flips != "keep")
    throw Usage_error{ "unknown way with flips '" + words.flips + "'; there are: repair, fail, keep" };
  options.flip_policy = words.flips == "fail"     ? SMP::Flip_policy::FAIL
                        : words.flips == "repair" ? SMP::Flip_policy::REPAIR
                                                  : SMP::Flip_policy::KEEP;
}

void read_numbers(const Numbers& numbers, Options& options)
{
  if (numbers.iterations < 0)
    throw Usage_error{ "the number of iterations must not be negative" };
  constexpr unsigned int greatest_seed = std::numeric_limits<unsigned int>::max();
  if (numbers.seed < 0 || numbers.seed > greatest_seed)
    throw Usage_error{ "the seed must be from 0 to " + std::to_string(greatest_seed) };
  options.iterations = std::size_t(numbers.iterations);
  options.seed = static_cast<unsigned int>(numbers.seed);
}

void read_atlas_numbers(const po::variables_map& values, Options& options)
{
  for (const Atlas_number& number : numbers_of_atlas())
    if (values.count(number.name)) {
      const double value = values[number.name].as<double>();
      if (!(value >= number.least && value <= number.greatest))
        throw Usage_error{ "--" + number.name + ": " + number.expected + " expected" };
      (options.*number.value).emplace(value);
    }
}

// A name or word that is empty, as of a variable that is not set, is not taken for one that was not given.
void check_texts(const po::variables_map& values)
{
  for (const auto& [option, value] : values)
    if (const auto* text = boost::any_cast<std::string>(&value.value())) {
      if (text->empty())
        throw Usage_error{ "--" + option + ": the value is empty" };
      if (text->compare(0, 2, "--") == 0)
        throw Usage_error{ "--" + option + ": the value is missing, or '" + *text + "' is to be './" + *text + "'" };
    }
}

// Options that the method would not look at.
void check_effects(const po::variables_map& values, const Options& options)
{
  const bool is_flip_free = options.method->is_flip_free;
  if (is_flip_free && options.flip_policy != SMP::Flip_policy::REPAIR)
    throw Usage_error{ "--flips: " + options.method->name + " flips no triangle" };
  if (!is_flip_free && values.count("weights"))
    throw Usage_error{ "--weights: " + options.method->name + " has no choice of the weights of triangles" };
  for (const std::string option : { "tolerance", "iterations" })
    if (options.flat && !is_flip_free && values.count(option))
      throw Usage_error{ "--" + option + ": not with --flat, where " + options.method->name + " does not use it" };
}

// The option that asks for an atlas; empty if none does.
std::string option_of_atlas(const std::string& components, const std::string& cut, const Options& options)
{
  if (components == "all")
    return "--components all";
  if (cut == "auto")
    return "--cut auto";
  for (const Atlas_number& number : numbers_of_atlas())
    if (options.*number.value)
      return "--" + number.name;
  return options.makes_atlas ? "--atlas" : "";
}

// Fits the options of an atlas to one whose charts stay whole.
void forbid_cuts(Options& options)
{
  if (options.least_used_part.value_or(0) > 0 || options.distortion_bound || options.overlap_bound ||
      options.sharp_angle)
    throw Usage_error{ "--least-used-part, --distortion-bound, --overlap-bound, --sharp-angle: not with --cut none" };
  options.least_used_part = 0;
  options.distortion_bound = std::numeric_limits<double>::infinity();
  options.overlap_bound = 1;
}

// Which part of a mesh is laid out, and whether it may be cut: what the command line says, or the defaults.
void read_part(const std::string& components, const std::string& cut, Options& options)
{
  constexpr double bound_of_regions = 4.5;      // between sharp edges, rings, too, as the side of a cylinder
  if (!components.empty() && components != "all" && components != "largest")
    throw Usage_error{ "unknown components '" + components + "'; there are: all, largest" };
  if (!cut.empty() && cut != "auto" && cut != "none")
    throw Usage_error{ "unknown way to cut '" + cut + "'; there are: auto, none" };
  const std::string atlas = option_of_atlas(components, cut, options), one_chart = options_of_one_chart(options);
  if (!one_chart.empty() && !atlas.empty())
    throw Usage_error{ atlas + ": not with " + one_chart + ", for which there is one chart" };
  options.takes_all_components = components.empty() ? one_chart.empty() : components == "all";
  options.cuts = cut.empty() ? one_chart.empty() : cut == "auto";
  for (const Atlas_number& number : numbers_of_atlas())
    options.makes_atlas = options.makes_atlas || options.*number.value;
  options.avoids_overlaps = options.cuts && options.method->is_flip_free;
  if (!options.cuts)
    forbid_cuts(options);
  else if (options.sharp_angle && !options.distortion_bound)
    options.distortion_bound = bound_of_regions;
}

void check_several_inputs(const Options& options)
{
  if (options.inputs.size() < 2)
    return;
  if (!options.start.empty() || !options.hold.empty() || !options.levels.empty())
    throw Usage_error{ "--start, --hold and --levels take one input" };
  const std::pair<std::string, std::string> outputs[] = { { "--output", options.output },
                                                          { "--picture", options.picture } };
  for (const auto& [option, name] : outputs)
    if (!name.empty() && !depends_on_input(name))
      throw Usage_error{ option + ": the files of several inputs need names of their own, as by '{.}.uv.obj' or "
                         "'maps/{/.}.obj'" };
}

// Outputs that are one file or folder, whatever the inputs are.
void check_single_names(const Options& options)
{
  const std::pair<std::string, std::string> names[] = { { "--report", options.report },
                                                        { "--levels", options.levels } };
  for (const auto& [option, name] : names)
    if (depends_on_input(name))
      throw Usage_error{ option + ": {.} and {/.} are for --output and --picture" };
}

// What does not go together.
void check_options(const Options& options)
{
  if (options.is_output_binary && !has_suffix(options.output, ".ply"))
    throw Usage_error{ "--binary: only an --output whose name ends in .ply can be binary" };
  if (!(options.tolerance >= 0))
    throw Usage_error{ "--tolerance: a number that is not negative expected" };
  if (options.is_globally_injective && !options.method->is_flip_free)
    throw Usage_error{ "--globally-injective: " + options.method->name + " does not promise maps without flips" };
  const std::pair<const char*, std::string> places[] = { { "--start", options.start }, { "--hold", options.hold } };
  for (const auto& [option, file] : places) {
    if (!file.empty() && !options.method->improves_map)
      throw Usage_error{ option + std::string(": ") + options.method->name + " does not improve a map" };
    if (file == "-")
      throw Usage_error{ option + std::string(": a file is needed, not the standard input") };
    if (!file.empty() && options.flat)
      throw Usage_error{ option + std::string(": not with --flat") };
  }
  if (!options.start.empty() && !options.levels.empty())
    throw Usage_error{ "--start: the levels below the finest, which --levels writes, have no maps then" };
  if (options.flat && options.fills_holes && options.method->run_shipped)
    throw Usage_error{ "--fill-holes: not with --flat, which runs " + options.method->name + " as CGAL ships it" };
  if (options.threads < 0)
    throw Usage_error{ "the number of threads must not be negative" };
  if (!options.levels.empty() && options.flat)
    throw Usage_error{ "--levels: not with --flat, which makes no levels" };
  if (!options.levels.empty() && !options.method->has_levels)
    throw Usage_error{ "--levels: " + options.method->name + " parameterizes the finest level only" };
  check_several_inputs(options);
  check_single_names(options);
  if (std::find(options.inputs.begin(), options.inputs.end(), "") != options.inputs.end())
    throw Usage_error{ "the name of an input is empty" };
}

} // namespace

std::string options_of_one_chart(const Options& options)
{
  const std::pair<const char*, bool> all[] = { { "--flat", options.flat },
                                               { "--levels", !options.levels.empty() },
                                               { "--start", !options.start.empty() },
                                               { "--hold", !options.hold.empty() } };
  std::string result;
  for (const auto& [option, is_given] : all)
    if (is_given)
      result += (result.empty() ? "" : " and ") + std::string(option);
  return result;
}

bool read_options(int argc, char** argv, Options& options)
{
  Words words;
  Numbers numbers;
  const po::options_description described = describe_options(options, words, numbers);
  po::options_description all;
  all.add(described).add_options()("input", po::value(&options.inputs));
  po::variables_map values;
  try {
    po::store(po::command_line_parser(argc, argv)
                  .options(all)
                  .positional(po::positional_options_description().add("input", -1))
                  .run(),
              values);
    po::notify(values);
  } catch (const po::error& error) {
    throw Usage_error{ error.what() };
  }
  if (values.count("help")) {
    print_help(described);
    return false;
  }
  if (values.count("version")) {
    std::cout << "hierarchical_parameterization " PROGRAM_VERSION " with CGAL " << CGAL_STR(CGAL_VERSION) << '\n';
    return false;
  }
  check_texts(values);
  read_words(words, options);
  read_numbers(numbers, options);
  check_effects(values, options);
  if (!values.count("tolerance"))
    options.tolerance = options.method->tolerance;
  if (!values.count("iterations"))
    options.iterations = options.method->iterations;
  read_atlas_numbers(values, options);
  read_part(words.components, words.cut, options);
  check_options(options);
  if (options.inputs.empty())
    options.inputs.emplace_back();
  return true;
}
