// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_MESH_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_MESH_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Run_watch.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/cut_mesh.h>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Component_cut> cut_mesh(Corner_mesh& mesh, const Cut_options& options, const Loops& loops)
{
  const std::vector<std::vector<Index>> components = connected_components(mesh);
  std::vector<Component_cut> result(components.size());
  const auto make_scratch = [&] { return std::vector<Index>(mesh.number_of_vertices(), no_index); };
  const auto cut = [&](Index begin, Index end, std::vector<Index>& scratch) {
    for (Index i = begin; i < end && goes_on(options.watch); ++i) {
      const std::vector<Index>& faces = components[i];
      Corner_mesh component = component_of(mesh, faces, scratch);
      result[i] = cut_component(component, options);
      for (Index h = 0; h < component.number_of_halfedges(); ++h)
        if (component.is_border(h))
          mesh.opposite[3 * faces[h / 3] + h % 3] = no_index;
      goes_on(options.watch, double(faces.size()));
    }
  };
  loops.for_each_block_with_scratch(0, Index(components.size()), make_scratch, cut, 1);
  split_vertices(mesh);
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_MESH_IMPL_H
