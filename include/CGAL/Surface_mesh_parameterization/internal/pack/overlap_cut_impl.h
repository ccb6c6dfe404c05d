// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_OVERLAP_CUT_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_OVERLAP_CUT_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/border/covered_triangles.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Distance_queue.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Flat_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Minimum_cut.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/overlap_cut.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

class Overlap_cutter
{
public:
  Overlap_cutter(const Corner_mesh& chart, const std::vector<Point_2>& uv)
    : m_chart(chart), m_number_of_faces(chart.number_of_faces()), m_is_rival(m_number_of_faces, false)
  {
    const std::vector<Index_triangle> triangles = triangles_of(chart);
    std::vector<std::pair<Index, Index>> covered;
    for_each_covered_triangle(triangles, uv, [&](std::size_t i, std::size_t j) {
      covered.emplace_back(Index(i), Index(j));
      m_is_rival[i] = m_is_rival[j] = true;
    });
    m_rivals = Compressed_lists<Index>(m_number_of_faces, [&](const auto& add) {
      for (const auto& [i, j] : covered) {
        add(i, j);
        add(j, i);
      }
    });
    for (const Index_triangle& t : triangles) {
      const Point_2 &a = uv[t[0]], &b = uv[t[1]], &c = uv[t[2]];
      m_centroids.emplace_back((a.x() + b.x() + c.x()) / 3, (a.y() + b.y() + c.y()) / 3);
      m_areas.push_back(doubled_area(a, b, c));
    }
  }

  // The halfedges of the cut.
  std::vector<Index> run() const
  {
    std::vector<bool> is_inside = with_short_border(largest_region());
    join_small_pieces(is_inside);
    return edges_between(is_inside);
  }

private:
  // A connected region of triangles none of which lies over another one, grown around one of them by the distances of
  // their centroids.
  std::vector<bool> region_around(Index seed) const
  {
    Distance_queue queue(m_number_of_faces);
    std::vector<bool> is_inside(m_number_of_faces, false), is_shut_out(m_number_of_faces, false);
    queue.reach(seed, 0);
    for (Index f; (f = queue.take_nearest()) != no_index;) {
      if (is_shut_out[f])
        continue;
      is_inside[f] = true;
      for (const Index rival : m_rivals[f])
        is_shut_out[rival] = true;
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (!m_chart.is_border(h)) {
          const Index g = m_chart.opposite[h] / 3;
          queue.reach(g, queue.distance(f) + std::sqrt((m_centroids[g] - m_centroids[f]).squared_length()));
        }
    }
    return is_inside;
  }

  // Of the regions around some large triangles, each outside of those before.
  std::vector<bool> largest_region() const
  {
    constexpr int most_regions = 8;
    std::vector<Index> by_area(m_number_of_faces);
    std::iota(by_area.begin(), by_area.end(), Index(0));
    std::stable_sort(by_area.begin(), by_area.end(), [this](Index f, Index g) { return m_areas[f] > m_areas[g]; });
    std::vector<bool> is_seen(m_number_of_faces, false), result;
    double greatest_area = 0;
    auto next = by_area.begin();
    for (int i = 0; i < most_regions; ++i) {
      next = std::find_if(next, by_area.end(), [&](Index f) { return !is_seen[f]; });
      if (next == by_area.end())
        break;
      std::vector<bool> region = region_around(*next);
      double area = 0;
      for (Index f = 0; f < m_number_of_faces; ++f)
        if (region[f]) {
          is_seen[f] = true;
          area += m_areas[f];
        }
      if (area > greatest_area) {
        greatest_area = area;
        result.swap(region);
      }
    }
    return result;
  }

  // Moves the border of a region to where it is shortest in space. Triangles that lie over or under others stay on
  // their side.
  std::vector<bool> with_short_border(const std::vector<bool>& region) const
  {
    constexpr double steps_of_longest = 1 << 20;
    double longest = 0;
    for (Index h = 0; h < m_chart.number_of_halfedges(); ++h)
      longest = (std::max)(longest, length(m_chart, h));
    const auto cost = [&](Index h) {
      const double part = length(m_chart, h) / longest;
      return 1 + (part <= 1 ? Minimum_cut::Cost(steps_of_longest * part) : 0);      // all may be 0
    };
    Minimum_cut cut(m_number_of_faces);
    for (Index h = 0; h < m_chart.number_of_halfedges(); ++h)
      if (const Index o = m_chart.opposite[h]; o != no_index && h < o)
        cut.add_edge(h / 3, o / 3, cost(h));
    for (Index f = 0; f < m_number_of_faces; ++f)
      if (m_is_rival[f])
        cut.hold(f, region[f]);
    return cut.sides();
  }

  // A connected part of one side.
  struct Piece
  {
    double area = 0;
    std::vector<Index> faces, neighbors;      // the latter may have been joined to other pieces since

    void append(Piece& other)
    {
      area += other.area;
      append(faces, other.faces);
      append(neighbors, other.neighbors);
    }

  private:
    static void append(std::vector<Index>& list, std::vector<Index>& other)
    {
      if (list.size() < other.size())
        list.swap(other);
      list.insert(list.end(), other.begin(), other.end());
    }
  };

  // Gives small pieces of either side to the other one, the smallest first, as long as they are little in all and two
  // pieces remain.
  void join_small_pieces(std::vector<bool>& is_inside) const
  {
    constexpr double greatest_part = 0.02, greatest_part_in_all = 0.05;       // of the area
    const double area = std::accumulate(m_areas.begin(), m_areas.end(), 0.);
    std::vector<Piece> pieces = pieces_of(is_inside);
    Disjoint_sets joined(pieces.size());
    std::set<std::pair<double, Index>> by_area;
    for (Index i = 0; i < pieces.size(); ++i)
      by_area.emplace(pieces[i].area, i);
    for (double joined_area = 0;;) {
      const Index smallest = by_area.begin()->second;
      Piece piece = std::move(pieces[smallest]);
      joined_area += piece.area;
      if (piece.area > greatest_part * area || joined_area > greatest_part_in_all * area)
        return;
      std::set<Index> neighbors;
      for (const Index neighbor : piece.neighbors)
        if (const Index i = joined.find(neighbor); i != smallest)
          neighbors.insert(i);
      if (neighbors.size() + 1 == by_area.size())
        return;
      for (const Index f : piece.faces)
        is_inside[f] = !is_inside[f];
      // With its neighbors, which are all on the side where it is now, it is one piece.
      by_area.erase(by_area.begin());
      piece.neighbors.clear();
      for (const Index i : neighbors) {
        by_area.erase({ pieces[i].area, i });
        piece.append(pieces[i]);
        joined.unite(smallest, i);
      }
      by_area.emplace(piece.area, smallest);
      pieces[smallest] = std::move(piece);
    }
  }

  std::vector<Piece> pieces_of(const std::vector<bool>& is_inside) const
  {
    const std::vector<Index> edges = edges_between(is_inside);
    Corner_mesh severed = m_chart;
    for (const Index h : edges)
      severed.sever(h);
    std::vector<Piece> result;
    std::vector<Index> piece_of_face(m_number_of_faces);
    for (std::vector<Index>& faces : connected_components(severed)) {
      Piece& piece = result.emplace_back();
      for (const Index f : faces) {
        piece_of_face[f] = Index(result.size() - 1);
        piece.area += m_areas[f];
      }
      piece.faces = std::move(faces);
    }
    for (const Index h : edges) {
      const Index i = piece_of_face[h / 3], j = piece_of_face[m_chart.opposite[h] / 3];
      result[i].neighbors.push_back(j);
      result[j].neighbors.push_back(i);
    }
    return result;
  }

  std::vector<Index> edges_between(const std::vector<bool>& is_inside) const
  {
    std::vector<Index> edges;
    for (Index h = 0; h < m_chart.number_of_halfedges(); ++h)
      if (const Index o = m_chart.opposite[h]; o != no_index && h < o && is_inside[h / 3] != is_inside[o / 3])
        edges.push_back(h);
    return edges;
  }

  const Corner_mesh& m_chart;
  Index m_number_of_faces;
  std::vector<bool> m_is_rival;           // by face: whether it lies over or under another one
  Compressed_lists<Index> m_rivals;       // by face: those
  std::vector<Point_2> m_centroids;
  std::vector<double> m_areas;
};

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool is_one_to_one(const Corner_mesh& chart, const std::vector<Point_2>& uv)
{
  std::vector<Border_edge> edges;
  for (Index h = 0; h < chart.number_of_halfedges(); ++h)
    if (chart.is_border(h))
      edges.push_back({ chart.source(h), chart.target(h) });
  return are_borders_one_to_one(edges, uv);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Index> overlap_cut(const Corner_mesh& chart, const std::vector<Point_2>& uv, double overlap_bound)
{
  const Flat_chart map = chart_of(chart, uv);
  const bool is_divisible = is_positive(map) && !is_one_to_one(chart, uv) &&
                            covered_part(map.triangles, map.points) > overlap_bound;
  return is_divisible ? Overlap_cutter(chart, uv).run() : std::vector<Index>();
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Chart_part> divided_at_overlaps(const Chart_part& chart, double overlap_bound, double bound_of_parts)
{
  std::vector<Chart_part> result, waiting;
  const auto divide = [&](const Chart_part& part, double bound) {
    const std::vector<Index> cut = overlap_cut(part.mesh, part.uv, bound);
    if (cut.empty())
      return false;
    std::vector<Chart_part> sides = sides_of(part, cut);
    std::move(sides.begin(), sides.end(), std::back_inserter(waiting));
    return true;
  };
  divide(chart, overlap_bound);
  while (!waiting.empty()) {
    Chart_part part = std::move(waiting.back());
    waiting.pop_back();
    if (!divide(part, bound_of_parts))
      result.push_back(std::move(part));
  }
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_OVERLAP_CUT_IMPL_H
