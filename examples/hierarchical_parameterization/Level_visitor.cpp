// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is done with each level.

#include "Level_visitor.h"

#include "printed.h"
#include "write_file.h"

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Text_writer.h>

#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace {

// One level as OBJ: its vertices where the input has them, or in the middle of a hole that was filled, its triangles,
// and its map in units of the input, before flips are repaired.
void write_level(std::ostream& os, const Mesh& mesh, const std::vector<Mesh::Vertex_index>& vertices_of_component,
                 const SMP::Level& level, const SMP::Level::Uv& uv)
{
  SMP::internal::Text_writer out(os);
  const auto is_of_mesh = [&](SMP::Level::Index v) {
    return level.hierarchy().input_vertex(v) < vertices_of_component.size();
  };
  const auto point_of_mesh = [&](SMP::Level::Index v) {
    return mesh.point(vertices_of_component[level.hierarchy().input_vertex(v)]);
  };
  const auto scaled = [&](SMP::Level::Index v) {
    const SMP::Level::Point_3& p = level.point(v);
    return Kernel::Point_3(std::ldexp(p.x(), -level.scale_exponent()), std::ldexp(p.y(), -level.scale_exponent()),
                           std::ldexp(p.z(), -level.scale_exponent()));
  };
  SMP::Level::Index reference = 0;
  while (!is_of_mesh(reference))
    ++reference;
  for (SMP::Level::Index v = 0; v < level.number_of_vertices(); ++v) {
    const Kernel::Point_3 p =
        is_of_mesh(v) ? point_of_mesh(v) : point_of_mesh(reference) + (scaled(v) - scaled(reference));
    out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }
  for (const SMP::Level::Point_2& p : uv)
    out << "vt " << std::ldexp(p.x(), -level.scale_exponent()) << ' ' << std::ldexp(p.y(), -level.scale_exponent())
        << '\n';
  for (const SMP::Level::Triangle& t : level.triangles())
    out << "f " << t[0] + 1 << '/' << t[0] + 1 << ' ' << t[1] + 1 << '/' << t[1] + 1 << ' ' << t[2] + 1 << '/'
        << t[2] + 1 << '\n';
  out.flush();
}

} // namespace

std::string level_file(const std::string& folder, std::size_t level)
{
  char name[32];
  std::snprintf(name, sizeof name, "level_%02zu.obj", level);
  return (std::filesystem::path(folder) / name).string();
}

Level_visitor::Level_visitor(const Input& input, const Method_options& options, const std::string& quantity)
  : m_options(options), m_mesh(input.mesh), m_quantity(quantity)
{
  if (!options.levels.empty())
    m_vertices = SMP::Mesh_component<Mesh>(input.mesh, input.border).vertices_of_component();
  if (!options.quiet && isatty(STDERR_FILENO))
    m_bar = std::make_shared<Progress_bar>();
}

bool Level_visitor::hierarchy_built(const SMP::Collapse_hierarchy_3& hierarchy)
{
  m_triangles.clear();
  for (std::size_t i = 0; i < hierarchy.number_of_levels(); ++i)
    m_triangles.push_back(hierarchy.number_of_faces(i));
  return true;
}

bool Level_visitor::level_parameterized(const SMP::Level& level, const SMP::Level::Uv& uv, const SMP::Level_summary&)
{
  if (!m_options.levels.empty())
    write_file(level_file(m_options.levels, level.index()),
               [&](std::ostream& out) { write_level(out, m_mesh, m_vertices, level, uv); });
  return true;
}

bool Level_visitor::progressed(const SMP::Parameterization_progress& progress)
{
  if (m_bar) {
    std::string text;
    if (progress.number_of_levels > 0 && progress.level < m_triangles.size())
      text = "level " + std::to_string(progress.level + 1) + '/' + std::to_string(progress.number_of_levels) + ", " +
             std::to_string(m_triangles[progress.level]) + " triangles, " + m_quantity +
             printed(" %.6g", progress.energy);
    m_bar->show(progress.part_done, text);
  }
  return true;
}
