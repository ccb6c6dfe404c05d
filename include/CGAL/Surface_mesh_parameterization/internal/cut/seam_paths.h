// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_SEAM_PATHS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_SEAM_PATHS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Shortest_paths.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Cuts along edges. Returns what was the number of each vertex before.
inline std::vector<Index> sever(Corner_mesh& mesh, const std::vector<Index>& halfedges)
{
  for (const Index h : halfedges)
    mesh.sever(h);
  return split_vertices(mesh);
}

// Of a sphere: a path of at least two edges between two places that are far from each other.
inline std::vector<Index> long_path(const Corner_mesh& mesh)
{
  Shortest_paths from_any(mesh);
  from_any.add_sources({ 0 });
  Shortest_paths paths(mesh);
  paths.add_sources({ from_any.farthest() });
  std::vector<Index> path = paths.path_to(paths.farthest());
  if (path.empty())                         // all points coincide
    path.push_back(0);
  if (path.size() == 1)
    path.push_back(Corner_mesh::next(path.front()));
  return path;
}

// Cuts one more edge at each border of two edges, whose ends are the same: what knows triangles by their vertices takes
// such a border for an edge. Not at one that another one's edge has met: cuts that close up would part the surface.
inline void open_short_borders(Corner_mesh& mesh)
{
  const std::vector<std::vector<Index>> all_borders = borders(mesh);
  Disjoint_sets joined(mesh.number_of_vertices());
  for (const std::vector<Index>& border : all_borders)
    for (const Index h : border)
      joined.unite(mesh.source(h), mesh.target(h));
  std::vector<Index> seam;
  for (const std::vector<Index>& border : all_borders) {
    const Index h = Corner_mesh::next(border[0]);
    if (border.size() == 2 && joined.unite(mesh.source(h), mesh.target(h)))
      seam.push_back(h);
  }
  sever(mesh, seam);
}

// The shortest paths from all borders.
inline Shortest_paths paths_from_borders(const Corner_mesh& mesh)
{
  Shortest_paths paths(mesh);
  std::vector<Index> borders;
  for (Index place = 0; place < paths.number_of_places() && paths.is_border(place); ++place)
    borders.push_back(place);
  paths.add_sources(borders);
  return paths;
}

// Of each place, the source at the end of the shortest path.
inline std::vector<Index> nearest_sources(const Shortest_paths& paths, const Corner_mesh& mesh)
{
  std::vector<Index> result(paths.number_of_places(), no_index), path;
  for (Index start = 0; start < paths.number_of_places(); ++start) {
    path.clear();
    Index place = start;
    for (; result[place] == no_index && paths.last_halfedge(place) != no_index;
         place = paths.place(mesh.source(paths.last_halfedge(place))))
      path.push_back(place);
    const Index source = result[place] == no_index ? place : result[place];
    result[place] = source;
    for (const Index p : path)
      result[p] = source;
  }
  return result;
}

// Joins all borders along a shortest spanning tree: each of its paths crosses an edge between the regions of places
// that two borders are nearest to.
inline void join_borders(Corner_mesh& mesh)
{
  const Shortest_paths paths = paths_from_borders(mesh);
  const std::vector<Index> sources = nearest_sources(paths, mesh);
  std::vector<std::pair<double, Index>> crossings;
  for (Index h = 0; h < mesh.number_of_halfedges(); ++h) {
    const Index v = paths.place(mesh.source(h)), w = paths.place(mesh.target(h));
    if (!mesh.is_border(h) && h < mesh.opposite[h] && sources[v] != sources[w])
      crossings.emplace_back(paths.distance(v) + length(mesh, h) + paths.distance(w), h);
  }
  std::sort(crossings.begin(), crossings.end());
  Disjoint_sets parts(paths.number_of_places());
  std::vector<Index> seam;
  for (const auto& [unused_length, h] : crossings) {
    const Index v = paths.place(mesh.source(h)), w = paths.place(mesh.target(h));
    if (!parts.unite(sources[v], sources[w]))
      continue;
    seam.push_back(h);
    for (const Index end : { v, w }) {
      const std::vector<Index> path = paths.path_to(end);
      seam.insert(seam.end(), path.begin(), path.end());
    }
  }
  sever(mesh, seam);
}

// Cuts a mesh of disk type from extremities to the border, or to the branch before.
inline void cut_branches(Corner_mesh& mesh, const std::vector<Index>& extremities)
{
  Shortest_paths paths = paths_from_borders(mesh);
  std::vector<Index> branches;
  for (const Index v : extremities) {
    const std::vector<Index> path = paths.path_to(paths.place(v));
    std::vector<Index> places;
    for (const Index h : path)
      places.push_back(paths.place(mesh.target(h)));
    paths.add_sources(places);
    branches.insert(branches.end(), path.begin(), path.end());
  }
  sever(mesh, branches);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_SEAM_PATHS_H
