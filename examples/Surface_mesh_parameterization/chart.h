// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CHART_H
#define CHART_H

#include "chart_layout.h"
#include "example_utilities.h"

#include <CGAL/boost/graph/Seam_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <list>
#include <queue>
#include <utility>
#include <vector>

typedef Mesh::Property_map<Mesh::Edge_index, bool>             Seam_edge_map;
typedef Mesh::Property_map<Mesh::Vertex_index, bool>           Seam_vertex_map;
typedef CGAL::Seam_mesh<Mesh, Seam_edge_map, Seam_vertex_map>  Seam_mesh;
typedef Mesh::Property_map<Mesh::Halfedge_index, Point_2>      Seam_uv_map;       // a vertex of a seam mesh is a halfedge of the mesh

// A mesh that can be cut open, and its map.
struct Chart
{
  Mesh mesh;
  Seam_mesh seam_mesh;
  Seam_uv_map uvmap;

  explicit Chart(const Mesh& uncut)
    : mesh(uncut), seam_mesh(mesh, mesh.add_property_map<Mesh::Edge_index, bool>("e:is_seam", false).first,
                             mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_seam", false).first),
      uvmap(mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first)
  { }

  Chart(const Chart&) = delete;              // the seam mesh refers to the mesh
};

// Finds a tree of edges: the shortest path between two vertices that are far from each other, then from the vertex that
// is farthest from the tree the shortest path to it, and so on. A tree on a sphere leaves a disk.
class Seam_tree
{
  typedef Mesh::Vertex_index   Vertex;

public:
  explicit Seam_tree(const Mesh& mesh) : m_mesh(mesh)
  {
    spread({ Vertex(0) });
    const Vertex first = farthest_vertex();
    m_distance.clear();
    spread({ first });
  }

  // Halfedges along `number_of_paths` paths; more if they are fewer than two edges, which make no border that can be
  // laid out. Precondition: the mesh is connected and has at least two edges.
  std::vector<Mesh::Halfedge_index> grow(std::size_t number_of_paths)
  {
    std::vector<Mesh::Halfedge_index> tree;
    for (std::size_t i = 0; i < number_of_paths || tree.size() < 2; ++i) {
      std::vector<Vertex> path = { farthest_vertex() };
      for (; m_distance[path.back()] > 0; path.push_back(m_mesh.target(tree.back())))
        tree.push_back(m_towards_tree[path.back()]);
      if (path.size() == 1)
        break;                           // all vertices are on the tree
      spread(path);
    }
    return tree;
  }

private:
  // Dijkstra's algorithm, from the distances that there are: these vertices are on the tree now.
  void spread(const std::vector<Vertex>& vertices)
  {
    typedef std::pair<double, Vertex>   Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    m_distance.resize(m_mesh.number_of_vertices(), (std::numeric_limits<double>::infinity)());
    m_towards_tree.resize(m_mesh.number_of_vertices());
    for (const Vertex v : vertices) {
      m_distance[v] = 0;
      queue.emplace(0, v);
    }
    while (!queue.empty()) {
      const auto [distance, v] = queue.top();
      queue.pop();
      if (distance > m_distance[v])
        continue;
      for (const Mesh::Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v))) {
        const Vertex w = m_mesh.source(h);
        const double length = distance + std::sqrt(CGAL::squared_distance(m_mesh.point(v), m_mesh.point(w)));
        if (length < m_distance[w]) {
          m_distance[w] = length;
          m_towards_tree[w] = h;
          queue.emplace(length, w);
        }
      }
    }
  }

  Vertex farthest_vertex() const
  {
    return Vertex(Mesh::size_type(std::max_element(m_distance.begin(), m_distance.end()) - m_distance.begin()));
  }

  const Mesh& m_mesh;
  std::vector<double> m_distance;                         // to the tree along edges, by vertex
  std::vector<Mesh::Halfedge_index> m_towards_tree;       // of each vertex that is not on it
};

// Moves the maps of charts into the unit square, side by side, all scaled alike.
inline void lay_side_by_side(std::list<Chart>& charts)
{
  std::vector<Chart_points> points;
  for (const Chart& chart : charts) {
    points.emplace_back();
    for (const Seam_mesh::vertex_descriptor v : vertices(chart.seam_mesh))
      points.back().push_back(chart.uvmap[v]);
  }
  lay_side_by_side(points);
  auto moved = points.begin();
  for (Chart& chart : charts) {
    auto p = (moved++)->begin();
    for (const Seam_mesh::vertex_descriptor v : vertices(chart.seam_mesh))
      chart.uvmap[v] = *p++;
  }
}

#endif // CHART_H
