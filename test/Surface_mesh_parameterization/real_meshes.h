// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef REAL_MESHES_H
#define REAL_MESHES_H

#include "test_meshes.h"

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <string>

// Real meshes, where they are at hand.
namespace test_meshes {

// The folder with the real meshes: SHARED_DATA in the environment, or what CMake was told by
// HIERARCHICAL_PARAMETERIZATION_TEST_DATA_DIR; ends in '/'.
inline std::string data_folder()
{
  const char* folder = std::getenv("SHARED_DATA");
  return std::string(folder ? folder : TEST_DATA_DIR) + '/';
}

// Returns whether the file could be read; triangles only.
inline bool read_off(const std::string& name, Flat_mesh& m)
{
  std::ifstream file(data_folder() + name);
  std::string word;
  std::size_t number_of_points, number_of_triangles, unused;
  if (!(file >> word >> number_of_points >> number_of_triangles >> unused))
    return false;
  m = Flat_mesh();
  double x, y, z;
  for (std::size_t i = 0; i < number_of_points && file >> x >> y >> z; ++i)
    m.points.emplace_back(x, y, z);
  Index_triangle t;
  for (std::size_t i = 0; i < number_of_triangles && file >> unused >> t[0] >> t[1] >> t[2]; ++i)
    m.triangles.push_back(t);
  return m.triangles.size() == number_of_triangles;
}

} // namespace test_meshes

#endif // REAL_MESHES_H
