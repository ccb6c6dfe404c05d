// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "held_vertices.h"

#include "File_scanner.h"
#include "errors.h"
#include "input.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

// Holds a vertex where a line of the file says.
void hold(File_scanner& file, const std::vector<bool>& is_in_chart, Input& input)
{
  long long index;
  double x, y;
  if (!file.read(index) || !file.read(x) || !file.read(y) || !file.is_at_line_end() ||
      !std::isfinite(x) || !std::isfinite(y))
    file.fail("a vertex and two finite coordinates expected");
  const std::string name = "vertex " + std::to_string(index);
  if (index < 0 || std::size_t(index) >= is_in_chart.size())
    file.fail("there is no " + name);
  if (!is_in_chart[std::size_t(index)])
    file.fail(name + " is not in the component that is laid out");
  const Mesh::Vertex_index v = Mesh::Vertex_index(Mesh::size_type(index));
  if (input.is_held[v])
    file.fail(name + " comes twice");
  input.is_held[v] = true;
  input.uvmap[v] = Kernel::Point_2(x, y);
}

} // namespace

void read_held_vertices(const std::string& file, Input& input)
try {
  const std::vector<bool> is_in_chart = vertices_of_faces(input);
  const std::string content = read_content(file, true);
  File_scanner lines(content);
  for (lines.skip_comments(); !lines.is_at_end(); lines.skip_line(), lines.skip_comments())
    hold(lines, is_in_chart, input);
} catch (const Input_error& error) {
  throw Input_error{ "--hold: '" + file + "' " + error.message, SMP::ERROR_WRONG_PARAMETER };
}
