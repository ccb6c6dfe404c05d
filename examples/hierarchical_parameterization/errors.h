// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the user is told of.

#ifndef ERRORS_H
#define ERRORS_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <string>

namespace SMP = CGAL::Surface_mesh_parameterization;

// Something that is wrong with the input: in words, and as CGAL's code where it has one. Faces and
// vertices count from 0.
struct Input_error
{
  std::string message;
  SMP::Error_code code = SMP::OK;     // OK: the file cannot be read
};

// Something that is wrong with the command line.
struct Usage_error { std::string message; };

// What a method, or its map, fails with.
struct Method_error { std::string message; SMP::Error_code code; };

#endif // ERRORS_H
