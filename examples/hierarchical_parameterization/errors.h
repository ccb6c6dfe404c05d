// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the user is told of.

#ifndef ERRORS_H
#define ERRORS_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <optional>
#include <string>

namespace SMP = CGAL::Surface_mesh_parameterization;

// Something that is wrong with the input: in words, and as CGAL's code where it has one. Faces and
// vertices count from 0.
struct Input_error
{
  std::string message;
  std::optional<SMP::Error_code> code = std::nullopt;     // none: the file cannot be read
};

// Something that is wrong with the command line.
struct Usage_error { std::string message; };

// What a method, or its map, fails with.
struct Method_error { std::string message; SMP::Error_code code; };

// Whether it is the method that has failed; other errors are those of the surface.
inline bool is_fault_of_method(SMP::Error_code code)
{
  return code == SMP::ERROR_NO_1_TO_1_MAPPING || code == SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM ||
         code == SMP::ERROR_NON_CONVEX_BORDER;
}

#endif // ERRORS_H
