// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes and checks the map of an input.

#ifndef LAY_OUT_H
#define LAY_OUT_H

#include "options.h"
#include "report.h"

struct Input;

// Fills in the map of the input, and in the record the summary, the quality and the status. An atlas takes the place of
// one chart that lies over itself although it should not. Faces of an atlas whose charts have no map are taken out of
// the input. Throws a Method_error if there is no map at all, or one that is not as the method and the options promise.
void lay_out(Input& input, const Options& options, Run_record& run);

// Throws a Method_error if charts of an atlas have no map, and an Input_error if components were left out.
void check_complete(const Input& input, const Options& options, const Run_record& run);

#endif // LAY_OUT_H
