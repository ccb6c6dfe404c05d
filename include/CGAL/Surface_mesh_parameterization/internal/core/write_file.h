// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_WRITE_FILE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_WRITE_FILE_H

#include <fstream>
#include <ios>
#include <string>

namespace CGAL::Surface_mesh_parameterization::internal {

// Writes a file by a function that takes the stream. Returns whether all of it was written.
template <class Write>
bool write_file(const std::string& name, const Write& write)
{
  std::ofstream file(name, std::ios::binary);
  if (!file)
    return false;
  write(file);
  file.close();
  return bool(file);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_WRITE_FILE_H
