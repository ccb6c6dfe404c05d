// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The endings of names.

#ifndef HAS_SUFFIX_H
#define HAS_SUFFIX_H

#include <algorithm>
#include <cctype>
#include <string>

// Whether the text ends so, in letters of either case. `suffix`: in small ones.
inline bool has_suffix(const std::string& text, const std::string& suffix)
{
  return text.size() >= suffix.size() && std::equal(suffix.rbegin(), suffix.rend(), text.rbegin(), [](char a, char b) {
           return a == std::tolower(static_cast<unsigned char>(b));
         });
}

#endif // HAS_SUFFIX_H
