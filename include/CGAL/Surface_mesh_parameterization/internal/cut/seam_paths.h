// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_SEAM_PATHS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_SEAM_PATHS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Shortest_paths.h>

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
  if (path.size() == 1)
    path.push_back(Corner_mesh::next(path.front()));
  return path;
}

// Joins all borders by short paths.
inline void join_borders(Corner_mesh& mesh)
{
  Shortest_paths paths(mesh);
  paths.add_sources({ 0 });        // the borders are the first places
  std::vector<Index> seam;
  for (Index place = 1; place < paths.number_of_places() && paths.is_border(place); ++place) {
    const std::vector<Index> path = paths.path_to(place);
    std::vector<Index> places(1, place);
    for (const Index h : path)
      places.push_back(paths.place(mesh.source(h)));
    paths.add_sources(places);
    seam.insert(seam.end(), path.begin(), path.end());
  }
  sever(mesh, seam);
}

// The places of all borders.
inline std::vector<Index> border_places(const Shortest_paths& paths)
{
  std::vector<Index> places;
  for (Index place = 0; place < paths.number_of_places() && paths.is_border(place); ++place)
    places.push_back(place);
  return places;
}

// Cuts a mesh of disk type from extremities to the border, or to the branch before.
inline void cut_branches(Corner_mesh& mesh, const std::vector<Index>& extremities)
{
  Shortest_paths paths(mesh);
  paths.add_sources(border_places(paths));
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
