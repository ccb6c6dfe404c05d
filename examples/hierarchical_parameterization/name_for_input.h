// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of outputs that depend on the input.

#ifndef NAME_FOR_INPUT_H
#define NAME_FOR_INPUT_H

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

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
  const std::filesystem::path path(input.empty() ? "face" : input);
  const std::string name = path.stem().string(), whole = (path.parent_path() / path.stem()).string();
  const std::pair<std::string, std::string> parts[] = { { name_without_ending, name },
                                                        { input_without_ending, whole } };
  for (std::size_t at = 0; at < pattern.size();) {      // what the input's name has of these stays
    std::size_t step = 1;
    for (const auto& [part, text] : parts)
      if (pattern.compare(at, part.size(), part) == 0) {
        pattern.replace(at, part.size(), text);
        step = text.size();
        break;
      }
    at += step;
  }
  return pattern;
}

#endif // NAME_FOR_INPUT_H
