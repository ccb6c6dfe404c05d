// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BORDER_CHORDS_H
#define BORDER_CHORDS_H

#include "example_utilities.h"

#include <cmath>
#include <vector>

// A vertex of a new mesh: its place in the plane; if it lies on a border, where: on which edge, and how far along it.
struct New_vertex
{
  Point_2 uv;
  Mesh::Halfedge_index border;     // null: not on a border; else the surface is to its left
  double fraction;
};

// The borders of a map as closed polygons, and coarser ones with a part of their vertices. A chord joins two
// consecutive ones of these.
class Border_chords
{
public:
  struct Chord { Mesh::Halfedge_index first, last; };       // the edges of the border that it spans, the surface to
                                                            // their left

  Border_chords(const Mesh& mesh, const Vertex_uv_map& uvmap)
    : m_mesh(mesh), m_uvmap(uvmap), m_leaving(mesh.number_of_vertices(), Mesh::null_halfedge())
  {
    for (const Mesh::Halfedge_index h : mesh.halfedges())
      if (mesh.is_border(h))
        m_leaving[mesh.target(h)] = mesh.opposite(h);
  }

  // The edge of the border that begins at a vertex; null if it is not on a border.
  Mesh::Halfedge_index leaving(Mesh::Vertex_index v) const { return m_leaving[v]; }

  std::vector<Chord> chords(const std::vector<bool>& is_kept) const
  {
    std::vector<Chord> result;
    for (const Mesh::Vertex_index v : m_mesh.vertices())
      if (is_kept[v] && m_leaving[v] != Mesh::null_halfedge()) {
        Chord chord = { m_leaving[v], m_leaving[v] };
        while (!is_kept[m_mesh.target(chord.last)])
          chord.last = next(chord.last);
        result.push_back(chord);
      }
    return result;
  }

  // Keeps the vertex in the middle. Returns whether there is one.
  bool split(const Chord& chord, std::vector<bool>& is_kept) const
  {
    Mesh::Halfedge_index middle = chord.first;
    for (Mesh::Halfedge_index h = chord.first; h != chord.last && (h = next(h)) != chord.last; h = next(h))
      middle = next(middle);
    is_kept[m_mesh.target(middle)] = true;
    return chord.first != chord.last;
  }

  bool do_cross(const Chord& a, const Chord& b) const
  {
    const Mesh::Vertex_index p = m_mesh.source(a.first), q = m_mesh.target(a.last), r = m_mesh.source(b.first),
                             s = m_mesh.target(b.last);
    return p != r && p != s && q != r && q != s &&
           CGAL::do_intersect(Kernel::Segment_2(m_uvmap[p], m_uvmap[q]), Kernel::Segment_2(m_uvmap[r], m_uvmap[s]));
  }

  // The middle of the border from a to b, by length in the plane.
  New_vertex middle(const New_vertex& a, const New_vertex& b) const
  {
    const double begin = a.fraction * length(a.border);
    double whole = b.fraction * length(b.border) - begin;
    if (a.border != b.border || a.fraction >= b.fraction)
      for (Mesh::Halfedge_index h = a.border; whole += length(h), (h = next(h)) != b.border;) { }
    New_vertex middle = { Point_2(), a.border, 0 };
    double left = begin + 0.5 * whole;
    for (; left > length(middle.border); middle.border = next(middle.border))
      left -= length(middle.border);
    middle.fraction = left / length(middle.border);
    const Point_2 &p = m_uvmap[m_mesh.source(middle.border)], &q = m_uvmap[m_mesh.target(middle.border)];
    middle.uv = p + middle.fraction * (q - p);
    return middle;
  }

private:
  Mesh::Halfedge_index next(Mesh::Halfedge_index h) const { return m_mesh.opposite(m_mesh.prev(m_mesh.opposite(h))); }
  double length(Mesh::Halfedge_index h) const
  {
    return std::sqrt(CGAL::squared_distance(m_uvmap[m_mesh.source(h)], m_uvmap[m_mesh.target(h)]));
  }

  const Mesh& m_mesh;
  const Vertex_uv_map& m_uvmap;
  std::vector<Mesh::Halfedge_index> m_leaving;
};

#endif // BORDER_CHORDS_H
