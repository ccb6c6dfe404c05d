// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of what was done.

#include "report.h"

#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <string>

const char* error_name(SMP::Error_code code)
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

namespace {

std::size_t peak_memory_bytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return std::size_t(usage.ru_maxrss) * 1024;
}

nlohmann::ordered_json levels_of(const SMP::Parameterization_summary& summary)
{
  nlohmann::ordered_json levels = nlohmann::ordered_json::array();
  for (const SMP::Level_summary& level : summary.levels)
    levels.push_back({ { "vertices", level.vertices },
                       { "faces", level.faces },
                       { "energy_start", level.energy_start },
                       { "energy_end", level.energy_end },
                       { "iterations", level.iterations },
                       { "cycles", level.cycles },
                       { "seconds", level.seconds } });
  return levels;
}

nlohmann::ordered_json seconds_of(const Run_record& run)
{
  nlohmann::ordered_json seconds = { { "read", run.seconds_read },
                                     { "hierarchy", run.summary.seconds_hierarchy },
                                     { "parameterize", run.summary.seconds_parameterize },
                                     { "write", run.seconds_write } };
  if (run.atlas) {
    seconds["cut"] = run.atlas->seconds_cut;
    seconds["pack"] = run.atlas->seconds_pack;
    seconds["one_chart"] = run.seconds_one_chart;
  }
  return seconds;
}

nlohmann::ordered_json atlas_of(const Run_record& run)
{
  const SMP::Atlas_summary& atlas = *run.atlas;
  const auto has_no_map = [](const SMP::Atlas_summary::Chart& chart) { return !chart.summary.is_ok(); };
  return { { "components", run.components },
           { "charts", atlas.charts.size() },
           { "charts_without_map", std::count_if(atlas.charts.begin(), atlas.charts.end(), has_no_map) },
           { "seam_edges", atlas.cut.seam_edges },
           { "seam_length", atlas.cut.seam_length },
           { "divisions", atlas.divisions },
           { "overlaps_of_one_chart", run.overlaps_of_one_chart },
           { "used_part", atlas.used_part } };
}

nlohmann::ordered_json json_of(const SMP::Linear_solver_summary& solver)
{
  return { { "iterations", solver.iterations },
           { "residual", solver.residual },
           { "direct_solutions", solver.direct_solutions },
           { "failures", solver.failures },
           { "seconds", solver.seconds_setup + solver.seconds_solve } };
}

nlohmann::ordered_json json_of(const SMP::Parameterization_quality& quality)
{
  return { { "flips", quality.flips },
           { "degenerate", quality.degenerate },
           { "overlaps", quality.overlaps },
           { "is_mirrored", quality.is_mirrored },
           { "mips", quality.mips },
           { "mips_excess", quality.mips_excess },
           { "symmetric_dirichlet", quality.symmetric_dirichlet },
           { "l2_stretch", quality.l2_stretch },
           { "linf_stretch", quality.linf_stretch },
           { "angle", quality.angle },
           { "area", quality.area } };
}

} // namespace

std::string report_line(const Run_record& run)
{
  const SMP::Parameterization_summary& summary = run.summary;
  nlohmann::ordered_json report = {
    { "input", run.input }, { "vertices", run.vertices }, { "faces", run.faces },
    { "borders", run.borders }, { "method", run.method }, { "status", run.status }, { "error", nullptr },
    { "levels", levels_of(summary) }, { "seconds", seconds_of(run) }, { "linear_solver", nullptr },
    { "repair", nullptr }, { "peak_memory_bytes", peak_memory_bytes() }, { "quality", nullptr } };
  if (!run.error.empty())
    report["error"] = run.error;
  if (run.atlas)
    report["atlas"] = atlas_of(run);
  if (summary.linear_solver.right_sides > 0)
    report["linear_solver"] = json_of(summary.linear_solver);
  if (summary.flips > 0)
    report["repair"] = { { "flips_before", summary.flips },
                         { "moved_vertices", summary.moved_vertices },
                         { "is_replaced", summary.is_replaced } };
  if (run.quality)
    report["quality"] = json_of(*run.quality);
  return report.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}
