// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_EDGE_PAIRS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_EDGE_PAIRS_H

#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/box_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The pairs of border edges that are near each other, remembered as long as each vertex stays in a box (a Verlet list):
// a step of Newton's method asks for them at several maps on its way, and a search takes longer than all else there.
class Border_edge_pairs
{
public:
  // One edge starts at each border vertex, in the order of the vertices.
  explicit Border_edge_pairs(std::vector<Border_edge> edges) : m_edges(std::move(edges)), m_next(m_edges.size())
  {
    for (std::size_t i = 0; i < m_edges.size(); ++i) {
      const auto next = std::lower_bound(m_edges.begin(), m_edges.end(), m_edges[i].target,
                                         [](const Border_edge& e, Index v) { return e.source < v; });
      m_next[i] = std::size_t(next - m_edges.begin());
    }
  }

  const std::vector<Border_edge>& edges() const { return m_edges; }

  // Calls f(i, j) for the pairs of edges whose boxes meet: each vertex v is anywhere in `box(v)`, and `reach(v)` is added
  // on all sides. Precondition: no number is infinite, or none.
  template <class Box, class Reach, class Function>
  void for_each(const Box& box, const Reach& reach, const Function& f)
  {
    m_now.clear();
    for (const Border_edge& e : m_edges)
      m_now.push_back({ box(e.source), reach(e.source) });
    const std::vector<Bbox_2> boxes = boxes_of_edges(m_now);
    if (!are_all_remembered()) {
      m_remembered = m_now;
      for (Vertex_box& b : m_remembered)
        b.reach *= spare_reach;
      remember_pairs();
    }
    if (m_are_pairs_remembered) {
      for (const auto& [i, j] : m_pairs)
        if (CGAL::do_overlap(boxes[i], boxes[j]))
          f(i, j);
    } else
      for_each_pair_of_boxes(boxes, [&](std::size_t i, std::size_t j) { f(Index(i), Index(j)); });
  }

private:
  static constexpr double spare_reach = 1.5;                // for edges that become longer
  static constexpr std::size_t most_pairs_an_edge = 32;     // more are not remembered

  struct Vertex_box
  {
    Bbox_2 box;
    double reach;
  };

  bool are_all_remembered() const
  {
    if (!m_are_pairs_remembered)
      return false;
    for (std::size_t i = 0; i < m_now.size(); ++i) {
      const Bbox_2 &outer = m_remembered[i].box, &inner = m_now[i].box;
      if (!(outer.xmin() <= inner.xmin() && outer.ymin() <= inner.ymin() && outer.xmax() >= inner.xmax() &&
            outer.ymax() >= inner.ymax() && m_remembered[i].reach >= m_now[i].reach))
        return false;
    }
    return true;
  }

  void remember_pairs()
  {
    m_pairs.clear();
    m_are_pairs_remembered = !any_pair_of_boxes(boxes_of_edges(m_remembered), [&](std::size_t i, std::size_t j) {
      m_pairs.emplace_back(Index(i), Index(j));
      return m_pairs.size() > most_pairs_an_edge * m_edges.size();
    });
  }

  std::vector<Bbox_2> boxes_of_edges(const std::vector<Vertex_box>& vertices) const
  {
    std::vector<Bbox_2> result;
    result.reserve(m_edges.size());
    for (std::size_t i = 0; i < m_edges.size(); ++i) {
      const Vertex_box &source = vertices[i], &target = vertices[m_next[i]];
      const Bbox_2 box = source.box + target.box;
      const double reach = (std::max)(source.reach, target.reach);
      result.emplace_back(box.xmin() - reach, box.ymin() - reach, box.xmax() + reach, box.ymax() + reach);
    }
    return result;
  }

  std::vector<Border_edge> m_edges;
  std::vector<std::size_t> m_next;        // the edge that starts where this one ends
  std::vector<Vertex_box> m_now, m_remembered;            // of the edges' sources
  std::vector<std::pair<Index, Index>> m_pairs;           // for the boxes remembered
  bool m_are_pairs_remembered = false;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_EDGE_PAIRS_H
