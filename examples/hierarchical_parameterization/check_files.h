// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files of the command line.

#ifndef CHECK_FILES_H
#define CHECK_FILES_H

struct Options;

// Throws a Usage_error if a file cannot be written in the format of its name, or if one output would overwrite an input
// or another output, and a std::runtime_error if there is no folder for it.
void check_files(const Options& options);

// Whether an output goes to the standard output, so that nothing else may.
bool is_standard_output_taken(const Options& options);

#endif // CHECK_FILES_H
