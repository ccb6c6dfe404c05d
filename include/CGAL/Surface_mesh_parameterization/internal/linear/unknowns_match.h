// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_UNKNOWNS_MATCH_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_UNKNOWNS_MATCH_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Whether the unknowns of a matrix sit where a hierarchy needs them. The vertices that come with the finest level are
// interpolated from neighbors of theirs. A matrix on the mesh couples most of them with these, and next to none if its
// unknowns sit elsewhere.
inline bool unknowns_match(const Hierarchy_interpolation& hierarchy, const Sparse_rows<double>& rows,
                           const std::vector<Mesh_unknown>& unknowns)
{
  if (unknowns.size() != rows.number_of_rows())
    return false;
  std::vector<bool> has_unknown(hierarchy.number_of_vertices(), false);
  for (const Mesh_unknown& unknown : unknowns)
    if (unknown.vertex != no_index)
      has_unknown[unknown.vertex] = true;
  const auto has_entry = [&rows](Index row, const auto& is_it) {
    bool result = false;
    rows.for_each_entry(row, [&](Index column, double value) { result = result || is_it(column, value); });
    return result;
  };
  const std::size_t levels = hierarchy.number_of_levels();
  const std::size_t coarse_vertices = hierarchy.number_of_vertices(levels < 2 ? 0 : levels - 2);
  std::size_t expected = 0, found = 0;
  for (Index i = 0; i < rows.number_of_rows(); ++i) {
    const bool is_given = !has_entry(i, [i](Index column, double value) { return column != i && value != 0; });
    const Index v = unknowns[i].vertex;
    if (v == no_index && !is_given)
      return false;
    if (is_given || v < coarse_vertices)
      continue;
    for (const Index parent : hierarchy.parent_triangle(v))
      if (has_unknown[parent]) {
        ++expected;
        found += has_entry(i, [&](Index column, double) { return unknowns[column].vertex == parent; });
      }
  }
  return 2 * found >= expected;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_UNKNOWNS_MATCH_H
