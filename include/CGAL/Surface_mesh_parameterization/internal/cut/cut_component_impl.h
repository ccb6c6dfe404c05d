// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/cut/Extremity_search.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/cut_component.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/handle_cut.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/seam_paths.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

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
  open_short_borders(mesh);
  if (options.joins_borders)
    join_borders(mesh);
  if (was_disk && !options.bounds_disks)
    return result;

  Extremity_search search(coarsest_level(make_hierarchy(mesh, options.sample_size)), options);
  const std::vector<Index> extremities = search.run();
  result.distortion = search.distortion();
  result.branches = extremities.size();
  cut_branches(mesh, extremities);
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_IMPL_H
