// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is parameterized.

#include "input.h"

#include "read_mesh.h"

#include <CGAL/Surface_mesh_parameterization/internal/mesh/longest_border.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

void choose_component(Input& input)
{
  const Mesh& mesh = input.mesh;
  auto component_of = input.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  input.number_of_components = CGAL::Polygon_mesh_processing::connected_components(mesh, component_of);

  std::vector<std::size_t> sizes(input.number_of_components, 0);
  for (const Mesh::Face_index f : mesh.faces())
    ++sizes[component_of[f]];
  const std::size_t largest = std::size_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  for (const Mesh::Face_index f : mesh.faces())
    if (component_of[f] == largest)
      input.faces.push_back(f);

  const auto longest = SMP::internal::longest_border(mesh, [&](Mesh::Halfedge_index h) { return component_of[mesh.face(mesh.opposite(h))] == largest; });
  input.border = longest.halfedge;
  input.number_of_borders = longest.number_of_borders;
  if (input.number_of_borders == 0)
    throw Input_error{ "is closed: a surface needs a border to be laid out; cut it open first, by leaving out a face or by doubling the vertices along a path of edges",
                       SMP::ERROR_NO_TOPOLOGICAL_DISC };
}

void read_input(const std::string& file, bool is_triangulated, Input& input)
{
  if (file.empty())
    input.mesh = built_in_face();
  else
    input.mesh = read_mesh(file, is_triangulated);
  choose_component(input);
}
