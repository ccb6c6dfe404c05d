// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files of the command line.

#include "check_files.h"

#include "File_place.h"
#include "Level_visitor.h"
#include "Output_files.h"
#include "errors.h"
#include "has_suffix.h"
#include "name_for_input.h"
#include "options.h"
#include "write_GLB.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace {

struct Named_place
{
  std::string option, name;
  File_place place;
};

// A name without an ending, and what is no regular file, say nothing of a format.
void check_suffix(const std::string& option, const std::string& name, const std::vector<std::string>& suffixes)
{
  if (name.empty() || !std::filesystem::path(name).has_extension() || output_place(name).is_special())
    return;
  if (std::none_of(suffixes.begin(), suffixes.end(), [&](const std::string& s) { return has_suffix(name, s); })) {
    std::string list;
    for (const std::string& suffix : suffixes)
      list += (list.empty() ? "" : " or ") + suffix;
    throw Usage_error{ option + ": '" + name + "' is not named " + list };
  }
}

void check_format(const std::string& option, const std::string& name)
{
  if (option == "--picture")
    check_suffix(option, name, { ".svg" });
  else if (option == "--output")
    check_suffix(option, name, { ".obj", ".ply", ".glb" });
  if (option == "--output" && has_suffix(name, ".glb") && !can_write_GLB())
    throw Usage_error{ option + ": '" + name + "' needs TinyGLTF (libtinygltf-dev in Debian), without which this "
                       "program was built" };
}

typedef std::vector<std::pair<std::string, std::string>>   Options_and_names;

// Those that are given and whose names depend on the input, or those whose names do not.
Options_and_names options_with_names(const Options& options, bool depend_on_input)
{
  Options_and_names result{ { "--output", options.output }, { "--picture", options.picture } };
  result.erase(std::remove_if(result.begin(), result.end(),
                              [=](const auto& o) {
                                return o.second.empty() || depends_on_input(o.second) != depend_on_input;
                              }),
               result.end());
  if (!depend_on_input && !options.report.empty())
    result.emplace_back("--report", options.report);
  return result;
}

std::vector<Named_place> output_places(const Options& options)
{
  constexpr std::size_t most_levels = 100;       // more than any mesh has
  std::vector<Named_place> outputs;
  const auto add = [&](const std::string& option, const std::string& name) {
    outputs.push_back({ option, name, output_place(name) });
  };
  for (const auto& [option, name] : options_with_names(options, false))
    add(option, name);
  for (std::size_t l = 0; l < most_levels && !options.levels.empty(); ++l)
    add("--levels", level_file(options.levels, l));
  if (!options.quiet && !is_standard_output_taken(options))
    add("the summary", "-");
  return outputs;
}

// What else forbids to write a file is told when it is written.
void check_output(const std::string& name)
{
  const File_place place = output_place(name);
  if (place.is_special())
    return;
  const std::filesystem::path folder = place.path.parent_path();
  std::error_code unused_error;
  const std::filesystem::file_status status = std::filesystem::status(folder.empty() ? "." : folder, unused_error);
  if (std::filesystem::status_known(status) && !std::filesystem::is_directory(status))
    throw std::runtime_error(name + ": cannot be written (there is no folder '" + folder.string() + "')");
  if (std::filesystem::is_directory(place.path, unused_error))
    throw std::runtime_error(name + ": cannot be written (it is a folder)");
  check_permission(name);
}

// Checks the outputs whose names depend on the input, by their places alone: there may be very many.
void check_outputs_of_inputs(const Options& options, const std::vector<std::string>& inputs,
                             const std::vector<Named_place>& outputs)
{
  std::map<std::filesystem::path, std::string> taken;
  for (const std::string& input : inputs)
    if (!input.empty())
      taken[input_place(input).canonical] = "the input '" + input + "'";
  for (const Named_place& output : outputs)
    taken[output.place.canonical] = "that of " + output.option;
  for (const auto& [option, pattern] : options_with_names(options, true))
    for (const std::string& input : options.inputs) {
      const std::string name = name_for_input(pattern, input);
      const File_place place = output_place(name);
      check_format(option, name);
      if (place.is_special())
        throw Usage_error{ option + ": '" + name + "' of '" + input + "' is no regular file" };
      const auto& [entry, is_new] =
          taken.try_emplace(place.canonical, "that of " + option + " for '" + input + "'");
      if (!is_new)
        throw Usage_error{ option + ": the file '" + name + "' of '" + input + "' is " + entry->second };
      check_output(name);
    }
}

} // namespace

bool is_standard_output_taken(const Options& options)
{
  const auto names = options_with_names(options, false);
  return std::any_of(names.begin(), names.end(),
                     [](const auto& o) { return is_standard_output(o.second); });
}

void check_files(const Options& options)
{
  for (const auto& [option, name] : options_with_names(options, false))
    check_format(option, name);

  const std::vector<Named_place> outputs = output_places(options);
  std::vector<std::string> inputs = options.inputs;
  inputs.insert(inputs.end(), { options.start, options.hold });
  for (const std::string& input : inputs) {
    const File_place place = input_place(input);
    for (const Named_place& output : outputs)
      if (!input.empty() && is_same_file(output.place, place))
        throw Usage_error{ output.option + ": '" + output.name + "' is the input '" + input + "'" };
  }
  for (auto a = outputs.begin(); a != outputs.end(); ++a)
    for (auto b = outputs.begin(); b != a; ++b)
      if (is_same_file(a->place, b->place))
        throw Usage_error{ b->option + " and " + a->option + " are the same file '" + b->name + "'" };
  for (const auto& option_and_name : options_with_names(options, false))
    check_output(option_and_name.second);
  check_outputs_of_inputs(options, inputs, outputs);
  std::error_code unused_error;
  const std::filesystem::file_status levels = std::filesystem::status(options.levels, unused_error);
  if (std::filesystem::exists(levels) && !std::filesystem::is_directory(levels))
    throw std::runtime_error(options.levels + ": cannot be written (it is no folder)");
}
