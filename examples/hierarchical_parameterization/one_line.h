// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names in messages.

#ifndef ONE_LINE_H
#define ONE_LINE_H

#include <cstdio>
#include <string>

// The text with control characters as \xNN: a name can hold any, a message is one line and steers no terminal.
inline std::string one_line(const std::string& text)
{
  std::string line;
  for (const char c : text) {
    const unsigned byte = static_cast<unsigned char>(c);
    char escape[5];
    std::snprintf(escape, sizeof escape, "\\x%02x", byte);
    line += byte < 32 || byte == 127 ? std::string(escape) : std::string(1, c);
  }
  return line;
}

#endif // ONE_LINE_H
