// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes and checks the map of an input.

#include "lay_out.h"

#include "components.h"
#include "counted.h"
#include "errors.h"
#include "held_vertices.h"
#include "input.h"
#include "sharp_edges.h"

#include <CGAL/Surface_mesh_parameterization/atlas_quality.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace {

// The advice is what the user has not tried.
std::string flips_message(std::size_t flips, SMP::Flip_policy policy)
{
  return "the map has " + counted(flips, "triangle") + " flipped" +
         (policy == SMP::Flip_policy::FAIL ? "; --flips repair or keep" : " that cannot be repaired; --flips keep");
}

Method_error error_of(const SMP::Parameterization_summary& summary, const Options& options)
{
  const bool is_flipped = summary.error.code == SMP::ERROR_NO_1_TO_1_MAPPING && summary.flips > 0;
  return { is_flipped ? flips_message(summary.flips, options.flip_policy) : SMP::error_message(summary.error),
           summary.error.code };
}

// What a map must be, whatever it looks like.
struct Promises
{
  bool has_no_flips, has_no_overlaps, is_not_mirrored;
};

void check_quality(const SMP::Parameterization_quality& quality, const Promises& promises)
{
  if (quality.is_mirrored && promises.is_not_mirrored)
    throw Method_error{ "the map is mirrored", SMP::ERROR_NO_1_TO_1_MAPPING };
  if (quality.flips > 0 && promises.has_no_flips)
    throw Method_error{ "no map without flips was found: " +
                            counted(quality.flips, "triangle is", "triangles are") + " not positive",
                        SMP::ERROR_NO_1_TO_1_MAPPING };
  if (quality.overlaps > 0 && promises.has_no_overlaps)
    throw Method_error{ "no map without overlaps was found: " +
                            counted(quality.overlaps, "pair of triangles overlaps", "pairs of triangles overlap"),
                        SMP::ERROR_NO_1_TO_1_MAPPING };
}

void lay_out_chart(Input& input, const Options& options, Run_record& run)
{
  input.uvmap = input.mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  input.is_held = input.mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_held", false).first;
  if (!options.start.empty())
    read_start(options.start, input);
  if (!options.hold.empty())
    read_held_vertices(options.hold, input);
  const bool is_shipped = options.flat && options.method->run_shipped;
  run.summary = (is_shipped ? options.method->run_shipped : options.method->run)(input, options);
  if (!run.summary.is_ok())
    throw error_of(run.summary, options);
  const SMP::Parameterization_quality quality = SMP::parameterization_quality(input.mesh, input.faces, input.uvmap);
  const bool is_flip_free = options.method->is_flip_free;
  check_quality(quality, { is_flip_free, options.is_globally_injective, is_flip_free && options.hold.empty() });
  run.quality = quality;
}

Corner_map add_corner_map(Mesh& mesh)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv", Kernel::Point_2(none, none)).first;
}

SMP::Atlas_summary atlas_with_sharp_seams(Mesh& mesh, Corner_map corner_map, const Options& options)
{
  const Seam_map seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  if (options.sharp_angle)
    part_at_sharp_edges(mesh, *options.sharp_angle, seams);
  SMP::Atlas_summary atlas = options.method->run_atlas({ mesh, seams, corner_map }, options);
  for (const Mesh::Edge_index e : mesh.edges())
    if (seams[e]) {
      ++atlas.cut.seam_edges;
      atlas.cut.seam_length += CGAL::Polygon_mesh_processing::edge_length(e, mesh);
    }
  return atlas;
}

// Runs the method on the faces of the input. The faces of errors are those of the mesh.
SMP::Atlas_summary atlas_of_chosen_faces(Input& input, const Options& options)
{
  input.corner_map = add_corner_map(input.mesh);
  if (input.faces.size() == input.mesh.number_of_faces())
    return atlas_with_sharp_seams(input.mesh, input.corner_map, options);
  Mesh part = mesh_of(input.mesh, input.faces);
  const Corner_map corner_map = add_corner_map(part);
  SMP::Atlas_summary atlas = atlas_with_sharp_seams(part, corner_map, options);
  for (std::size_t i = 0; i < input.faces.size(); ++i) {
    Mesh::Halfedge_index h = input.mesh.halfedge(input.faces[i]);
    const Mesh::Face_index f = Mesh::Face_index(Mesh::size_type(i));
    for (const Mesh::Halfedge_index k : part.halfedges_around_face(part.halfedge(f))) {
      input.corner_map[h] = corner_map[k];
      h = input.mesh.next(h);
    }
  }
  for (SMP::Atlas_summary::Chart& chart : atlas.charts)
    if (chart.summary.error.place == SMP::Parameterization_error::FACE)
      chart.summary.error.index = input.faces[chart.summary.error.index];
  return atlas;
}

// Of all charts that have a map: the levels and the linear solver are those of the chart with the most triangles, as it
// was laid out, and the map is replaced if that of any chart is.
SMP::Parameterization_summary summary_of(const SMP::Atlas_summary& atlas)
{
  SMP::Parameterization_summary result;
  std::size_t most_faces = 0;
  double seconds_hierarchy = 0;
  std::size_t flips = 0, moved_vertices = 0;
  bool converged = true, is_replaced = false;
  for (const SMP::Atlas_summary::Chart& chart : atlas.charts) {
    if (!chart.summary.is_ok())
      continue;
    const std::size_t faces = chart.summary.levels.empty() ? chart.faces : chart.summary.levels.back().faces;
    if (faces > most_faces) {
      most_faces = faces;
      result = chart.summary;
    }
    seconds_hierarchy += chart.summary.seconds_hierarchy;
    flips += chart.summary.flips;
    moved_vertices += chart.summary.moved_vertices;
    converged = converged && chart.summary.converged;
    is_replaced = is_replaced || chart.summary.is_replaced;
  }
  result.seconds_hierarchy = seconds_hierarchy;
  result.seconds_parameterize = atlas.seconds_parameterize;
  result.flips = flips;
  result.moved_vertices = moved_vertices;
  result.converged = converged;
  result.is_replaced = is_replaced;
  return result;
}

std::vector<const SMP::Atlas_summary::Chart*> charts_without_map(const SMP::Atlas_summary& atlas)
{
  std::vector<const SMP::Atlas_summary::Chart*> charts;
  for (const SMP::Atlas_summary::Chart& chart : atlas.charts)
    if (!chart.summary.is_ok())
      charts.push_back(&chart);
  return charts;
}

void lay_out_atlas(Input& input, const Options& options, Run_record& run)
{
  run.atlas = atlas_of_chosen_faces(input, options);
  const auto has_no_map = [&](Mesh::Face_index f) {
    return !std::isfinite(input.corner_map[input.mesh.halfedge(f)].x());
  };
  input.faces.erase(std::remove_if(input.faces.begin(), input.faces.end(), has_no_map), input.faces.end());
  const auto failed = charts_without_map(*run.atlas);
  if (input.faces.empty())
    throw failed.empty() ? Method_error{ SMP::error_message(run.atlas->error), run.atlas->error.code }
                         : error_of(failed.front()->summary, options);
  run.summary = summary_of(*run.atlas);
  const SMP::Parameterization_quality quality = SMP::atlas_quality(input.mesh, input.faces, input.corner_map);
  const bool is_flip_free = options.method->is_flip_free;
  check_quality(quality, { is_flip_free, is_flip_free, is_flip_free });
  run.quality = quality;
}

// An atlas takes the place of a chart that lies over itself.
void give_up_chart(Input& input, Run_record& run)
{
  run.overlaps_of_one_chart = run.quality->overlaps;
  run.seconds_one_chart = run.seconds_of_map();
  run.quality.reset();
  run.summary = SMP::Parameterization_summary();
  input.mesh.remove_property_map(input.uvmap);
  input.mesh.remove_property_map(input.is_held);
  input.is_atlas = true;
}

std::string count_text(std::size_t n, std::size_t all, const std::string& what)
{
  return std::to_string(n) + " of " + std::to_string(all) + ' ' + what;
}

} // namespace

void lay_out(Input& input, const Options& options, Run_record& run)
{
  if (!input.is_atlas) {
    lay_out_chart(input, options, run);
    if (options.avoids_overlaps && run.quality->overlaps > 0)
      give_up_chart(input, run);
  }
  if (input.is_atlas)
    lay_out_atlas(input, options, run);
  run.status = run.summary.converged ? "ok" : "not_converged";
}

void check_complete(const Input& input, const Options& options, const Run_record& run)
{
  if (!run.atlas)
    return;
  std::string message;
  if (!input.left_out.empty())
    message = count_text(input.left_out.size(), input.number_of_components, "components") +
              " are closed or have handles and were left out, first that of face " +
              std::to_string(std::size_t(input.left_out.front())) + "; --cut auto cuts them";
  const auto failed = charts_without_map(*run.atlas);
  if (!failed.empty()) {
    const Method_error first = error_of(failed.front()->summary, options);
    throw Method_error{ count_text(failed.size(), run.atlas->charts.size(), "charts") +
                            " have no map, first that of face " + std::to_string(failed.front()->summary.error.index) +
                            ": " + first.message + (message.empty() ? "" : "; ") + message,
                        first.code };
  }
  if (!message.empty())
    throw Input_error{ message, SMP::ERROR_NO_TOPOLOGICAL_DISC };
}
