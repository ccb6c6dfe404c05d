// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ERROR_MESSAGE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ERROR_MESSAGE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>

#include <string>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationRef
///
/// describes an error in words: the cause in this package, and the vertex or face. Do not use CGAL's
/// `get_error_message()` for errors of this package: it lacks an entry.
inline std::string error_message(const Parameterization_error& error)
{
  const bool is_at_vertex = error.place == Parameterization_error::VERTEX;
  std::string message = error.code == ERROR_STOPPED ? "a visitor stopped the run" : "unknown error";
  switch (error.code) {
    case OK: message = "no error"; break;
    case ERROR_EMPTY_MESH: message = "the mesh has no faces"; break;
    case ERROR_NON_TRIANGULAR_MESH: message = "not all faces are triangles"; break;
    case ERROR_NO_TOPOLOGICAL_DISC:
      message = is_at_vertex ? "several fans of triangles meet at a vertex, or two edges have the same ends"
                             : "the surface is closed or has a handle: atlas_parameterization() takes such surfaces; "
                               "or cut it open first, by a seam along a path of edges, as cut_to_disk() does";
      break;
    case ERROR_NO_TOPOLOGICAL_BALL: message = "the surface is no sphere"; break;
    case ERROR_BORDER_TOO_SHORT: message = "the border has no length, or too few edges for its shape"; break;
    case ERROR_NON_CONVEX_BORDER:
      message = "the border of the map crosses itself, or vertices that a border parameterizer was given are not on "
                "the outer border, or not in the component";
      break;
    case ERROR_CANNOT_SOLVE_LINEAR_SYSTEM:
      message = "a linear system could not be solved";
      break;
    case ERROR_NO_1_TO_1_MAPPING:
      message = is_at_vertex ? "a constrained vertex could not reach its uv coordinates without a flip"
                             : "no map without flips was found";
      break;
    case ERROR_WRONG_PARAMETER:
      message = "a parameter is out of its range or not finite, or the halfedge is on no border";
      break;
  }
  if (error.cause)
    message = error.cause;
  if (error.place != Parameterization_error::NOWHERE)
    message += (is_at_vertex ? " (vertex " : " (face ") + std::to_string(error.index) + ")";
  return message;
}

/// \ingroup PkgHierarchicalParameterizationRef
///
/// describes an error code in words, for functions that return no more: the cause in this package. Unlike CGAL's
/// `get_error_message()` it knows every code.
inline std::string error_message(Error_code code)
{
  Parameterization_error error;
  error.code = code;
  return error_message(error);
}

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ERROR_MESSAGE_H
