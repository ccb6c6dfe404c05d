// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_HANDLE_CUT_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_HANDLE_CUT_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_watch.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Shortest_paths.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/handle_cut.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// The edges that neither a tree of shortest paths nor a spanning tree of the faces has: two for each handle. The faces
// are joined across the edges that close the longest loops, so that those of the shortest remain.
inline std::vector<Index> closing_edges(const Corner_mesh& mesh, const Shortest_paths& paths)
{
  const auto is_in_tree = [&](Index h) {
    return paths.last_halfedge(paths.place(mesh.target(h))) == h;
  };
  std::vector<std::pair<double, Index>> edges;
  for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if (const Index o = mesh.opposite[h]; !mesh.is_border(h) && h < o && !is_in_tree(h) && !is_in_tree(o))
      edges.emplace_back(paths.distance(paths.place(mesh.source(h))) + paths.distance(paths.place(mesh.target(h))) +
                             length(mesh, h),
                         h);
  std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  Disjoint_sets parts(mesh.number_of_faces());
  std::vector<Index> result;
  for (const auto& [unused_length, h] : edges)
    if (!parts.unite(h / 3, mesh.opposite[h] / 3))
      result.push_back(h);
  return result;
}

// Removes the edges that lead nowhere: to a place of one edge that is no border.
inline std::vector<Index> without_dead_ends(const Corner_mesh& mesh, const Shortest_paths& paths,
                                            const std::vector<Index>& edges)
{
  const Compressed_lists<Index> edges_at(paths.number_of_places(), [&](const auto& add) {
    for (Index i = 0; i < edges.size(); ++i) {
      add(paths.place(mesh.source(edges[i])), i);
      add(paths.place(mesh.target(edges[i])), i);
    }
  });
  std::vector<Index> degree, dead_ends;
  for (Index place = 0; place < paths.number_of_places(); ++place) {
    degree.push_back(Index(edges_at[place].size()));
    if (degree[place] == 1 && !paths.is_border(place))
      dead_ends.push_back(place);
  }
  std::vector<bool> is_removed(edges.size(), false);
  while (!dead_ends.empty()) {
    const Index place = dead_ends.back();
    dead_ends.pop_back();
    for (const Index i : edges_at[place])
      if (!is_removed[i]) {
        is_removed[i] = true;
        const Index v = paths.place(mesh.source(edges[i])), other = v == place ? paths.place(mesh.target(edges[i])) : v;
        if (--degree[other] == 1 && !paths.is_border(other))
          dead_ends.push_back(other);
      }
  }
  std::vector<Index> result;
  for (Index i = 0; i < edges.size(); ++i)
    if (!is_removed[i])
      result.push_back(edges[i]);
  return result;
}

// The closing edges with the paths to their ends. These are those of a tree: what lies before an edge that one of them
// shares with an earlier one is there already.
inline std::vector<Index> system_of_loops(const Corner_mesh& mesh, const Shortest_paths& paths)
{
  std::vector<bool> is_taken(mesh.number_of_halfedges(), false);
  std::vector<Index> result;
  for (const Index edge : closing_edges(mesh, paths)) {
    result.push_back(edge);
    for (const Index end : { mesh.source(edge), mesh.target(edge) }) {
      Index h = paths.last_halfedge(paths.place(end));
      while (h != no_index && !is_taken[h]) {
        is_taken[h] = true;
        result.push_back(h);
        h = paths.last_halfedge(paths.place(mesh.source(h)));
      }
    }
  }
  return without_dead_ends(mesh, paths, result);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Index> handle_cut(const Corner_mesh& mesh, Run_watch* watch)
{
  constexpr int most_roots = 4;
  if (genus(mesh) == 0)
    return {};
  std::vector<Index> best;
  double least_length = (std::numeric_limits<double>::infinity)();
  Index root = 0;      // then what is farthest from the last root
  for (int i = 0; i < most_roots && (i == 0 || goes_on(watch)); ++i) {
    Shortest_paths paths(mesh);
    paths.add_sources({ root });
    std::vector<Index> loops = system_of_loops(mesh, paths);
    if (const double other_length = length(mesh, loops); i == 0 || other_length < least_length) {
      least_length = other_length;
      best.swap(loops);
    }
    root = paths.farthest();
  }
  return best;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_HANDLE_CUT_IMPL_H
