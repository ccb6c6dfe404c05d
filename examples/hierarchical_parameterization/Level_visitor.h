// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is done with each level.

#ifndef LEVEL_VISITOR_H
#define LEVEL_VISITOR_H

#include "input.h"
#include "methods.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>

#include <cstddef>
#include <string>
#include <vector>

// The name of the file of a level.
std::string level_file(const std::string& folder, std::size_t level);

// Tells of progress on a terminal and writes the levels.
class Level_visitor : public SMP::Hierarchy_visitor_3
{
public:
  // Both must outlive the visitor.
  Level_visitor(const Input& input, const Method_options& options);

  bool level_parameterized(const SMP::Level& level, const SMP::Level::Uv& uv, const SMP::Level_summary& summary);

private:
  void print_progress(const SMP::Level& level, const SMP::Level_summary& summary);

  const Method_options& m_options;
  const Mesh& m_mesh;
  std::vector<Mesh::Vertex_index>
      m_vertices;      // of the component, as the hierarchy numbers them; if levels are written
  bool m_has_progress_line;
  double m_seconds = 0;                               // on the levels that are done
};

#endif // LEVEL_VISITOR_H
