// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_MINIMUM_CUT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_MINIMUM_CUT_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The cheapest way to part a graph in two, by Boykov and Kolmogorov's maximum flow.
class Minimum_cut
{
public:
  // Costs are whole numbers, which have no rounding errors.
  typedef std::int64_t   Cost;

  explicit Minimum_cut(std::size_t number_of_vertices) : m_source(number_of_vertices), m_sink(m_source + 1) { }

  void add_edge(std::size_t a, std::size_t b, Cost cost)
  {
    add_arcs(a, b, cost, cost);
    m_sum += cost;
  }

  // Holds a vertex on one side. Edges are to be added before.
  void hold(std::size_t v, bool is_on_side_of_source)
  {
    if (is_on_side_of_source)
      add_arcs(m_source, v, m_sum + 1, 0);
    else
      add_arcs(v, m_sink, m_sum + 1, 0);
  }

  // Whether each vertex is on the side of the source.
  std::vector<bool> sides() const
  {
    typedef boost::compressed_sparse_row_graph<boost::directedS>   Graph;
    typedef boost::graph_traits<Graph>::edge_descriptor            Arc;
    const std::size_t n = m_sink + 1;
    const Compressed_lists<Index> leaving(n, [&](const auto& add) {
      for (std::size_t i = 0; i < m_ends.size(); ++i)
        add(Index(m_ends[i].first), Index(i));
    });
    std::vector<std::pair<std::size_t, std::size_t>> ends;
    std::vector<Cost> costs, rest(m_ends.size());
    std::vector<Index> place(m_ends.size());
    for (const Index i : leaving.items()) {
      place[i] = Index(ends.size());
      ends.push_back(m_ends[i]);
      costs.push_back(m_costs[i]);
    }
    Graph graph(boost::edges_are_sorted, ends.begin(), ends.end(), n);
    std::vector<Arc> arcs(boost::edges(graph).first, boost::edges(graph).second), reverse;
    for (const Index i : leaving.items())
      reverse.push_back(arcs[place[i ^ 1]]);
    std::vector<boost::default_color_type> colors(n);
    const auto arc_index = boost::get(boost::edge_index, graph);
    boost::boykov_kolmogorov_max_flow(
        graph, boost::make_iterator_property_map(costs.begin(), arc_index),
        boost::make_iterator_property_map(rest.begin(), arc_index),
        boost::make_iterator_property_map(reverse.begin(), arc_index),
        boost::make_iterator_property_map(colors.begin(), boost::get(boost::vertex_index, graph)),
        boost::get(boost::vertex_index, graph), m_source, m_sink);
    std::vector<bool> result;
    for (std::size_t v = 0; v < m_source; ++v)
      result.push_back(colors[v] == boost::black_color);
    return result;
  }

private:
  // An arc and its reverse have numbers that differ in the last bit.
  void add_arcs(std::size_t a, std::size_t b, Cost cost, Cost cost_back)
  {
    m_ends.emplace_back(a, b);
    m_ends.emplace_back(b, a);
    m_costs.push_back(cost);
    m_costs.push_back(cost_back);
  }

  std::size_t m_source, m_sink;
  Cost m_sum = 0;
  std::vector<std::pair<std::size_t, std::size_t>> m_ends;
  std::vector<Cost> m_costs;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_MINIMUM_CUT_H
