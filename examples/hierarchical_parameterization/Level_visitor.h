// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is done with each level.

#ifndef LEVEL_VISITOR_H
#define LEVEL_VISITOR_H

#include "Progress_bar.h"
#include "input.h"
#include "methods.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

// The name of the file of a level.
std::string level_file(const std::string& folder, std::size_t level);

// Shows progress on a terminal and writes the levels.
class Level_visitor : public SMP::Hierarchy_visitor_3
{
public:
  // The first two must outlive the visitor. `quantity` says what the method lowers.
  Level_visitor(const Input& input, const Method_options& options, const std::string& quantity = "energy");

  bool hierarchy_built(const SMP::Collapse_hierarchy_3& hierarchy);
  bool level_parameterized(const SMP::Level& level, const SMP::Level::Uv& uv, const SMP::Level_summary&);
  bool progressed(const SMP::Parameterization_progress& progress);

private:
  const Method_options& m_options;
  const Mesh& m_mesh;
  std::string m_quantity;
  std::vector<Mesh::Vertex_index>
      m_vertices;      // of the component, as the hierarchy numbers them; if levels are written
  std::vector<std::size_t> m_triangles;               // of the levels
  std::shared_ptr<Progress_bar> m_bar;                // null if there is none
};

#endif // LEVEL_VISITOR_H
