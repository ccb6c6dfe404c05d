// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_FACE_HIERARCHY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_FACE_HIERARCHY_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Vertex_hierarchy.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The triangles of a hierarchy. Faces get ranks as vertices do: first those of level 0, then those that vanish with
// each split. Only the input's are stored: on the way down a corner that is removed becomes the vertex that it
// collapses onto.
struct Face_hierarchy
{
  std::vector<Index_triangle> triangles;      // by rank, those of the input
  std::vector<Index> input_face;              // by rank
  std::vector<Index> first_face;              // of level 0, and of every split; one more ends the last range

  Face_hierarchy() = default;

  // `input`: the triangles in the input's order and vertices
  Face_hierarchy(const Vertex_hierarchy& vertices, std::vector<Index_triangle> input)
  {
    const std::vector<Index> vertex_rank = vertices.ranks();
    std::vector<Index> place(input.size());
    first_face.assign(vertices.splits.size() + 2, 0);
    for (std::size_t f = 0; f < input.size(); ++f) {
      Index_triangle& t = input[f];
      t = { vertex_rank[t[0]], vertex_rank[t[1]], vertex_rank[t[2]] };
      place[f] = place_of(vertices, t);
      ++first_face[place[f] + 1];
    }
    std::partial_sum(first_face.begin(), first_face.end(), first_face.begin());

    triangles.resize(input.size());
    input_face.resize(input.size());
    std::vector<Index> next_face = first_face;
    for (std::size_t f = 0; f < input.size(); ++f) {
      const Index rank = next_face[place[f]]++;
      input_face[rank] = Index(f);
      triangles[rank] = input[f];
    }
  }

private:
  // With which split a triangle comes back, plus one; 0 on level 0. Its corner of the greatest rank is the next to be
  // removed: either W0 takes it over, or W0 is a corner already, and the triangle vanishes.
  static Index place_of(const Vertex_hierarchy& vertices, Index_triangle t)
  {
    const Index coarsest_vertices = Index(vertices.level_vertices.front());
    for (;;) {
      const Index v = (std::max)((std::max)(t[0], t[1]), t[2]);
      if (v < coarsest_vertices)
        return 0;
      const Index split = v - coarsest_vertices, w0 = vertices.splits[split].parent[0];
      // With one branch: which corner it is cannot be foreseen.
      const int corners_at_w0 = (t[0] == w0) + (t[1] == w0) + (t[2] == w0);
      if (corners_at_w0 > 0)
        return split + 1;
      replace_corner(t, v, w0);
    }
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_FACE_HIERARCHY_H
