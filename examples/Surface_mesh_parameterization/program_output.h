// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAM_OUTPUT_H
#define PROGRAM_OUTPUT_H

#include "program_file.h"
#include "program_input.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

// What there is to report of one input.
struct Run_record
{
  Input input;
  SMP::Parameterization_summary summary;
  std::optional<SMP::Parameterization_quality> quality;     // of a map that was written
  double seconds_read = 0, seconds_write = 0;
  std::string status, error;                                // for the report; no error: an empty text
};

// The mesh with its map as PLY, in plain text. Vertices of other components get no place, so that of the origin.
inline void write_PLY(std::ostream& out, const Mesh& mesh, const Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>& uvmap)
{
  Mesh copy;    // without the properties that are of no use outside
  std::vector<Mesh::Vertex_index> vertices;
  for (const Mesh::Vertex_index v : mesh.vertices())
    vertices.push_back(copy.add_vertex(mesh.point(v)));
  std::vector<Mesh::Vertex_index> corners;
  for (const Mesh::Face_index f : mesh.faces()) {
    corners.clear();
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners.push_back(vertices[v]);
    copy.add_face(corners);
  }
  const auto u = copy.add_property_map<Mesh::Vertex_index, double>("v:u").first, v = copy.add_property_map<Mesh::Vertex_index, double>("v:v").first;
  for (const Mesh::Vertex_index w : mesh.vertices()) {
    u[vertices[w]] = uvmap[w].x();
    v[vertices[w]] = uvmap[w].y();
  }
  CGAL::IO::write_PLY(out, copy, CGAL::parameters::stream_precision(17));
}

// One level as OBJ: its vertices where the input has them, or in the middle of a hole that was filled, its triangles, and its map (up to scale).
inline void write_level(std::ostream& out, const Mesh& mesh, const std::vector<Mesh::Vertex_index>& vertices_of_component,
                        const SMP::Level& level, const SMP::Level::Uv& uv)
{
  out.precision(17);
  const auto is_of_mesh = [&](SMP::Level::Index v) { return level.hierarchy().input_vertex(v) < vertices_of_component.size(); };
  const auto point_of_mesh = [&](SMP::Level::Index v) { return mesh.point(vertices_of_component[level.hierarchy().input_vertex(v)]); };
  const auto scaled = [&](SMP::Level::Index v) {
    const SMP::Level::Point_3& p = level.point(v);
    return Kernel::Point_3(std::ldexp(p.x(), -level.scale_exponent()), std::ldexp(p.y(), -level.scale_exponent()), std::ldexp(p.z(), -level.scale_exponent()));
  };
  SMP::Level::Index reference = 0;
  while (!is_of_mesh(reference))
    ++reference;
  for (SMP::Level::Index v = 0; v < level.number_of_vertices(); ++v)
    out << "v " << (is_of_mesh(v) ? point_of_mesh(v) : point_of_mesh(reference) + (scaled(v) - scaled(reference))) << '\n';
  for (const SMP::Level::Point_2& p : uv)
    out << "vt " << p << '\n';
  for (const SMP::Level::Triangle& t : level.triangles())
    out << "f " << t[0] + 1 << '/' << t[0] + 1 << ' ' << t[1] + 1 << '/' << t[1] + 1 << ' ' << t[2] + 1 << '/' << t[2] + 1 << '\n';
}

inline const char* error_name(SMP::Error_code code)
{
  switch (code) {
    case SMP::OK: return "ok";
    case SMP::ERROR_EMPTY_MESH: return "ERROR_EMPTY_MESH";
    case SMP::ERROR_NON_TRIANGULAR_MESH: return "ERROR_NON_TRIANGULAR_MESH";
    case SMP::ERROR_NO_TOPOLOGICAL_DISC: return "ERROR_NO_TOPOLOGICAL_DISC";
    case SMP::ERROR_NO_TOPOLOGICAL_BALL: return "ERROR_NO_TOPOLOGICAL_BALL";
    case SMP::ERROR_BORDER_TOO_SHORT: return "ERROR_BORDER_TOO_SHORT";
    case SMP::ERROR_NON_CONVEX_BORDER: return "ERROR_NON_CONVEX_BORDER";
    case SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM: return "ERROR_CANNOT_SOLVE_LINEAR_SYSTEM";
    case SMP::ERROR_NO_1_TO_1_MAPPING: return "ERROR_NO_1_TO_1_MAPPING";
    case SMP::ERROR_WRONG_PARAMETER: return "ERROR_WRONG_PARAMETER";
  }
  return "unknown";
}

inline std::size_t peak_memory_bytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return std::size_t(usage.ru_maxrss) * 1024;
}

// The report of one input. What is not finite, or was not measured, is null.
inline nlohmann::ordered_json make_report(const Run_record& run, const std::string& method)
{
  const SMP::Parameterization_summary& summary = run.summary;
  nlohmann::ordered_json report = {
    { "input", run.input.name }, { "vertices", run.input.mesh.number_of_vertices() }, { "faces", run.input.mesh.number_of_faces() },
    { "borders", run.input.number_of_borders }, { "method", method }, { "status", run.status }, { "error", nullptr },
    { "levels", nlohmann::ordered_json::array() },
    { "seconds", { { "read", run.seconds_read }, { "hierarchy", summary.seconds_hierarchy },
                   { "parameterize", summary.seconds_parameterize }, { "write", run.seconds_write } } },
    { "linear_solver", nullptr },
    { "peak_memory_bytes", peak_memory_bytes() },
    { "quality", nullptr } };
  if (!run.error.empty())
    report["error"] = run.error;
  for (const SMP::Level_summary& level : summary.levels)
    report["levels"].push_back({ { "vertices", level.vertices }, { "faces", level.faces }, { "energy_start", level.energy_start },
                                 { "energy_end", level.energy_end }, { "iterations", level.iterations }, { "seconds", level.seconds } });
  if (const SMP::Linear_solver_summary& solver = summary.linear_solver; solver.right_sides > 0)
    report["linear_solver"] = { { "iterations", solver.iterations }, { "residual", solver.residual }, { "direct_solutions", solver.direct_solutions },
                                { "seconds", solver.seconds_setup + solver.seconds_solve } };
  if (const auto& quality = run.quality)
    report["quality"] = { { "flips", quality->flips }, { "degenerate", quality->degenerate }, { "overlaps", quality->overlaps },
                          { "mips", quality->mips }, { "mips_excess", quality->mips_excess },
                          { "symmetric_dirichlet", quality->symmetric_dirichlet }, { "l2_stretch", quality->l2_stretch },
                          { "linf_stretch", quality->linf_stretch }, { "angle", quality->angle }, { "area", quality->area } };
  return report;
}

#endif // PROGRAM_OUTPUT_H
