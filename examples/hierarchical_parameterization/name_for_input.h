// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of outputs that depend on the input.

#ifndef NAME_FOR_INPUT_H
#define NAME_FOR_INPUT_H

#include <cstddef>
#include <filesystem>
#include <string>

// As for GNU parallel: the input without its ending, and without its folder, too.
inline constexpr char input_without_ending[] = "{.}", name_without_ending[] = "{/.}";

inline bool depends_on_input(const std::string& pattern)
{
  return pattern.find(input_without_ending) != std::string::npos ||
         pattern.find(name_without_ending) != std::string::npos;
}

// What a pattern means for an input; without a file: the built-in face.
inline std::string name_for_input(std::string pattern, const std::string& input)
{
  const auto replace = [&pattern](const std::string& part, const std::string& text) {
    for (std::size_t at = 0; (at = pattern.find(part, at)) != std::string::npos; at += text.size())
      pattern.replace(at, part.size(), text);
  };
  const std::filesystem::path path(input.empty() ? "face" : input);
  replace(name_without_ending, path.stem().string());
  replace(input_without_ending, (path.parent_path() / path.stem()).string());
  return pattern;
}

#endif // NAME_FOR_INPUT_H
