// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHY_BUILDER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHY_BUILDER_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Collapse_group.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Ring_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Unit_edge_metric.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Vertex_hierarchy.h>

#include <cstddef>
#include <numeric>
#include <optional>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Builds a hierarchy group by group, on a mesh that is compacted after every group, so that coarse levels stay in the
// cache.
class Hierarchy_builder
{
public:
  Hierarchy_builder(std::vector<Point_3> points, std::vector<bool> is_pinned,
                    const std::vector<Index_triangle>& triangles, const Loops& loops)
    : m_loops(loops), m_points(std::move(points)), m_is_pinned(std::move(is_pinned)),
      m_mesh(m_points.size(), triangles, loops)
  {
    m_splits.reserve(m_points.size());
    m_removed_vertices.reserve(m_points.size());
    m_vertex.resize(m_points.size());
    std::iota(m_vertex.begin(), m_vertex.end(), Index(0));
  }

  // Makes collapse groups until the mesh is small enough or nothing can be collapsed any more.
  Vertex_hierarchy build(const Hierarchy_options& options)
  {
    constexpr std::size_t fewest_vertices = 3;
    constexpr double least_removed_part = 1. / 64;      // a group that removes less of them is not worth a level
    std::mt19937 random(options.random_seed);
    std::optional<Unit_edge_metric> metric;
    if (options.has_unit_edges)
      metric.emplace(m_points, m_mesh);
    for (;;) {
      m_level_vertices.push_back(m_points.size());
      if (m_points.size() <= options.coarsest_size || !may_go_on(options.progress))
        break;
      m_group.choose({ m_mesh, m_points, m_is_pinned, metric ? &*metric : nullptr }, fewest_vertices, random, m_loops);
      if (double(m_group.collapses().size()) <= least_removed_part * double(m_points.size()))
        break;
      perform_group();
      if (metric)
        metric->compact(m_is_removed);
    }
    metric.reset();
    release_mesh();
    return number_by_removal();
  }

private:
  // The work is about proportional to the vertices that are removed.
  bool may_go_on(Run_progress* progress) const
  {
    Parameterization_progress now;
    now.vertices = m_points.size();
    now.part_done = 1 - double(m_points.size()) / double(m_level_vertices.front());
    return !progress || progress->tell(now);
  }

  void perform_group()
  {
    m_is_removed.assign(m_points.size(), 0);
    for (const Collapse_group::Collapse& c : m_group.collapses()) {
      m_is_removed[c.removed_vertex] = 1;
      m_removed_vertices.push_back(m_vertex[c.removed_vertex]);
      m_splits.push_back({ { m_vertex[c.parent[0]], m_vertex[c.parent[1]], m_vertex[c.parent[2]] }, c.coordinates });
    }
    compact_vertices();
    m_mesh.collapse(m_is_removed, m_number, m_loops);
  }

  void compact_vertices()
  {
    m_number.resize(m_points.size());
    std::size_t kept = 0;
    for (std::size_t v = 0; v < m_points.size(); ++v)
      if (!m_is_removed[v]) {
        m_points[kept] = m_points[v];
        m_is_pinned[kept] = m_is_pinned[v];
        m_vertex[kept] = m_vertex[v];
        m_number[v] = Index(kept++);
      }
    m_points.resize(kept);
    m_is_pinned.resize(kept);
    m_vertex.resize(kept);
    for (const Collapse_group::Collapse& c : m_group.collapses())
      m_number[c.removed_vertex] = m_number[c.parent[0]];
  }

  // What no group needs any more, before the splits take their place twice.
  void release_mesh()
  {
    const auto release = [](auto& member) { std::decay_t<decltype(member)> released(std::move(member)); };
    release(m_mesh);
    release(m_group);
    release(m_points);
    release(m_is_removed);
    release(m_number);
  }

  // Turns the splits, finest group first, into those of the hierarchy, coarsest group first; inside a group the order
  // stays.
  Vertex_hierarchy number_by_removal()
  {
    Vertex_hierarchy result;
    result.level_vertices.assign(m_level_vertices.rbegin(), m_level_vertices.rend());
    result.input_vertex = std::move(m_vertex);
    result.input_vertex.reserve(m_level_vertices.front());
    result.splits.reserve(m_splits.size());
    std::size_t end = m_splits.size();
    for (std::size_t level = 1; level < result.level_vertices.size(); ++level) {
      const std::size_t begin = end - (result.level_vertices[level] - result.level_vertices[level - 1]);
      result.input_vertex.insert(result.input_vertex.end(), m_removed_vertices.begin() + begin,
                                 m_removed_vertices.begin() + end);
      result.splits.insert(result.splits.end(), m_splits.begin() + begin, m_splits.begin() + end);
      end = begin;
    }
    const std::vector<Index> rank = result.ranks();
    m_loops.for_each(0, Index(result.splits.size()), [&](Index i) {
      for (Index& v : result.splits[i].parent)
        v = rank[v];
    });
    return result;
  }

  Loops m_loops;

  // The mesh after the groups so far, compacted, and the input's numbers of its vertices.
  std::vector<Point_3> m_points;
  std::vector<bool> m_is_pinned;
  Ring_mesh m_mesh;
  std::vector<Index> m_vertex;

  // Finest first, in the input's numbers.
  std::vector<std::size_t> m_level_vertices;
  std::vector<Index> m_removed_vertices;
  std::vector<Vertex_split> m_splits;

  Collapse_group m_group;
  std::vector<unsigned char> m_is_removed;
  std::vector<Index> m_number;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHY_BUILDER_H
