// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seams along sharp edges.

#include "sharp_edges.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>

#include <algorithm>
#include <cstddef>

namespace {

Mesh::Edge_index longest_edge(const Mesh& mesh, Mesh::Face_index f)
{
  const auto squared_length = [&](Mesh::Halfedge_index h) {
    return CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  };
  const auto halfedges = mesh.halfedges_around_face(mesh.halfedge(f));
  return mesh.edge(*std::max_element(halfedges.begin(), halfedges.end(),
                                     [&](Mesh::Halfedge_index g, Mesh::Halfedge_index h) {
                                       return squared_length(g) < squared_length(h);
                                     }));
}

} // namespace

void part_at_sharp_edges(Mesh& mesh, double angle, Seam_map seams)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  PMP::detect_sharp_edges(mesh, angle, seams);
  // A face without area has no normal: it belongs to what lies beyond its longest edge.
  for (const Mesh::Face_index f : mesh.faces())
    if (PMP::is_degenerate_triangle_face(f, mesh))
      seams[longest_edge(mesh, f)] = false;

  const auto region = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region").first;
  PMP::connected_components(mesh, region, CGAL::parameters::edge_is_constrained_map(seams));
  for (const Mesh::Edge_index e : mesh.edges())
    seams[e] = !mesh.is_border(e) && region[mesh.face(mesh.halfedge(e, 0))] != region[mesh.face(mesh.halfedge(e, 1))];
}
