// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line.

#include "options.h"

#include "describe_options.h"
#include "errors.h"
#include "has_suffix.h"
#include "name_for_input.h"

#include <CGAL/Surface_mesh_parameterization/Option_defaults.h>

#include <CGAL/version.h>

#include <boost/algorithm/string/join.hpp>
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
    { "sharp-angle", &Method_options::sharp_angle, 0, 180, "a number of degrees from 0 to 180" },
    { "margin", &Method_options::margin, 0, 0.1, "a number from 0 to 0.1" } };
  return numbers;
}

// The word of an option must be one of these.
void check_word(const std::string& option, const std::string& word, const std::vector<std::string>& words)
{
  if (std::find(words.begin(), words.end(), word) == words.end())
    throw Usage_error{ "--" + option + ": '" + word + "' is none of " + boost::algorithm::join(words, ", ") };
}

void check_words(const Words& words)
{
  std::vector<std::string> names_of_methods;
  for (const Method& method : methods())
    names_of_methods.push_back(method.name);
  check_word("method", words.method, names_of_methods);
  check_word("flips", words.flips, { "repair", "fail", "keep" });
  if (!words.weights.empty())
    check_word("weights", words.weights, { "triangle", "area" });
  if (!words.components.empty())
    check_word("components", words.components, { "all", "largest" });
  if (!words.cut.empty())
    check_word("cut", words.cut, { "auto", "none" });
}

void read_words(const Words& words, Options& options)
{
  check_words(words);
  options.method = find_method(words.method);
  options.triangle_weight = words.weights.empty()     ? options.method->triangle_weight
                            : words.weights == "area" ? SMP::Triangle_weight::AREA
                                                      : SMP::Triangle_weight::ONE;
  options.flip_policy = words.flips == "fail"     ? SMP::Flip_policy::FAIL
                        : words.flips == "repair" ? SMP::Flip_policy::REPAIR
                                                  : SMP::Flip_policy::KEEP;
}

void read_numbers(const Numbers& numbers, Options& options)
{
  if (numbers.iterations < 0)
    throw Usage_error{ "--iterations: a number that is not negative expected" };
  constexpr unsigned int greatest_seed = std::numeric_limits<unsigned int>::max();
  if (numbers.seed < 0 || numbers.seed > greatest_seed)
    throw Usage_error{ "--seed: a number from 0 to " + std::to_string(greatest_seed) + " expected" };
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
  if (options.flat && !values["seed"].defaulted())
    throw Usage_error{ "--seed: not with --flat, which makes no random choice" };
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
  const std::pair<const char*, bool> cutting_options[] = {
    { "--least-used-part", options.least_used_part.value_or(0) > 0 },
    { "--distortion-bound", options.distortion_bound.has_value() },
    { "--overlap-bound", options.overlap_bound.has_value() },
    { "--sharp-angle", options.sharp_angle.has_value() }
  };
  for (const auto& [option, is_given] : cutting_options)
    if (is_given)
      throw Usage_error{ option + std::string(": not with --cut none") };
  options.least_used_part = 0;
  options.distortion_bound = std::numeric_limits<double>::infinity();
  options.overlap_bound = 1;
}

// Which part of a mesh is laid out, and whether it may be cut: what the command line says, or the defaults.
void read_part(const std::string& components, const std::string& cut, Options& options)
{
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
    options.distortion_bound = SMP::Option_defaults::distortion_bound;      // rings, too, as the side of a cylinder
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
    throw Usage_error{ "--threads: a number that is not negative expected" };
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
