// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_HANDLE_CUT_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_HANDLE_CUT_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/cut/Shortest_paths.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/handle_cut.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
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
  boost::disjoint_sets_with_storage<> parts(mesh.number_of_faces());
  std::vector<Index> result;
  for (const auto& edge : edges) {
    const std::size_t f = parts.find_set(edge.second / 3), g = parts.find_set(mesh.opposite[edge.second] / 3);
    if (f != g)
      parts.link(f, g);
    else
      result.push_back(edge.second);
  }
  return result;
}

// Removes the edges that lead nowhere: to a place of one edge that is no border.
inline std::vector<Index> without_dead_ends(const Corner_mesh& mesh, const Shortest_paths& paths,
                                            std::vector<Index> edges)
{
  std::vector<Index> degree(paths.number_of_places(), 0);
  const auto ends = [&](Index h) {
    return std::make_pair(paths.place(mesh.source(h)), paths.place(mesh.target(h)));
  };
  for (const Index h : edges) {
    ++degree[ends(h).first];
    ++degree[ends(h).second];
  }
  const auto is_dead_end = [&](Index place) { return degree[place] == 1 && !paths.is_border(place); };
  std::size_t old_size;
  do {
    old_size = edges.size();
    edges.erase(std::remove_if(edges.begin(), edges.end(), [&](Index h) {
                  const auto [a, b] = ends(h);
                  const bool is_removed = is_dead_end(a) || is_dead_end(b);
                  degree[a] -= is_removed;
                  degree[b] -= is_removed;
                  return is_removed;
                }), edges.end());
  } while (edges.size() < old_size);
  return edges;
}

inline std::vector<Index> system_of_loops(const Corner_mesh& mesh, const Shortest_paths& paths)
{
  std::vector<bool> is_taken(mesh.number_of_halfedges(), false);
  std::vector<Index> result;
  const auto take = [&](Index h) {
    if (!is_taken[h])
      result.push_back(h);
    is_taken[h] = true;
  };
  for (const Index edge : closing_edges(mesh, paths)) {
    take(edge);
    for (const Index end : { mesh.source(edge), mesh.target(edge) })
      for (const Index h : paths.path_to(paths.place(end)))
        take(h);
  }
  return without_dead_ends(mesh, paths, std::move(result));
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Index> handle_cut(const Corner_mesh& mesh)
{
  constexpr int most_roots = 4;
  if (genus(mesh) == 0)
    return {};
  std::vector<Index> best;
  double least_length = (std::numeric_limits<double>::infinity)();
  Index root = 0;      // then what is farthest from the last root
  for (int i = 0; i < most_roots; ++i) {
    Shortest_paths paths(mesh);
    paths.add_sources({ root });
    std::vector<Index> loops = system_of_loops(mesh, paths);
    if (const double other_length = length(mesh, loops); !(other_length >= least_length)) {
      least_length = other_length;
      best.swap(loops);
    }
    root = paths.farthest();
  }
  return best;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_HANDLE_CUT_IMPL_H
