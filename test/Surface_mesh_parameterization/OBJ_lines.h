// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef OBJ_LINES_H
#define OBJ_LINES_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace test_meshes {

// The lines of an OBJ file, by a reader that knows nothing of its writers: points, texture vertices and faces, which
// refer to lines before theirs.
struct OBJ_lines
{
  // Indices count from 1.
  struct Corner
  {
    std::size_t vertex;
    std::size_t texture_vertex;     // 0 if there is none
  };

  std::vector<CGAL::Surface_mesh_parameterization::internal::Point_3> points;
  std::vector<CGAL::Surface_mesh_parameterization::internal::Point_2> uv;
  std::vector<std::vector<Corner>> faces;

  explicit OBJ_lines(const std::string& text)
  {
    std::istringstream file(text);
    for (std::string line, word; std::getline(file, line);) {
      std::istringstream words(line);
      words >> word;
      double x, y, z;
      if (word == "v" && words >> x >> y >> z)
        points.emplace_back(x, y, z);
      else if (word == "vt" && words >> x >> y)
        uv.emplace_back(x, y);
      else if (word == "f") {
        faces.emplace_back();
        while (words >> word)
          faces.back().push_back(corner(word));
      } else
        ADD_FAILURE() << line;
    }
  }

private:
  Corner corner(const std::string& word) const
  {
    const std::size_t slash = word.find('/');
    const Corner result = { std::stoul(word), slash == std::string::npos ? 0 : std::stoul(word.substr(slash + 1)) };
    EXPECT_TRUE(result.vertex >= 1 && result.vertex <= points.size()) << word;
    EXPECT_TRUE(slash == std::string::npos || (result.texture_vertex >= 1 && result.texture_vertex <= uv.size()))
        << word;
    return result;
  }
};

} // namespace test_meshes

#endif // OBJ_LINES_H
