// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_DISTANCE_QUEUE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_DISTANCE_QUEUE_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The nodes of a graph by their distances from sources, for Dijkstra's algorithm: the nearest node is taken out, and
// its neighbors are reached from it, until none is left.
class Distance_queue
{
public:
  explicit Distance_queue(std::size_t number_of_nodes = 0)
    : m_distance(number_of_nodes, (std::numeric_limits<double>::infinity)())
  {}

  // Whether a node has come nearer. With the least distance that is left from there to a goal, nodes on the way to the
  // goal are taken out first (A*).
  bool reach(Index node, double distance, double distance_to_goal = 0)
  {
    if (!(distance < m_distance[node]))
      return false;
    m_distance[node] = distance;
    m_queue.emplace(distance + distance_to_goal, node, distance);
    return true;
  }

  // Takes out the nearest node that was reached; `no_index` if there is none.
  Index take_nearest()
  {
    while (!m_queue.empty()) {
      const auto [order, node, distance] = m_queue.top();
      m_queue.pop();
      if (distance == m_distance[node])       // else it has come nearer since
        return node;
    }
    return no_index;
  }

  // Infinite if the node was not reached.
  double distance(Index node) const { return m_distance[node]; }

  // The farthest node, the least one of several.
  Index farthest() const
  {
    return Index(std::max_element(m_distance.begin(), m_distance.end()) - m_distance.begin());
  }

private:
  typedef std::tuple<double, Index, double>   Entry;

  std::vector<double> m_distance;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_DISTANCE_QUEUE_H
