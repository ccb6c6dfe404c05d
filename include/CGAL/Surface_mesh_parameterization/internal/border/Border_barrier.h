// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_BARRIER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_BARRIER_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Contact.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/box_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/logarithmic_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/time_on_one_line.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Keeps the borders of a map from running into themselves or each other, as Smith and Schaefer (2015) do: by an energy
// that grows beyond all bounds where a border vertex V comes near a border edge AB, and vanishes where the two are
// farther apart than a gap, a part of the border edges there:
//
//       V            distance d = |V - Q|, see barrier_energy()
//       |
//   A---Q-----B      Q = (1 - t) A + t B
//
// A valid map whose borders meet nowhere is one-to-one.
class Border_barrier
{
public:
  // The energy is multiplied by `stiffness`.
  Border_barrier(const Level& level, double stiffness)
    : m_part_of_edge(level.is_finest() ? 0.25 : 0.5), m_stiffness(stiffness), m_edges(border_edges(level.rings())),
      m_gap(level.number_of_vertices(), (std::numeric_limits<double>::infinity)())
  {
    for (const Border_edge& e : m_edges)
      m_previous.push_back(level.one_ring(e.source).back());
  }

  // Whether no two border edges meet, but at a vertex that they share.
  bool keeps_apart(const Level::Uv& uv) const { return !has_crossings(m_edges, uv); }

  // Takes the gaps from a map; they stay until the next call.
  void set_gaps(const Level::Uv& uv)
  {
    for_each_shortest_edge(uv, [&](Index v, double length) { m_gap[v] = m_part_of_edge * length; });
  }

  double operator()(const Level::Uv& uv) const
  {
    double sum = 0;
    for_each_close_pair(uv, m_gap, [&](const Close_pair& p) {
      sum += barrier_energy(p.distance, gap_of(p), m_stiffness);
    });
    return sum;
  }

  void add_contacts(const Level::Uv& uv, Contacts& contacts) const
  {
    for_each_close_pair(uv, m_gap, [&](const Close_pair& p) {
      const double gap = gap_of(p), d = p.distance;
      if (!(d < gap))
        return;
      const Block_vector normal(p.from_edge.x() / d, p.from_edge.y() / d);
      const Barrier_derivatives derivatives = barrier_derivatives(d, gap, m_stiffness);
      contacts.push_back({ { p.vertex, p.edge.source, p.edge.target },
                         { normal, (p.t - 1) * normal, -p.t * normal },
                         derivatives.first,
                         derivatives.second });
    });
  }

  // The least length of the step `direction`, infinite if there is none, at which a vertex meets an edge.
  double longest_step(const Level::Uv& uv, const Block_vectors& direction) const
  {
    const auto moved = [&](Index v) { return uv[v] + Vector_2(direction[v].x, direction[v].y); };
    std::vector<Bbox_2> vertices, edges;
    for (const Border_edge& e : m_edges) {
      vertices.push_back(uv[e.source].bbox() + moved(e.source).bbox());
      edges.push_back(uv[e.source].bbox() + moved(e.source).bbox() + uv[e.target].bbox() + moved(e.target).bbox());
    }
    double longest = (std::numeric_limits<double>::infinity)();
    for_each_pair_of_boxes(vertices, edges, [&](std::size_t i, std::size_t j) {
      const Border_edge& e = m_edges[j];
      const Index v = m_edges[i].source;
      if (v != e.source && v != e.target)
        longest = (std::min)(longest, time_of_meeting(uv, moved, v, e));
    });
    return longest;
  }

  // Sets how far each border vertex may go without help of the barrier: such that no vertex and edge come nearer than
  // their gap, wherever the others go. A vertex that goes on its way has to be charged for it.
  void set_reach(const Level::Uv& uv)
  {
    constexpr double part_of_way = 0.45;      // two may approach each other
    set_gaps(uv);
    std::vector<double> range(uv.size(), 0.);
    m_reach.resize(uv.size());
    for_each_shortest_edge(uv, [&](Index v, double length) {
      range[v] = length;
      m_reach[v] = part_of_way * (length - m_gap[v]);
    });
    for_each_close_pair(uv, range, [&](const Close_pair& p) {
      const double free = part_of_way * (std::max)(0., p.distance - gap_of(p));
      for (const Index v : { p.vertex, p.edge.source, p.edge.target })
        m_reach[v] = (std::min)(m_reach[v], free);
    });
  }

  double& reach(Index v) { return m_reach[v]; }

private:
  struct Close_pair
  {
    Index vertex;
    Border_edge edge;
    Vector_2 from_edge;     // from the nearest point of the edge to the vertex
    double t;               // where that point lies: 0 at the source, 1 at the target
    double distance;
  };

  double gap_of(const Close_pair& p) const
  {
    return (std::min)({ m_gap[p.vertex], m_gap[p.edge.source], m_gap[p.edge.target] });
  }

  // Calls f(v, l) for every border vertex with the length of the shorter one of its border edges.
  template <class Function>
  void for_each_shortest_edge(const Level::Uv& uv, const Function& f) const
  {
    std::vector<double> shortest(uv.size(), (std::numeric_limits<double>::infinity)());
    for (const Border_edge& e : m_edges) {
      const double length = std::sqrt((uv[e.target] - uv[e.source]).squared_length());
      for (const Index v : { e.source, e.target })
        shortest[v] = (std::min)(shortest[v], length);
    }
    for (const Border_edge& e : m_edges)
      f(e.source, shortest[e.source]);
  }

  // Calls f for all pairs of a border vertex and an edge that does not end there, and is not nearest at a neighbor, at
  // least for those no farther apart than the range of the vertex and the greater one of the edge's ends together.
  template <class Function>
  void for_each_close_pair(const Level::Uv& uv, const std::vector<double>& range, const Function& f) const
  {
    const auto widened = [](const CGAL::Bbox_2& box, double r) {
      return CGAL::Bbox_2(box.xmin() - r, box.ymin() - r, box.xmax() + r, box.ymax() + r);
    };
    std::vector<Bbox_2> vertices, edges;
    for (const auto& [v, w] : m_edges) {
      vertices.push_back(widened(uv[v].bbox(), range[v]));
      edges.push_back(widened(uv[v].bbox() + uv[w].bbox(), (std::max)(range[v], range[w])));
    }
    for_each_pair_of_boxes(vertices, edges, [&](std::size_t i, std::size_t j) {
      const Border_edge &at_vertex = m_edges[i], &e = m_edges[j];
      if (at_vertex.source == e.source || at_vertex.source == e.target)
        return;
      const Close_pair p = close_pair(uv, at_vertex.source, e);
      const bool is_at_neighbor = (p.t == 0 && e.source == at_vertex.target) || (p.t == 1 && e.target == m_previous[i]);
      if (!is_at_neighbor)
        f(p);
    });
  }

  // The part of the way at which V comes to lie on the edge, if both go straight on; infinite if it does not.
  template <class Moved>
  static double time_of_meeting(const Level::Uv& uv, const Moved& moved, Index v, const Border_edge& e)
  {
    const Vector_2 p = uv[e.source] - uv[v], q = uv[e.target] - uv[v], dp = (moved(e.source) - moved(v)) - p,
                   dq = (moved(e.target) - moved(v)) - q;
    return time_on_one_line(p, dp, q, dq, [](const Vector_2& a, const Vector_2& b) { return a * b <= 0; });
  }

  static Close_pair close_pair(const Level::Uv& uv, Index v, const Border_edge& e)
  {
    const Vector_2 ab = uv[e.target] - uv[e.source], av = uv[v] - uv[e.source];
    const double t = (std::min)(1., (std::max)(0., (av * ab) / ab.squared_length()));
    const Vector_2 from_edge = av - t * ab;
    return { v, e, from_edge, t, std::sqrt(from_edge.squared_length()) };
  }

  double m_part_of_edge;      // is the gap; coarse levels leave room for the vertices that are still to come
  double m_stiffness;
  std::vector<Border_edge> m_edges;       // one starts at each border vertex
  std::vector<Index> m_previous;          // where the edge comes from that ends where this one starts
  std::vector<double> m_gap, m_reach;     // by vertex, of those on borders
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_BARRIER_H
