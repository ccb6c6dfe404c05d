// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_CHART_PART_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_CHART_PART_H

#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/seam_paths.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A chart, or a part of one.
struct Chart_part
{
  std::vector<Index> faces;                 // of the atlas's mesh, in increasing order
  Corner_mesh mesh;
  std::vector<Point_2> uv;

  // The mean symmetric Dirichlet energy of its map.
  double distortion() const
  {
    double energy = 0, area = 0;
    for (Index h = 0; h < mesh.number_of_halfedges(); h += 3) {
      const Index v = mesh.vertex[h], a = mesh.vertex[h + 1], b = mesh.vertex[h + 2];
      const Rest_corner rest = rest_corner(mesh.points[v], mesh.points[a], mesh.points[b]);
      const double weight = 1 / rest.inverse_area;
      area += weight;
      energy += weight * Symmetric_Dirichlet_energy_2::value(rest.squared_frobenius_norm(uv[v], uv[a], uv[b]),
                                                             rest.determinant(uv[v], uv[a], uv[b]));
    }
    return energy / area;
  }

  // The halfedge of the atlas's mesh that a halfedge of the part is.
  Index halfedge_of_atlas(Index h) const { return 3 * faces[h / 3] + h % 3; }
};

// What a cut along halfedges leaves: its sides, or the whole part if it does not divide it.
inline std::vector<Chart_part> sides_of(const Chart_part& part, const std::vector<Index>& cut)
{
  Corner_mesh mesh = part.mesh;
  const std::vector<Index> old_vertices = sever(mesh, cut);
  std::vector<Index> scratch(mesh.number_of_vertices(), no_index);
  std::vector<Chart_part> sides;
  for (const std::vector<Index>& faces : connected_components(mesh)) {
    Chart_part& side = sides.emplace_back();
    side.mesh = component_of(mesh, faces, scratch);
    for (const Index f : faces)
      side.faces.push_back(part.faces[f]);
    for (const Index v : vertices_of(mesh, faces))
      side.uv.push_back(part.uv[old_vertices[v]]);
  }
  return sides;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_CHART_PART_H
