// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs parameterizers as CGAL ships them.

#ifndef RUN_SHIPPED_H
#define RUN_SHIPPED_H

#include "methods.h"

// Of the methods that are CGAL's. By themselves, as their solvers take a compiler long.
Run_method run_shipped_barycentric, run_shipped_mean_value, run_shipped_conformal, run_shipped_authalic;
Run_method run_shipped_iterative_authalic, run_shipped_lscm, run_shipped_arap;

#endif // RUN_SHIPPED_H
