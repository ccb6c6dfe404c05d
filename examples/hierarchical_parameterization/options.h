// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line.

#ifndef OPTIONS_H
#define OPTIONS_H

#include "input.h"
#include "methods.h"

#include <string>
#include <vector>

struct Options : Method_options, Input_options
{
  std::vector<std::string> inputs;
  const Method* method = nullptr;
  std::string output, picture;      // see name_for_input()
  bool is_output_binary = false;    // if it is PLY
  std::string report;
  int threads = 0;
};

// Returns whether there is something to do: not after --help and --version. Throws a Usage_error.
bool read_options(int argc, char** argv, Options& options);

// Those that take one chart, of which the user has given some, as "--start and --hold"; else empty.
std::string options_of_one_chart(const Options& options);

#endif // OPTIONS_H
