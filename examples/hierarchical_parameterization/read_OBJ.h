// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads OBJ.

#ifndef READ_OBJ_H
#define READ_OBJ_H

#include "File_scanner.h"
#include "Polygon_soup.h"

#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>

// Reads the `v` and `f` lines of Wavefront OBJ; what else a line may say is skipped. Indices count from 1, or, if
// negative, back from the last vertex so far.
inline Polygon_soup read_OBJ(File_scanner& file)
{
  Polygon_soup soup;
  for (file.skip_comments(); !file.is_at_end(); file.skip_line(), file.skip_comments()) {
    const std::string_view keyword = file.word();
    if (keyword == "v") {
      double x, y, z;
      if (!file.read(x) || !file.read(y) || !file.read(z))
        file.fail("the coordinates of " + vertex_text(soup.points.size()) + " cannot be read");
      soup.points.push_back({ x, y, z });
    } else if (keyword == "f") {
      Polygon_soup::Polygon polygon;
      long long index;
      while (file.read(index)) {
        polygon.push_back(index < 0 ? soup.points.size() + std::size_t(index) : std::size_t(index) - 1);
        file.skip_word();                // the indices of texture coordinates and normal
      }
      const std::string_view rest = file.word();
      if (!rest.empty() && rest.front() != '#')
        file.fail("the vertices of " + face_text(soup.polygons.size()) + " cannot be read");
      soup.polygons.push_back(polygon);
    } else if (!std::isalpha(static_cast<unsigned char>(keyword.front())))
      file.fail("a keyword of OBJ expected");
  }
  return soup;
}

#endif // READ_OBJ_H
