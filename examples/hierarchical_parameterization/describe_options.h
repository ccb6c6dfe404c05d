// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DESCRIBE_OPTIONS_H
#define DESCRIBE_OPTIONS_H

#include "options.h"

#include <boost/program_options/options_description.hpp>

#include <string>

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

// The options by subject, with their texts, and where their values go.
po::options_description describe_options(Options& options, Words& words, Numbers& numbers);

void print_help(const po::options_description& described);

#endif // DESCRIBE_OPTIONS_H
