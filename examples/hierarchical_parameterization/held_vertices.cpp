// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "held_vertices.h"

#include "File_place.h"
#include "errors.h"
#include "input.h"

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Held_vertex
{
  std::size_t vertex;
  double u, v;
};

// Of a line that is not empty.
Held_vertex read_line(const std::string& line)
{
  constexpr std::size_t most_digits = 18;      // more than any mesh has vertices, less than a number holds
  std::istringstream words(line);
  std::string vertex, rest;
  Held_vertex held;
  if (!(words >> vertex >> held.u >> held.v) || words >> rest ||
      vertex.find_first_not_of("0123456789") != std::string::npos || vertex.size() > most_digits)
    throw Input_error{ "a vertex and two finite coordinates expected" };
  held.vertex = std::stoull(vertex);
  return held;
}

void hold(const Held_vertex& held, const std::vector<bool>& is_in_chart, Input& input)
{
  const std::string name = "vertex " + std::to_string(held.vertex);
  if (held.vertex >= is_in_chart.size())
    throw Input_error{ "there is no " + name };
  if (!is_in_chart[held.vertex])
    throw Input_error{ name + " is not in the component that is laid out" };
  const Mesh::Vertex_index v = Mesh::Vertex_index(Mesh::size_type(held.vertex));
  if (input.is_held[v])
    throw Input_error{ name + " comes twice" };
  input.is_held[v] = true;
  input.uvmap[v] = Kernel::Point_2(held.u, held.v);
}

} // namespace

void read_held_vertices(const std::string& file, Input& input)
{
  const std::vector<bool> is_in_chart = vertices_of_faces(input);
  std::size_t number = 0;
  try {
    std::istringstream lines(read_content(file, true));
    for (std::string line; std::getline(lines, line);) {
      ++number;
      const std::size_t first = line.find_first_not_of(" \t\r");
      if (first != std::string::npos && line[first] != '#')
        hold(read_line(line), is_in_chart, input);
    }
  } catch (const Input_error& error) {
    const std::string place = number > 0 ? "line " + std::to_string(number) + ": " : "";
    throw Input_error{ "--hold: '" + file + "' " + place + error.message, SMP::ERROR_WRONG_PARAMETER };
  }
}
