// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PRINTED_H
#define PRINTED_H

#include <cstdio>
#include <string>

// As printf() would write the number.
inline std::string printed(const char* format, double number)
{
  char result[32];
  std::snprintf(result, sizeof result, format, number);
  return result;
}

#endif // PRINTED_H
