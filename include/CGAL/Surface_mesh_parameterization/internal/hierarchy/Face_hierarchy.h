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

// What becomes of the triangles on the way down a hierarchy. Faces get ranks as vertices do: first those of level 0,
// then those that vanish with each split.
struct Face_hierarchy
{
  std::vector<Index_triangle> last_triangle;      // by rank: as they were just before they vanished, or on level 0
  std::vector<Index> input_face;                  // by rank
  std::vector<Index> first_face;                  // of level 0, and of every split; one more ends the last range
  std::vector<Index> first_fan_face;              // of every split, in fan_faces; likewise
  std::vector<Index> fan_faces;                   // the ranks of those that W0 takes over from V

  Face_hierarchy() = default;

  // `triangles`: those of the input, in the input's vertices
  Face_hierarchy(const Vertex_hierarchy& vertices, std::vector<Index_triangle> triangles)
  {
    const std::vector<Index> vertex_rank = vertices.ranks();
    std::vector<Index> place(triangles.size());       // 0 on level 0, else one more than the split
    first_face.assign(vertices.splits.size() + 2, 0);
    first_fan_face.assign(vertices.splits.size() + 1, 0);
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      Index_triangle& t = triangles[f];
      t = { vertex_rank[t[0]], vertex_rank[t[1]], vertex_rank[t[2]] };
      place[f] = walk_down(vertices, t, [&](Index split) { ++first_fan_face[split + 1]; }).place;
      ++first_face[place[f] + 1];
    }
    std::partial_sum(first_face.begin(), first_face.end(), first_face.begin());
    std::partial_sum(first_fan_face.begin(), first_fan_face.end(), first_fan_face.begin());

    last_triangle.resize(triangles.size());
    input_face.resize(triangles.size());
    fan_faces.resize(first_fan_face.back());
    std::vector<Index> next_face = first_face, next_fan_face = first_fan_face;
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      const Index rank = next_face[place[f]]++;
      input_face[rank] = Index(f);
      last_triangle[rank] =
          walk_down(vertices, triangles[f], [&](Index split) { fan_faces[next_fan_face[split]++] = rank; }).triangle;
    }
  }

private:
  struct Last_state { Index_triangle triangle; Index place; };

  // A triangle's corner of the greatest rank is the next to be removed: either W0 takes it over, or W0 is a corner
  // already, and the triangle vanishes.
  template <class Function>
  static Last_state walk_down(const Vertex_hierarchy& vertices, Index_triangle t, const Function& be_taken_over)
  {
    const Index coarsest_vertices = Index(vertices.level_vertices.front());
    for (;;) {
      const Index v = (std::max)((std::max)(t[0], t[1]), t[2]);
      if (v < coarsest_vertices)
        return { t, 0 };
      const Index split = v - coarsest_vertices, w0 = vertices.splits[split].parent[0];
      const int corners_at_w0 =
          (t[0] == w0) + (t[1] == w0) + (t[2] == w0);      // with one branch: which corner it is cannot be foreseen
      if (corners_at_w0 > 0)
        return { t, split + 1 };
      be_taken_over(split);
      replace_corner(t, v, w0);
    }
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_FACE_HIERARCHY_H
