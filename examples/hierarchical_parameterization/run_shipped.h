// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs parameterizers as CGAL ships them.

#ifndef RUN_SHIPPED_H
#define RUN_SHIPPED_H

#include "methods.h"

// Made for the parameterizers of CGAL that are methods of the program, by themselves: their solvers take a compiler long.
template <class Parameterizer>
SMP::Parameterization_summary run_shipped(Input& input, const Method_options& options);

#endif // RUN_SHIPPED_H
