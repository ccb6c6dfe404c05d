// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/cut/Extremity_search.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/cut_component.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/handle_cut.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/seam_paths.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void settle_borders(Corner_mesh& mesh, const Cut_options& options)
{
  open_short_borders(mesh);
  if (options.joins_borders)
    join_borders(mesh);
}

// The length of all borders, as a part of that of a circle whose area is the surface's.
inline double relative_length_of_borders(const Corner_mesh& mesh)
{
  double length_of_borders = 0, area = 0;
  for (Index h = 0; h < mesh.number_of_halfedges(); ++h) {
    if (mesh.is_border(h))
      length_of_borders += length(mesh, h);
    if (h % 3 == 0)
      area += 0.5 * doubled_area(mesh.points[mesh.vertex[h]], mesh.points[mesh.vertex[h + 1]],
                                 mesh.points[mesh.vertex[h + 2]]);
  }
  return length_of_borders / std::sqrt(4 * CGAL_PI * area);
}

// A mesh of disk type, and where it is to be cut.
struct Cut_candidate
{
  Corner_mesh mesh;
  Extremity_search search;
  std::vector<Index> extremities;

  Cut_candidate(Corner_mesh m, const Cut_options& options)
    : mesh(std::move(m)), search(coarsest_level(make_hierarchy(mesh, options.sample_size)), options)
  { }

  void find_extremities() { extremities = search.run(); }
};

// Cuts a mesh of disk type that exceeds a bound from extremities to its borders. Several borders are joined before if
// that is enough, as on a pipe with two open ends, or serves better than extremities alone.
inline void cut_distorted(Corner_mesh& mesh, double bound, const Cut_options& options, Component_cut& result)
{
  Cut_candidate best(std::move(mesh), options);
  if (best.search.distortion() > bound) {
    const auto is_good = [&](const Cut_candidate& c) { return c.search.distortion() <= options.distortion_bound; };
    std::optional<Cut_candidate> joined;
    if (borders(best.mesh).size() > 1) {
      Corner_mesh joined_mesh = best.mesh;
      join_borders(joined_mesh);
      joined.emplace(std::move(joined_mesh), options);
    }
    if (joined && is_good(*joined))
      best = std::move(*joined);
    else {
      best.find_extremities();
      if (joined && !is_good(best)) {
        joined->find_extremities();
        if (joined->search.distortion() < best.search.distortion())
          best = std::move(*joined);
      }
    }
    cut_branches(best.mesh, best.extremities);
  }
  result.branches = best.extremities.size();
  result.distortion = best.search.distortion();
  mesh = std::move(best.mesh);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Component_cut cut_component(Corner_mesh& mesh, const Cut_options& options)
{
  Component_cut result;
  result.faces = mesh.number_of_faces();
  result.genus = genus(mesh);
  result.borders = borders(mesh).size();
  std::vector<Index> seam = handle_cut(mesh);
  if (seam.empty() && result.borders == 0)
    seam = long_path(mesh);
  const bool was_disk = seam.empty();
  sever(mesh, seam);
  settle_borders(mesh, options);
  const double bound = was_disk ? options.bound_of_disks : options.distortion_bound;
  const bool may_exceed = !was_disk || options.measures_all_disks ||
                          relative_length_of_borders(mesh) < options.least_length_of_border;
  if (may_exceed && std::isfinite(bound))
    cut_distorted(mesh, bound, options, result);
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_IMPL_H
