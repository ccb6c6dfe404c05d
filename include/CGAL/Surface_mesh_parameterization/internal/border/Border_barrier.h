// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_BARRIER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_BARRIER_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Border_edge_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Contact.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
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
    : m_part_of_edge(level.is_finest() ? 0.25 : 0.5), m_stiffness(stiffness), m_pairs(border_edges(level.rings())),
      m_gap(level.number_of_vertices(), (std::numeric_limits<double>::infinity)())
  {
    for (const Border_edge& e : m_pairs.edges())
      m_previous.push_back(level.one_ring(e.source).back());
  }

  // Whether no two border edges meet, but at a vertex that they share.
  bool keeps_apart(const Level::Uv& uv)
  {
    bool result = true;
    m_pairs.for_each(Way{ uv }, [](Index) { return 0.; }, [&](Index i, Index j) {
      result = result && !do_cross(edges()[i], edges()[j], uv);
    });
    return result;
  }

  // Takes the gaps from a map; they stay until the next call.
  void set_gaps(const Level::Uv& uv)
  {
    for_each_shortest_edge(uv, [&](Index v, double length) { m_gap[v] = m_part_of_edge * length; });
  }

  double operator()(const Level::Uv& uv)
  {
    double sum = 0;
    for_each_close_pair(uv, Half_of_gap{ m_gap }, [&](const Close_pair& p) {
      sum += barrier_energy(p.distance, gap_of(p), m_stiffness);
    });
    return sum;
  }

  void add_contacts(const Level::Uv& uv, Contacts& contacts)
  {
    for_each_close_pair(uv, Half_of_gap{ m_gap }, [&](const Close_pair& p) {
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

  // The least length of the step `direction` at which a vertex meets an edge. If that is above `limit` or 1, it may be
  // missed: the result is greater then.
  double longest_step(const Level::Uv& uv, const Block_vectors& direction, double limit)
  {
    double longest = (std::numeric_limits<double>::infinity)();
    limit = (std::min)(1., limit);
    const Way way{ uv, &direction, limit };
    const auto look = [&](Index v, const Border_edge& e) {
      if (v != e.source && v != e.target && CGAL::do_overlap(way(v), way(e.source) + way(e.target)))
        longest = (std::min)(longest, time_of_meeting(uv, direction, v, e));
    };
    m_pairs.for_each(way, Half_of_gap{ m_gap }, [&](Index i, Index j) {
      look(edges()[i].source, edges()[j]);
      look(edges()[j].source, edges()[i]);
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
    for_each_close_pair(uv, [&](Index v) { return range[v]; }, [&](const Close_pair& p) {
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

  // The box of a vertex on its way.
  struct Way
  {
    const Level::Uv& uv;
    const Block_vectors* direction = nullptr;     // null for a map
    double length = 0;

    Bbox_2 operator()(Index v) const
    {
      const Bbox_2 start = uv[v].bbox();
      return direction ? start + moved(uv, *direction, v, length).bbox() : start;
    }
  };

  static Point_2 moved(const Level::Uv& uv, const Block_vectors& direction, Index v, double length)
  {
    return uv[v] + Vector_2(length * direction[v].x, length * direction[v].y);
  }

  const std::vector<Border_edge>& edges() const { return m_pairs.edges(); }

  // What is farther apart than that of both together is farther apart than the lesser gap.
  struct Half_of_gap
  {
    const std::vector<double>& gap;
    double operator()(Index v) const { return 0.5 * gap[v]; }
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
    for (const Border_edge& e : edges()) {
      const double length = std::sqrt((uv[e.target] - uv[e.source]).squared_length());
      for (const Index v : { e.source, e.target })
        shortest[v] = (std::min)(shortest[v], length);
    }
    for (const Border_edge& e : edges())
      f(e.source, shortest[e.source]);
  }

  // Calls f for all pairs of a border vertex and an edge that does not end there, and is not nearest at a neighbor, at
  // least for those no farther apart than the reach of the vertex and the greater one of the edge's ends together.
  template <class Reach, class Function>
  void for_each_close_pair(const Level::Uv& uv, const Reach& reach, const Function& f)
  {
    const auto is_far = [&](Index v, const Border_edge& e) {
      const double r = reach(v) + (std::max)(reach(e.source), reach(e.target));
      const Bbox_2 box = uv[e.source].bbox() + uv[e.target].bbox();
      const Point_2& p = uv[v];
      return p.x() < box.xmin() - r || p.x() > box.xmax() + r || p.y() < box.ymin() - r || p.y() > box.ymax() + r;
    };
    const auto look = [&](Index i, const Border_edge& e) {
      const auto& [v, next] = edges()[i];
      if (v == e.source || v == e.target || is_far(v, e))
        return;
      const Close_pair p = close_pair(uv, v, e);
      const bool is_at_neighbor = (p.t == 0 && e.source == next) || (p.t == 1 && e.target == m_previous[i]);
      if (!is_at_neighbor)
        f(p);
    };
    m_pairs.for_each(Way{ uv }, reach, [&](Index i, Index j) {
      look(i, edges()[j]);
      look(j, edges()[i]);
    });
  }

  // The part of the way at which V comes to lie on the edge, if both go straight on; infinite if it does not.
  static double time_of_meeting(const Level::Uv& uv, const Block_vectors& direction, Index v, const Border_edge& e)
  {
    const auto end = [&](Index w) { return moved(uv, direction, w, 1); };
    const Vector_2 p = uv[e.source] - uv[v], q = uv[e.target] - uv[v], dp = (end(e.source) - end(v)) - p,
                   dq = (end(e.target) - end(v)) - q;
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
  Border_edge_pairs m_pairs;
  std::vector<Index> m_previous;          // where the edge comes from that ends where this one starts
  std::vector<double> m_gap, m_reach;     // by vertex, of those on borders
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BORDER_BARRIER_H
