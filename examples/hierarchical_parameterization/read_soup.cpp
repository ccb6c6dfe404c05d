// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads polygons from files.

#include "File_scanner.h"
#include "OFF_reader.h"
#include "PLY_reader.h"
#include "Polygon_soup.h"
#include "STL_reader.h"
#include "has_suffix.h"
#include "read_OBJ.h"

#include <string>

// Not by CGAL::IO::read_polygon_soup(): its readers believe the counts and types that a file states, which costs all
// memory or a crash, and cannot tell which face or vertex is wrong.
Polygon_soup read_soup(const std::string& name, const std::string& content, bool has_uv)
{
  File_scanner scanner(content);
  if (has_suffix(name, ".off"))
    return OFF_reader(scanner).read();
  if (has_suffix(name, ".obj"))
    return read_OBJ(content, has_uv);
  if (has_suffix(name, ".ply"))
    return PLY_reader(scanner, has_uv).read();
  if (has_suffix(name, ".stl"))
    return STL_reader(scanner).read();
  throw Input_error{ has_uv ? "is not named .ply or .obj" : "is not named .off, .obj, .ply or .stl" };
}
