// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CORNER_MESH_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CORNER_MESH_H

#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Triangles and what they share, as flat arrays, so that a cut only severs halfedges:
//
//                       corner 3f+2
//                        /     \                  The halfedge 3f+i leads to the corner 3f+i of the triangle f, from
//     halfedge 3f+2     /       \   halfedge      the corner before it.
//     leads up         /    f    \  3f leads down
//                     /           \               .
//           corner 3f+1 --------- corner 3f
//
// Any number of components, with borders and handles. Every vertex has one fan of triangles, and vertices are numbered
// as the corners meet them.
struct Corner_mesh
{
  std::vector<Point_3> points;          // of the vertices: the user's, times 2 to the power of the exponent
  int scale_exponent = 0;
  std::vector<Index> vertex;            // of each corner
  std::vector<Index> opposite;          // of each halfedge; `no_index` on a border

  std::size_t number_of_vertices() const { return points.size(); }
  Index number_of_faces() const { return Index(vertex.size() / 3); }
  Index number_of_halfedges() const { return Index(vertex.size()); }

  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  bool is_border(Index h) const { return opposite[h] == no_index; }
  Index target(Index h) const { return vertex[h]; }
  Index source(Index h) const { return vertex[previous(h)]; }

  // Makes both sides of an edge border. split_vertices() has to follow.
  void sever(Index h)
  {
    if (!is_border(h))
      opposite[opposite[h]] = no_index;
    opposite[h] = no_index;
  }
};

// Scales the points by a power of two, to about size 1.
void normalize(Corner_mesh& mesh);

// The length of an edge in space, and of several.
double length(const Corner_mesh& mesh, Index h);
double length(const Corner_mesh& mesh, const std::vector<Index>& halfedges);
double length_of_borders(const Corner_mesh& mesh);

// The length of an edge of the user's mesh.
double user_length(const Corner_mesh& mesh, Index h);

// Edges along which a surface is severed.
struct Seam
{
  std::size_t edges = 0;
  double length = 0;            // in the user's units

  void add(const Corner_mesh& mesh, Index h)
  {
    ++edges;
    length += user_length(mesh, h);
  }
};

double area_of_face(const Corner_mesh& mesh, Index f);

// Renumbers the vertices, so that each has one fan of triangles and they are in order. Returns what was the number of
// each before.
std::vector<Index> split_vertices(Corner_mesh& mesh);

// The faces of each connected component, in increasing order.
std::vector<std::vector<Index>> connected_components(const Corner_mesh& mesh);

// Some faces of a mesh, in increasing order, whose neighbors are all among them, as a mesh of its own. Faces, corners
// and vertices keep their order. The scratch has an element `no_index` for each vertex of `mesh`, before and after.
Corner_mesh component_of(const Corner_mesh& mesh, const std::vector<Index>& faces, std::vector<Index>& scratch);

// The borders as cycles of halfedges, with the surface to their left.
std::vector<std::vector<Index>> borders(const Corner_mesh& mesh);

// The vertices of each face.
std::vector<Index_triangle> triangles_of(const Corner_mesh& mesh);

// A connected mesh as hierarchies take it; its longest border is the outer one.
Triangulated_surface_3 surface_of(const Corner_mesh& mesh);

// Of a connected mesh, with every border closed by a disk: the number of handles.
std::size_t genus(const Corner_mesh& mesh);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CORNER_MESH_H
